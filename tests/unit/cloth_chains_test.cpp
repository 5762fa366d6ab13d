// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#include "cloth/chains.h"

#include <gtest/gtest.h>

#include <set>
#include <utility>

#include "cloth/yarns.h"

namespace meniscus::cloth {
namespace {

std::set<std::pair<uint32_t, uint32_t>> ends_of(const std::vector<EdgeConstraint>& edges) {
  std::set<std::pair<uint32_t, uint32_t>> ends;
  for (const EdgeConstraint& e : edges) ends.insert({e.a, e.b});
  return ends;
}

/// Takes the chains; no two edges of a colour share a vertex, and none is lost.
Coloured<EdgeConstraint> chains_of(ClothConstraints& constraints, size_t vertices) {
  const auto before = ends_of(constraints.edges.items);
  const Coloured<EdgeConstraint> chains = take_chains(constraints, vertices);
  if (chains.items.empty()) return chains;
  EXPECT_TRUE(constraints.edges.items.empty());
  EXPECT_EQ(ends_of(chains.items), before);
  for (uint32_t c = 0; c < chains.colours(); ++c) {
    std::set<uint32_t> seen;
    for (uint32_t k = chains.colour_starts[c]; k < chains.colour_starts[c + 1]; ++k)
      for (uint32_t v : {chains.items[k].a, chains.items[k].b})
        EXPECT_TRUE(seen.insert(v).second) << "vertex " << v << " twice in colour " << c;
  }
  return chains;
}

ClothConstraints with_edges(const std::vector<std::pair<uint32_t, uint32_t>>& ends) {
  ClothConstraints constraints;
  for (const auto& [a, b] : ends) constraints.edges.items.push_back({a, b, 1, 0});
  constraints.edges.colour_starts.push_back(static_cast<uint32_t>(ends.size()));
  return constraints;
}

TEST(Chains, ASheetsDiagonalsHaveTwoColours) {
  const ClothMesh mesh = make_sheet(1, 1, 9, 7);
  ClothConstraints constraints = build_constraints(mesh, {.shear_stiffness = 100});
  draw_yarns(constraints, mesh.vertices, {});
  ASSERT_EQ(constraints.edges.items.size(), 8u * 6u);
  EXPECT_EQ(chains_of(constraints, mesh.vertices.size()).colours(), 2u);
}

TEST(Chains, ARingOfFiveNeedsAThird) {
  ClothConstraints constraints = with_edges({{0, 1}, {1, 2}, {2, 3}, {3, 4}, {0, 4}});
  EXPECT_EQ(chains_of(constraints, 5).colours(), 3u);
}

TEST(Chains, WhereThreeMeetThereAreNone) {
  ClothConstraints constraints = with_edges({{0, 1}, {0, 2}, {0, 3}});
  EXPECT_EQ(chains_of(constraints, 4).items.size(), 0u);
  EXPECT_EQ(constraints.edges.items.size(), 3u);
}

}  // namespace
}  // namespace meniscus::cloth
