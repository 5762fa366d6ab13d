// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tests of how the edges of cloth are joined to chains.
#include "cloth/build/chains.h"

#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <set>
#include <type_traits>
#include <utility>

#include "cloth/build/topology.h"
#include "cloth/solve/chain_kernel.h"
#include "cloth/solve/tridiagonal.h"
#include "pbd/device/cpu/cpu_device.h"
#include "tests/unit/cloth/cloth_shapes.h"
#include "tests/unit/cloth/one_lane.h"

namespace meniscus::cloth {
namespace {

using tests::ManyThreads;
using tests::OneThread;

using Ends = std::pair<uint32_t, uint32_t>;

Ends ends(const EdgeConstraint& e) {
  return {std::min(e.a, e.b), std::max(e.a, e.b)};
}

std::map<Ends, float> lengths(const std::vector<EdgeConstraint>& edges) {
  std::map<Ends, float> all;
  for (const EdgeConstraint& e : edges) {
    EXPECT_TRUE(all.emplace(ends(e), e.rest_length).second) << e.a << " to " << e.b << " is there twice";
  }
  return all;
}

struct Drawn {
  ClothConstraints before, left;
  Chains chains;
};

/// Checks that all edges belong to chains, and that chains of a layer share no vertex.
Drawn draw(const ClothMesh& mesh, const FabricParameters& fabric, float gas = 0) {
  Drawn d{build_constraints(mesh, fabric), {}, {}};
  d.left = d.before;
  const auto count = static_cast<uint32_t>(mesh.vertices.size());
  d.chains = draw_chains(d.left, mesh.vertices,
                         std::vector<Piece>{{.first_vertex = 0, .end_vertex = count, .inside = gas}});
  std::vector<uint32_t> layer_of(mesh.vertices.size(), none);
  for (uint32_t layer = 0; layer < d.chains.layers(); ++layer) {
    for (uint32_t y = d.chains.layer_starts[layer]; y < d.chains.layer_starts[layer + 1]; ++y) {
      const Chain chain = d.chains.chains[y];
      EXPECT_GE(chain.count, Chain::fewest_edges);
      EXPECT_LE(chain.count, Chain::most_edges);
      for (uint32_t k = chain.first; k < chain.first + chain.count; ++k) {
        const EdgeConstraint& e = d.chains.edges[k];
        if (k > chain.first) {
          EXPECT_EQ(e.a, d.chains.edges[k - 1].b);
        }
        for (uint32_t v : {e.a, e.b}) {
          if (v == e.a && k > chain.first) continue;
          EXPECT_NE(layer_of[v], layer) << "vertex " << v << " is in two chains";
          layer_of[v] = layer;
        }
      }
    }
  }
  std::vector<EdgeConstraint> all = d.chains.edges;
  all.insert(all.end(), d.left.edges.items.begin(), d.left.edges.items.end());
  EXPECT_EQ(lengths(all), lengths(d.before.edges.items));
  return d;
}

TEST(Chains, OfASheetAreItsWarpAndWeft) {
  const Drawn d = draw(make_sheet(1, 0.8f, 20, 15), {.shear_stiffness = 100});
  EXPECT_EQ(d.chains.layers(), 2u);
  EXPECT_EQ(d.chains.chains.size(), 20u + 15u);
  EXPECT_EQ(d.chains.edges.size(), 20u * 14u + 15u * 19u);
  std::multiset<uint32_t> counts;
  for (const Chain& y : d.chains.chains) counts.insert(y.count);
  EXPECT_EQ(counts.count(14), 20u);
  EXPECT_EQ(counts.count(19), 15u);
}

TEST(Chains, OfAPatchOfTrianglesRunInThreeDirections) {
  const Drawn d = draw(equilateral_patch(0.1f, 30, 30), {});
  EXPECT_EQ(d.chains.layers(), 3u);
  EXPECT_GT(d.chains.edges.size(), 0.9 * static_cast<double>(d.before.edges.items.size()));
}

TEST(Chains, RingsOfATubeAreOpenAtOneEdge) {
  const Drawn d = draw(tube(0.3f, 1, 24, 9), {.shear_stiffness = 100});
  EXPECT_GE(d.chains.edges.size(), 9u * 23u + 24u * 8u);
}

TEST(Chains, LongOnesAreCut) {
  const uint32_t columns = 2 * Chain::most_edges + 100;
  const Drawn d = draw(make_sheet(10, 0.05f, columns, 6), {.shear_stiffness = 100});
  uint32_t along = 0;
  for (const Chain& y : d.chains.chains) along += y.count > 5 ? 1 : 0;
  EXPECT_EQ(along, 3u * 6u);
  EXPECT_EQ(d.chains.edges.size(), 6u * (columns - 3) + 5u * columns);
}

TEST(Chains, AreCutWhereTheyAreLongerThanTheMost) {
  for (const uint32_t edges : {511u, 512u, 513u, 514u, 515u, 1025u, 1026u, 1027u, 1028u}) {
    SCOPED_TRACE(edges);
    const Drawn d = draw(make_sheet(10, 0.02f, edges + 1, 2), {.shear_stiffness = 100});
    const uint32_t cuts = edges / (Chain::most_edges + 1);
    EXPECT_EQ(d.chains.chains.size(), 2 * (cuts + 1));
    EXPECT_EQ(d.chains.edges.size(), 2 * (edges - cuts));
  }
}

TEST(Chains, OfAPatchWithoutAGrainAreSoftEdgesAsWell) {
  const FabricParameters fabric{.warp_stiffness = 20000, .weft_stiffness = 20000, .shear_stiffness = 100};
  const Drawn d = draw(equilateral_patch(0.1f, 30, 30), fabric);
  EXPECT_EQ(d.chains.layers(), 3u);
  EXPECT_GT(d.chains.edges.size(), 0.9 * static_cast<double>(d.before.edges.items.size()));
}

TEST(Chains, OfASheetWithASoftWeftRunAlongThatAsWell) {
  const Drawn d = draw(make_sheet(1, 1, 12, 12), {.weft_stiffness = 10, .shear_stiffness = 10});
  const auto of_weft =
      std::count_if(d.chains.edges.begin(), d.chains.edges.end(),
                    [](const EdgeConstraint& e) { return std::max(e.a, e.b) - std::min(e.a, e.b) == 12; });
  EXPECT_GT(of_weft, 12 * 11 * 3 / 4);
}

TEST(Chains, PiecesHaveAGrainOrNoneEachOnItsOwn) {
  ClothMesh both = make_sheet(1, 1, 12, 12);
  both.material.clear();
  const auto shift = static_cast<uint32_t>(both.vertices.size());
  const ClothMesh patch = equilateral_patch(0.1f, 12, 12);
  for (Vec3 v : patch.vertices) both.vertices.push_back(v + Vec3{5, 0, 0});
  for (auto t : patch.triangles) both.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  ClothConstraints all =
      build_constraints(both, {.warp_stiffness = 20000, .weft_stiffness = 20000, .shear_stiffness = 100});
  const auto of_sheet = [&](const std::vector<EdgeConstraint>& edges) {
    return std::count_if(edges.begin(), edges.end(), [&](const EdgeConstraint& e) { return e.a < shift; });
  };
  const Chains chains = draw_chains(all, both.vertices,
                                    std::vector<Piece>{{.first_vertex = 0, .end_vertex = shift},
                                                       {.first_vertex = shift, .end_vertex = 2 * shift}});
  EXPECT_EQ(of_sheet(chains.edges), 2 * 12 * 11);
  const std::vector<EdgeConstraint>& left = all.edges.items;
  EXPECT_LT(static_cast<double>(left.size()) - static_cast<double>(of_sheet(left)),
            0.15 * static_cast<double>(chains.edges.size()));
}

TEST(Chains, ThereAreNoneWhereThereIsGasInside) {
  EXPECT_TRUE(draw(make_sheet(1, 1, 12, 12), {}, 1).chains.edges.empty());
}

TEST(Chains, ASeamIsPartOfNone) {
  const ClothMesh mesh = make_sheet(1, 1, 12, 12);
  ClothConstraints all = build_constraints(mesh, {.shear_stiffness = 100});
  all.edges.items.push_back({11, 132, 0.0f, 0});  // from corner to corner
  all.edges.colour_starts.push_back(static_cast<uint32_t>(all.edges.items.size()));
  draw_chains(all, mesh.vertices, {});
  const std::vector<EdgeConstraint>& left = all.edges.items;
  EXPECT_TRUE(std::any_of(left.begin(), left.end(), [](const EdgeConstraint& e) { return e.b == 132; }));
}

using Row = TridiagonalRow<float>;

/// As chains have them; `own` is what each row has on its diagonal beyond what is beside it.
std::vector<Row> make_rows(uint32_t n, float own) {
  std::mt19937 bits(n);
  std::uniform_real_distribution<float> mass(0.5f, 2), turn(-1, 1);
  std::vector<float> w(n + 1);
  for (float& x : w) x = mass(bits);
  std::vector<Row> rows(n);
  for (uint32_t i = 0; i < n; ++i) {
    const float before = i ? -w[i] * (1 - 0.1f * std::fabs(turn(bits))) : 0;
    rows[i] = {before, 1.003f * (w[i] + w[i + 1]) + own, i + 1 < n ? -w[i + 1] : 0, turn(bits)};
  }
  return rows;
}

/// What the solution leaves of the right-hand side, over the largest term.
template <class Group, Coupling coupling>
double residual(const std::vector<Row>& given) {
  const auto n = static_cast<uint32_t>(given.size());
  std::vector<Row> rows = given, other(n);
  solve_tridiagonal<coupling>(Group{}, rows.data(), other.data(), n);
  const auto x = [&](uint32_t i) { return i < n ? double{rows[i].right} : 0; };
  double most = 0, largest = 0;
  for (uint32_t i = 0; i < n; ++i) {
    const Row& r = given[i];
    most = std::max(most, std::fabs(r.lower * x(i - 1) + r.diagonal * x(i) + r.upper * x(i + 1) - r.right));
    largest = std::max(largest, std::fabs(r.diagonal * x(i)));
  }
  return most / largest;
}

TEST(Tridiagonal, IsSolvedByOneThreadAndByMany) {
  for (uint32_t n : {1u, 2u, 3u, 4u, 5u, 7u, 13u, 64u, 65u, 100u, 250u, 255u, 256u, 257u, 499u, 512u, 513u}) {
    for (float own : {0.0f, 0.3f, 3.0f, 300.0f}) {
      const std::vector<Row> rows = make_rows(n, own);
      EXPECT_LT((residual<OneThread, Coupling::tight>(rows)), 1e-6) << n << ' ' << own;
      EXPECT_LT((residual<ManyThreads, Coupling::tight>(rows)), 1e-6) << n << ' ' << own;
      EXPECT_LT((residual<ManyThreads, Coupling::loose>(rows)), 1e-6) << n << ' ' << own;
    }
  }
}

/// Chains of all lengths in a layer, bent and pulled at random, some of their vertices held.
struct Layer {
  std::vector<Chain> chains;
  std::vector<EdgeConstraint> edges;
  std::vector<pbd::Vec4> position, previous, moved, multiplier, pending;

