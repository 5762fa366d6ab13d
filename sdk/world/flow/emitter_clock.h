// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The times at which particles leave an emitter's opening.
#pragma once

#include <cstdint>
#include <vector>

#include "pbd/state/state_visitor.h"

namespace meniscus {

/// A particle that is due to leave a place of an opening.
struct Departure {
  double time;         ///< s
  uint32_t place;      ///< number
  bool waits = false;  ///< it found no room before
};

/// The times at which particles leave each place of an opening: at a constant rate, unless one finds no room.
/// That particle waits and leaves at the end of the first step that has room for it; the rate continues from
/// there. Other places are not affected.
class EmitterClock {
 public:
  /// Times in s. Each place makes one particle per `period`, the first within one period after `start`. The
  /// places take turns over the fraction `spread` of the period before that.
  EmitterClock(uint32_t places, double start, double stop, double period, double spread);

  /// About how many particles are due until then.
  double expected(double until) const;
  /// The particles that are due until then, in the order of time, then of places.
  void due(double until, std::vector<Departure>& departures) const;
  /// The particles that a place did not make in a step of length dt (s) that ends `now`, because its
  /// departure found no room. Over time these and those that left are what the rate asks for.
  double refused(const Departure& departure, double now, double dt) const {
    return (departure.waits ? dt : now - departure.time) / period_;
  }
  /// Records whether a departure left; call it in the order of due().
  void note(const Departure& departure, bool left);

  void visit_state(pbd::StateVisitor& v) {
    v.list("place", places_);
    v.value("stop", stop_);
    v.value("period", period_);
  }

 private:
  struct Place {
    double next;  // s
    bool waits;
  };

  bool may_leave(double time) const { return time <= stop_ + 1e-6 * period_; }

  std::vector<Place> places_;
  double stop_, period_;
};

}  // namespace meniscus
