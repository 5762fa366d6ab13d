// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tests of the table of marching cubes.
#include "pbd/marching_cubes.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "tests/unit/fluid/surfaces.h"

namespace meniscus::tests {
namespace {

constexpr uint32_t width = 12;  // nodes on each axis of a grid

uint32_t node(uint32_t x, uint32_t y, uint32_t z) {
  return x + width * (y + width * z);
}

/// The surface in a grid of which the outermost nodes are outside. A vertex is 4 times its edge's lower node,
/// and the edge's axis.
std::vector<std::array<uint32_t, 3>> surface_of(const std::vector<bool>& inside) {
  static const std::vector<pbd::CubeTriangles> table = pbd::marching_cubes();
  std::vector<std::array<uint32_t, 3>> triangles;
  for (uint32_t i = 0; i < (width - 1) * (width - 1) * (width - 1); ++i) {
    const uint32_t x = i % (width - 1), y = i / (width - 1) % (width - 1), z = i / (width - 1) / (width - 1);
    const auto corner = [&](uint32_t c) { return node(x + (c & 1), y + (c >> 1 & 1), z + (c >> 2)); };
    uint32_t corners = 0;
    for (uint32_t c = 0; c < 8; ++c) corners |= uint32_t{inside[corner(c)]} << c;
    for (uint32_t t = 0; t < table[corners].count; ++t) {
      const auto vertex = [&](uint32_t k) {
        const auto [low, axis] = pbd::cube_edge(table[corners].edges[3 * t + k]);
        EXPECT_NE(inside[corner(low)], inside[corner(low | 1u << axis)]) << "the edge is not cut";
        return 4 * corner(low) + axis;
      };
      triangles.push_back({vertex(0), vertex(1), vertex(2)});
    }
  }
  return triangles;
}

TEST(MarchingCubes, EdgesOfACubeAreTwelveAndDiffer) {
  std::set<std::pair<uint32_t, uint32_t>> edges;
  for (uint32_t e = 0; e < 12; ++e) {
    const auto [corner, axis] = pbd::cube_edge(e);
    EXPECT_EQ(corner >> axis & 1, 0u) << "edge " << e << " does not start at its lower corner";
    edges.emplace(corner, axis);
  }
  EXPECT_EQ(edges.size(), 12u);
}

TEST(MarchingCubes, NothingIsCutWhereAllCornersAreOnOneSide) {
  const std::vector<pbd::CubeTriangles> table = pbd::marching_cubes();
  ASSERT_EQ(table.size(), 256u);
  EXPECT_EQ(table[0].count, 0);
  EXPECT_EQ(table[255].count, 0);
}

TEST(MarchingCubes, OneCornerIsCutOffWithItsInsideBehind) {
  const pbd::CubeTriangles cube = pbd::marching_cubes()[1];  // the corner at the origin
  ASSERT_EQ(cube.count, 1);
  Vec3 p[3];
  for (int k = 0; k < 3; ++k) {
    const uint32_t axis = pbd::cube_edge(cube.edges[k]).axis;
    p[k] = {axis == 0 ? 0.5f : 0, axis == 1 ? 0.5f : 0, axis == 2 ? 0.5f : 0};
  }
  const Vec3 normal = cross(p[1] - p[0], p[2] - p[0]);
  EXPECT_GT(normal.x, 0);
  EXPECT_EQ(normal.x, normal.y);
  EXPECT_EQ(normal.x, normal.z);
}

// Noise has every case beside every other.
TEST(MarchingCubes, SurfacesInNoiseAreClosedAndManifold) {
  std::mt19937 random(5);
  for (const double share : {0.1, 0.3, 0.5, 0.7, 0.9}) {
    std::bernoulli_distribution is_inside(share);
    for (int run = 0; run < 10; ++run) {
      std::vector<bool> inside(width * width * width, false);
      for (uint32_t z = 1; z + 1 < width; ++z) {
        for (uint32_t y = 1; y + 1 < width; ++y) {
          for (uint32_t x = 1; x + 1 < width; ++x) inside[node(x, y, z)] = is_inside(random);
        }
      }
      const auto triangles = surface_of(inside);
      EXPECT_GT(triangles.size(), 100u);
      EXPECT_EQ(open_edges(triangles), 0u);
      EXPECT_EQ(broken_rings(triangles), 0u);
    }
  }
}

}  // namespace
}  // namespace meniscus::tests
