// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Spray, foam and bubbles before, on, in and behind water.
#include "tests/pictures/golden.h"

namespace meniscus::tests {
namespace {

constexpr float spacing = 0.05f;

class FoamPictures : public GoldenTest {
 protected:
  static io::PreviewScene pool_side() { return on_ground({0, 1.0f, 2.2f}, {0, 0.2f, 0}, 32); }

  /// A pool, and a ball of water before it.
  static Water pool_and_ball(bool has_ball) {
    return Water(points_where(spacing, {0.8f, 0.75f, 1.1f},
                              [&](Vec3 p) {
                                const bool in_ball = length(p - Vec3{0.1f, 0.45f, 0.85f}) < 0.2f;
                                return (p.y > 0 && p.y < 0.25f && p.z < 0.6f) || (has_ball && in_ball);
                              }),
                 spacing);
  }

  /// Pieces all over a square at this height; a third of the square has none.
  static void add(std::vector<DiffuseParticle>& all, DiffuseKind kind, Vec3 lower, float size, float apart,
                  Vec3 velocity = {}) {
    std::mt19937 random(3);
    const int count = static_cast<int>(size / apart);
    for (Vec3 p : lattice(count, 1, count, apart, lower)) {
      p = p + random_vector(random, apart);
      if (std::sin(9 * p.x) + std::sin(7 * p.z) > -0.6f) all.push_back({p, velocity, 2, kind});
    }
  }
};

TEST_F(FoamPictures, OnWaterAndBeforeIt) {
  std::vector<DiffuseParticle> diffuse;
  add(diffuse, DiffuseKind::foam, {-0.7f, 0.26f, -0.9f}, 1.3f, 0.012f);
  add(diffuse, DiffuseKind::spray, {-0.3f, 0.5f, 0.6f}, 0.5f, 0.03f, {2, 3, 0});
  const Water water = pool_and_ball(false);
  render::Moment moment = water.moment();
  moment.diffuse = diffuse;
  expect_drawn("foam_before_water", pool_side(), moment);
}

/// Foam of the pool is dyed by the ball before it, and by nothing else. Bubbles are dyed by the pool.
TEST_F(FoamPictures, BehindWater) {
  std::vector<DiffuseParticle> diffuse;
  add(diffuse, DiffuseKind::foam, {-0.1f, 0.26f, -0.9f}, 1.3f, 0.012f);
  add(diffuse, DiffuseKind::bubble, {-0.75f, 0.1f, -0.9f}, 0.7f, 0.01f);
  io::PreviewScene scene = pool_side();
  scene.fluid_colors = {{0.45f, 0.7f, 0.85f}};
  const Water water = pool_and_ball(true);
  render::Moment moment = water.moment();
  moment.diffuse = diffuse;
  expect_drawn("foam_behind_water", scene, moment);
}

}  // namespace
}  // namespace meniscus::tests
