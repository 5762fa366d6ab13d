// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The parts of frames with several meshes, one after another.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "sdk/io/cloth_frame.h"
#include "sdk/io/liquid_frame.h"

namespace meniscus::io {

/// The range of one part's vertices and triangles.
struct MeshPart {
  uint32_t first_vertex = 0, vertex_count = 0;
  std::size_t first_triangle = 0, triangle_count = 0;

  template <class T>
  std::span<const T> vertices(const std::vector<T>& all) const {
    return std::span<const T>(all).subspan(first_vertex, vertex_count);
  }
  template <class T>
  std::span<const T> triangles(const std::vector<T>& all) const {
    return std::span<const T>(all).subspan(first_triangle, triangle_count);
  }
  /// Of what there is one a corner.
  template <class T>
  std::span<const T> corners(const std::vector<T>& all) const {
    return std::span<const T>(all).subspan(3 * first_triangle, 3 * triangle_count);
  }
};

std::vector<MeshPart> parts_of(const ClothFrame& frame);
/// Each vertex of a fluid is in one of its triangles.
std::vector<MeshPart> parts_of(const LiquidFrame& frame);

}  // namespace meniscus::io
