// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Which triangle owns which vertex and edge, and which groups are neighbours.
#include "cloth/self_contact/tables.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "pbd/surface_tree/order.h"
#include "tests/bench/harness/self_contact_bench.h"

namespace meniscus::tests {
namespace {

using pbd::SurfaceTriangle;

struct SelfContactTablesTest : testing::Test {
  ClothCase cloth;
  std::vector<SurfaceTriangle> triangles;  // by place
  cloth::SelfContactTables tables;

  SelfContactTablesTest() {
    const auto flat = [](float u, float v) { return Vec3{u, 0, v}; };
    cloth.add_sheet(13, 9, 0.01f, 1, {}, flat);
    cloth.add_sheet(4, 6, 0.02f, 1, {}, flat);
    for (uint32_t t : pbd::tree_order(cloth.triangles, cloth.rest)) {
      const SurfaceTriangle none{pbd::no_index, pbd::no_index, pbd::no_index, 0};
      triangles.push_back(t == pbd::no_index ? none : cloth.triangles[t]);
    }
    tables = cloth::build_tables(triangles, cloth.rest, 2);
  }

  static std::array<uint32_t, 3> corners(const SurfaceTriangle& t) { return {t.a, t.b, t.c}; }
  bool has(size_t place, uint16_t bit, uint32_t k) const { return (tables.features[place] >> k & bit) != 0; }
};

TEST_F(SelfContactTablesTest, EachFeatureIsOwnedOnce) {
  std::map<uint32_t, int> vertices;
  std::map<std::pair<uint32_t, uint32_t>, int> edges, uses, borders;
  for (size_t place = 0; place < triangles.size(); ++place) {
    if (triangles[place].a == pbd::no_index) {
      EXPECT_EQ(tables.features[place], 0);
      continue;
    }
    const auto c = corners(triangles[place]);
    for (uint32_t k = 0; k < 3; ++k) {
      const std::pair<uint32_t, uint32_t> edge = std::minmax(c[k], c[(k + 1) % 3]);
      vertices[c[k]] += has(place, cloth::owns_vertex, k);
      edges[edge] += has(place, cloth::owns_edge, k);
      borders[edge] += has(place, cloth::is_border, k);
      ++uses[edge];
    }
  }
  EXPECT_EQ(vertices.size(), cloth.vertices.size());
  for (const auto& [v, times] : vertices) EXPECT_EQ(times, 1) << "vertex " << v;
  for (const auto& [e, times] : edges) EXPECT_EQ(times, 1) << "edge " << e.first << ", " << e.second;
  for (const auto& [e, times] : uses) EXPECT_EQ(borders[e], times == 1) << e.first << ", " << e.second;
}

TEST_F(SelfContactTablesTest, GroupsThatShareAVertexAreNeighbours) {
  std::map<uint32_t, std::set<uint32_t>> groups;  // by vertex
  for (uint32_t place = 0; place < triangles.size(); ++place)
    if (triangles[place].a != pbd::no_index)
      for (uint32_t v : corners(triangles[place])) groups[v].insert(place / 8);
  std::set<std::pair<uint32_t, uint32_t>> expected, found;
  for (const auto& [v, of] : groups)
    for (uint32_t a : of)
      for (uint32_t b : of) expected.insert({a, b});
  for (uint32_t g = 0; g < triangles.size() / 8; ++g)
    for (uint32_t n = tables.neighbour_start[g]; n < tables.neighbour_start[g + 1]; ++n)
      found.insert({g, tables.neighbours[n]});
  EXPECT_EQ(found, expected);
  EXPECT_EQ(found.size(), tables.neighbours.size());
}

TEST_F(SelfContactTablesTest, FinenessIsTheLeastHeight) {
  EXPECT_NEAR(tables.fineness[0], 0.01f / std::sqrt(2.0f), 1e-6f);
  EXPECT_NEAR(tables.fineness[1], 0.02f / std::sqrt(2.0f), 1e-6f);
}

}  // namespace
}  // namespace meniscus::tests
