// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tests of the triangles that represent solids.
#include "sdk/io/solid_triangles.h"

#include <gtest/gtest.h>

#include <map>
#include <numbers>

#include "collision/mesh/mesh.h"
#include "pbd/math/vec.h"
#include "sdk/io/surface_frame.h"

namespace meniscus::io {
namespace {

constexpr float pi = std::numbers::pi_v<float>;

collision::TriangleMesh mesh_of(const Geometry& geometry) {
  BodyDef body;
  body.geometry = geometry;
  const BodyState still;
  const SurfaceFrame frame = BodySurfaces({body}).at(0, {&still, 1});
  return {frame.vertices, frame.triangles};
}

/// Each edge is there once in either direction: the surface has neither holes nor faces turned around.
bool is_closed(const collision::TriangleMesh& mesh) {
  std::map<std::pair<uint32_t, uint32_t>, int> edges;
  for (const auto& [a, b, c] : mesh.triangles) ++edges[{a, b}], ++edges[{b, c}], ++edges[{c, a}];
  for (const auto& [edge, count] : edges) {
    const auto other = edges.find({edge.second, edge.first});
    if (count != 1 || other == edges.end()) return false;
  }
  return true;
}

float area(const std::vector<SolidTriangle>& triangles) {
  float sum = 0;
  for (const SolidTriangle& t : triangles) {
    sum += 0.5f * length(cross(t.corners[1] - t.corners[0], t.corners[2] - t.corners[0]));
  }
  return sum;
}

struct Solid {
  const char* name;
  Geometry geometry;
  double volume;
  double accuracy;  ///< of round surfaces, which facets cut short
};

std::vector<Solid> solids() {
  const CompoundGeometry two{{{BoxGeometry{{1, 1, 1}}, {{-3, 0, 0}, {0, 0, 0, 1}}},
                              {BoxGeometry{{1, 2, 1}}, {{3, 0, 0}, {0.6f, 0, 0, 0.8f}}}}};
  return {
      {"box", BoxGeometry{{1, 2, 3}}, 48, 1e-6},
      {"sphere", SphereGeometry{2}, 4.0 / 3 * pi * 8, 0.01},
      {"capsule", CapsuleGeometry{1, 2}, 4.0 / 3 * pi + 4 * pi, 0.01},
      {"ball as a capsule", CapsuleGeometry{1, 0}, 4.0 / 3 * pi, 0.01},
      {"cylinder", CylinderGeometry{0.5f, 2}, pi, 0.01},
      {"hull", HullGeometry{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.1f, 0.1f, 0.1f}}}, 1.0 / 6, 1e-5},
      {"compound", two, 8 + 16, 1e-5}};
}

TEST(SolidTriangles, BoundTheirSolids) {
  for (const Solid& solid : solids()) {
    const collision::TriangleMesh mesh = mesh_of(solid.geometry);
    EXPECT_TRUE(is_closed(mesh)) << solid.name;
    EXPECT_NEAR(signed_volume(mesh) / solid.volume, 1, solid.accuracy) << solid.name;
  }
}

TEST(SolidTriangles, NormalsPointTheSameWayAsTheFaces) {
  for (const Solid& solid : solids()) {
    for (const SolidTriangle& t : solid_triangles(solid.geometry)) {
      const Vec3 face = normalized_or(cross(t.corners[1] - t.corners[0], t.corners[2] - t.corners[0]), {});
      for (const Vec3 n : t.normals) {
        ASSERT_NEAR(length(n), 1, 1e-5f) << solid.name;
        ASSERT_GT(dot(n, face), 0.9f) << solid.name;
      }
    }
  }
}

TEST(SolidTriangles, APlaneHasNoEnd) {
  EXPECT_TRUE(solid_triangles(PlaneGeometry{}).empty());
}

TEST(SolidTriangles, AHeightFieldFacesUp) {
  const HeightFieldGeometry field{3, 2, 0.5f, {0, 1, 0, 0, 1, 0}};
  const auto triangles = solid_triangles(field);
  EXPECT_EQ(triangles.size(), 4u);
  for (const SolidTriangle& t : triangles) {
    EXPECT_GT(cross(t.corners[1] - t.corners[0], t.corners[2] - t.corners[0]).y, 0);
  }
}

TEST(SolidTriangles, AContainerIsSeenFromInside) {
  EXPECT_TRUE(is_closed(mesh_of(ContainerGeometry{{1, 2, 3}, {}})));
  EXPECT_NEAR(signed_volume(mesh_of(ContainerGeometry{{1, 2, 3}, {}})), -48, 1e-4);
}

TEST(SolidTriangles, OpeningsAreCutOutOfTheWalls) {
  const ContainerGeometry cup{{1, 2, 3},
                              {{Face::y_high, std::nullopt},
                               {Face::x_low, Aabb{{-1, 0, 0}, {-1, 1, 1.5f}}},
                               {Face::x_low, Aabb{{-1, 1.5f, -3}, {-1, 9, -2}}}}};  // over the border
  const float closed = 2 * (4 * 6) + 2 * (2 * 6) + 2 * (2 * 4);
  EXPECT_NEAR(area(solid_triangles(cup)), closed - 2 * 6 - 1.5f - 0.5f, 1e-4f);
  for (const SolidTriangle& t : solid_triangles(cup)) {
    const Vec3 middle = (t.corners[0] + t.corners[1] + t.corners[2]) / 3.0f;
    EXPECT_LT(middle.y, 2 - 1e-3f) << "the lid is gone";
    EXPECT_LT(dot(t.normals[0], middle), 0) << "walls face inwards";
  }
}

}  // namespace
}  // namespace meniscus::io
