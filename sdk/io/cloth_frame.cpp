// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Copies the cloth and ropes of a world into frames.
#include "sdk/io/cloth_frame.h"

#include <numeric>
#include <span>

#include "pbd/math/vec.h"

namespace meniscus::io {
namespace {

template <class T>
void append(std::vector<T>& all, std::span<const T> more) {
  all.insert(all.end(), more.begin(), more.end());
}

std::vector<std::size_t> counts(const std::vector<uint32_t>& pieces, std::size_t count) {
  std::vector<std::size_t> result(count);
  for (const uint32_t piece : pieces) ++result.at(piece);
  return result;
}

}  // namespace

std::vector<std::size_t> ClothFrame::vertex_counts() const {
  return counts(vertex_pieces, names.size());
}

std::vector<std::size_t> ClothFrame::triangle_counts() const {
  return counts(pieces, names.size());
}

std::vector<double> RopeFrame::lengths() const {
  std::vector<double> result;
  for (const std::vector<uint32_t>& line : lines) {
    double sum = 0;
    for (std::size_t k = 1; k < line.size(); ++k)
      sum += double{length(vertices[line[k]] - vertices[line[k - 1]])};
    result.push_back(sum);
  }
  return result;
}

ClothFrame cloth_frame_of(const World& world, const std::vector<ClothId>& ids,
                          const std::vector<ClothDef>& defs) {
  ClothFrame frame;
  frame.time = world.time();
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const auto first = static_cast<uint32_t>(frame.vertices.size());
    append(frame.vertices, world.cloth_positions(ids[i]));
    append(frame.velocities, world.cloth_velocities(ids[i]));
    append(frame.normals, world.cloth_normals(ids[i]));
    append(frame.wetness, world.cloth_wetness(ids[i]));
    append(frame.strains, world.cloth_strains(ids[i]));
    const std::span<const uint32_t> corners = world.cloth_triangles(ids[i]);
    for (std::size_t k = 0; k + 2 < corners.size(); k += 3) {
      frame.triangles.push_back({first + corners[k], first + corners[k + 1], first + corners[k + 2]});
    }
    frame.vertex_pieces.resize(frame.vertices.size(), static_cast<uint32_t>(i));
    frame.pieces.resize(frame.triangles.size(), static_cast<uint32_t>(i));
    frame.names.push_back(defs[i].name);
  }
  return frame;
}

void add_texture(ClothFrame& frame, const World& world, const std::vector<ClothId>& ids) {
  bool any = false;
  for (const ClothId id : ids) {
    const std::span<const TexturePoint> points = world.cloth_texture(id);
    any = any || !points.empty();
    append(frame.texture, points);
    if (points.empty()) frame.texture.resize(frame.texture.size() + world.cloth_triangles(id).size());
  }
  if (!any) frame.texture.clear();
}

RopeFrame rope_frame_of(const World& world, const std::vector<RopeId>& ids,
                        const std::vector<RopeDef>& defs) {
  RopeFrame frame;
  frame.time = world.time();
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const std::span<const Vec3> positions = world.rope_positions(ids[i]);
    std::vector<uint32_t> line(positions.size());
    std::iota(line.begin(), line.end(), static_cast<uint32_t>(frame.vertices.size()));
    if (defs[i].closed) line.push_back(line.front());
    frame.lines.push_back(std::move(line));
    append(frame.vertices, positions);
    append(frame.velocities, world.rope_velocities(ids[i]));
    frame.radii.push_back(defs[i].radius);
    frame.names.push_back(defs[i].name);
  }
  return frame;
}

}  // namespace meniscus::io
