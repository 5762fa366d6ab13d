// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tests of the colouring of constraints, and of the merge of pieces.
#include "cloth/build/colouring.h"

#include <gtest/gtest.h>

#include "cloth/build/merge.h"
#include "cloth/build/topology.h"
#include "tests/expect_error.h"
#include "tests/unit/cloth/cloth_shapes.h"

namespace meniscus::cloth {
namespace {

using tests::expect_error;

std::vector<uint32_t> vertices_of(const EdgeConstraint& e) {
  return {e.a, e.b};
}
std::vector<uint32_t> vertices_of(const StrainConstraint& s) {
  return {s.a, s.b, s.c};
}
std::vector<uint32_t> vertices_of(const HingeConstraint& h) {
  return {h.a, h.b, h.c, h.d};
}

// No two constraints of a colour share a vertex; no colour is empty, or much smaller than the rest.
template <class Constraint>
void expect_coloured(const Coloured<Constraint>& all, size_t vertices, double least_share) {
  ASSERT_EQ(all.colour_starts.front(), 0u);
  ASSERT_EQ(all.colour_starts.back(), all.items.size());
  std::vector<uint32_t> seen(vertices, none);
  for (uint32_t c = 0; c < all.colours(); ++c) {
    const uint32_t size = all.colour_starts[c + 1] - all.colour_starts[c];
    EXPECT_GE(size, least_share * static_cast<double>(all.items.size()) / all.colours()) << c;
    for (uint32_t i = all.colour_starts[c]; i < all.colour_starts[c + 1]; ++i) {
      for (uint32_t v : vertices_of(all.items[i])) {
        ASSERT_NE(seen[v], c) << "two constraints of the colour share a vertex";
        seen[v] = c;
      }
    }
  }
}

struct Colours {
  uint32_t edges, strains, hinges;
};

Colours expect_coloured(const ClothMesh& mesh, double least_share) {
  const size_t n = mesh.vertices.size();
  const auto angles =
      build_constraints(mesh, {.bending_stiffness = 1, .strain_triangles = true, .dihedral = true});
  const auto edges = build_constraints(mesh, {.bending_stiffness = 1});
  expect_coloured(edges.edges, n, least_share);
  expect_coloured(angles.strains, n, least_share);
  expect_coloured(angles.hinges, n, least_share);
  return {edges.edges.colours(), angles.strains.colours(), angles.hinges.colours()};
}

TEST(Colouring, OfASheetIsNearTheLeastPossible) {
  const Colours colours = expect_coloured(make_sheet(1, 1, 60, 50), 0.9);
  EXPECT_EQ(colours.edges, 6u);
  EXPECT_LE(colours.strains, 7u);
  EXPECT_LE(colours.hinges, 13u);  // 12 meet at a vertex
}

TEST(Colouring, OfAShuffledSheetIsNotMuchWorse) {
  const Colours colours = expect_coloured(shuffled(make_sheet(1, 1, 60, 50), 4), 0.3);
  EXPECT_LE(colours.edges, 7u);
  EXPECT_LE(colours.strains, 7u);
  EXPECT_LE(colours.hinges, 14u);
}

TEST(Colouring, OfAClosedMeshIsProper) {
  expect_coloured(octahedron(), 0);
  expect_coloured(tube(1, 1, 31, 20), 0.3);
}

TEST(Colouring, OfAWheelHasAColourForEachSpoke) {
  // More than fit into the bits of a word.
  constexpr uint32_t spokes = 150;
  ClothMesh mesh;
  mesh.vertices.push_back({0, 0, 0});
  for (uint32_t i = 0; i < spokes; ++i) {
    const float a = 2 * std::numbers::pi_v<float> * static_cast<float>(i) / spokes;
    mesh.vertices.push_back({std::cos(a), 0, -std::sin(a)});
    mesh.triangles.push_back({0, 1 + i, 1 + (i + 1) % spokes});
  }
  const Colours colours = expect_coloured(mesh, 0);
  EXPECT_EQ(colours.edges, spokes);
  EXPECT_EQ(colours.strains, spokes);
  EXPECT_EQ(colours.hinges, spokes);
}

TEST(Colouring, IsTheSameEachTimeAndNamesNoColourInVain) {
  std::vector<std::array<uint32_t, 3>> triangles = shuffled(make_sheet(1, 1, 40, 40), 8).triangles;
  const std::span<const std::array<uint32_t, 3>> view = triangles;
  const auto first = colour_constraints(view, 1600), second = colour_constraints(view, 1600);
  EXPECT_EQ(first, second);
  std::vector<bool> used(*std::max_element(first.begin(), first.end()) + 1);
  for (uint32_t c : first) used[c] = true;
  EXPECT_EQ(std::count(used.begin(), used.end(), false), 0);
  EXPECT_TRUE(colour_constraints(view.first(0), 0).empty());
}

TEST(Colouring, KeepsColoursInTheOrderOfVertices) {
  const auto constraints = build_constraints(shuffled(make_sheet(1, 1, 20, 20), 2),
                                             {.bending_stiffness = 1, .strain_triangles = true});
  const auto expect_ascending = [](const auto& all, const auto& key) {
    for (uint32_t c = 0; c < all.colours(); ++c) {
      EXPECT_TRUE(std::is_sorted(all.items.begin() + all.colour_starts[c],
                                 all.items.begin() + all.colour_starts[c + 1],
                                 [&](const auto& s, const auto& t) { return key(s) < key(t); }));
    }
  };
  expect_ascending(constraints.strains, [](const StrainConstraint& s) { return std::min({s.a, s.b, s.c}); });
}

TEST(Merge, NumbersVerticesPieceAfterPiece) {
  const FabricParameters fabric{.bending_stiffness = 1e-3f};
  const std::vector<ClothConstraints> pieces{
      build_constraints(make_sheet(1, 1, 8, 8), fabric), build_constraints(tube(1, 1, 9, 4), fabric),
      build_constraints(octahedron(), {.bending_stiffness = 1, .strain_triangles = true})};
  const ClothConstraints all = merge(pieces);
  ASSERT_EQ(all.masses.size(), 64u + 36 + 6);
  EXPECT_EQ(all.masses[64], pieces[1].masses[0]);
  EXPECT_EQ(all.edges.items.size(), pieces[0].edges.items.size() + pieces[1].edges.items.size());
  EXPECT_EQ(all.hinges.items.size(), pieces[1].hinges.items.size() + pieces[2].hinges.items.size());
  EXPECT_EQ(all.strains.items.size(), 8u);
  EXPECT_EQ(all.edges.colours(), std::max(pieces[0].edges.colours(), pieces[1].edges.colours()));
  expect_coloured(all.edges, all.masses.size(), 0);
  expect_coloured(all.strains, all.masses.size(), 0);
  expect_coloured(all.hinges, all.masses.size(), 0);
  for (const StrainConstraint& s : all.strains.items) EXPECT_GE(std::min({s.a, s.b, s.c}), 100u);
  for (const EdgeConstraint& e : all.edges.items) EXPECT_EQ(e.a < 64, e.b < 64);
  EXPECT_TRUE(merge({}).masses.empty());
}

TEST(Merge, SeamsTakeFreeColours) {
  const std::vector<ClothConstraints> pieces(2, build_constraints(make_sheet(1, 1, 10, 10), {}));
  ClothConstraints all = merge(pieces);
  const uint32_t colours = all.edges.colours();
  std::vector<EdgeConstraint> seams;
  for (uint32_t i = 0; i < 10; ++i) seams.push_back({90 + i, 100 + i, 0.01f, 1e-4f});
  add_seams(all, seams);
  EXPECT_EQ(all.edges.items.size(), 2 * pieces[0].edges.items.size() + 10);
  EXPECT_EQ(all.edges.colours(), colours);  // vertices of the border have colours to spare
  expect_coloured(all.edges, 200, 0.5);
  int found = 0;
  for (const EdgeConstraint& e : all.edges.items) found += e.a < 100 && e.b >= 100 && e.compliance == 1e-4f;
  EXPECT_EQ(found, 10);
}

TEST(Merge, ManySeamsAtAVertexTakeNewColours) {
  ClothConstraints all = build_constraints(make_sheet(1, 1, 10, 10), {});
  std::vector<EdgeConstraint> seams;
  for (uint32_t i = 0; i < 8; ++i) seams.push_back({55, 80 + i, 0, 0});
  add_seams(all, seams);
  expect_coloured(all.edges, 100, 0);
  EXPECT_GE(all.edges.colours(), 14u);
}

TEST(Merge, SeamsThatCannotBeAreRefused) {
  ClothConstraints all = build_constraints(make_sheet(1, 1, 3, 3), {});
  const size_t before = all.edges.items.size();
  const auto refused = [&](const char* named, const EdgeConstraint& seam) {
    const std::vector<EdgeConstraint> seams{{0, 8, 0, 0}, seam};
    expect_error(ErrorCode::invalid_argument, named, [&] { add_seams(all, seams); });
  };
  refused("seam 1 has the vertex 9", {0, 9, 0, 0});
  refused("vertex 4 at both ends", {4, 4, 0, 0});
  refused("length", {0, 4, -1, 0});
  refused("compliance", {0, 4, 0, -1});
  EXPECT_EQ(all.edges.items.size(), before);
}

}  // namespace
}  // namespace meniscus::cloth
