// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tests of the bending constraints that are built from a mesh.
#include <gtest/gtest.h>

#include "cloth/build/build_constraints.h"
#include "cloth/solve/bending_kernels.h"
#include "cloth/solve/bending_matrix.h"
#include "tests/unit/cloth/cloth_shapes.h"

namespace meniscus::cloth {
namespace {

float angle_of(const HingeConstraint& h, const std::vector<Vec3>& x) {
  return bending_kernels::fold_of(x[h.a], x[h.b], x[h.c], x[h.d]).angle;
}

double value_of(const IsometricConstraint& h, const std::vector<Vec3>& x) {
  const uint32_t corner[] = {h.a, h.b, h.c, h.d};
  const float weight[] = {-(h.weight[0] + h.weight[1] + h.weight[2]), h.weight[0], h.weight[1], h.weight[2]};
  double sum[3] = {0, 0, 0};
  for (int k = 0; k < 4; ++k) {
    sum[0] += double{weight[k]} * x[corner[k]].x;
    sum[1] += double{weight[k]} * x[corner[k]].y;
    sum[2] += double{weight[k]} * x[corner[k]].z;
  }
  return std::sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
}

TEST(BuildBending, OfASheetRolledUpIsHalfStiffnessTimesSquaredCurvature) {
  constexpr uint32_t columns = 16, rows = 9;
  constexpr float cell = 0.1f, turn = 0.05f, stiffness = 1e-3f;
  const ClothMesh sheet = make_sheet(cell * (columns - 1), cell * (rows - 1), columns, rows);
  std::vector<Vec3> x = sheet.vertices;
  for (uint32_t i = 0; i < columns; ++i) {
    double along = 0, up = 0;  // a chain of straight cells, each turned by the same angle
    for (uint32_t k = 0; k < i; ++k) {
      along += cell * std::cos(turn * k);
      up += cell * std::sin(turn * k);
    }
    for (uint32_t j = 0; j < rows; ++j) {
      x[j * columns + i].x = static_cast<float>(along);
      x[j * columns + i].y = static_cast<float>(up);
    }
  }
  const double inner_area = double{cell} * cell * (columns - 2) * (rows - 1);
  const double expected = 0.5 * stiffness * (turn / cell) * (turn / cell) * inner_area;
  double dihedral = 0, isometric = 0;
  const auto by_angle = build_constraints(sheet, {.bending_stiffness = stiffness, .dihedral = true});
  for (const HingeConstraint& h : by_angle.hinges.items) {
    EXPECT_EQ(h.rest_angle, 0);
    dihedral += 0.5 * angle_of(h, x) * angle_of(h, x) / h.compliance;
  }
  const auto quadratic = build_constraints(sheet, {.bending_stiffness = stiffness});
  EXPECT_TRUE(quadratic.hinges.items.empty());
  for (const IsometricConstraint& h : quadratic.isometric) {
    isometric += 0.5 * value_of(h, x) * value_of(h, x) / h.compliance;
  }
  EXPECT_NEAR(dihedral / expected, 1, 1e-3);
  EXPECT_NEAR(isometric / expected, 1, 1e-3);
}

TEST(BuildBending, OfEquilateralTrianglesIsThatInAnyDirection) {
  constexpr float edge = 0.1f, curvature = 0.02f, stiffness = 1;
  const ClothMesh patch = equilateral_patch(edge, 7, 7);
  const uint32_t middle = 3 * 7 + 3;
  const auto constraints = build_constraints(patch, {.bending_stiffness = stiffness, .dihedral = true});
  for (float turn : {0.0f, 0.2f, 0.5f, 0.8f, 1.4f, 2.5f}) {
    const auto x = deformed(patch, [&](Vec3 v) {
      const Vec3 from = v - patch.vertices[middle];
      const float along = std::cos(turn) * from.x + std::sin(turn) * from.z;
      return Vec3{v.x, 0.5f * curvature * along * along, v.z};
    });
    double energy = 0;
    int hinges = 0;
    for (const HingeConstraint& h : constraints.hinges.items) {
      if (h.a != middle && h.b != middle) continue;
      ++hinges;
      energy += 0.5 * angle_of(h, x) * angle_of(h, x) / h.compliance;
    }
    ASSERT_EQ(hinges, 6);
    // Half of each edge is the vertex's, as is a third of each of its six triangles.
    const double area = 2 * std::sqrt(0.1875) * edge * edge;
    EXPECT_NEAR(0.5 * energy / (0.5 * stiffness * curvature * curvature * area), 1, 5e-3) << turn;
  }
}

/// The energy of all hinges around the middle of a sheet of 9 × 9 vertices, bent across a direction, over
/// that of its stiffness. Diagonals turn from row to row, so hinges of two rows count.
double energy_of_sheet(float turn) {
  constexpr float cell = 0.1f, curvature = 0.02f;
  constexpr uint32_t columns = 9;
  const ClothMesh sheet = make_sheet(8 * cell, 8 * cell, columns, columns);
  const auto x = deformed(sheet, [&](Vec3 v) {
    const float along = std::cos(turn) * v.x + std::sin(turn) * v.z;
    return Vec3{v.x, 0.5f * curvature * along * along, v.z};
  });
  double energy = 0;
  for (const IsometricConstraint& h : build_constraints(sheet, {.bending_stiffness = 1}).isometric) {
    for (uint32_t end : {h.a, h.b}) {
      const bool counts = end == 4 * columns + 4 || end == 5 * columns + 4;
      if (counts) energy += 0.25 * value_of(h, x) * value_of(h, x) / double{h.compliance};
    }
  }
  return energy / (0.5 * double{curvature} * curvature * 2 * cell * cell);
}

TEST(BuildBending, OfASheetIsTheSameInAnyDirection) {
  for (float turn : {0.0f, 0.3f, 0.7854f, 1.2f, 1.5708f, 2.3562f, 2.8f})
    EXPECT_NEAR(energy_of_sheet(turn), 1, 0.01) << turn;
}

TEST(BuildBending, AnglesAreTakenAtRest) {
  const ClothMesh mesh = tube(0.3f, 1, 24, 5);
  const auto constraints = build_constraints(mesh, {.bending_stiffness = 1e-3f});
  int bent = 0;
  for (const HingeConstraint& h : constraints.hinges.items) {
    EXPECT_NEAR(angle_of(h, mesh.vertices), h.rest_angle, 1e-5);
    EXPECT_NEAR(std::abs(h.rest_angle), 2 * std::numbers::pi / 24, 1e-4);
    ++bent;
  }
  EXPECT_EQ(bent, 24 * 4);                                    // the upright edges
  EXPECT_EQ(constraints.isometric.size(), 24u * 3 + 24 * 4);  // rings and diagonals are flat
}

TEST(BuildBending, AnglesArePositiveTowardsTheNormal) {
  ClothMesh mesh{{{0, 0, 0}, {0, 0, 1}, {1, 0.2f, 0}, {-1, 0.2f, 0}}, {{0, 1, 2}, {1, 0, 3}}, {}};
  const auto hinges = build_constraints(mesh, {.bending_stiffness = 1}).hinges.items;
  ASSERT_EQ(hinges.size(), 1u);  // (0, 1, 2) faces up, and both wings are raised
  EXPECT_NEAR(hinges[0].rest_angle, 2 * std::atan(0.2f), 1e-6);
  EXPECT_NEAR(angle_of(hinges[0], mesh.vertices), hinges[0].rest_angle, 1e-6);
}

TEST(BuildBending, IsometricHingesMeasureTheAngle) {
  const ClothMesh flat{
      {{0, 0, 0}, {0.3f, 0, 1.1f}, {0.9f, 0, 0.2f}, {-0.4f, 0, 0.9f}}, {{0, 1, 2}, {1, 0, 3}}, {}};
  const auto hinges = build_constraints(flat, {.bending_stiffness = 1}).isometric;
  ASSERT_EQ(hinges.size(), 1u);
  EXPECT_NEAR(value_of(hinges[0], flat.vertices), 0, 1e-6);
  const Vec3 axis = flat.vertices[1] - flat.vertices[0];
  for (float angle : {0.1f, 1.0f, 2.5f}) {
    std::vector<Vec3> x = flat.vertices;
    x[3] = rotate(rotation_by(angle / length(axis) * axis), x[3]);
    EXPECT_NEAR(value_of(hinges[0], x), length(axis) * 2 * std::sin(angle / 2), 1e-5);
  }
}

struct Entries {
  const BendingMatrix& matrix;

