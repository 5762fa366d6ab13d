// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Bodies that are attached to cloth and ropes, and the forces in these attachments, with both solvers.
#include <gtest/gtest.h>

#include "tests/rigid_solvers.h"
#include "tests/unit/sdk/world/cloth/hanging.h"

namespace meniscus::tests {
namespace {

constexpr float g = 9.81f;

class AttachedBodyTest : public WithSolver, protected Hanging {
 protected:
  AttachedBodyTest() : Hanging(world_def(GetParam(), 0.05f)) {}
};
MENISCUS_WITH_EACH_RIGID_SOLVER(AttachedBodyTest);

TEST_P(AttachedBodyTest, AKinematicBodyBearsTheWeightToo) {
  const ClothId id = hanging_sheet();
  const BodyId bar = world_.create_body(kinematic(BoxGeometry{{0.3f, 0.02f, 0.02f}}, {0, 0.03f, 0}));
  AttachmentDef def = attach(id, vertices_from(0, 9));
  def.body = bar;
  const AttachmentId held = world_.create_attachment(def);
  settle(2);
  const float weight = world_.cloth_state(id).mass * g;
  expect_near(mean_force(held), {0, -weight, 0}, 0.01f * weight);
}

TEST_P(AttachedBodyTest, ADynamicBodyHangsFromCloth) {
  const ClothId id = hanging_sheet(1);
  const AttachmentId above = world_.create_attachment(attach(id, vertices_from(0, 9)));
  BodyDef load = body(BoxGeometry{{0.25f, 0.02f, 0.02f}}, {0, 0.48f, 0});
  load.mass = 0.5f;
  load.can_sleep = false;
  const BodyId bar = world_.create_body(load);
  AttachmentDef def = attach(id, vertices_from(72, 9));
  def.body = bar;
  const AttachmentId below = world_.create_attachment(def);
  settle(4);
  const float weight = world_.cloth_state(id).mass * g;
  const Vec3 top = mean_force(above), bottom = mean_force(below);
  EXPECT_NEAR(top.y, -(weight + 0.5f * g), 0.02f * (weight + 0.5f * g));
  EXPECT_NEAR(bottom.y, 0.5f * g, 0.02f * 0.5f * g);
  EXPECT_NEAR(world_.body_state(bar).pose.position.y, 0.48f, 0.01f);
}

TEST_P(AttachedBodyTest, ARopeBearsABucketAndFeelsItsWeight) {
  RopeDef line = rope({{0, 0, 0}, {0, -1, 0}}, 10);
  line.youngs_modulus = unyielding;
  const RopeId id = world_.create_rope(line);
  const AttachmentId above = world_.create_attachment(attach(id, {0}));
  BodyDef load = body(SphereGeometry{0.1f}, {0, -1.1f, 0});
  load.mass = 2;
  const BodyId bucket = world_.create_body(load);
  AttachmentDef def = attach(id, {10});
  def.body = bucket;
  const AttachmentId below = world_.create_attachment(def);
  settle(1);
  const float rope_weight = 1000 * pi * 25e-6f * g;
  EXPECT_NEAR(mean_force(above).y, -(2 * g + rope_weight), 0.01f * 2 * g);
  EXPECT_NEAR(mean_force(below).y, 2 * g, 0.01f * 2 * g);
  EXPECT_NEAR(length(world_.rope_positions(id)[10] - world_.rope_positions(id)[0]), 1, 3e-3f);
}

// Had it fallen asleep before it was at rest, its rope would pull with 1.4 % less from then on.
TEST_P(AttachedBodyTest, ABodyComesToRestOnItsRope) {
  World world(world_def(GetParam(), 0.05f));
  const RopeId id = world.create_rope(rope({{0, 0, 0}, {0, -1, 0}}, 20));
  world.create_attachment(attach(id, {0}));
  BodyDef load = body(SphereGeometry{0.1f}, {0, -1.1f, 0});
  load.mass = 10;
  AttachmentDef def = attach(id, {20});
  def.body = world.create_body(load);
  const AttachmentId below = world.create_attachment(def);
  run(world, 360, 1 / 60.0f);
  EXPECT_TRUE(world.body_state(*def.body).awake);
  EXPECT_NEAR(world.attachment_force(below).y, 10 * g, 1e-3f * 10 * g);
}

/// The greatest fall of a ball of 34 kg on a rope that extends by 34 mm under its weight. It starts with the
/// rope unloaded, so it may fall twice as far.
float deepest_fall(const SolverCase& which, int substeps, int iterations) {
  WorldDef def = world_def(which, 0.05f);
  def.substeps = substeps;
  def.iterations = iterations;
  World world(def);
  BodyDef ball = body(SphereGeometry{0.16f}, {0, 0.45f, 0});
  ball.density = 2000;
  const BodyId load = world.create_body(ball);
  RopeDef line = rope({{0, 1.4f, 0}, {0, 0.61f, 0}}, 20);
  line.youngs_modulus = 1e8f;
  line.damping = 0;
  const RopeId id = world.create_rope(line);
  world.create_attachment(attach(id, {0}));
  AttachmentDef attachment = attach(id, {20});
  attachment.body = load;
  world.create_attachment(attachment);
  float deepest = 0;
  for (int k = 0; k < 60; ++k) {
    world.step(1 / 60.0f);
    deepest = std::max(deepest, 0.45f - world.body_state(load).centre_of_mass.y);
  }
  return deepest;
}

TEST_P(AttachedBodyTest, AHeavyBodyFallsAsFarAsItsRopeGivesWay) {
  const float mass = 2000 * 4.0f / 3 * pi * 0.16f * 0.16f * 0.16f, area = pi * 25e-6f;
  const float at_rest = mass * g * 0.79f / (1e8f * area);
  const std::pair<int, int> settings[] = {{4, 1}, {4, 10}, {20, 4}};
  for (const auto& [substeps, iterations] : settings) {
    const float deepest = deepest_fall(GetParam(), substeps, iterations);
    EXPECT_GT(deepest, 1.7f * at_rest) << substeps << " x " << iterations;
    EXPECT_LT(deepest, 2.05f * at_rest) << substeps << " x " << iterations;
  }
}

/// A ball of 78 kg, a thousand times as heavy as its rope, with 4 substeps of 10 iterations.
TEST_P(AttachedBodyTest, ARopeBearsAThousandTimesItsWeight) {
  WorldDef def = world_def(GetParam(), 0.05f);
  def.substeps = 4;
  def.iterations = 10;
  World world(def);
  RopeDef line = rope({{0, 0, 0}, {0, -1, 0}}, 20);
  line.youngs_modulus = unyielding;
  const RopeId id = world.create_rope(line);
  world.create_attachment(attach(id, {0}));
  BodyDef load = body(SphereGeometry{0.1f}, {0, -1.1f, 0});
  constexpr float mass = 1000 * (1000 * pi * 25e-6f);
  load.mass = mass;
  load.can_sleep = false;
  AttachmentDef attachment = attach(id, {20});
  attachment.body = world.create_body(load);
  const AttachmentId below = world.create_attachment(attachment);
  float lowest = 0, fastest = 0;
  Vec3 force{0, 0, 0};
  constexpr int steps = 240, last = 60;
  for (int k = 0; k < steps; ++k) {
    world.step(1 / 60.0f);
    const BodyState state = world.body_state(*attachment.body);
    lowest = std::min(lowest, state.centre_of_mass.y);
    if (k < steps - last) continue;
    fastest = std::max(fastest, length(state.velocity));
    force += world.attachment_force(below) / float(last);
  }
  EXPECT_GT(lowest, -1.11f);
  EXPECT_LT(fastest, 0.01f);
  EXPECT_NEAR(force.y, mass * g, 0.01f * mass * g);
}

TEST_P(AttachedBodyTest, AKinematicBodyTakesItsClothAlong) {
  const ClothId id = world_.create_cloth(sheet(0.5f, 0.5f, 5, 5, {0, 2, 0}));
  const BodyId bar = world_.create_body(kinematic(BoxGeometry{{0.3f, 0.02f, 0.02f}}, {0, 2.05f, -0.25f}));
  AttachmentDef def = attach(id, vertices_from(0, 5));
  def.body = bar;
  world_.create_attachment(def);
  world_.move_body(bar, {{1, 2.05f, -0.25f}, about_z(90)}, 1);
  run(world_, 100, 0.016f);
  for (uint32_t v = 0; v < 5; ++v) {
    const float along = 0.125f * float(v) - 0.25f;
    expect_near(world_.cloth_positions(id)[v], {1.05f, 2.05f + along, -0.25f}, 2e-3f);
  }
}

TEST_P(AttachedBodyTest, ForcesOfAttachmentsMadeSinceTheLastStepReadZero) {
  const ClothId id = hanging_sheet();
  const BodyId bar = world_.create_body(kinematic(BoxGeometry{{0.3f, 0.02f, 0.02f}}, {0, 0.03f, 0}));
  AttachmentDef def = attach(id, vertices_from(0, 4));
  def.body = bar;
  const AttachmentId first = world_.create_attachment(def);
  run(world_, 30, 1 / 60.0f);
  const Vec3 before = world_.attachment_force(first);
  EXPECT_LT(before.y, -0.1f);
  def.vertices = vertices_from(4, 5);
  const AttachmentId second = world_.create_attachment(def),
                     third = world_.create_attachment(attach(id, {80}));
  world_.diagnostics();  // for which cloth is uploaded
  EXPECT_EQ(world_.attachment_force(second), (Vec3{0, 0, 0}));
  EXPECT_EQ(world_.attachment_force(third), (Vec3{0, 0, 0}));
  EXPECT_EQ(world_.attachment_force(first), before);
  run(world_, 3, 1 / 60.0f);
  EXPECT_NE(world_.attachment_force(second), (Vec3{0, 0, 0}));
  EXPECT_NE(world_.attachment_force(third), (Vec3{0, 0, 0}));
  const Vec3 last = world_.attachment_force(third);
  world_.destroy_body(bar);
  EXPECT_EQ(world_.attachment_force(third), last);
}

}  // namespace
}  // namespace meniscus::tests
