// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What one force field does to a velocity. docs/methods/force-fields.md has the equations.
#pragma once

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "pbd/device/base/view.h"
#include "pbd/device/scalar.h"
#include "sdk/engine/force_fields/curl_noise.h"

namespace meniscus {

/// A force field, with all vectors in the world's frame but those of grids.
struct ForceField {
  enum class Kind : uint32_t { uniform, radial, vortex, drag, noise, grid };
  enum class Region : uint32_t { everywhere, box, ball };
  enum Target : uint32_t { fluids = 1, grains = 2, cloth = 4, bodies = 8 };

  Kind kind = Kind::uniform;
  Region region = Region::everywhere;
  uint32_t targets = 0;        ///< of Target
  uint32_t is_per_volume = 0;  ///< amounts are N/m³
  Pose pose{};                 ///< of the field in the world
  Aabb box{{0, 0, 0}, {0, 0, 0}};
  float ball_radius = 0;  ///< m
  Vec3 vector{0, 0, 0};   ///< uniform: amount; vortex: Ω ŷ, rad/s; drag: u, m/s
  float strength = 0;     ///< radial, noise: amount; drag: quadratic part; grid: the greatest amount
  float rate = 0;         ///< vortex, drag: linear part
  float size = 1;         ///< m, radial: radius; noise: size; grid: cell
  float softening2 = 0;   ///< m², radial
  float period = 0;       ///< s, noise
  int exponent = 0;       ///< radial
  uint32_t seed = 0;      ///< noise
  Vec3 lower{0, 0, 0};    ///< m, grid
  uint32_t nodes_x = 0, nodes_y = 0, nodes_z = 0;  ///< grid
  pbd::View<const Vec3> values{};                  ///< grid, in the memory of whoever uses the field
};

/// The volumes of vertices, for fields that act on volumes.
struct VertexVolumes {
  std::vector<float> volumes{};  ///< m³, by vertex, 0 of those without one; empty if no field acts on volumes
  float least_density = std::numeric_limits<float>::infinity();  ///< kg/m³, of the dry vertices
};

/// A field, and the values of its grid on the host.
struct ForceFieldModel {
  ForceField field;
  std::vector<Vec3> values;
};

namespace force_kernels {

using pbd::View;

/// The density of what has no volume.
inline constexpr float infinite_density = 3e38f;

/// What feels a field.
struct Felt {
  Vec3 place;       ///< m
  float density;    ///< kg/m³, mass over volume; infinite_density without a volume
  uint32_t target;  ///< a ForceField::Target
};

/// The weights and seeds of the two patterns between which noise changes at present. Their squares add up to
/// 1, so that the mean square stays.
struct NoiseBlend {
  float first = 1, second = 0;
  uint32_t seed = 0;

