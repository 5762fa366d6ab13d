// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What the baselines' bounds on a substep depend on.
#pragma once

#include <algorithm>
#include <cmath>

#include "fluid/baselines/tuning.h"
#include "fluid/density/density_set.h"
#include "pbd/device/buffer.h"
#include "pbd/device/scalar.h"
#include "pbd/particles.h"

namespace meniscus::fluid {

/// Of all fluid particles.
struct FluidMotion {
  float fastest2 = 0;                ///< m²/s²
  float energy = -pbd::most_finite;  ///< J/kg, the largest of v²/2 − g·x
  float lowest = pbd::most_finite;   ///< J/kg, the smallest of −g·x
  float inverse_mass = 0;            ///< 1/kg, the largest

  /// m/s, of a particle that falls from the highest energy to the lowest place.
  float greatest_speed() const { return energy > lowest ? std::sqrt(2 * (energy - lowest)) : 0.0f; }
};

namespace baseline_kernels {

struct MeasureMotion {
  pbd::View<const pbd::Vec4> position, velocity;
  Vec3 gravity;

  MENISCUS_HD FluidMotion operator()(uint32_t i) const {
    const pbd::Vec4 p = position[i];
    const Vec3 v = velocity[i].xyz();
    const float speed2 = dot(v, v), potential = -dot(gravity, p.xyz());
    return {speed2, 0.5f * speed2 + potential, potential, p.w};
  }
};

struct MergeMotions {
  MENISCUS_HD FluidMotion operator()(const FluidMotion& a, const FluidMotion& b) const {
    return {pbd::max(a.fastest2, b.fastest2), pbd::max(a.energy, b.energy), pbd::min(a.lowest, b.lowest),
            pbd::max(a.inverse_mass, b.inverse_mass)};
  }
};

}  // namespace baseline_kernels

/// Measures the motion at a step's start. It waits for the device.
template <class D>
class MotionReader {
 public:
  explicit MotionReader(D& device) : device_(device) { motion_.resize_discard(1); }

  FluidMotion read(const pbd::ParticleView& start, Vec3 gravity) {
    FluidMotion motion;
    if (start.sorted == 0) return motion;
    device_.reduce("baseline/motion", start.sorted, FluidMotion{},
                   baseline_kernels::MeasureMotion{start.position, start.velocity, gravity},
                   baseline_kernels::MergeMotions{}, motion_.view());
    motion_.read(std::span(&motion, 1));
    return motion;
  }

 private:
  D& device_;
  pbd::Buffer<FluidMotion> motion_{device_, "fluid motion"};
};

/// At least `chosen` substeps of a step of length dt, each at most `longest` long; s.
inline int substeps_within(float dt, float longest, int chosen) {
  const float wanted = std::ceil(dt / longest);
  const auto most = static_cast<float>(baseline_tuning::most_substeps);
  return std::max(chosen, static_cast<int>(wanted < most ? wanted : most));
}

/// The same, so that nothing moves further than courant_number spacings in a substep (Bender & Koschier 2015,
/// section 3.2; Ihmsen et al. 2010).
inline int courant_substeps(const FluidMotion& motion, float dt, const DensityParameters& parameters,
                            int chosen) {
  if (parameters.courant_number == 0) return chosen;
  const float speed = std::sqrt(motion.fastest2) + dt * length(parameters.gravity);
  return substeps_within(dt, parameters.courant_number * parameters.spacing / std::max(speed, 1e-30f),
                         chosen);
}

}  // namespace meniscus::fluid
