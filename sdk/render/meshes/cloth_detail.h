// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What cloth has beside its triangles: threads, and a roll along its borders.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "sdk/io/cloth_frame.h"

namespace meniscus::render {

struct ClothDetail {
  std::array<float, 2> threads{};  ///< whole numbers from 0 to 1 in the texture, along u and v; 0: no weave
  float hem = 0;                   ///< m: radius of the roll along borders
};

std::size_t piece_count(const io::ClothFrame& frame);

/// Details of each piece, measured on the frame. A side of a square of the piece's area has 100 threads.
std::vector<ClothDetail> cloth_details(const io::ClothFrame& frame);

/// An edge that belongs to one triangle. It runs from one vertex to the other as the triangle does.
struct BorderEdge {
  uint32_t from, to, triangle;
};

/// In the order of their triangles.
std::vector<BorderEdge> border_edges(std::span<const std::array<uint32_t, 3>> triangles);

}  // namespace meniscus::render
