// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Holds the velocity of particles that have just left an opening.
#pragma once

#include <algorithm>

#include "pbd/particles.h"
#include "pbd/substep.h"

namespace meniscus {

namespace jet_kernels {

using pbd::View;

/// Removes the change that constraints made to the velocity.
struct Hold {
  View<const pbd::Phase> phase;
  View<const pbd::Vec4> accumulated_delta;
  View<pbd::Vec4> velocity;
  float inverse_dt;

  MENISCUS_HD void operator()(uint32_t i) const {
    if (pbd::held_steps(phase[i]) == 0) return;
    velocity[i] = pbd::with_w(velocity[i].xyz() - inverse_dt * accumulated_delta[i].xyz(), velocity[i].w);
  }
};

struct Age {
  View<pbd::Phase> phase;

  MENISCUS_HD void operator()(uint32_t i) const {
    if (pbd::held_steps(phase[i]) > 0) phase[i] -= pbd::held_for(1);
  }
};

}  // namespace jet_kernels

/// Keeps the velocity of particles that have just left an opening until fluid has followed behind them.
/// Without this, the rest of the jet would push back the newest layer, which has nothing behind it. The next
/// layer would then be placed into it, and so on: a jet of incompressible fluid would break up.
template <class D>
class Jets final : public pbd::VelocityPass<D> {
 public:
  explicit Jets(D& device) : device_(device) {}

  void apply(pbd::Substep<D>& substep, pbd::Particles& particles) override {
    if (steps_left_ == 0) return;
    const pbd::ParticleView& p = substep.particles;
    device_.parallel_for("jets/hold", particles.sorted(),
                         jet_kernels::Hold{p.phase, p.accumulated_delta, p.velocity, 1 / substep.dt});
  }

  /// Some particle keeps its velocity for this many steps.
  void hold_for(uint32_t steps) { steps_left_ = std::max(steps_left_, steps); }

  /// Call it after a completed step.
  void age(pbd::Particles& particles) {
    if (steps_left_ == 0) return;
    device_.parallel_for("jets/age", particles.sorted(), jet_kernels::Age{particles.phase.current.view()});
    --steps_left_;
  }

  void visit_state(pbd::StateVisitor& v) { v.value("steps_left", steps_left_); }

 private:
  D& device_;
  uint32_t steps_left_ = 0;  // steps for which any particle is still held
};

}  // namespace meniscus
