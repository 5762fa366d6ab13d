// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tests of the lengths of tethers.
#include "cloth/build/tethers.h"

#include <gtest/gtest.h>

#include <functional>
#include <numeric>

#include "tests/expect_error.h"
#include "tests/unit/cloth/cloth_shapes.h"

namespace meniscus::cloth {
namespace {

std::vector<Tether> unyielding_tethers(const ClothMesh& mesh, std::span<const uint32_t> held) {
  return build_tethers(mesh, held, {});
}

struct Range {
  double least = 1e30, most = 0;
};

// Of the tethers' lengths over what they should be.
Range ratios(const ClothMesh& mesh, const std::vector<uint32_t>& held,
             const std::function<double(uint32_t vertex)>& expected) {
  const std::vector<Tether> tethers = unyielding_tethers(mesh, held);
  EXPECT_EQ(tethers.size(), mesh.vertices.size() - held.size());
  Range range;
  for (const Tether& t : tethers) {
    const double ratio = t.length / expected(t.vertex);
    range = {std::min(range.least, ratio), std::max(range.most, ratio)};
    EXPECT_GE(t.length * (1 + 1e-6), length(mesh.vertices[t.vertex] - mesh.vertices[t.anchor]));
  }
  return range;
}

std::function<double(uint32_t)> straight_to_nearest(const ClothMesh& mesh,
                                                    const std::vector<uint32_t>& held) {
  return [&](uint32_t v) {
    double least = 1e30;
    for (uint32_t h : held) least = std::min(least, double{length(mesh.vertices[v] - mesh.vertices[h])});
    return least;
  };
}

void expect_straight(const ClothMesh& mesh, const std::vector<uint32_t>& held, double tolerance) {
  const Range range = ratios(mesh, held, straight_to_nearest(mesh, held));
  EXPECT_GT(range.least, 1 - 1e-6);
  EXPECT_LT(range.most, 1 + tolerance);
}

std::vector<uint32_t> first(uint32_t count) {
  std::vector<uint32_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

TEST(Tethers, OfASheetHeldByARowAreStraight) {
  expect_straight(make_sheet(1, 1, 40, 40), first(40), 1e-6);
}

TEST(Tethers, OfASheetHeldByCornersAreStraight) {
  const ClothMesh sheet = make_sheet(1, 1, 40, 40);
  expect_straight(sheet, {0}, 1e-5);
  expect_straight(sheet, {0, 39}, 1e-5);
  expect_straight(sheet, {0, 39, 40 * 39, 40 * 40 - 1}, 1e-5);
}

TEST(Tethers, OfIrregularFlatMeshesAreStraight) {
  const ClothMesh mesh = jittered_sheet(40, 40, 0.008f, 7);
  expect_straight(mesh, {820}, 1e-4);
  expect_straight(mesh, {0, 39, 1595}, 1e-4);
  expect_straight(mesh, first(40), 1e-4);
  expect_straight(shuffled(mesh, 2), {100, 200, 300, 400, 500}, 1e-4);
}

// Held in the middle: to see all of the jagged border from there.
TEST(Tethers, OfEquilateralTrianglesAreStraight) {
  expect_straight(equilateral_patch(0.05f, 30, 30), {15 * 30 + 15}, 1e-4);
}

TEST(Tethers, OfObtuseTrianglesAreStraight) {
  ClothMesh mesh = equilateral_patch(0.05f, 30, 30);
  for (Vec3& v : mesh.vertices) v.x *= 4;  // corners of up to 133°
  expect_straight(mesh, {15 * 30 + 15}, 1e-4);
}

TEST(Tethers, OfATubeHeldByItsRimRunDownIt) {
  const ClothMesh mesh = tube(0.3f, 1, 60, 40);
  const Range range = ratios(mesh, first(60), [&](uint32_t v) { return mesh.vertices[v].y; });
  EXPECT_NEAR(range.least, 1, 1e-5);
  EXPECT_NEAR(range.most, 1, 1e-5);
}

TEST(Tethers, OfATubeHeldAtAPointRunAroundIt) {
  constexpr uint32_t around = 90;
  const ClothMesh mesh = tube(0.3f, 1, around, 60);
  const Range range = ratios(mesh, {0}, [&](uint32_t v) {
    const uint32_t steps = std::min(v % around, around - v % around);
    // Over a polygon with sides as long as the mesh's.
    const double across = 2 * 0.3 * std::sin(std::numbers::pi / around) * steps;
    return std::hypot(across, mesh.vertices[v].y);
  });
  EXPECT_GT(range.least, 1 - 1e-3);
  EXPECT_LT(range.most, 1 + 1e-3);
}

TEST(Tethers, OfAFoldedSheetAreThoseOfTheFlatOne) {
  const ClothMesh flat = make_sheet(1, 1, 41, 41);
  ClothMesh folded = flat;
  for (uint32_t v = 0; v < folded.vertices.size(); ++v) {
    const uint32_t column = v % 41, from_fold = column % 8 < 4 ? column % 4 : 4 - column % 4;
    folded.vertices[v].x *= 0.28f;
    folded.vertices[v].y = 0.025f * 0.96f * static_cast<float>(from_fold);
  }
  const auto expect_flat = [&](const std::vector<uint32_t>& held, double least) {
    const Range range = ratios(folded, held, straight_to_nearest(flat, held));
    EXPECT_GT(range.least, least);
    EXPECT_LT(range.most, 1 + 1e-4);
  };
  expect_flat({820}, 1 - 1e-4);
  expect_flat(first(41), 1 - 1e-4);
  expect_flat({5, 333, 700, 1200}, 0.96);
}

TEST(Tethers, GoAroundTheCornerOfAnL) {
  // A square without its quarter of large x and z.
  ClothMesh mesh = make_sheet(2, 2, 41, 41);
  mesh.material.clear();
  std::erase_if(mesh.triangles, [&](const auto& t) {
    const Vec3 sum = mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]];
    return sum.x > 0 && sum.z > 0;
  });
  const uint32_t held = 40, far_end = 41 * 40;  // at (1, −1) and (−1, 1)
  const uint32_t end_of_leg = far_end + 20;     // at (0, 1), out of sight
  for (const Tether& t : unyielding_tethers(mesh, std::vector{held})) {
    if (t.vertex == end_of_leg) {
      EXPECT_NEAR(t.length / (std::sqrt(2) + 1), 1, 0.01);
    }
    if (t.vertex == far_end) {
      EXPECT_NEAR(t.length / (2 * std::sqrt(2)), 1, 0.01);
    }
  }
}

TEST(Tethers, BelongToTheNearestHeldVertexAndAreSortedByIt) {
  const ClothMesh sheet = make_sheet(1, 1, 21, 5);
  const std::vector<Tether> tethers = unyielding_tethers(sheet, std::vector<uint32_t>{20, 0});
  ASSERT_EQ(tethers.size(), sheet.vertices.size() - 2);
  for (size_t k = 0; k < tethers.size(); ++k) {
    const Tether& t = tethers[k];
    const float x = sheet.vertices[t.vertex].x;
    if (std::abs(x) > 1e-3f) {
      EXPECT_EQ(t.anchor, x < 0 ? 0u : 20u) << t.vertex;
    }
    if (k == 0) continue;
    EXPECT_LT(std::pair(tethers[k - 1].anchor, tethers[k - 1].vertex), std::pair(t.anchor, t.vertex));
  }
}

TEST(Tethers, PartsThatNothingHoldsGetNone) {
  ClothMesh mesh = make_sheet(1, 1, 3, 3);
  const ClothMesh other = mesh;
  for (Vec3 v : other.vertices) mesh.vertices.push_back(v + Vec3{5, 0, 0});
  for (auto t : other.triangles) mesh.triangles.push_back({t[0] + 9, t[1] + 9, t[2] + 9});
  mesh.material.clear();
  const std::vector<Tether> tethers = unyielding_tethers(mesh, std::vector<uint32_t>{4});
  EXPECT_EQ(tethers.size(), 8u);
  for (const Tether& t : tethers) EXPECT_LT(t.vertex, 9u);
  EXPECT_TRUE(unyielding_tethers(mesh, {}).empty());
}

// With the area that its vertex stands for: a hundredth of a square metre, and half of that at a border.
TEST(Tethers, YieldAsStripsOfTheFabricDo) {
  const ClothMesh sheet = make_sheet(1, 1, 11, 11);  // the warp runs along x
  const FabricParameters fabric{.warp_stiffness = 2000, .weft_stiffness = 500, .shear_stiffness = 100};
  const auto compliance = [&](uint32_t held, uint32_t vertex) {
    for (const Tether& t : build_tethers(sheet, std::vector{held}, fabric)) {
      if (t.vertex == vertex) return double{t.compliance};
    }
    return -1.0;
  };
  EXPECT_NEAR(compliance(5 * 11, 5 * 11 + 4), 0.4 * 0.4 / 0.01 / 2000, 1e-6);
  EXPECT_NEAR(compliance(5, 4 * 11 + 5), 0.4 * 0.4 / 0.01 / 500, 1e-5);
  EXPECT_NEAR(compliance(0, 6), 0.6 * 0.6 / 0.005 / 2000, 1e-4);
  EXPECT_NEAR(compliance(2 * 11 + 2, 6 * 11 + 6), 0.32 / 0.01 * (0.25 / 2000 + 0.25 / 500 + 0.25 / 100),
              1e-3);
}

// Of a sheet of 7 × 7 with tethers, the vertices in the order of rows: whether what they carry counts.
std::string what_counts(std::vector<uint32_t> held, float gas = 0) {
  ClothModel model;
  model.rest = make_sheet(1, 1, 7, 7).vertices;
  model.held = std::move(held);
  ClothConstraints constraints = build_constraints(make_sheet(1, 1, 7, 7), {.shear_stiffness = 100});
  for (const Tether& t : unyielding_tethers(make_sheet(1, 1, 7, 7), model.held))
    model.tethers.push_back({t.vertex, t.anchor, t.length, t.compliance, 0.5f});
  const Piece piece{.first_vertex = 0, .end_vertex = 49, .inside = gas};
  std::string marks(49, 'o');
  for (const Tether& t : tethers_beside(draw_chains(constraints, model.rest, std::vector{piece}), model)) {
    EXPECT_TRUE(t.self_mass == 0 || t.self_mass == 0.5f);
    marks[t.vertex] = t.self_mass > 0 ? 'x' : '.';
  }
  return marks;
}

TEST(Tethers, AreStiffenedByLoadsWhereNoChainLeadsToWhatIsHeld) {
  EXPECT_EQ(what_counts({0, 6, 42, 48}),
            "o.....o"
            ".xxxxx."
            ".xxxxx."
            ".xxxxx."
            ".xxxxx."
            ".xxxxx."
            "o.....o");
  EXPECT_EQ(what_counts(first(7)), "ooooooo" + std::string(42, '.'));
  EXPECT_EQ(what_counts({24}, 1).find('x'), std::string::npos) << "without chains";
}

TEST(Tethers, OfWhatDoesNotResistPullAtNothing) {
  const FabricParameters fabric{.warp_stiffness = 0, .weft_stiffness = 500, .shear_stiffness = 100};
  for (const Tether& t : build_tethers(make_sheet(1, 1, 5, 5), std::vector{0u}, fabric)) {
    EXPECT_TRUE(std::isfinite(t.compliance));
    if (t.vertex < 5) {
      EXPECT_GT(t.compliance, 1e19f);
    }
  }
}

TEST(Tethers, RefuseWhatIsNoVertex) {
  tests::expect_error(ErrorCode::invalid_argument, "vertex 9", [] {
    unyielding_tethers(make_sheet(1, 1, 3, 3), std::vector<uint32_t>{0, 9});
  });
}

}  // namespace
}  // namespace meniscus::cloth
