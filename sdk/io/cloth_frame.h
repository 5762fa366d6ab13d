// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Cloth and ropes at one moment, as input of the writers and the preview.
#pragma once

#include <meniscus/world.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace meniscus::io {

/// All pieces of cloth, one after the other. The triangles and their number may change from frame to frame.
struct ClothFrame {
  double time = 0;                                 ///< s
  std::vector<Vec3> vertices;                      ///< m
  std::vector<Vec3> velocities;                    ///< m/s, one per vertex
  std::vector<Vec3> normals;                       ///< unit, one per vertex
  std::vector<float> wetness;                      ///< one per vertex, or none: see World::cloth_wetness
  std::vector<std::array<uint32_t, 3>> triangles;  ///< corners counter-clockwise about the normal
  std::vector<float> strains;                      ///< one per triangle: its largest principal strain
  std::vector<uint32_t> pieces;                    ///< one per triangle: its piece, in the order of the scene
  std::vector<uint32_t> vertex_pieces;             ///< one per vertex: its piece
  std::vector<std::string> names;                  ///< of the pieces
  /// One per corner of the triangles, (0, 0) for pieces without any; empty unless add_texture has found some.
  std::vector<TexturePoint> texture;

  std::vector<std::size_t> vertex_counts() const;    ///< of each piece
  std::vector<std::size_t> triangle_counts() const;  ///< likewise
};

/// All ropes, one after the other.
struct RopeFrame {
  double time = 0;               ///< s
  std::vector<Vec3> vertices;    ///< m
  std::vector<Vec3> velocities;  ///< m/s, one per vertex
  std::vector<std::vector<uint32_t>>
      lines;  ///< the vertices along each rope; a closed rope repeats its first vertex at the end
  std::vector<float> radii;        ///< m, of the ropes
  std::vector<std::string> names;  ///< of the ropes

  std::vector<double> lengths() const;  ///< m, of each rope
};

/// The present cloth of a world; ids and definitions in the same order.
ClothFrame cloth_frame_of(const World& world, const std::vector<ClothId>& ids,
                          const std::vector<ClothDef>& defs);

/// Adds the texture coordinates of these pieces to their frame. Throws what World::cloth_texture throws.
void add_texture(ClothFrame& frame, const World& world, const std::vector<ClothId>& ids);

/// The present ropes of a world, likewise.
RopeFrame rope_frame_of(const World& world, const std::vector<RopeId>& ids, const std::vector<RopeDef>& defs);

}  // namespace meniscus::io
