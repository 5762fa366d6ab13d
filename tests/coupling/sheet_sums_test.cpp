// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The force and torque that contacts of cloth distribute to its vertices, in double precision.
#include <gtest/gtest.h>

#include <random>

#include "collision/fluid_cloth/load.h"
#include "tests/coupling/body_worlds.h"

namespace meniscus::tests {
namespace {

using namespace collision::fluid_cloth_kernels;

template <class T>
pbd::View<T> view(std::vector<T>& values) {
  return {values.data(), static_cast<uint32_t>(values.size())};
}

TEST(SheetSums, TheVerticesGetTheOppositeOfAllPushesAtTheirLevers) {
  constexpr uint32_t vertices = 60;
  std::mt19937 random(7);
  std::uniform_real_distribution<float> share(0, 1);
  std::vector<Vec3> x;
  for (uint32_t v = 0; v < vertices; ++v) x.push_back(random_vector(random, 2));
  std::vector<FluidClothContact> touches(700);
  std::vector<std::vector<uint32_t>> of_vertex(vertices);
  Sum3 linear, angular;
  double gross = 0, gross_angular = 0;
  for (uint32_t n = 0; n < touches.size(); ++n) {
    FluidClothContact& t = touches[n];
    t = {};
    const float u = share(random), v = share(random) * (1 - u);
    const uint32_t first = static_cast<uint32_t>(random() % (vertices - 2));
    const float weights[] = {1 - u - v, u, v};
    for (uint32_t k = 0; k < 3; ++k) {
      of_vertex[first + k].push_back(n << 5 | k);
      t.add(first + k, weights[k]);
    }
    t.point = t.mean([&](uint32_t at) { return x[at]; });
    t.pending = random_vector(random, 0.01f);
    linear += -1 * Sum3(t.pending);
    angular += -1 * cross(Sum3(t.point), t.pending);
    gross += norm(t.pending);
    gross_angular += norm(t.point) * norm(t.pending);
  }
  std::vector<uint32_t> start{0}, entries;
  for (const auto& list : of_vertex) {
    entries.insert(entries.end(), list.begin(), list.end());
    start.push_back(static_cast<uint32_t>(entries.size()));
  }
  std::vector<float> self_weight(vertices, 100);
  const LoadedVertices loaded{view(start), view(entries), view(touches), view(self_weight),
                              std::ldexp(1.0f, -49)};
  Sum3 got, turned;
  for (uint32_t v = 0; v < vertices; ++v) {
    const Sum3 push = loaded.pending(v);
    got += push;
    turned += cross(Sum3(x[v]), push);
  }
  EXPECT_LE(norm(got - linear), 1e-6 * gross);
  EXPECT_LE(norm(turned - angular), 1e-6 * gross_angular);
}

}  // namespace
}  // namespace meniscus::tests
