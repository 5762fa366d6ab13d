// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Cloth and ropes of which the cases build their worlds, and what is read off them.
#pragma once

#include <meniscus/world.h>

#include <cstdint>
#include <span>
#include <vector>

#include "pbd/math/vec.h"
#include "sdk/validation/parts.h"

namespace meniscus::validation {

inline constexpr float cloth_frame = 1 / 60.0f;  // s

inline WorldDef cloth_world(WorldDef def, int substeps, int iterations) {
  def.substeps = substeps;
  def.iterations = iterations;
  return def;
}

/// A flat sheet about a point.
inline ClothDef sheet(float width, float depth, int columns, int rows, Vec3 position = {0, 0, 0}) {
  ClothDef def;
  def.name = "sheet";
  def.geometry = SheetGeometry{width, depth, columns, rows};
  def.pose.position = position;
  return def;
}

/// The columns of a sheet with these numbers, one after the other.
inline std::vector<uint32_t> columns_of(const ClothDef& def, std::initializer_list<int> columns) {
  const auto& g = std::get<SheetGeometry>(def.geometry);
  std::vector<uint32_t> vertices;
  for (int column : columns) {
    for (int row = 0; row < g.rows; ++row)
      vertices.push_back(static_cast<uint32_t>(row * g.columns + column));
  }
  return vertices;
}

inline AttachmentDef held(ClothId cloth, std::vector<uint32_t> vertices) {
  AttachmentDef def;
  def.cloth = cloth;
  def.vertices = std::move(vertices);
  return def;
}

inline AttachmentDef held(RopeId rope, std::vector<uint32_t> vertices) {
  AttachmentDef def;
  def.rope = rope;
  def.vertices = std::move(vertices);
  return def;
}

inline Vec3 mean_of(std::span<const Vec3> values, const std::vector<uint32_t>& chosen) {
  Vec3 sum{0, 0, 0};
  for (uint32_t v : chosen) sum += values[v] / static_cast<float>(chosen.size());
  return sum;
}

inline Quat about_z(float degrees) {
  return rotation_by({0, 0, degrees * 3.14159265f / 180});
}

}  // namespace meniscus::validation