  MENISCUS_HD static NoiseBlend at(const ForceField& f, double time) {
    if (!(f.period > 0)) return {1, 0, f.seed};
    const double turns = time / double{f.period}, whole = floor(turns);
    const auto t = static_cast<float>(turns - whole);
    const float angle = 0.5f * std::numbers::pi_v<float> * t * t * (3 - 2 * t);
    return {cosf(angle), sinf(angle), f.seed + static_cast<uint32_t>(static_cast<int64_t>(whole))};
  }
};

MENISCUS_HD inline bool is_inside(const ForceField& f, Vec3 q) {
  if (f.region == ForceField::Region::box) return inside(f.box, q);
  return f.region == ForceField::Region::everywhere || dot(q, q) <= f.ball_radius * f.ball_radius;
}

/// strength · (radius/s)ⁿ · x/s
MENISCUS_HD inline Vec3 radial_amount(const ForceField& f, Vec3 x) {
  const float s = sqrtf(dot(x, x) + f.softening2);
  float amount = f.strength / s;
  if (f.exponent < 0) amount *= s / f.size;
  for (int k = 0; k < f.exponent; ++k) amount *= f.size / s;
  return amount * x;
}

MENISCUS_HD inline Vec3 noise_amount(const ForceField& f, Vec3 q, double time) {
  const NoiseBlend blend = NoiseBlend::at(f, time);
  const Vec3 at = q / f.size;
  Vec3 sum = blend.first * curl_noise(at, blend.seed);
  if (blend.second != 0) sum += blend.second * curl_noise(at, blend.seed + 1);
  return f.strength * sum;
}

/// Linear between the nodes along each axis; 0 outside of the grid.
MENISCUS_HD inline Vec3 grid_amount(const ForceField& f, Vec3 q) {
  const Vec3 at = (q - f.lower) / f.size;
  const auto fits = [](float x, uint32_t nodes) { return x >= 0 && x <= static_cast<float>(nodes - 1); };
  if (!fits(at.x, f.nodes_x) || !fits(at.y, f.nodes_y) || !fits(at.z, f.nodes_z)) return {0, 0, 0};
  const auto below = [](float x, uint32_t nodes) {
    const auto k = static_cast<uint32_t>(x);
    return k < nodes - 1 ? k : nodes - 2;
  };
  const uint32_t i = below(at.x, f.nodes_x), j = below(at.y, f.nodes_y), k = below(at.z, f.nodes_z);
  const Vec3 t = at - Vec3{static_cast<float>(i), static_cast<float>(j), static_cast<float>(k)};
  Vec3 sum{0, 0, 0};
  for (uint32_t corner = 0; corner < 8; ++corner) {
    const uint32_t a = corner & 1, b = corner >> 1 & 1, c = corner >> 2;
    const float weight = (a ? t.x : 1 - t.x) * (b ? t.y : 1 - t.y) * (c ? t.z : 1 - t.z);
    sum += weight * f.values[((k + c) * f.nodes_y + j + b) * f.nodes_x + i + a];
  }
  return sum;
}

/// The exact change, over dt, of a velocity that lags behind a flow by `lag` and takes it at a rate.
MENISCUS_HD inline Vec3 taken_up(Vec3 lag, float rate, float dt) {
  return -expm1f(-rate * dt) * lag;
}

/// Linear drag for dt, then quadratic drag: with w = u − v, w ← w e^(−k h), w ← w/(1 + c |w| h).
MENISCUS_HD inline Vec3 drag_change(const ForceField& f, Vec3 v, float share, float dt) {
  const Vec3 lag = f.vector - v;
  const Vec3 change = taken_up(lag, share * f.rate, dt), left = lag - change;
  const float braking = share * f.strength * length(left) * dt;
  return change + (braking / (1 + braking)) * left;
}

/// h (Ω × (Ω × x)), and the velocity of the flow at the rate.
MENISCUS_HD inline Vec3 vortex_change(const ForceField& f, Vec3 x, Vec3 v, float dt) {
  const Vec3 flow = cross(f.vector, x);
  return dt * cross(f.vector, flow) + taken_up(flow - v, f.rate, dt);
}

/// What a field adds to a velocity in dt.
MENISCUS_HD inline Vec3 change_by(const ForceField& f, const Felt& felt, Vec3 v, double time, float dt) {
  const bool has_volume = felt.density < infinite_density;
  if (!(f.targets & felt.target) || (f.is_per_volume && !has_volume)) return {0, 0, 0};
  const Vec3 q = to_local(f.pose, felt.place), x = felt.place - f.pose.position;
  if (!is_inside(f, q)) return {0, 0, 0};
  const float share = f.is_per_volume ? 1 / felt.density : 1.0f;
  switch (f.kind) {
    case ForceField::Kind::uniform:
      return (share * dt) * f.vector;
    case ForceField::Kind::radial:
      return (share * dt) * radial_amount(f, x);
    case ForceField::Kind::vortex:
      return vortex_change(f, x, v, dt);
    case ForceField::Kind::drag:
      return drag_change(f, v, share, dt);
    case ForceField::Kind::noise:
      return (share * dt) * rotate(f.pose.rotation, noise_amount(f, q, time));
    case ForceField::Kind::grid:
      return (share * dt) * rotate(f.pose.rotation, grid_amount(f, q));
  }
  return {0, 0, 0};
}

/// What all fields add to a velocity in dt, one after the other.
MENISCUS_HD inline Vec3 change_by_all(View<const ForceField> fields, const Felt& felt, Vec3 v, double time,
                                      float dt) {
  Vec3 sum{0, 0, 0};
  for (uint32_t k = 0; k < fields.count; ++k) sum += change_by(fields[k], felt, v + sum, time, dt);
  return sum;
}

}  // namespace force_kernels
}  // namespace meniscus
