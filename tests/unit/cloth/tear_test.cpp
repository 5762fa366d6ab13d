// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tests of how a torn mesh is split.
#include "cloth/build/tearing.h"

#include <gtest/gtest.h>

#include <set>

#include "cloth/build/build_constraints.h"
#include "cloth/build/topology.h"
#include "tests/expect_error.h"
#include "tests/unit/cloth/cloth_shapes.h"

namespace meniscus::cloth {
namespace {

using tests::expect_error;

// The triangles around each vertex hang together along edges: a surface, with or without a border.
void expect_surface(const ClothMesh& mesh) {
  check_mesh(mesh);
  const VertexTriangles around(mesh);
  for (uint32_t v = 0; v < mesh.vertices.size(); ++v) {
    std::set<uint32_t> rest(around.of(v).begin(), around.of(v).end());
    std::vector<uint32_t> front{*rest.begin()};
    rest.erase(rest.begin());
    while (!front.empty()) {
      const auto t = mesh.triangles[front.back()];
      front.pop_back();
      const std::vector<uint32_t> candidates(rest.begin(), rest.end());
      for (uint32_t other : candidates) {
        const auto& u = mesh.triangles[other];
        const auto shared = std::count_if(
            t.begin(), t.end(), [&](uint32_t w) { return std::find(u.begin(), u.end(), w) != u.end(); });
        if (shared < 2) continue;
        rest.erase(other);
        front.push_back(other);
      }
    }
    EXPECT_TRUE(rest.empty()) << "the triangles at vertex " << v << " hang together at that point alone";
  }
}

uint32_t parts(const ClothMesh& mesh) {
  const std::vector<uint32_t> numbers = connected_parts(mesh);
  return *std::max_element(numbers.begin(), numbers.end()) + 1;
}

// Equal but for the numbers of copies.
void expect_same_triangles(const ClothMesh& torn, const ClothMesh& whole,
                           std::span<const TornVertex> copies) {
  std::vector<uint32_t> original(torn.vertices.size());
  for (uint32_t v = 0; v < original.size(); ++v) original[v] = v;
  for (const TornVertex& t : copies) original[t.copy] = original[t.original];
  ASSERT_EQ(torn.triangles.size(), whole.triangles.size());
  for (size_t k = 0; k < torn.triangles.size(); ++k) {
    const auto& [a, b, c] = torn.triangles[k];
    EXPECT_EQ((std::array{original[a], original[b], original[c]}), whole.triangles[k]) << k;
  }
  for (uint32_t v = 0; v < original.size(); ++v) {
    EXPECT_TRUE(torn.vertices[v] == torn.vertices[original[v]]);
    EXPECT_EQ(torn.material[v], torn.material[original[v]]);
  }
}

double mass_of(const ClothMesh& mesh) {
  double mass = 0;
  for (float m : build_constraints(mesh, {}).masses) mass += m;
  return mass;
}

TEST(Tearing, OpensASlitInsideASheet) {
  const ClothMesh whole = make_sheet(1, 1, 5, 5);
  ClothMesh torn = whole;
  const auto copies = tear(torn, 12, whole.vertices, {1, 0, 0});
  ASSERT_EQ(copies.size(), 1u);
  EXPECT_EQ(copies[0].copy, 25u);
  EXPECT_EQ(copies[0].original, 12u);
  expect_surface(torn);
  expect_same_triangles(torn, whole, copies);
  EXPECT_EQ(parts(torn), 1u);
}

TEST(Tearing, PartsTheTrianglesByTheSideTheyAreOn) {
  const ClothMesh whole = make_sheet(1, 1, 5, 5);
  for (const Vec3 normal : {Vec3{1, 0, 0}, Vec3{0, 0, 1}, Vec3{-1, 0, 0.4f}}) {
    ClothMesh torn = whole;
    ASSERT_EQ(tear(torn, 12, whole.vertices, normal).size(), 1u);
    const VertexTriangles around(torn);
    const auto side_of = [&](uint32_t vertex) {
      std::set<bool> sides;
      for (uint32_t t : around.of(vertex)) {
        Vec3 way{0, 0, 0};
        for (uint32_t v : torn.triangles[t]) way += torn.vertices[v] - torn.vertices[12];
        sides.insert(dot(way, normal) > 0);
      }
      return sides;
    };
    EXPECT_EQ(side_of(12).size(), 1u);
    EXPECT_EQ(side_of(25).size(), 1u);
    EXPECT_NE(side_of(12), side_of(25));
  }
}

TEST(Tearing, SplitsWhatWouldHangAtOnePoint) {
  // A strip one cell wide: when the upper border's middle vertex parts, so does the one below it.
  const ClothMesh whole = make_sheet(4, 1, 5, 2);
  ClothMesh torn = whole;
  const auto copies = tear(torn, 2, whole.vertices, {1, 0, 0});
  EXPECT_EQ(copies.size(), 2u);
  expect_surface(torn);
  expect_same_triangles(torn, whole, copies);
  EXPECT_EQ(parts(torn), 2u);
}

TEST(Tearing, PartsTwoFansThatTouchAtAPoint) {
  ClothMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 1}, {1, 0, -1}, {-1, 0, 1}, {-1, 0, -1}};
  mesh.triangles = {{0, 1, 2}, {0, 4, 3}};
  mesh.material = {{0, 0}, {1, 1}, {1, -1}, {-1, 1}, {-1, -1}};
  const std::vector<Vec3> positions = mesh.vertices;
  EXPECT_EQ(tear(mesh, 0, positions, {0, 1, 0}).size(), 1u);
  EXPECT_EQ(parts(mesh), 2u);
}

