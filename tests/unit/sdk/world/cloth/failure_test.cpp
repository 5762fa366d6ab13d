// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A step of cloth that fails leaves the state as it was. A step that is repeated for lack of room leaves no
// trace.
#include <gtest/gtest.h>

#include "tests/cloth_worlds.h"
#include "tests/unit/sdk/world/solids/body_worlds.h"

namespace meniscus::tests {
namespace {

constexpr float dt = 0.01f;

class ClothFailureTest : public OnDevice {
 protected:
  struct Parts {
    World world;
    ClothId cloth;
    RopeId rod;
    AttachmentId held, attached;
    BodyId body;
  };

  /// A sheet between the world and a body, a rope or a rod, gusts.
  static Parts make(pbd::DeviceKind device, bool bends = true) {
    Parts p{World(world_def(device, 0.05f)), {}, {}, {}, {}, {}};
    p.cloth = p.world.create_cloth(sheet(0.5f, 0.5f, 9, 9));
    RopeDef rod = rope({{1, 0, 0}, {2, 0, 0}}, 8);
    rod.bends_and_twists = bends;
    p.rod = p.world.create_rope(rod);
    p.held = p.world.create_attachment(attach(p.cloth, vertices_from(0, 9)));
    AttachmentDef attachment = attach(p.cloth, {80});
    p.body = p.world.create_body(body(SphereGeometry{0.03f}, {0.27f, 0, 0.27f}));
    attachment.body = p.body;
    p.attached = p.world.create_attachment(attachment);
    p.world.create_attachment(attach(p.rod, {0}));
    p.world.set_wind({.velocity = {3, 0, 1}, .gust_speed = 1});
    return p;
  }

