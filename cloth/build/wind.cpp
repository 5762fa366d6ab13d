// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Draws the waves of gusts from a seed.
#include "cloth/build/wind.h"
#include "cloth/build/tuning.h"

#include <cmath>
#include <random>

namespace meniscus::cloth {

Wind make_wind(Vec3 velocity, float air_density, float gust_speed, float gust_size, uint32_t seed) {
  Wind wind{.velocity = velocity, .density = air_density, .gusts = {}, .gusty = gust_speed > 0};
  if (!wind.gusty) return wind;
  constexpr double pi = 3.14159265358979;
  std::mt19937 bits(seed);
  const auto uniform = [&] {
    return static_cast<double>(bits()) / 4294967296.0;
  };  // the same on every platform
  const auto direction = [&] {
    const double z = 2 * uniform() - 1, turn = 2 * pi * uniform(), r = std::sqrt(1 - z * z);
    return Vec3{static_cast<float>(r * std::cos(turn)), static_cast<float>(r * std::sin(turn)),
                static_cast<float>(z)};
  };
  for (Gust& g : wind.gusts) {
    const Vec3 n = direction();
    const auto number = static_cast<float>(2 * pi / gust_size *
                                           (build_tuning::least_gust + build_tuning::gust_range * uniform()));
    const Vec3 across = normalized_or(cross(n, direction()), {1, 0, 0});
    g.wave = number * n;
    g.amplitude = gust_speed * std::sqrt(2.0f / Wind::gust_count) * across;
    // The waves move with the wind, and evolve at a rate of their own.
    g.rate = dot(g.wave, velocity) + number * gust_speed;
    g.phase = static_cast<float>(2 * pi * uniform());
  }
  return wind;
}

}  // namespace meniscus::cloth
