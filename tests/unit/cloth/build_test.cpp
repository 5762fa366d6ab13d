// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Constraints against closed forms: the energy that a deformed mesh has by them.
#include "cloth/build/build_constraints.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "tests/unit/cloth/cloth_shapes.h"

namespace meniscus::cloth {
namespace {

double edge_energy(const ClothConstraints& constraints, const std::vector<Vec3>& x) {
  double energy = 0;
  for (const EdgeConstraint& e : constraints.edges.items) {
    const double c = double{length(x[e.b] - x[e.a])} - e.rest_length;
    energy += 0.5 * c * c / e.compliance;
  }
  return energy;
}

struct Strains {
  double u, v, uv;
};

Strains strains_of(const StrainConstraint& s, const std::vector<Vec3>& x) {
  const Vec3 ab = x[s.b] - x[s.a], ac = x[s.c] - x[s.a];
  const Vec3 fu = s.inverse_rest[0] * ab + s.inverse_rest[2] * ac;
  const Vec3 fv = s.inverse_rest[1] * ab + s.inverse_rest[3] * ac;
  return {length(fu) - 1, length(fv) - 1, dot(fu, fv) / (length(fu) * length(fv))};
}

double strain_energy(const ClothConstraints& constraints, const std::vector<Vec3>& x) {
  double energy = 0;
  for (const StrainConstraint& s : constraints.strains.items) {
    const Strains e = strains_of(s, x);
    energy += 0.5 * (e.u * e.u / s.warp_compliance + e.v * e.v / s.weft_compliance +
                     e.uv * e.uv / s.shear_compliance);
  }
  return energy;
}

TEST(BuildMasses, AreThirdsOfTheTriangles) {
  const ClothMesh sheet = make_sheet(2, 1, 11, 6);  // cells of .2 × .2
  const std::vector<float> masses = build_constraints(sheet, {.density = 0.3f}).masses;
  ASSERT_EQ(masses.size(), 66u);
  double sum = 0;
  for (float m : masses) sum += m;
  EXPECT_NEAR(sum, 0.6, 1e-6);
  EXPECT_NEAR(masses[2 * 11 + 5], 0.3 * 0.04, 1e-7);
}

TEST(BuildEdges, OfASheetHaveItsStiffnessPerWidth) {
  const ClothMesh sheet = make_sheet(2, 1, 21, 16);
  const FabricParameters fabric{.warp_stiffness = 1000, .weft_stiffness = 300, .shear_stiffness = 0};
  const ClothConstraints constraints = build_constraints(sheet, fabric);
  constexpr float e = 1e-2f;
  const auto wide = deformed(sheet, [](Vec3 v) { return Vec3{(1 + e) * v.x, v.y, v.z}; });
  const auto deep = deformed(sheet, [](Vec3 v) { return Vec3{v.x, v.y, (1 + e) * v.z}; });
  EXPECT_NEAR(edge_energy(constraints, wide) / (0.5 * 1000 * e * e * 2), 1, 1e-4);
  EXPECT_NEAR(edge_energy(constraints, deep) / (0.5 * 300 * e * e * 2), 1, 1e-4);
  EXPECT_EQ(constraints.edges.items.size(), 20u * 16 + 21 * 15);  // diagonals would yield without limit
}

TEST(BuildEdges, OfASheetHaveItsShearStiffness) {
  const ClothMesh sheet = make_sheet(1, 1, 21, 21);
  const FabricParameters fabric{.warp_stiffness = 1000, .weft_stiffness = 1000, .shear_stiffness = 10};
  constexpr float angle = 1e-2f;
  const auto sheared = deformed(sheet, [](Vec3 v) { return Vec3{v.x + angle * v.z, v.y, v.z}; });
  const double energy = edge_energy(build_constraints(sheet, fabric), sheared);
  EXPECT_NEAR(energy / (0.5 * 10 * angle * angle), 1, 0.02);
  FabricParameters unyielding_threads = fabric;
  unyielding_threads.warp_stiffness = unyielding_threads.weft_stiffness = unyielding;
  double diagonals = 0;
  for (const EdgeConstraint& edge : build_constraints(sheet, unyielding_threads).edges.items) {
    if (edge.compliance == 0) continue;
    const double c = double{length(sheared[edge.b] - sheared[edge.a])} - edge.rest_length;
    diagonals += 0.5 * c * c / edge.compliance;
  }
  EXPECT_NEAR(diagonals / (0.5 * 10 * angle * angle), 1, 2e-3);
}

TEST(BuildEdges, OfEquilateralTrianglesHaveTheStiffnessInAnyDirection) {
  const ClothMesh patch = equilateral_patch(0.1f, 20, 20);
  const FabricParameters fabric{.warp_stiffness = 500, .weft_stiffness = 500, .shear_stiffness = 250};
  const ClothConstraints constraints = build_constraints(patch, fabric);
  constexpr float e = 1e-3f;
  const auto energy = [&](float turn) {
    // Pulled along one direction, and free to contract across: by ⅓, as networks of springs do.
    const Vec3 along{std::cos(turn), 0, std::sin(turn)}, across{-std::sin(turn), 0, std::cos(turn)};
    return edge_energy(constraints, deformed(patch, [&](Vec3 v) {
                         return v + e * dot(v, along) * along - e / 3 * dot(v, across) * across;
                       }));
  };
  const double expected = 0.5 * 500 * e * e * area_of(patch);
  EXPECT_NEAR(energy(0) / expected, 1, 5e-3);
  EXPECT_NEAR(energy(0.3f) / expected, 1, 0.02);  // the border's triangles are not all there
  EXPECT_NEAR(energy(1.2f) / expected, 1, 0.02);
}

TEST(BuildEdges, CountTheAreaAndTheWarpOfBothTriangles) {
  ClothMesh mesh{{{0, 0, 0}, {5, 0, 0}, {1, 0, 2}, {1, 0, -6}}, {{0, 2, 1}, {1, 3, 0}}, {}};
  const FabricParameters fabric{.warp_stiffness = 100, .weft_stiffness = 20, .shear_stiffness = 5};
  const auto compliance = [&](const ClothMesh& m) {
    for (const EdgeConstraint& e : build_constraints(m, fabric).edges.items) {
      if (e.a == 0 && e.b == 1) return e.compliance;
    }
    return 0.0f;
  };
  EXPECT_NEAR(compliance(mesh) / (25 / (100 * (5.0 + 15.0))), 1, 1e-5);
  // With the second triangle stood on end, the warp still runs along the edge in both.
  mesh.vertices[3] = {1, 6, 0};
  EXPECT_NEAR(compliance(mesh) / (25 / (100 * (5.0 + 15.0))), 1, 1e-5);
  // Turned to run along z, the edge lies across the warp of the first; the second faces x, so that its warp
  // is z.
  mesh.vertices = {{0, 0, 0}, {0, 0, 5}, {2, 0, 1}, {0, 6, 1}};
  const double half_and_half = 0.25 / 100 + 0.25 / 20 + 0.25 / 5;
  EXPECT_NEAR(compliance(mesh) / (25 / 20.0 * half_and_half), 1, 1e-5);
}

TEST(BuildEdges, UnyieldingOnesHaveNoCompliance) {
  for (const EdgeConstraint& e : build_constraints(make_sheet(1, 1, 5, 5), {}).edges.items) {
    EXPECT_EQ(e.compliance, 0);
    EXPECT_GT(e.rest_length, 0);
  }
}

TEST(BuildEdges, FollowTheWarpOfTheMaterial) {
  ClothMesh sheet = make_sheet(1, 1, 6, 6);
  for (auto& [u, v] : sheet.material) std::swap(u, v);
  for (auto& [u, v] : sheet.material) u *= 7;  // directions alone count
  const FabricParameters fabric{.warp_stiffness = 1000, .weft_stiffness = 0, .shear_stiffness = 0};
  for (const EdgeConstraint& e : build_constraints(sheet, fabric).edges.items) {
    EXPECT_EQ(e.b - e.a, 6u);  // along z
  }
}

TEST(BuildStrains, AreNoneAtRestAndThoseOfTheMotion) {
  ClothMesh mesh = jittered_sheet(6, 6, 0.05f, 3);
  mesh.material.clear();
  const auto constraints = build_constraints(mesh, {.strain_triangles = true});
  EXPECT_TRUE(constraints.edges.items.empty());
  ASSERT_EQ(constraints.strains.items.size(), 50u);
  const auto moved = deformed(mesh, [](Vec3 v) { return Vec3{0.9f * v.z + 0.02f * v.x, 3, 1.2f * v.x}; });
  for (const StrainConstraint& s : constraints.strains.items) {
    const Strains at_rest = strains_of(s, mesh.vertices), now = strains_of(s, moved);
    EXPECT_NEAR(at_rest.u, 0, 1e-5);
    EXPECT_NEAR(at_rest.v, 0, 1e-5);
    EXPECT_NEAR(at_rest.uv, 0, 1e-5);
    EXPECT_NEAR(now.u, std::hypot(0.02, 1.2) - 1, 1e-5);
    EXPECT_NEAR(now.v, -0.1, 1e-5);
    EXPECT_NEAR(std::abs(now.uv), 0.02 / std::hypot(0.02, 1.2), 1e-5);
  }
}

TEST(BuildStrains, HaveTheStiffnessPerWidth) {
  ClothMesh flat = jittered_sheet(12, 12, 0.02f, 5);
  flat.material.clear();
  const FabricParameters fabric{
      .warp_stiffness = 1000, .weft_stiffness = 300, .shear_stiffness = 20, .strain_triangles = true};
  const ClothConstraints constraints = build_constraints(flat, fabric);
  const double area = area_of(flat);
  constexpr float e = 1e-2f;
  const auto expect_energy = [&](double stiffness, const std::function<Vec3(Vec3)>& map) {
    EXPECT_NEAR(strain_energy(constraints, deformed(flat, map)) / (0.5 * stiffness * e * e * area), 1, 2e-3);
  };
  expect_energy(1000, [](Vec3 v) { return Vec3{(1 + e) * v.x, v.y, v.z}; });
  expect_energy(300, [](Vec3 v) { return Vec3{v.x, v.y, (1 + e) * v.z}; });
  expect_energy(20, [](Vec3 v) { return Vec3{v.x + 0.5f * e * v.z, v.y, v.z + 0.5f * e * v.x}; });
}

TEST(BuildStrains, WithoutStiffnessStayFinite) {
  const FabricParameters fabric{.shear_stiffness = 0, .strain_triangles = true};
  for (const StrainConstraint& s : build_constraints(make_sheet(1, 1, 3, 3), fabric).strains.items) {
    EXPECT_EQ(s.warp_compliance, 0);
    EXPECT_GT(s.shear_compliance, 1e15f);
    EXPECT_LT(s.shear_compliance, std::numeric_limits<float>::infinity());
  }
}

}  // namespace
}  // namespace meniscus::cloth
