// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The shapes that are found for eight triangles together, against those of each triangle.
#include "collision/fluid_cloth/cloth_shapes.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "pbd/feature_pair.h"

namespace meniscus::tests {
namespace {

using namespace collision::fluid_cloth_kernels;

constexpr uint32_t group = 8;

template <class T>
pbd::View<T> view(std::vector<T>& values) {
  return {values.data(), static_cast<uint32_t>(values.size())};
}

/// A strip of eight triangles, one of them not there, bent by up to so many radians from edge to edge.
struct Strip {
  std::vector<pbd::Vec4> position;
  std::vector<pbd::SurfaceTriangle> triangles;
  std::vector<uint32_t> marks = std::vector<uint32_t>(group);

  Strip(std::mt19937& random, float bend) {
    std::uniform_real_distribution<float> turn(-bend, bend), off(-0.2f, 0.2f);
    Vec3 at{0, 0, 0};
    float angle = 0;
    for (uint32_t k = 0; k < 6; ++k) {
      for (float z : {0.0f, 1.0f}) position.push_back({at.x, at.y + off(random) * bend, z + off(random), 1});
      angle += turn(random);
      at += Vec3{std::cos(angle), std::sin(angle), 0};
    }
    for (uint32_t t = 0; t < group; ++t)
      triangles.push_back(t % 2 ? pbd::SurfaceTriangle{t + 1, t, t + 2, 0}
                                : pbd::SurfaceTriangle{t, t + 1, t + 2, 0});
    triangles[5].a = pbd::no_index;
  }

  GroupShape shape() {
    Surface surface{};
    surface.tree.triangles = view(triangles);
    surface.position = view(position);
    surface.marks = view(marks);
    std::vector<GroupShape> shapes(1);
    FitShapes{surface, view(shapes)}(0);
    return shapes[0];
  }
  bool is_over_any(Vec3 p) const {
    for (const pbd::SurfaceTriangle& t : triangles) {
      if (t.a != pbd::no_index &&
          pbd::is_over_triangle(p, position[t.a].xyz(), position[t.b].xyz(), position[t.c].xyz()))
        return true;
    }
    return false;
  }
};

TEST(SheetShapes, LeaveNothingOutThatAPointIsOver) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> u(-5, 9);
  int over = 0, left_out = 0, flat = 0;
  for (int n = 0; n < 400; ++n) {
    const float bend = static_cast<float>(n % 4) * 0.15f;
    Strip strip(random, bend);
    const GroupShape shape = strip.shape();
    for (int k = 0; k < 100; ++k) {
      const Vec3 p{u(random), u(random), u(random)};
      over += strip.is_over_any(p);
      EXPECT_TRUE(shape.may_be_over(p) || !strip.is_over_any(p));
      if (bend > 0) continue;
      ++flat;
      left_out += !shape.may_be_over(p);
    }
  }
  EXPECT_GT(over, 500);
  EXPECT_GT(left_out, flat / 2) << "most points lie beside a flat group";
}

TEST(SheetShapes, MayBeUnderAnythingAtABorder) {
  std::mt19937 random(6);
  Strip strip(random, 0);
  EXPECT_FALSE(strip.shape().may_be_over({30, 1, 0}));
  strip.marks[3] = 1;
  EXPECT_TRUE(strip.shape().may_be_over({30, 1, 0}));
}

}  // namespace
}  // namespace meniscus::tests
