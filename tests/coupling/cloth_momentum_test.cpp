// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The exchange of momentum between cloth and cloth, and between cloth and bodies: the total is conserved.
#include <gtest/gtest.h>

#include "tests/cloth_worlds.h"
#include "tests/coupling/body_worlds.h"
#include "tests/rigid_solvers.h"

namespace meniscus::tests {
namespace {

class ClothMomentum : public WithSolver {
 protected:
  World world_{still_def()};

  WorldDef still_def() const {
    WorldDef def = world_def(GetParam(), 0.05f);
    def.gravity = {0, 0, 0};
    def.substeps = 8;
    def.iterations = 4;
    return def;
  }

  void SetUp() override { world_.set_wind({.air_density = 0}); }

  template <class Sum>
  void expect_kept(int steps, double linear, double angular, const Sum& sum) {
    const Momentum before = sum();
    for (int k = 0; k < steps; ++k) {
      world_.step(1 / 60.0f);
      const Momentum now = sum();
      EXPECT_LT(norm(now.linear - before.linear), linear * before.gross) << "step " << k;
      EXPECT_LT(norm(now.angular - before.angular), angular * before.gross) << "step " << k;
    }
    const Momentum after = sum();
    RecordProperty("linear_drift",
                   std::to_string(1e6 * norm(after.linear - before.linear) / before.gross) + "e-6");
    RecordProperty("angular_drift",
                   std::to_string(1e6 * norm(after.angular - before.angular) / before.gross) + "e-6");
  }
};

TEST_P(ClothMomentum, TwoSheetsThatCollideKeepIt) {
  ClothDef upper = sheet(0.6f, 0.6f, 21, 21, {0.1f, 0.1f, 0.05f}), lower = sheet(0.5f, 0.5f, 17, 17);
  upper.velocity = {0, -2, 0};
  lower.velocity = {0.3f, 0, 0};
  upper.pose.rotation = about_z(10);
  const ClothId a = world_.create_cloth(upper), b = world_.create_cloth(lower);
  expect_kept(60, 1e-5, 0.001, [&] { return cloth_momentum(world_, a) + cloth_momentum(world_, b); });
  EXPECT_LT(cloth_momentum(world_, b).linear.y, -0.005) << "they did not meet";
}

TEST_P(ClothMomentum, ASheetThatTumblesKeepsIt) {
  ClothDef def = sheet(0.6f, 0.6f, 21, 21);
  def.self_collision = false;
  def.stretch = {1.05f, 1, 0.97f};
  def.velocity = {1, 2, 0};
  const ClothId id = world_.create_cloth(def);
  expect_kept(60, 1e-6, 0.001, [&] { return cloth_momentum(world_, id); });
}

TEST_P(ClothMomentum, ABallAndASheetExchangeIt) {
  const ClothId id = world_.create_cloth(sheet(0.6f, 0.6f, 21, 21));
  BodyDef def = body(SphereGeometry{0.1f}, {0.02f, 0.15f, 0.01f}, 20);
  def.velocity = {0, -2, 0};
  const BodyId ball = world_.create_body(def);
  expect_kept(60, 1e-5, 0.005, [&] { return cloth_momentum(world_, id) + body_momentum(world_, ball); });
  EXPECT_LT(cloth_momentum(world_, id).linear.y, -0.02) << "they did not meet";
}

TEST_P(ClothMomentum, ABodyAttachedToASheetExchangesIt) {
  const ClothId id = world_.create_cloth(sheet(0.6f, 0.6f, 21, 21));
  BodyDef def = body(BoxGeometry{{0.05f, 0.05f, 0.05f}}, {0, -0.06f, 0.3f}, 100);
  def.velocity = {0.5f, -1, 0};
  const BodyId box = world_.create_body(def);
  AttachmentDef attachment = attach(id, {429, 430, 431});
  attachment.body = box;
  world_.create_attachment(attachment);
  expect_kept(60, 1e-5, 0.005, [&] { return cloth_momentum(world_, id) + body_momentum(world_, box); });
  EXPECT_LT(cloth_momentum(world_, id).linear.y, -0.005) << "it does not follow";
}

// The CCD fail-safe of cloth against cloth does not affect ropes, which pass through cloth.
TEST_P(ClothMomentum, ARopeThatABallHitsExchangesItBesideCloth) {
  world_.create_cloth(sheet(0.1f, 0.1f, 21, 21, {0, 3, 0}));
  RopeDef line = rope({{-0.5f, 0, 0}, {0.5f, 0, 0}}, 20);
  line.radius = 0.02f;
  const RopeId id = world_.create_rope(line);
  BodyDef def = body(SphereGeometry{0.1f}, {0.02f, 0.2f, 0.01f}, 500);
  def.velocity = {0, -8, 0};
  const BodyId ball = world_.create_body(def);
  const auto rope_momentum = [&] {
    Momentum sum;
    const auto x = world_.rope_positions(id), v = world_.rope_velocities(id);
    const double segment = 3.14159265358979 * 0.02 * 0.02 * 1000 / 20;
    for (size_t k = 0; k < x.size(); ++k)
      add(sum, segment * (k == 0 || k + 1 == x.size() ? 0.5 : 1), x[k], v[k]);
    return sum;
  };
  expect_kept(60, 1e-5, 0.005, [&] { return rope_momentum() + body_momentum(world_, ball); });
  EXPECT_LT(rope_momentum().linear.y, -0.1) << "they did not meet";
}

MENISCUS_WITH_EACH_RIGID_SOLVER(ClothMomentum);

}  // namespace
}  // namespace meniscus::tests