  Layer() {
    std::mt19937 bits(7);
    std::uniform_real_distribution<float> any(-1, 1);
    for (uint32_t count : {40u, 40u, 33u, 20u, 20u, 11u, 9u, 8u, 8u, 5u, 4u}) {
      chains.push_back({static_cast<uint32_t>(edges.size()), count});
      for (uint32_t k = 0; k <= count; ++k) {
        const auto v = static_cast<uint32_t>(position.size());
        if (k < count) edges.push_back({v, v + 1, 0.1f, k % 3 ? 1e-5f : 0});
        previous.push_back({0.1f * static_cast<float>(k), 0.02f * any(bits), 0.02f * any(bits), 0});
        position.push_back({previous.back().x + 0.02f * any(bits), 0.03f * any(bits), 0.03f * any(bits),
                            bits() % 9 ? 300 + 200 * any(bits) : 0});
        moved.push_back({0, 0, 0, 0});
        pending.push_back({1e-5f * any(bits), 1e-5f * any(bits), 1e-5f * any(bits), 0});
      }
    }
    for (size_t k = 0; k < edges.size(); ++k)
      multiplier.push_back({1e-4f * any(bits), 1e-4f * any(bits), 1e-4f * any(bits), 2e-4f * any(bits)});
  }

  SolveChains solver(ChainStage stage) {
    const auto view = [](auto& values) {
      using T = std::remove_pointer_t<decltype(values.data())>;
      return pbd::View<T>{values.data(), static_cast<uint32_t>(values.size())};
    };
    SolveChains solve{.chains = view(std::as_const(chains)),
                      .edges = view(std::as_const(edges)),
                      .multiplier = view(multiplier),
                      .all = {},
                      .pending = view(pending),
                      .effective_mass = {},
                      .loaded = {},
                      .stage = stage,
                      .first = 0,
                      .end = static_cast<uint32_t>(chains.size())};
    solve.all.particles.position = view(position);
    solve.all.particles.previous = view(std::as_const(previous));
    solve.all.particles.accumulated_delta = view(moved);
    solve.all.damping = {0.002f, 0.002f};
    solve.all.inverse_dt = 300;
    return solve;
  }

