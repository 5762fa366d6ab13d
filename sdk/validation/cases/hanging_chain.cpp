// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Ropes and strips of cloth that hang between two points, and a chain that swings.
#include "sdk/validation/cases/hanging_chain.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "sdk/validation/cases/cloth_parts.h"

namespace meniscus::validation {
namespace {

constexpr int segments = 40;
constexpr float unyielding = std::numeric_limits<float>::infinity();

/// The slope at the end itself, from those of the first two segments.
Catenary measured(const std::vector<Vec3>& x, float length) {
  const auto angle = [&](std::size_t k) {
    const Vec3 d = x[k + 1] - x[k];
    return std::atan2(-d.y, d.x) * 180 / 3.14159265f;
  };
  Catenary found{length, 0, angle(0) + 0.5f * (angle(0) - angle(1))};
  for (Vec3 p : x) found.sag = std::max(found.sag, -p.y);
  return found;
}

}  // namespace

Catenary exact_catenary(float length) {
  double low = 0.05, high = 10;  // of 1/2a
  for (int k = 0; k < 100; ++k) {
    const double u = 0.5 * (low + high);
    (std::sinh(u) / u < double{length} ? low : high) = u;
  }
  return {length, static_cast<float>((std::cosh(low) - 1) / (2 * low)),
          static_cast<float>(std::atan(std::sinh(low)) * 180 / std::numbers::pi)};
}

Catenary hang_rope(const WorldDef& base, float length, int substeps) {
  World world(cloth_world(base, substeps, 10));
  const float depth = 0.5f * std::sqrt(length * length - 1);
  RopeDef def;
  def.points = {{-0.5f, 0, 0}, {0, -depth, 0}, {0.5f, 0, 0}};
  def.segments = segments;
  def.youngs_modulus = unyielding;
  def.damping = 0.05f;
  const RopeId id = world.create_rope(def);
  world.create_attachment(held(id, {0, segments}));
  run_steps(world, 60 * 60, cloth_frame);
  const auto x = world.rope_positions(id);
  return measured({x.begin(), x.end()}, length);
}

Catenary hang_strip(const WorldDef& base, float length) {
  World world(cloth_world(base, 40, 10));
  ClothDef def = sheet(length, length / segments, segments + 1, 2);
  def.stretch = {1 / length, 1, 1};
  def.self_collision = def.tethers = false;
  def.fabric.warp_stiffness = def.fabric.weft_stiffness = unyielding;
  def.fabric.bending_stiffness = def.fabric.stretch_damping = def.fabric.lift = 0;
  const ClothId id = world.create_cloth(def);
  world.create_attachment(held(id, columns_of(def, {0, segments})));
  world.set_wind({.air_density = 3000});
  run_steps(world, 20 * 60, cloth_frame);
  world.set_wind({.air_density = 0});
  run_steps(world, 30, cloth_frame);
  std::vector<Vec3> middle;
  for (int k = 0; k <= segments; ++k)
    middle.push_back(mean_of(world.cloth_positions(id), columns_of(def, {k})));
  return measured(middle, length);
}

Curve swing_chain(const WorldDef& base, int chain_segments) {
  constexpr double first_root = 2.404826, amplitude = 0.02;  // of J₀; m
  World world(cloth_world(base, 20, 10));
  RopeDef def;
  for (int k = 0; k <= chain_segments; ++k) {
    const double height = 1 - double(k) / chain_segments;  // over the free end
    def.points.push_back(
        {static_cast<float>(amplitude * std::cyl_bessel_j(0, first_root * std::sqrt(height))),
         static_cast<float>(height - 1), 0});
  }
  def.points.front().x = 0;
  def.youngs_modulus = unyielding;
  def.damping = 0;
  const RopeId id = world.create_rope(def);
  world.create_attachment(held(id, {0}));
  Curve end{"measured"};
  while (world.time() < 9) {
    world.step(cloth_frame);
    end.add(world.time(), double{world.rope_positions(id).back().x});
  }
  return end;
}

}  // namespace meniscus::validation
