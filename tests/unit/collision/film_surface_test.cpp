// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The surfaces of films, and the quick test of where films may be.
#include <gtest/gtest.h>

#include <map>
#include <vector>

#include "collision/film/film_nearness.h"
#include "collision/film/tuning.h"
#include "collision/mesh/triangle.h"
#include "tests/unit/collision/mesh_shapes.h"

namespace meniscus::collision {
namespace {

double area_of(const TriangleMesh& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    sum += 0.5 * double{length(area_normal({mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]}))};
  return sum;
}

void expect_closed_with_edges_up_to(float longest, const TriangleMesh& mesh) {
  std::map<std::pair<uint32_t, uint32_t>, int> edges;
  for (const auto& t : mesh.triangles) {
    for (size_t k = 0; k < 3; ++k) {
      const uint32_t a = t[k], b = t[(k + 1) % 3];
      edges[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
      EXPECT_LE(length(mesh.vertices[a] - mesh.vertices[b]), 1.0001f * longest);
    }
  }
  for (const auto& [edge, uses] : edges) EXPECT_EQ(uses, 0);
}

TEST(FilmSurface, IsFineClosedAndOutwards) {
  constexpr float edge = 0.1f;
  constexpr double pi = 3.14159265358979;
  const struct {
    TriangleMesh mesh;
    double area, volume, error;
  } solids[] = {
      {box_surface_mesh({0.3f, 0.2f, 0.1f}), 0.88, 0.048, 1e-5},
      {capsule_surface_mesh(0.3f, 0, edge), 0.36 * pi, 0.036 * pi, 0.05},
      {capsule_surface_mesh(0.3f, 0.2f, edge), 0.6 * pi, 0.072 * pi, 0.05},
      {cylinder_surface_mesh(0.3f, 0.2f, edge), 0.42 * pi, 0.036 * pi, 0.05},
  };
  for (const auto& solid : solids) {
    const TriangleMesh mesh = film_mesh(solid.mesh, edge);
    expect_closed_with_edges_up_to(edge, mesh);
    EXPECT_NEAR(area_of(mesh), solid.area, solid.error * solid.area);
    EXPECT_NEAR(signed_volume(mesh), solid.volume, solid.error * solid.volume);
  }
}

TEST(FilmSurface, IsNoFinerThanNeeded) {
  const TriangleMesh box = box_surface_mesh({0.5f, 0.5f, 0.5f}), fine = film_mesh(box, 0.02f);
  const TriangleMesh merged = film_mesh(fine, 0.2f);
  EXPECT_LT(10 * merged.triangles.size(), fine.triangles.size());
  EXPECT_NEAR(area_of(merged), 6, 0.6);
  EXPECT_LE(film_mesh(box, 1e-4f).triangles.size(), 8 * film_tuning::most_triangles);
}

// Spheres around bodies, with a reach of 0.1 m.
TEST(FilmNearness, KnowsFloorsBoxesAndOtherBodies) {
  const auto box = std::make_shared<TriangleMesh>(box_surface_mesh({0.3f, 0, 0.4f}));  // a sphere of 0.5 m
  const FilmPart parts[] = {{2, 0, {}, box}, {3, 1, {}, box}};
  std::vector<Shape> shapes(4);
  shapes[1].kind = ShapeKind::box;
  shapes[1].bounds = {{10, 0, 0}, {11, 9, 1}};
  shapes[2].body = 0;
  shapes[3].body = 1;
  FilmNearness nearness;
  nearness.set(shapes, 2, join_film_parts(parts, 2));
  const auto any = [&](Vec3 a, Vec3 b) {
    const RigidMotion motions[] = {{{a, {0, 0, 0, 1}}, {0, 0, 0}, {0, 0, 0}},
                                   {{b, {0, 0, 0, 1}}, {0, -1, 0}, {0, 0, 0}}};
    return nearness.any(motions, 0.01f, 0.1f);
  };
  EXPECT_FALSE(any({0, 0.61f, 0}, {0, 5, 0}));
  EXPECT_TRUE(any({0, 0.59f, 0}, {0, 5, 0}));
  EXPECT_FALSE(any({9.39f, 1, 0}, {0, 5, 0}));
  EXPECT_TRUE(any({9.41f, 1, 0}, {0, 5, 0}));
  EXPECT_FALSE(any({0, 2, 0}, {0, 3.12f, 0}));
  EXPECT_TRUE(any({0, 2, 0}, {0, 3.1f, 0}));  // it comes down by 1 cm
  nearness.set(shapes, 2, join_film_parts({parts, 1}, 2));
  EXPECT_TRUE(any({0, 5, 0}, {0, 50, 0})) << "what has no surface may be anywhere";
}

}  // namespace
}  // namespace meniscus::collision