  template <class Visit>
  void for_each(uint32_t row, const Visit& visit) const {
    constexpr uint32_t slice = BendingMatrix::slice;
    for (uint32_t n = matrix.slice_start[row / slice] + row % slice; n < matrix.slice_start[row / slice + 1];
         n += slice)
      visit(matrix.column[n], matrix.value[n]);
  }
};

TEST(BendingMatrix, HasTheEnergyOfAllHinges) {
  const ClothMesh sheet = make_sheet(1, 0.8f, 11, 9);
  const auto all = build_constraints(sheet, {.bending_stiffness = 1e-3f});
  const auto x = deformed(sheet, [](Vec3 v) { return Vec3{v.x, 0.1f * v.x * v.x * v.z, v.z + 0.05f * v.x}; });
  double expected = 0, energy = 0;
  for (const IsometricConstraint& h : all.isometric)
    expected += 0.5 * value_of(h, x) * value_of(h, x) / double{h.compliance};
  const BendingMatrix matrix = bending_matrix(all.isometric, all.masses);
  for (uint32_t i = 0; i < x.size(); ++i) {
    Entries{matrix}.for_each(i, [&](uint32_t j, float q) {
      const double apart[3] = {double{x[j].x} - x[i].x, double{x[j].y} - x[i].y, double{x[j].z} - x[i].z};
      for (double d : apart) energy -= 0.25 * double{q} * d * d;
      Entries{matrix}.for_each(j, [&](uint32_t k, float other) {
        if (k == i && j != i) {
          EXPECT_EQ(q, other) << i << ", " << j;
        }
      });
    });
  }
  EXPECT_NEAR(energy / expected, 1, 1e-3);
}

TEST(BendingMatrix, BoundsItsFastestMode) {
  const ClothMesh sheet = make_sheet(1, 1, 21, 21);
  const auto all = build_constraints(sheet, {.bending_stiffness = 1e-3f});
  const BendingMatrix matrix = bending_matrix(all.isometric, all.masses);
  const std::vector<Piece> pieces{{.first_vertex = 0, .end_vertex = 441}};
  const double bound = double{bending_rates(matrix, all.isometric, all.masses, pieces)[0].fastest};
  std::vector<double> mode(441), next(441);
  for (uint32_t i = 0; i < 441; ++i) mode[i] = i % 3 == 0 ? 1 : -0.7;
  double rate = 0;
  for (int round = 0; round < 300; ++round) {
    double most = 0;
    for (uint32_t i = 0; i < 441; ++i) {
      double sum = 0;
      Entries{matrix}.for_each(i, [&](uint32_t j, float q) { sum += double{q} * (mode[j] - mode[i]); });
      next[i] = sum / double{all.masses[i]};
      most = std::max(most, std::abs(next[i]));
    }
    for (uint32_t i = 0; i < 441; ++i) mode[i] = next[i] / most;
    rate = most;
  }
  EXPECT_GE(bound, rate);
  EXPECT_LE(bound, 1.3 * rate);
}

TEST(BendingMatrix, HasFiniteEntriesForUnyieldingCloth) {
  const auto all = build_constraints(make_sheet(1, 1, 5, 5), {.bending_stiffness = unyielding});
  for (float q : bending_matrix(all.isometric, all.masses).value) EXPECT_TRUE(std::isfinite(q));
}

TEST(BuildBending, WithoutStiffnessThereIsNone) {
  const ClothConstraints constraints = build_constraints(tube(1, 1, 8, 3), {.bending_stiffness = 0});
  EXPECT_TRUE(constraints.hinges.items.empty());
  EXPECT_TRUE(constraints.isometric.empty());
}

}  // namespace
}  // namespace meniscus::cloth
