// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The tree over a surface's triangles against looking at all of them.
#include "pbd/surface_tree/surface_tree.h"

#include <gtest/gtest.h>

#include <random>

#include "pbd/surface_tree/order.h"
#include "tests/bench/harness/self_contact_bench.h"
#include "tests/devices.h"

namespace meniscus::tests {
namespace {

using pbd::joined;
using pbd::overlap;
using pbd::SurfaceTriangle;
using pbd::Vec4;

class SurfaceTreeTest : public OnDevice {
 protected:
  std::mt19937 random_{3};

  Vec3 anywhere(float size) {
    std::uniform_real_distribution<float> u(-size, size);
    return {u(random_), u(random_), u(random_)};
  }

  /// Two pieces of cloth, of which nothing is a multiple of eight, crumpled and on the move.
  ClothCase crumpled(int columns) {
    ClothCase c;
    const auto shape = [&](float u, float v) { return Vec3{u, 0.2f * std::sin(9 * u + 5 * v), v}; };
    c.add_sheet(columns, 27, 0.02f, 1e-4f, {}, shape);
    c.add_sheet(7, 6, 0.05f, 1e-4f, {}, [&](float u, float v) { return Vec3{u, 0.1f, v + 0.2f}; });
    return c;
  }

  static Aabb displacement_of(const SurfaceTriangle& t, std::span<const Vec4> from, std::span<const Vec4> to,
                              float reach) {
    Aabb box = pbd::empty_box;
    for (uint32_t v : {t.a, t.b, t.c})
      for (Vec3 x : {from[v].xyz(), to[v].xyz()}) box = joined(box, {x, x});
    return pbd::inflated(box, reach);
  }

  void expect_all_found(const ClothCase& c) {
    const std::unique_ptr<SelfContactBench> bench = make_self_contact_bench(GetParam(), c);
    std::vector<Vec4> to = c.vertices;
    for (Vec4& x : to) x = pbd::with_w(x.xyz() + anywhere(0.03f), x.w);
    std::vector<Aabb> boxes;
    for (int n = 0; n < 200; ++n) {
      const Vec3 at = anywhere(0.6f);
      boxes.push_back(pbd::inflated({at, at}, n < 3 ? 1.0f : 0.001f * float(n)));
    }
    const auto found = bench->overlaps(c.vertices, to, 0.004f, boxes, false);
    EXPECT_EQ(bench->overlaps(c.vertices, to, 0.004f, boxes, true), found);
    size_t total = 0;
    for (size_t b = 0; b < boxes.size(); ++b) {
      std::vector<uint32_t> expected;
      for (uint32_t t = 0; t < c.triangles.size(); ++t)
        if (overlap(displacement_of(c.triangles[t], c.vertices, to, 0.004f), boxes[b])) expected.push_back(t);
      EXPECT_EQ(found[b], expected) << "box " << b;
      total += expected.size();
    }
    EXPECT_GT(total, 3 * c.triangles.size());
  }
};

TEST_P(SurfaceTreeTest, FindsWhatLookingAtAllFinds) {
  expect_all_found(crumpled(41));
}

TEST_P(SurfaceTreeTest, FindsItInTreesOfOneAndTwoLevels) {
  for (int columns : {2, 3, 6}) expect_all_found(crumpled(columns));
}

TEST(SurfaceOrder, HasEachTriangleOnceAndNoGroupOfTwoParts) {
  ClothCase c;
  const auto flat = [](float u, float v) { return Vec3{u, 0, v}; };
  for (int n = 2; n < 12; ++n) c.add_sheet(n, 5, 0.01f, 1, {}, flat);
  const std::vector<uint32_t> order = pbd::tree_order(c.triangles, c.rest);
  ASSERT_EQ(order.size() % 8, 0u);
  std::vector<int> seen(c.triangles.size());
  for (size_t place = 0; place < order.size(); ++place) {
    if (order[place] == pbd::no_index) continue;
    ++seen[order[place]];
    const uint32_t first = order[place / 8 * 8];
    ASSERT_NE(first, pbd::no_index);
    EXPECT_EQ(c.triangles[order[place]].piece, c.triangles[first].piece);
  }
  for (int times : seen) EXPECT_EQ(times, 1);
}

TEST(SurfaceOrder, KeepsGroupsCompact) {
  ClothCase c;
  c.add_sheet(101, 77, 0.01f, 1, {}, [](float u, float v) { return Vec3{u, 0, v}; });
  const std::vector<uint32_t> order = pbd::tree_order(c.triangles, c.rest);
  double area = 0;
  for (size_t g = 0; g < order.size() / 8; ++g) {
    Aabb box = pbd::empty_box;
    for (size_t k = 8 * g; k < 8 * g + 8; ++k) {
      if (order[k] == pbd::no_index) continue;
      const SurfaceTriangle& t = c.triangles[order[k]];
      for (uint32_t v : {t.a, t.b, t.c}) box = joined(box, {c.rest[v], c.rest[v]});
    }
    area += double(box.upper.x - box.lower.x) * double(box.upper.z - box.lower.z);
  }
  EXPECT_LT(area, 1.8 * 1.00 * 0.76);  // boxes of perfect groups would cover each place once
}

MENISCUS_ON_EACH_DEVICE(SurfaceTreeTest);

}  // namespace
}  // namespace meniscus::tests
