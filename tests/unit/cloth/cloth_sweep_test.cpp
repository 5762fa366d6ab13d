// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tests of clusters, and of their sweep against one constraint at a time.
#include "cloth/solve/sweep_kernel.h"

#include <gtest/gtest.h>

#include <memory>
#include <set>
#include <utility>

#include "pbd/device/cpu/cpu_device.h"
#include "tests/unit/cloth/crumpled_vertices.h"
#include "tests/unit/cloth/one_lane.h"

namespace meniscus::cloth {
namespace {

Clusters clusters_of(const ClothMesh& mesh) {
  return build_clusters(build_constraints(mesh, {.bending_stiffness = 1e-5f, .dihedral = true}),
                        mesh.vertices);
}

uint32_t vertices_of(const Cluster& cluster) {
  return cluster.end_vertex - cluster.first_vertex;
}

TEST(Clusters, OfAPassShareNoVertexAndHoldAll) {
  const ClothMesh mesh = make_sheet(1, 1, 60, 60);
  const Clusters all = clusters_of(mesh);
  size_t constraints = 0;
  for (size_t pass = 0; pass + 1 < all.pass_starts.size(); ++pass) {
    std::set<uint32_t> seen;
    for (uint32_t k = all.pass_starts[pass]; k < all.pass_starts[pass + 1]; ++k) {
      const Cluster& cluster = all.clusters[k];
      EXPECT_LE(vertices_of(cluster), Cluster::most_vertices);
      for (uint32_t v = cluster.first_vertex; v < cluster.end_vertex; ++v)
        EXPECT_TRUE(seen.insert(all.vertices[v]).second) << pass << ": " << all.vertices[v];
      for (uint32_t b = cluster.first_batch; b < cluster.end_batch; ++b) constraints += all.batches[b].count;
    }
  }
  EXPECT_EQ(constraints, all.hinges.size() + all.edges.size());
}

// What the first clusters of a sheet leave are bands, and small crossings of bands.
TEST(Clusters, ThatAreSmallArePutTogether) {
  const Clusters all = clusters_of(make_sheet(1, 1, 100, 100));
  for (size_t pass = 0; pass + 1 < all.pass_starts.size(); ++pass) {
    const uint32_t begin = all.pass_starts[pass], end = all.pass_starts[pass + 1];
    uint32_t vertices = 0;
    for (uint32_t k = begin; k < end; ++k) vertices += vertices_of(all.clusters[k]);
    EXPECT_LE((end - begin - 1) * Cluster::most_vertices / 2, vertices) << pass;
  }
}

struct Crumpled {
  ClothMesh mesh = make_sheet(1, 1, 40, 40);
  Clusters clusters = clusters_of(mesh);
  CrumpledVertices vertices{mesh};
  std::vector<float> hinge_multiplier;
  std::vector<pbd::Vec4> edge_multiplier;

  Crumpled() {
    number_locally(clusters);
    hinge_multiplier.resize(clusters.hinges.size(), 0);
    edge_multiplier.resize(clusters.edges.size(), {0, 0, 0, 1e-5f});
  }

  SolveClusters solver(uint32_t pass, bool starts, bool common_damping) {
    VertexState all = vertices.state();
    if (common_damping) all.damping = {0.002f, 0.01f};
    return {.clusters = view_of(std::as_const(clusters.clusters)),
            .batches = view_of(std::as_const(clusters.batches)),
            .numbers = view_of(std::as_const(clusters.vertices)),
            .all = all,
            .hinge = {view_of(std::as_const(clusters.hinges)), view_of(hinge_multiplier), starts},
            .strain = {},
            .edge = {.edges = view_of(std::as_const(clusters.edges)),
                     .multiplier = view_of(edge_multiplier),
                     .relaxation = 1.2f,
                     .fraction = starts ? 0.9f : 1,
                     .momentum = starts ? 0 : cloth_tuning::round_momentum,
                     .shears = starts,
                     .loaded = {},
                     .ends = !starts,
                     .next_fraction = 0.7f},
            .first = clusters.pass_starts[pass],
            .backwards = !starts};
  }

  std::vector<float> results() const {
    std::vector<float> all = numbers_of({&vertices.position, &vertices.moved, &edge_multiplier});
    all.insert(all.end(), hinge_multiplier.begin(), hinge_multiplier.end());
    return all;
  }
};

/// Two sweeps: from the last substep's multipliers, then on from those that came of it.
template <class Run>
std::vector<float> swept(bool common_damping, const Run& run) {
  Crumpled sheet;
  for (bool starts : {true, false}) {
    const auto passes = static_cast<uint32_t>(sheet.clusters.pass_starts.size() - 1);
    for (uint32_t pass = 0; pass < passes; ++pass) {
      const uint32_t count = sheet.clusters.pass_starts[pass + 1] - sheet.clusters.pass_starts[pass];
      run(sheet.solver(pass, starts, common_damping), count);
    }
  }
  return sheet.results();
}

TEST(Clusters, ConstraintsSideBySideAreSolvedAsEachAlone) {
  for (bool common_damping : {true, false}) {
    const std::vector<float> alone = swept(common_damping, [](const SolveClusters& solve, uint32_t count) {
      const auto scratch = std::make_unique<ClusterScratch>();
      for (uint32_t n = 0; n < count; ++n) {
        solve.prepare(tests::OneThread{}, *scratch, n);
        solve(tests::OneThread{}, *scratch, n);
      }
    });
    for (const auto registers : {pbd::CpuDevice::Registers::widest, pbd::CpuDevice::Registers::baseline}) {
      pbd::CpuDevice device(2, registers);
      const std::vector<float> together =
          swept(common_damping, [&](const SolveClusters& solve, uint32_t count) {
            device.parallel_for_groups("sweep", count, solve);
          });
      EXPECT_EQ(together, alone);
    }
    EXPECT_NE(alone, Crumpled().results());
  }
}

}  // namespace
}  // namespace meniscus::cloth