  static void expect_failure(World& world, const std::string& named = "non-finite", float seconds = 1e20f) {
    expect_error(ErrorCode::non_finite, named, [&] { world.step(seconds); });
  }
};

TEST_P(ClothFailureTest, AFailedStepLeavesAllAsItWas) {
  Parts p = make(GetParam(), true);
  run(p.world, 10, dt);
  const uint64_t hash = p.world.state_hash();
  const std::vector<Vec3> x = copy_of(p.world.cloth_positions(p.cloth));
  const std::vector<Quat> frames(p.world.rope_frames(p.rod).begin(), p.world.rope_frames(p.rod).end());
  const double time = p.world.time();
  expect_failure(p.world);
  EXPECT_EQ(p.world.state_hash(), hash);
  EXPECT_EQ(p.world.time(), time);
  for (size_t v = 0; v < x.size(); ++v) EXPECT_EQ(p.world.cloth_positions(p.cloth)[v], x[v]);
  for (size_t s = 0; s < frames.size(); ++s) {
    EXPECT_EQ(p.world.rope_frames(p.rod)[s].x, frames[s].x);
    EXPECT_EQ(p.world.rope_frames(p.rod)[s].w, frames[s].w);
  }
}

TEST_P(ClothFailureTest, AFailedStepLeavesNoTraceInWhatFollows) {
  Parts p = make(GetParam()), twin = make(GetParam());
  for (int times = 0; times < 3; ++times) {
    run(p.world, 7, dt);
    run(twin.world, 7, dt);
    expect_failure(p.world);
  }
  run(p.world, 7, dt);
  run(twin.world, 7, dt);
  EXPECT_EQ(p.world.state_hash(), twin.world.state_hash());
  EXPECT_EQ(p.world.attachment_force(p.held), twin.world.attachment_force(twin.held));
  EXPECT_EQ(p.world.attachment_force(p.attached), twin.world.attachment_force(twin.attached));
}

TEST_P(ClothFailureTest, AfterAFailedStepAttachmentsReadNoForce) {
  Parts p = make(GetParam());
  run(p.world, 10, dt);
  expect_failure(p.world);
  EXPECT_EQ(p.world.attachment_force(p.held), (Vec3{0, 0, 0}));
  EXPECT_EQ(p.world.attachment_force(p.attached), (Vec3{0, 0, 0}));
}

TEST_P(ClothFailureTest, NorDoTheyWhereABodyHasFailed) {
  Parts p = make(GetParam());
  run(p.world, 10, dt);
  p.world.apply_force(p.body, {3e38f, 0, 0}, {0.27f, 0, 0.27f});
  expect_failure(p.world, "body", 0.1f);
  EXPECT_EQ(p.world.attachment_force(p.held), (Vec3{0, 0, 0}));
  EXPECT_EQ(p.world.attachment_force(p.attached), (Vec3{0, 0, 0}));
}

TEST_P(ClothFailureTest, TheFirstStepMayFailAsWell) {
  Parts p = make(GetParam()), twin = make(GetParam());
  expect_failure(p.world);
  EXPECT_EQ(p.world.state_hash(), twin.world.state_hash());
  run(p.world, 5, dt);
  run(twin.world, 5, dt);
  EXPECT_EQ(p.world.state_hash(), twin.world.state_hash());
}

TEST_P(ClothFailureTest, TheCulpritIsNamedByItsPieceAndNumber) {
  World world(world_def(GetParam(), 0.05f));
  world.add_fluid(block(world.create_fluid({}), {5, 0, 0}, {5.2f, 0.2f, 0.2f}));
  world.create_cloth(sheet(1, 1, 3, 3));
  ClothDef mad = sheet(1, 1, 3, 3, {0, 5, 0});
  mad.name = "veil";
  mad.velocity = {3e38f, 0, 0};
  const ClothId id = world.create_cloth(mad);
  expect_failure(world, "vertex 0 of the cloth \"veil\"", 1000);
  world.destroy_cloth(id);
  RopeDef line = rope({{0, 8, 0}, {1, 8, 0}}, 3);
  line.name = "leash";
  line.velocity = {0, 3e38f, 0};
  world.create_rope(line);
  expect_failure(world, "of the rope \"leash\"", 1000);
}

TEST_P(ClothFailureTest, WithoutTheCulpritTheWorldGoesOn) {
  World world(world_def(GetParam(), 0.05f));
  const ClothId good = world.create_cloth(sheet(1, 1, 3, 3));
  ClothDef mad = sheet(1, 1, 3, 3, {0, 5, 0});
  mad.velocity = {3e38f, 0, 0};
  const ClothId id = world.create_cloth(mad);
  expect_failure(world, "non-finite", 1000);
  world.destroy_cloth(id);
  run(world, 10, dt);
  EXPECT_NEAR(world.cloth_state(good).centre.y, -0.5f * 9.81f * 0.01f, 0.01f);
}

TEST_P(ClothFailureTest, ClothThatFliesOffTooFastIsAFailure) {
  for (const float speed : {1e22f, 1e25f, 1e30f}) {
    SCOPED_TRACE(speed);
    World world(world_def(GetParam(), 0.05f));
    world.create_cloth(sheet(1, 1, 15, 15));
    const FluidId water = world.create_fluid({});
    world.add_fluid(block(water, {-0.2f, 0.1f, -0.2f}, {0.2f, 0.3f, 0.2f}));
    ClothDef mad = sheet(1, 1, 15, 15, {0, 1, 0});
    mad.velocity = {speed, 0, 0};
    world.create_cloth(mad);
    expect_failure(world, "non-finite", dt);
  }
}

// Contacts start with little room. A world in which there was more from the beginning must agree with one in
// which steps had to be done again.
TEST_P(ClothFailureTest, AStepThatIsDoneAgainIsTheSame) {
  World roomy(world_def(GetParam(), 0.05f)), tight(world_def(GetParam(), 0.05f));
  for (World* world : {&roomy, &tight}) world->create_shape(shape(PlaneGeometry{}));
  const ClothId filler = roomy.create_cloth(sheet(2, 2, 81, 81, {0, 0.004f, 0}));
  run(roomy, 3, dt);
  roomy.destroy_cloth(filler);
  for (World* world : {&roomy, &tight}) {
    world->create_cloth(sheet(2, 2, 61, 61, {0, 0.3f, 0}));
    RopeDef rod = rope({{2, 0.3f, 0}, {3, 0.3f, 0}}, 20);
    rod.bends_and_twists = true;
    world->create_rope(rod);
    world->step(dt);
  }
  const size_t before = tight.device_bytes();
  run(roomy, 30, dt);
  run(tight, 30, dt);
  EXPECT_GT(tight.device_bytes(), before) << "nothing was done again";
  EXPECT_EQ(roomy.state_hash(), tight.state_hash());
}

MENISCUS_ON_EACH_DEVICE(ClothFailureTest);

}  // namespace
}  // namespace meniscus::tests
