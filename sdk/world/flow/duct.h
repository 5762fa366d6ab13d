// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The duct behind the opening of an imposed emitter, whose layers of particles are its piston.
#pragma once

#include <meniscus/types.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "pbd/state/state_visitor.h"

namespace meniscus {

/// Layer k, counted from the first one, is centred at travelled − (k + ½) layer along the opening's
/// direction.
struct Duct {
  bool is_due = false;  ///< its first step is over
  bool is_open = false;
  bool is_full_ahead = false;      ///< the fluid in front has no room: the piston rests
  double travelled = 0;            ///< m, by the piston
  double asked = 0, stroke = 0;    ///< m, what the present step asks for, and what it gets
  double pressure = 0;             ///< Pa, on the piston in the last step
  uint64_t passed = 0;             ///< layers that have passed the opening
  std::vector<ParticleId> layers;  ///< the first particle of each layer behind them, foremost first

  uint64_t made() const { return passed + layers.size(); }
  double centre(uint64_t k, double layer) const { return travelled - (static_cast<double>(k) + 0.5) * layer; }
  /// How far the piston can move while layers still fill the duct to this depth, m.
  double room(double layer, double depth) const {
    return static_cast<double>(made()) * layer - depth - travelled;
  }
  /// The number of layers that fill the duct to this depth after a further stroke.
  uint64_t needed(double layer, double depth, double further) const {
    return static_cast<uint64_t>(std::ceil((travelled + further + depth) / layer));
  }

  void visit_state(pbd::StateVisitor& v) {
    v.value("is_due", is_due);
    v.value("is_open", is_open);
    v.value("is_full_ahead", is_full_ahead);
    v.value("travelled", travelled);
    v.value("pressure", pressure);
    v.value("passed", passed);
    v.list("layer", layers);
  }
};

}  // namespace meniscus
