// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#include "cloth/sweep_kernel.h"

#include <gtest/gtest.h>

#include <memory>
#include <set>
#include <utility>

#include "pbd/device/cpu/cpu_device.h"
#include "tests/unit/cloth_shapes.h"
#include "tests/unit/one_lane.h"

namespace meniscus::cloth {
namespace {

Clusters clusters_of(const ClothMesh& mesh) {
  return build_clusters(build_constraints(mesh, {.bending_stiffness = 1e-5f}), mesh.vertices);
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
  EXPECT_EQ(constraints, all.isometric.size() + all.edges.size());
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

/// A crumpled sheet, of two pieces with damping of their own, some of its vertices held.
struct Crumpled {
  Clusters clusters;
  std::vector<PackedHinge> hinges;
  std::vector<pbd::Vec4> coefficients, hinge_multiplier, edge_multiplier;
  std::vector<pbd::Vec4> position, previous, moved;
  std::vector<pbd::Phase> phase;
  std::vector<Piece> pieces{{.stretch_damping = 0.002f, .bending_damping = 0.01f}, {.stretch_damping = 0}};

  Crumpled() {
    const ClothMesh mesh = make_sheet(1, 1, 40, 40);
    clusters = clusters_of(mesh);
    number_locally(clusters);
    for (const IsometricConstraint& h : clusters.isometric) {
      hinges.push_back(PackedHinge::of(h));
      coefficients.push_back({h.weight[0], h.weight[1], h.weight[2], h.compliance});
    }
    std::mt19937 bits(11);
    std::uniform_real_distribution<float> any(-1, 1);
    const auto near = [&](Vec3 x) { return x + 0.01f * Vec3{any(bits), any(bits), any(bits)}; };
    for (const Vec3& x : mesh.vertices) {
      previous.push_back(pbd::with_w(near(x), 0));
      position.push_back(pbd::with_w(near(x), bits() % 9 ? 300 + 200 * any(bits) : 0));
      phase.push_back(bits() % 2);
    }
    moved.resize(position.size(), {0, 0, 0, 0});
    hinge_multiplier.resize(hinges.size(), {0, 0, 0, 0});
    edge_multiplier.resize(clusters.edges.size(), {0, 0, 0, 1e-5f});
  }

  SolveClusters solver(uint32_t pass, bool starts, bool common_damping) {
    const auto view = [](auto& values) {
      return pbd::View{values.data(), static_cast<uint32_t>(values.size())};
    };
    VertexState all;
    all.particles.position = view(position);
    all.particles.previous = view(std::as_const(previous));
    all.particles.moved = view(moved);
    all.particles.phase = view(std::as_const(phase));
    all.pieces = view(std::as_const(pieces));
    if (common_damping) all.damping = {0.002f, 0.01f};
    all.inverse_dt = 300;
    return {.clusters = view(std::as_const(clusters.clusters)),
            .batches = view(std::as_const(clusters.batches)),
            .numbers = view(std::as_const(clusters.vertices)),
            .all = all,
            .isometric = {view(std::as_const(hinges)), view(std::as_const(coefficients)),
                          view(hinge_multiplier), starts},
            .hinge = {},
            .strain = {},
            .edge = {.edges = view(std::as_const(clusters.edges)),
                     .multiplier = view(edge_multiplier),
                     .relaxation = 1.2f,
                     .share = starts ? 0.9f : 1,
                     .momentum = starts ? 0 : stretch_kernels::round_momentum,
                     .shears = starts,
                     .ends = !starts,
                     .next_share = 0.7f},
            .first = clusters.pass_starts[pass],
            .bends = pass < clusters.bending_passes,
            .backwards = !starts};
  }

  std::vector<float> results() const {
    std::vector<float> all;
    for (const auto* values : {&position, &moved, &hinge_multiplier, &edge_multiplier}) {
      for (const pbd::Vec4& v : *values) all.insert(all.end(), {v.x, v.y, v.z, v.w});
    }
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
