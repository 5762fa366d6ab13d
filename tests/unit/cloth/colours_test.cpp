// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tests of the constraints that are solved by colours.
#include <gtest/gtest.h>

#include <set>
#include <utility>

#include "cloth/build/chains.h"
#include "cloth/build/clusters.h"
#include "cloth/solve/colour_kernel.h"
#include "pbd/device/cpu/cpu_device.h"
#include "tests/unit/cloth/crumpled_vertices.h"
#include "tests/unit/cloth/one_lane.h"

namespace meniscus::cloth {
namespace {

/// What is left to clusters and colours of a sheet whose warp and weft are chains.
Clusters left_of(const ClothMesh& mesh) {
  ClothConstraints constraints =
      build_constraints(mesh, {.shear_stiffness = 100, .bending_stiffness = 1e-5f});
  const auto count = static_cast<uint32_t>(mesh.vertices.size());
  draw_chains(constraints, mesh.vertices, std::vector<Piece>{{.first_vertex = 0, .end_vertex = count}});
  return build_clusters(constraints, mesh.vertices);
}

TEST(Colours, OfASheetsDiagonalsAreTwo) {
  const Clusters all = left_of(make_sheet(1, 1, 60, 50));
  ASSERT_EQ(all.colour_starts.size(), 3u);
  EXPECT_EQ(all.edges.size(), 59u * 49u);
  EXPECT_EQ(all.colour_starts.back(), all.edges.size());
  for (size_t colour = 0; colour < 2; ++colour) {
    std::set<uint32_t> seen;
    for (uint32_t k = all.colour_starts[colour]; k < all.colour_starts[colour + 1]; ++k) {
      EXPECT_TRUE(seen.insert(all.edges[k].a).second);
      EXPECT_TRUE(seen.insert(all.edges[k].b).second);
    }
    EXPECT_GT(seen.size(), 59u * 49u / 2);
  }
  for (const Batch& batch : all.batches) EXPECT_LT(batch.kind, ConstraintKind::strain);
  EXPECT_EQ(all.pass_starts.size(), all.bending_passes + 1);
}

TEST(Colours, ThatAreManyAreLeftToClusters) {
  const ClothMesh mesh = make_sheet(1, 1, 20, 20);
  const Clusters all = build_clusters(build_constraints(mesh, {}), mesh.vertices);
  EXPECT_TRUE(all.colour_starts.empty());
  EXPECT_GT(all.pass_starts.size(), all.bending_passes + 1);
}

struct Crumpled {
  ClothMesh mesh = make_sheet(1, 1, 41, 38);
  Clusters all = left_of(mesh);
  CrumpledVertices vertices{mesh};
  std::vector<pbd::Vec4> multiplier{all.edges.size(), {0, 0, 0, 1e-5f}};

  /// Calls run(kernel, count) for each colour, from the last substep's multipliers and then from those that
  /// came of it.
  template <class Run>
  std::vector<float> swept(const Run& run) {
    for (bool starts : {true, false}) {
      for (size_t colour = 0; colour + 1 < all.colour_starts.size(); ++colour) {
        const uint32_t first = all.colour_starts[colour];
        run(SolveColour{{.edges = view_of(std::as_const(all.edges)).from(first),
                         .multiplier = view_of(multiplier).from(first),
                         .relaxation = 1.2f,
                         .fraction = starts ? 0.9f : 1,
                         .momentum = starts ? 0 : cloth_tuning::round_momentum,
                         .shears = starts,
                         .loaded = {},
                         .ends = !starts,
                         .next_fraction = 0.7f},
                        vertices.state()},
            all.colour_starts[colour + 1] - first);
      }
    }
    return numbers_of({&vertices.position, &vertices.moved, &multiplier});
  }
};

TEST(Colours, EdgesSideBySideAreSolvedAsEachAlone) {
  const auto alone = Crumpled().swept([](const SolveColour& solve, uint32_t count) {
    for (uint32_t k = 0; k < count; ++k) solve.run(pbd::SideBySide<tests::OneLane>(k, k + 1));
  });
  for (const auto registers : {pbd::CpuDevice::Registers::widest, pbd::CpuDevice::Registers::baseline}) {
    pbd::CpuDevice device(2, registers);
    const auto together = Crumpled().swept(
        [&](const SolveColour& solve, uint32_t count) { device.parallel_for_lanes("colour", count, solve); });
    EXPECT_EQ(together, alone);
  }
  EXPECT_NE(alone, Crumpled().swept([](const SolveColour&, uint32_t) {}));
}

}  // namespace
}  // namespace meniscus::cloth