TEST(Tearing, LeavesAVertexAloneWhereNothingWouldPart) {
  const ClothMesh whole = make_sheet(1, 1, 4, 4);
  for (const auto& [vertex, normal] : {std::pair{0u, Vec3{1, 0, 0}}, {5u, {0, 1, 0}}, {5u, {0, 0, 0}}}) {
    ClothMesh mesh = whole;
    EXPECT_TRUE(tear(mesh, vertex, whole.vertices, normal).empty());
    EXPECT_EQ(mesh.triangles, whole.triangles);
    EXPECT_EQ(mesh.vertices.size(), whole.vertices.size());
  }
}

TEST(Tearing, AStripComesApart) {
  const ClothMesh whole = make_sheet(2, 0.5f, 21, 6);
  ClothMesh torn = whole;
  std::vector<TornVertex> copies;
  std::vector<Vec3> positions = whole.vertices;
  for (uint32_t row = 0; row < 6; ++row) {
    for (const TornVertex& t : tear(torn, row * 21 + 10, positions, {1, 0, 0})) {
      copies.push_back(t);
      positions.push_back(Vec3(positions[t.original]));
    }
    expect_surface(torn);
    EXPECT_EQ(parts(torn), row < 4 ? 1u : 2u) << row;
  }
  expect_same_triangles(torn, whole, copies);
  EXPECT_EQ(copies.size(), 6u);
  EXPECT_NEAR(mass_of(torn), mass_of(whole), 1e-6 * mass_of(whole));
}

TEST(Tearing, ThePositionsOfNowDecide) {
  // A sheet turned so that its x points up.
  const ClothMesh whole = make_sheet(1, 1, 5, 5);
  std::vector<Vec3> positions;
  for (Vec3 v : whole.vertices) positions.push_back({0, v.x, v.z});
  ClothMesh mesh = whole;
  EXPECT_TRUE(tear(mesh, 12, positions, {1, 0, 0}).empty());
  EXPECT_EQ(tear(mesh, 12, positions, {0, 1, 0}).size(), 1u);
}

TEST(Tearing, TakesTheMostStretchedEdgesFirst) {
  const ClothMesh whole = make_sheet(1, 1, 12, 12);
  const std::vector<OverstretchedEdge> edges{{50, 51, 0.1f}, {88, 89, 0.3f}, {103, 104, 0.2f}};
  ClothMesh torn = whole;
  const auto two = tear_along(torn, whole.vertices, edges, 2);
  ASSERT_EQ(two.size(), 2u);
  EXPECT_TRUE(two[0].original == 88 || two[0].original == 89);
  EXPECT_TRUE(two[1].original == 103 || two[1].original == 104);
  expect_surface(torn);
  ClothMesh torn_all = whole;
  EXPECT_EQ(tear_along(torn_all, whole.vertices, edges, 100).size(), 3u);
  ClothMesh untorn = whole;
  EXPECT_TRUE(tear_along(untorn, whole.vertices, edges, 0).empty());
}

TEST(Tearing, TriesTheEndWithMoreStretchAroundIt) {
  const ClothMesh whole = make_sheet(1, 1, 12, 12);
  ClothMesh torn = whole;
  const std::vector<OverstretchedEdge> edges{{64, 65, 0.3f}, {65, 66, 0.2f}};
  const auto copies = tear_along(torn, whole.vertices, edges, 100);
  ASSERT_EQ(copies.size(), 1u);  // 66 waits
  EXPECT_EQ(copies[0].original, 65u);
}

std::vector<OverstretchedEdge> all_edges(const ClothMesh& mesh) {
  std::vector<OverstretchedEdge> edges;
  const std::vector<EdgeUse> uses = edge_uses(mesh);
  for_each_edge(uses, [&](std::span<const EdgeUse> e) { edges.push_back({e[0].low, e[0].high, 1}); });
  return edges;
}