  std::vector<float> results() const {
    std::vector<float> all;
    for (const auto* values : {&position, &moved, &multiplier, &pending})
      for (const pbd::Vec4& v : *values) all.insert(all.end(), {v.x, v.y, v.z, v.w});
    return all;
  }
};

/// From no multipliers, for what is pending and then at once; then from those that came of it.
template <class Run>
std::vector<float> solved(const Run& run) {
  Layer layer;
  for (const auto stage : {ChainStage::absorbs_pending, ChainStage::starts, ChainStage::continues})
    run(layer.solver(stage));
  return layer.results();
}

TEST(Chains, SideBySideAreSolvedAsEachAlone) {
  const std::vector<float> alone = solved([](const SolveChains& solve) {
    const auto scratch = std::make_unique<SolveChains::Scratch<OneThread>>();
    for (uint32_t n = 0; n < solve.end; ++n) solve(OneThread{}, *scratch, n);
  });
  for (const auto registers : {pbd::CpuDevice::Registers::widest, pbd::CpuDevice::Registers::baseline}) {
    pbd::CpuDevice device(2, registers);
    const std::vector<float> together = solved(
        [&](const SolveChains& solve) { device.parallel_for_lane_groups("chains", solve.end, solve); });
    EXPECT_EQ(together, alone);
  }
  EXPECT_NE(alone, Layer().results());
}

}  // namespace
}  // namespace meniscus::cloth
