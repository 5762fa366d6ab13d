// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Moving air: a mean velocity, and gusts as a sum of divergence-free waves. The velocity of each wave is
// perpendicular to its direction of travel (after Kraichnan 1970).
#pragma once

#include "pbd/device/scalar.h"

namespace meniscus::cloth {

using pbd::sine;

struct Gust {
  Vec3 wave;       ///< rad/m
  Vec3 amplitude;  ///< m/s, across the wave
  float rate;      ///< rad/s
  float phase;     ///< rad
};

struct Wind {
  static constexpr int gust_count = 8;

  Vec3 velocity{0, 0, 0};  ///< m/s
  float density = 1.2f;    ///< kg/m³, of the air
  Gust gusts[gust_count] = {};
  bool gusty = false;

  template <class R>
  MENISCUS_HD pbd::Vec3Of<R> at(const pbd::Vec3Of<R>& x, const R& time) const {
    const auto each = [](Vec3 a) { return pbd::Vec3Of<R>{R(a.x), R(a.y), R(a.z)}; };
    pbd::Vec3Of<R> v = each(velocity);
    if (!gusty) return v;
    for (const Gust& g : gusts) v += sine(dot(g.wave, x) - R(g.rate) * time + R(g.phase)) * each(g.amplitude);
    return v;
  }
};

/// Wind with gusts of this standard deviation (m/s) and about this size (m). The same seed gives the same
/// wind.
Wind make_wind(Vec3 velocity, float air_density, float gust_speed, float gust_size, uint32_t seed);

}  // namespace meniscus::cloth
