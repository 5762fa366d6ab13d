// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Cloth for validation: worlds of cloth alone, and sheets that remember how they lie at rest.
#pragma once

#include "tests/cloth_worlds.h"
#include "tests/validation/measures.h"

namespace meniscus::tests {

inline constexpr float frame = 1 / 60.0f;  // s

inline WorldDef cloth_world(pbd::DeviceKind device, int substeps, int iterations) {
  WorldDef def = world_def(device, 0.05f);
  def.substeps = substeps;
  def.iterations = iterations;
  return def;
}

/// Runs with air that takes the motion out, and a while longer in air that weighs nothing.
inline void settle(World& world, float seconds, float air_density = 20) {
  world.set_wind({.air_density = air_density});
  run(world, static_cast<int>(seconds / frame), frame);
  world.set_wind({.air_density = 0});
  run(world, 30, frame);
}

/// Where a sheet's vertices lie at rest, in its own frame.
inline std::vector<Vec3> at_rest(const ClothDef& def) {
  const auto& g = std::get<SheetGeometry>(def.geometry);
  std::vector<Vec3> rest;
  for (int row = 0; row < g.rows; ++row) {
    for (int column = 0; column < g.columns; ++column) {
      rest.push_back({g.width * (float(column) / float(g.columns - 1) - 0.5f), 0,
                      g.depth * (float(row) / float(g.rows - 1) - 0.5f)});
    }
  }
  return rest;
}

/// A column of a sheet.
inline std::vector<uint32_t> column_of(const ClothDef& def, int column) {
  const auto& g = std::get<SheetGeometry>(def.geometry);
  std::vector<uint32_t> vertices;
  for (int row = 0; row < g.rows; ++row) vertices.push_back(static_cast<uint32_t>(row * g.columns + column));
  return vertices;
}

inline std::vector<uint32_t> operator+(std::vector<uint32_t> a, const std::vector<uint32_t>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

inline Vec3 mean_of(std::span<const Vec3> values, const std::vector<uint32_t>& chosen) {
  Vec3 sum{0, 0, 0};
  for (uint32_t v : chosen) sum += values[v] / static_cast<float>(chosen.size());
  return sum;
}

}  // namespace meniscus::tests
