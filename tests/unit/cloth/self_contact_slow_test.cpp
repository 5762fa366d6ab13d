// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Sheets thrown at each other at random, each vertex with an additional velocity of its own: no triangle ever
// passes through another.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/bench/harness/self_contact_bench.h"
#include "tests/devices.h"
#include "tests/triangle_intersections.h"

namespace meniscus::tests {
namespace {

constexpr float spacing = 0.01f, thickness = 0.006f, substep = 0.002f;

class SelfContactSlowTest : public OnDevice {
 protected:
  std::mt19937 random_{11};

  Vec3 anywhere(float size) {
    std::uniform_real_distribution<float> u(-size, size);
    return {u(random_), u(random_), u(random_)};
  }

  /// Speeds in thicknesses a substep.
  ClothCase thrown(float speed, float shaken) {
    ClothCase c;
    c.substeps = 1;
    cloth::ContactPiece piece;
    piece.thickness = thickness;
    for (int k = 0; k < 3; ++k) {
      const float angle = anywhere(3).x, phase = anywhere(3).x, height = 0.03f * float(k);
      c.add_sheet(
          13, 13, spacing, 2e-5f, piece,
          [=](float u, float v) {
            return Vec3{std::cos(angle) * u - std::sin(angle) * v,
                        height + thickness * std::sin(60 * u + phase),
                        std::sin(angle) * u + std::cos(angle) * v};
          },
          speed * thickness / substep * anywhere(1));
    }
    for (Vec3& v : c.velocities) v += shaken * thickness / substep * anywhere(1);
    return c;
  }
};

TEST_P(SelfContactSlowTest, NothingEverGoesThrough) {
  uint32_t crossings = 0;
  for (float speed : {1.0f, 5.0f, 20.0f}) {
    for (float shaken : {0.0f, 2.0f}) {
      const ClothCase c = thrown(speed, shaken);
      const auto bench = make_self_contact_bench(GetParam(), c);
      std::vector<TriangleCorners> triangles;
      for (const pbd::SurfaceTriangle& t : c.triangles) triangles.push_back({t.a, t.b, t.c});
      for (int k = 0; k < 15; ++k) {
        bench->step(substep);
        crossings = std::max(crossings, bench->most_crossings());
        const std::vector<Vec3> x = bench->positions();
        ASSERT_EQ(TriangleIntersections(x, triangles).count(), 0u)
            << speed << " and " << shaken << " thicknesses a substep, substep " << k;
      }
    }
  }
  EXPECT_GT(crossings, 0u);  // or the last resort was not tried
}

MENISCUS_ON_EACH_DEVICE(SelfContactSlowTest);

}  // namespace
}  // namespace meniscus::tests
