// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The candidate shapes of a particle: all that it could touch, and few others.
#include "collision/contact/candidates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "pbd/device/cpu/cpu_device.h"
#include "tests/unit/collision/mesh_shapes.h"

namespace meniscus::collision {
namespace {

using pbd::Vec4;

struct Scene {
  pbd::CpuDevice device;
  std::vector<Shape> shapes;
  std::vector<Vec4> from, to;

  uint32_t fixed = 0, worlds = 1;

  ShapeSet set() {
    return {{shapes.data(), static_cast<uint32_t>(shapes.size())}, fixed, {}, {}, {}, worlds};
  }

  void add_box(Vec3 centre, float half) {
    Shape shape;
    shape.kind = ShapeKind::box;
    shape.bounds = {centre - Vec3{half, half, half}, centre + Vec3{half, half, half}};
    shapes.push_back(shape);
  }
  void add_motion(Vec3 a, Vec3 b) {
    from.push_back(pbd::with_w(a, 1));
    to.push_back(pbd::with_w(b, 1));
  }

  /// For each particle, the numbers it is given.
  std::vector<std::vector<uint32_t>> find(float reach) {
    const auto count = static_cast<uint32_t>(from.size());
    Candidates candidates(device);
    candidates.reserve(count, set().of_world());
    candidates.find(device, set(), {from.data(), count}, {to.data(), count}, count, reach,
                    {set().worlds, count / set().worlds});
    std::vector<std::vector<uint32_t>> found(count);
    for (uint32_t i = 0; i < count; ++i)
      candidates.view().for_each(i, [&](uint32_t shape) { found[i].push_back(shape); });
    return found;
  }
};

TEST(Candidates, NothingWithinReachIsLeftOut) {
  Noise noise(7);
  for (int shapes : {1, 31, 32, 33, 100}) {
    Scene scene;
    for (int k = 0; k < shapes; ++k) scene.add_box(noise.in_cube(2), 0.2f * noise.next());
    for (int n = 0; n < 100; ++n) {
      const Vec3 a = noise.in_cube(2);
      scene.add_motion(a, a + noise.in_cube(0.3f));
    }
    constexpr float reach = 0.1f;
    const auto found = scene.find(reach);
    for (size_t i = 0; i < found.size(); ++i) {
      EXPECT_TRUE(std::is_sorted(found[i].begin(), found[i].end()));
      for (uint32_t k = 0; k < scene.shapes.size(); ++k) {
        const bool near = !out_of_reach(scene.shapes[k], scene.from[i].xyz(), scene.to[i].xyz(), reach);
        if (near) {
          EXPECT_TRUE(std::binary_search(found[i].begin(), found[i].end(), k)) << i << ' ' << k;
        }
      }
    }
  }
}

TEST(Candidates, APlaneIsAlwaysOneAndWhatIsFarNever) {
  Scene scene;
  scene.shapes.emplace_back();  // a plane
  for (int k = 0; k < 40; ++k) scene.add_box({100, 0, 0}, 1);
  scene.add_box({0, 0, 0}, 0.1f);
  for (int n = 0; n < 70; ++n) scene.add_motion({0.01f * float(n % 7), 0, 0}, {0, 0.1f, 0});
  for (const auto& found : scene.find(0.1f)) EXPECT_EQ(found, (std::vector<uint32_t>{0, 41}));
}

// The last cluster is not full: its box is that of the particles that are there.
TEST(Candidates, ParticlesOfOneClusterShareAList) {
  Scene scene;
  scene.add_box({0, 0, 0}, 0.1f);
  for (uint32_t n = 0; n < cluster_size + 5; ++n) {
    const Vec3 p = n == 3 ? Vec3{0, 0, 0} : Vec3{9, 9, 9};
    scene.add_motion(p, p);
  }
  const auto found = scene.find(0.1f);
  for (size_t i = 0; i < found.size(); ++i) EXPECT_EQ(found[i].size(), i < cluster_size ? 1u : 0u) << i;
}

// Worlds of fewer particles than a cluster has, and of more. Shapes of other worlds are at the same places.
TEST(Candidates, AreOfTheParticlesOwnWorld) {
  Noise noise(11);
  for (uint32_t each : {5u, 33u, 100u}) {
    Scene scene;
    scene.fixed = 2;
    scene.worlds = 7;
    constexpr uint32_t moving = 40;
    for (uint32_t k = 0; k < scene.fixed + scene.worlds * moving; ++k) scene.add_box(noise.in_cube(2), 0.3f);
    for (uint32_t n = 0; n < scene.worlds * each; ++n) {
      const Vec3 a = noise.in_cube(2);
      scene.add_motion(a, a);
    }
    const auto found = scene.find(0.1f);
    for (uint32_t i = 0; i < found.size(); ++i) {
      const uint32_t first = scene.fixed + i / each * moving;
      for (uint32_t k : found[i]) EXPECT_TRUE(k < scene.fixed || (k >= first && k < first + moving)) << i;
      for (uint32_t k = 0; k < scene.shapes.size(); ++k) {
        if (k >= scene.fixed && (k < first || k >= first + moving)) continue;
        const bool near = !out_of_reach(scene.shapes[k], scene.from[i].xyz(), scene.to[i].xyz(), 0.1f);
        EXPECT_TRUE(!near || std::count(found[i].begin(), found[i].end(), k)) << i << ' ' << k;
      }
    }
  }
}

TEST(Candidates, TheWayCountsAndNotItsEndsAlone) {
  Scene scene;
  scene.add_box({0, 0, 0}, 0.1f);
  scene.add_motion({-5, 0, 0}, {5, 0, 0});
  EXPECT_EQ(scene.find(0.01f)[0].size(), 1u);
}

}  // namespace
}  // namespace meniscus::collision