TEST(Tearing, NeighboursOfASplitVertexWait) {
  const ClothMesh whole = make_sheet(1, 1, 12, 12);
  std::vector<OverstretchedEdge> edges = all_edges(whole);
  std::erase_if(edges, [](const auto& e) { return e.a != 65 && e.b != 65; });
  ASSERT_EQ(edges.size(), 6u);
  ClothMesh torn = whole;
  const auto copies = tear_along(torn, whole.vertices, edges, 1000);
  ASSERT_EQ(copies.size(), 1u);
  EXPECT_EQ(copies[0].original, 65u);  // with the most stretch around it
}

TEST(Tearing, EverywhereAtOnceLeavesASurface) {
  const ClothMesh whole = make_sheet(1, 1, 12, 12);
  ClothMesh torn = whole;
  const auto copies = tear_along(torn, whole.vertices, all_edges(whole), 1000);
  EXPECT_GT(copies.size(), 30u);
  expect_surface(torn);
  expect_same_triangles(torn, whole, copies);
}

// A sheet pulled about at random, torn round after round.
ClothMesh torn_at_random(uint32_t seed, std::vector<TornVertex>& copies) {
  ClothMesh mesh = make_sheet(1, 1, 20, 20);
  std::mt19937 bits(seed);
  const auto random = [&] { return static_cast<float>(bits() >> 8) / 16777216.0f; };
  for (int round = 0; round < 40; ++round) {
    std::vector<Vec3> positions;
    for (Vec3 v : mesh.vertices) positions.push_back(v + 0.1f * Vec3{random(), random(), random()});
    std::vector<OverstretchedEdge> edges;
    const std::vector<EdgeUse> uses = edge_uses(mesh);
    for_each_edge(uses, [&](std::span<const EdgeUse> e) {
      const float stretch = length(positions[e[0].high] - positions[e[0].low]) /
                            length(mesh.vertices[e[0].high] - mesh.vertices[e[0].low]);
      if (stretch > 1.8f) edges.push_back({e[0].low, e[0].high, stretch});
    });
    for (const TornVertex& t : tear_along(mesh, positions, edges, 20)) copies.push_back(t);
  }
  return mesh;
}

TEST(Tearing, StaysASurfaceThroughManyTears) {
  const ClothMesh whole = make_sheet(1, 1, 20, 20);
  for (uint32_t seed = 1; seed <= 5; ++seed) {
    std::vector<TornVertex> copies;
    const ClothMesh torn = torn_at_random(seed, copies);
    EXPECT_GT(copies.size(), 300u);
    EXPECT_EQ(torn.vertices.size(), whole.vertices.size() + copies.size());
    expect_surface(torn);
    expect_same_triangles(torn, whole, copies);
    EXPECT_NEAR(mass_of(torn), mass_of(whole), 1e-6);
  }
}

TEST(Tearing, IsTheSameEachTime) {
  std::vector<TornVertex> first, second;
  const ClothMesh a = torn_at_random(9, first), b = torn_at_random(9, second);
  EXPECT_EQ(a.triangles, b.triangles);
}

TEST(Tearing, ComesToAnEnd) {
  ClothMesh mesh = make_sheet(1, 1, 4, 4);
  int rounds = 0;
  for (bool torn = true; torn && rounds < 100; ++rounds) {
    const std::vector<Vec3> positions = mesh.vertices;
    torn = !tear_along(mesh, positions, all_edges(mesh), 100).empty();
  }
  EXPECT_LT(rounds, 30);
  expect_surface(mesh);
  EXPECT_NEAR(area_of(mesh), 1, 1e-6);
  EXPECT_GT(parts(mesh), 9u);  // of 18 triangles: those left have no wide corner to part at
}

TEST(Tearing, RefusesWhatIsNotThere) {
  ClothMesh mesh = make_sheet(1, 1, 3, 3);
  const std::vector<Vec3> positions = mesh.vertices, few(4);
  expect_error(ErrorCode::invalid_argument, "vertex 9", [&] { tear(mesh, 9, positions, {1, 0, 0}); });
  expect_error(ErrorCode::invalid_argument, "4 positions", [&] { tear(mesh, 0, few, {1, 0, 0}); });
  const std::vector<OverstretchedEdge> edges{{0, 11, 1}};
  expect_error(ErrorCode::invalid_argument, "vertex 11", [&] { tear_along(mesh, positions, edges, 1); });
  EXPECT_EQ(mesh.vertices.size(), 9u);
}

}  // namespace
}  // namespace meniscus::cloth
