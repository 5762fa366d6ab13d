// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The interface of forces beside gravity.
#pragma once

#include "pbd/particles.h"

namespace meniscus::pbd {

/// Forces beside gravity that act on all particles, and on objects outside of the device. They change
/// velocities before the prediction, as gravity does.
template <class D>
class ExternalForces {
 public:
  virtual ~ExternalForces() = default;
  /// Whether there are any on particles.
  virtual bool any() const = 0;
  /// m/s², the most that any particle between these corners may get.
  virtual float greatest_acceleration(Vec3 lower, Vec3 upper) const = 0;
  virtual void reserve(uint32_t /*particles*/) {}
  virtual void start_step() {}
  /// Called first in a substep, before the sets predict: changes objects outside of the device.
  virtual void start_substep(float dt) = 0;
  /// m/s, by particle of the present order: what the forces add to the velocity in dt.
  virtual View<const Vec4> velocity_changes(const ParticleView& start, float dt) = 0;
};

}  // namespace meniscus::pbd
