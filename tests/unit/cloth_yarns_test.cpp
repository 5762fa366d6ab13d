// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#include "cloth/yarns.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "cloth/topology.h"
#include "cloth/tridiagonal.h"
#include "tests/unit/cloth_shapes.h"

namespace meniscus::cloth {
namespace {

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
  Yarns yarns;
};

/// Edges are chained up in yarns, those of a layer share no vertex, and none is lost.
Drawn draw(const ClothMesh& mesh, const FabricParameters& fabric, std::span<const Piece> pieces = {}) {
  Drawn d{build_constraints(mesh, fabric), {}, {}};
  d.left = d.before;
  d.yarns = draw_yarns(d.left, mesh.vertices, pieces);
  std::vector<uint32_t> layer_of(mesh.vertices.size(), none);
  for (uint32_t layer = 0; layer < d.yarns.layers(); ++layer) {
    for (uint32_t y = d.yarns.layer_starts[layer]; y < d.yarns.layer_starts[layer + 1]; ++y) {
      const Yarn yarn = d.yarns.yarns[y];
      EXPECT_GE(yarn.count, Yarn::fewest_edges);
      EXPECT_LE(yarn.count, Yarn::most_edges);
      for (uint32_t k = yarn.first; k < yarn.first + yarn.count; ++k) {
        const EdgeConstraint& e = d.yarns.edges[k];
        if (k > yarn.first) EXPECT_EQ(e.a, d.yarns.edges[k - 1].b);
        for (uint32_t v : {e.a, e.b}) {
          if (v == e.a && k > yarn.first) continue;
          EXPECT_NE(layer_of[v], layer) << "vertex " << v << " is in two yarns";
          layer_of[v] = layer;
        }
      }
    }
  }
  std::vector<EdgeConstraint> all = d.yarns.edges;
  all.insert(all.end(), d.left.edges.items.begin(), d.left.edges.items.end());
  EXPECT_EQ(lengths(all), lengths(d.before.edges.items));
  return d;
}

TEST(Yarns, OfASheetAreItsWarpAndWeft) {
  const Drawn d = draw(make_sheet(1, 0.8f, 20, 15), {.shear_stiffness = 100});
  EXPECT_EQ(d.yarns.layers(), 2u);
  EXPECT_EQ(d.yarns.yarns.size(), 20u + 15u);
  EXPECT_EQ(d.yarns.edges.size(), 20u * 14u + 15u * 19u);
  std::multiset<uint32_t> counts;
  for (const Yarn& y : d.yarns.yarns) counts.insert(y.count);
  EXPECT_EQ(counts.count(14), 20u);
  EXPECT_EQ(counts.count(19), 15u);
}

TEST(Yarns, OfAPatchOfTrianglesRunInThreeDirections) {
  const Drawn d = draw(equilateral_patch(0.1f, 30, 30), {});
  EXPECT_EQ(d.yarns.layers(), 3u);
  EXPECT_GT(d.yarns.edges.size(), 0.9 * static_cast<double>(d.before.edges.items.size()));
}

TEST(Yarns, RingsOfATubeAreOpenAtOneEdge) {
  const Drawn d = draw(tube(0.3f, 1, 24, 9), {.shear_stiffness = 100});
  EXPECT_GE(d.yarns.edges.size(), 9u * 23u + 24u * 8u);
}

TEST(Yarns, LongOnesAreCut) {
  const uint32_t columns = 2 * Yarn::most_edges + 100;
  const Drawn d = draw(make_sheet(10, 0.05f, columns, 6), {.shear_stiffness = 100});
  uint32_t along = 0;
  for (const Yarn& y : d.yarns.yarns) along += y.count > 5 ? 1 : 0;
  EXPECT_EQ(along, 3u * 6u);
  EXPECT_EQ(d.yarns.edges.size(), 6u * (columns - 3) + 5u * columns);
}

TEST(Yarns, SoftEdgesAreNone) {
  const Drawn d = draw(make_sheet(1, 1, 12, 12), {.weft_stiffness = 10, .shear_stiffness = 10});
  EXPECT_EQ(d.yarns.layers(), 1u);
  EXPECT_EQ(d.yarns.edges.size(), 12u * 11u);
}

TEST(Yarns, ThereAreNoneWhereThereIsGasInside) {
  const ClothMesh mesh = make_sheet(1, 1, 12, 12);
  const Piece blown_up[] = {{.first_vertex = 0, .end_vertex = 144, .inside = 1}};
  EXPECT_TRUE(draw(mesh, {}, blown_up).yarns.edges.empty());
}

TEST(Yarns, ASeamIsPartOfNone) {
  const ClothMesh mesh = make_sheet(1, 1, 12, 12);
  ClothConstraints all = build_constraints(mesh, {.shear_stiffness = 100});
  all.edges.items.push_back({11, 132, 0.0f, 0});  // from corner to corner
  all.edges.colour_starts.push_back(static_cast<uint32_t>(all.edges.items.size()));
  draw_yarns(all, mesh.vertices, {});
  const std::vector<EdgeConstraint>& left = all.edges.items;
  EXPECT_TRUE(std::any_of(left.begin(), left.end(), [](const EdgeConstraint& e) { return e.b == 132; }));
}

/// Several threads, one after the other.
struct ManyThreads {
  static constexpr bool is_one_thread = false;
  template <class F>
  void for_each(uint32_t count, const F& f) const {
    for (uint32_t i = 0; i < count; ++i) f(i);
  }
};
struct OneThread : ManyThreads {
  static constexpr bool is_one_thread = true;
};

/// What the solution leaves of the right-hand side, over the largest term.
template <class Group>
double tridiagonal_residual(uint32_t n) {
  std::mt19937 bits(n);
  std::uniform_real_distribution<float> mass(0.5f, 2), turn(-1, 1);
  std::vector<float> w(n + 1);
  for (float& x : w) x = mass(bits);
  std::vector<TridiagonalRow<float>> rows(n), other(n);
  for (uint32_t i = 0; i < n; ++i) {
    const float before = i ? -w[i] * (1 - 0.1f * std::fabs(turn(bits))) : 0;
    rows[i] = {before, 1.003f * (w[i] + w[i + 1]), i + 1 < n ? -w[i + 1] : 0, turn(bits)};
  }
  const std::vector<TridiagonalRow<float>> given = rows;
  const TridiagonalRow<float>* solved = solve_tridiagonal(Group{}, rows.data(), other.data(), n);
  const auto x = [&](uint32_t i) { return i < n ? double{solved[i].right} : 0; };
  double most = 0, largest = 0;
  for (uint32_t i = 0; i < n; ++i) {
    const TridiagonalRow<float>& r = given[i];
    most = std::max(most, std::fabs(r.lower * x(i - 1) + r.diagonal * x(i) + r.upper * x(i + 1) - r.right));
    largest = std::max(largest, std::fabs(r.diagonal * x(i)));
  }
  return most / largest;
}

TEST(Tridiagonal, IsSolvedByOneThreadAndByMany) {
  for (uint32_t n : {1u, 2u, 3u, 7u, 64u, 100u, 512u}) {
    EXPECT_LT(tridiagonal_residual<OneThread>(n), 1e-6) << n;
    EXPECT_LT(tridiagonal_residual<ManyThreads>(n), 1e-6) << n;
  }
}

}  // namespace
}  // namespace meniscus::cloth
