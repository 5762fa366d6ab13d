// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Cloth, ropes and attachments come and go; their ids mean them alone, and their vertices stay what they are
// wherever they lie in memory.
#include <gtest/gtest.h>

#include "tests/cloth_worlds.h"
#include "tests/unit/sdk/world/solids/body_worlds.h"

namespace meniscus::tests {
namespace {

constexpr float dt = 0.01f;

class ClothIdTest : public OnDevice {
 protected:
  World world_{world_def(GetParam(), 0.05f)};

  template <class Call>
  void expect_unknown(const std::string& what, const Call& call) {
    expect_error(ErrorCode::not_found, what, call);
  }

  /// Every call that takes a piece of cloth.
  void expect_unknown_cloth(ClothId id) {
    expect_unknown("cloth", [&] { world_.destroy_cloth(id); });
    expect_unknown("cloth", [&] { world_.cloth_positions(id); });
    expect_unknown("cloth", [&] { world_.cloth_velocities(id); });
    expect_unknown("cloth", [&] { world_.cloth_normals(id); });
    expect_unknown("cloth", [&] { world_.cloth_triangles(id); });
    expect_unknown("cloth", [&] { world_.cloth_strains(id); });
    expect_unknown("cloth", [&] { world_.cloth_state(id); });
    expect_unknown("cloth", [&] { world_.create_attachment(attach(id, {0})); });
  }

  void expect_unknown_rope(RopeId id) {
    expect_unknown("rope", [&] { world_.destroy_rope(id); });
    expect_unknown("rope", [&] { world_.rope_positions(id); });
    expect_unknown("rope", [&] { world_.rope_velocities(id); });
    expect_unknown("rope", [&] { world_.rope_frames(id); });
    expect_unknown("rope", [&] { world_.create_attachment(attach(id, {0})); });
  }

  void expect_unknown_attachment(AttachmentId id) {
    expect_unknown("attachment", [&] { world_.destroy_attachment(id); });
    expect_unknown("attachment", [&] { world_.attachment_force(id); });
    expect_unknown("attachment", [&] { world_.attachment_vertices(id); });
  }

  static RopeDef line(float x) { return rope({{x, 0, 0}, {x, 1, 0}}, 4); }
};

TEST_P(ClothIdTest, AnIdThatIsStaleMeansNothingThoughItsPlaceIsTakenAgain) {
  const ClothId gone = world_.create_cloth(sheet(1, 1, 4, 4));
  const ClothId other = world_.create_cloth(sheet(1, 1, 5, 5, {3, 0, 0}));
  world_.step(dt);
  world_.destroy_cloth(gone);
  expect_unknown_cloth(gone);
  const ClothId next = world_.create_cloth(sheet(1, 1, 3, 3, {0, 7, 0}));
  EXPECT_EQ(next.index, gone.index);
  expect_unknown_cloth(gone);
  EXPECT_EQ(world_.cloth_positions(next).size(), 9u);
  EXPECT_EQ(world_.cloth_positions(next)[0].y, 7);
  EXPECT_EQ(world_.cloth_positions(other).size(), 25u);
  world_.step(dt);
}

TEST_P(ClothIdTest, RopesAndAttachmentsLikewise) {
  const RopeId gone = world_.create_rope(line(0)), other = world_.create_rope(line(3));
  const AttachmentId held = world_.create_attachment(attach(other, {4}));
  world_.step(dt);
  world_.destroy_rope(gone);
  world_.destroy_attachment(held);
  expect_unknown_rope(gone);
  expect_unknown_attachment(held);
  const RopeId next = world_.create_rope(line(5));
  EXPECT_EQ(next.index, gone.index);
  EXPECT_EQ(world_.create_attachment(attach(next, {0})).index, held.index);
  expect_unknown_rope(gone);
  expect_unknown_attachment(held);
  world_.step(dt);
  EXPECT_EQ(world_.rope_positions(next)[0], (Vec3{5, 0, 0}));
}

TEST_P(ClothIdTest, IdsThatNoCreateCallGaveAreRefused) {
  world_.create_cloth(sheet(1, 1, 2, 2));
  for (ClothId id : {ClothId{}, ClothId{0, 0}, ClothId{7, 1}}) expect_unknown_cloth(id);
  for (RopeId id : {RopeId{}, RopeId{0, 0}}) expect_unknown_rope(id);
  for (AttachmentId id : {AttachmentId{}, AttachmentId{0, 0}}) expect_unknown_attachment(id);
}

TEST_P(ClothIdTest, IdsOfAnotherWorldAreRefused) {
  World other(world_def(GetParam(), 0.05f));
  const ClothId foreign = other.create_cloth(sheet(1, 1, 2, 2));
  const RopeId foreign_rope = other.create_rope(line(0));
  const AttachmentId foreign_hold = other.create_attachment(attach(foreign, {0}));
  const ClothId own = world_.create_cloth(sheet(1, 1, 2, 2));
  world_.create_attachment(attach(own, {0}));
  world_.create_rope(line(0));
  expect_unknown_cloth(foreign);
  expect_unknown_rope(foreign_rope);
  expect_unknown_attachment(foreign_hold);
  AttachmentDef seam = attach(own, {0});
  seam.other_cloth = foreign;
  expect_unknown("cloth", [&] { world_.create_attachment(seam); });
}

TEST_P(ClothIdTest, AttachmentsGoWithWhatTheyHoldAndWithWhatHolds) {
  const ClothId a = world_.create_cloth(sheet(1, 1, 3, 3));
  const ClothId b = world_.create_cloth(sheet(1, 1, 3, 3, {1, 0, 0}));
  const RopeId line_a = world_.create_rope(line(-0.5f));
  const BodyId bar = world_.create_body(kinematic(BoxGeometry{{0.05f, 0.05f, 0.05f}}, {0, 2, 0}));
  AttachmentDef to_b = attach(a, {2, 5, 8}), to_rope = attach(b, {0}), to_bar = attach(b, {4}),
                rope_to_a = attach(line_a, {0});
  to_b.other_cloth = b;
  to_rope.other_rope = line_a;
  to_rope.reach = 3;
  to_bar.body = bar;
  rope_to_a.other_cloth = a;
  rope_to_a.reach = 3;
  const AttachmentId a_b = world_.create_attachment(to_b), b_rope = world_.create_attachment(to_rope),
                     b_bar = world_.create_attachment(to_bar), rope_a = world_.create_attachment(rope_to_a),
                     b_world = world_.create_attachment(attach(b, {8}));
  world_.step(dt);
  world_.destroy_body(bar);
  expect_unknown_attachment(b_bar);
  world_.step(dt);
  world_.destroy_rope(line_a);
  expect_unknown_attachment(b_rope);
  expect_unknown_attachment(rope_a);
  world_.step(dt);
  world_.destroy_cloth(a);
  expect_unknown_attachment(a_b);
  EXPECT_EQ(world_.attachment_vertices(b_world), std::vector<uint32_t>{8});
  world_.step(dt);
  world_.destroy_cloth(b);
  expect_unknown_attachment(b_world);
  world_.step(dt);
}

TEST_P(ClothIdTest, WhatWasAttachedToABodyThatIsGoneCanBeLookedAtAndFalls) {
  const ClothId cloth = world_.create_cloth(sheet(0.4f, 0.4f, 3, 3));
  const BodyId bar = world_.create_body(kinematic(BoxGeometry{{0.05f, 0.05f, 0.05f}}, {0, 2, 0}));
  AttachmentDef def = attach(cloth, vertices_from(0, 9));
  def.body = bar;
  world_.create_attachment(def);
  run(world_, 3, dt);
  const float before = world_.cloth_positions(cloth)[4].y;
  EXPECT_NEAR(before, 0, 1e-4f);
  world_.destroy_body(bar);
  EXPECT_EQ(world_.diagnostics().non_finite, 0u);
  world_.relax(1);
  EXPECT_EQ(world_.diagnostics().non_finite, 0u);
  run(world_, 20, dt);
  EXPECT_LT(world_.cloth_positions(cloth)[4].y, before - 0.1f);
}

// One hangs, one falls, one is sewn, in all orders of their going.
TEST_P(ClothIdTest, InWhateverOrderPiecesGoTheRestGoesOnUnmoved) {
  std::vector<int> order{0, 1, 2};
  do {
    World world(world_def(GetParam(), 0.05f)), alone(world_def(GetParam(), 0.05f));
    std::vector<ClothId> ids;
    for (int k = 0; k < 3; ++k)
      ids.push_back(world.create_cloth(sheet(0.5f, 0.5f, 4 + k, 5, {3 * float(k), 0, 0})));
    const auto last = static_cast<size_t>(order[2]);
    world.create_attachment(attach(ids[last], {0}));
    const ClothId twin = alone.create_cloth(sheet(0.5f, 0.5f, 4 + order[2], 5, {3 * float(order[2]), 0, 0}));
    alone.create_attachment(attach(twin, {0}));
    for (int k : order) {
      run(world, 3, dt);
      if (k != order[2]) world.destroy_cloth(ids[static_cast<size_t>(k)]);
    }
    run(alone, 9, dt);
    const auto x = world.cloth_positions(ids[last]), y = alone.cloth_positions(twin);
    ASSERT_EQ(x.size(), y.size());
    // Going resets the multipliers that a substep starts from, so that they do not agree to the bit.
    for (size_t v = 0; v < x.size(); ++v) EXPECT_LT(length(x[v] - y[v]), 2e-3f) << "vertex " << v;
  } while (std::next_permutation(order.begin(), order.end()));
}

// ---- vertices come after the fluid's particles, and move with their number ----

class ClothPlaceTest : public OnDevice {
 protected:
  struct Parts {
    World world;
    ClothId cloth;
    RopeId rope;
  };

  /// Cloth and a rope that hang 3 m beside where water may come.
  static Parts make(pbd::DeviceKind device) {
    Parts p{World(world_def(device, 0.05f)), {}, {}};
    p.cloth = p.world.create_cloth(sheet(0.5f, 0.5f, 7, 7, {3, 1, 0}));
    p.world.create_attachment(attach(p.cloth, {0, 6}));
    RopeDef def = rope({{4, 1, 0}, {4.5f, 1, 0}}, 6);
    def.bends_and_twists = true;
    p.rope = p.world.create_rope(def);
    p.world.create_attachment(attach(p.rope, {0}));
    return p;
  }

  static void expect_alike(const Parts& a, const Parts& b) {
    for (size_t v = 0; v < a.world.cloth_positions(a.cloth).size(); ++v) {
      ASSERT_EQ(a.world.cloth_positions(a.cloth)[v], b.world.cloth_positions(b.cloth)[v]) << "vertex " << v;
      ASSERT_EQ(a.world.cloth_velocities(a.cloth)[v], b.world.cloth_velocities(b.cloth)[v]);
    }
    for (size_t v = 0; v < a.world.rope_positions(a.rope).size(); ++v)
      ASSERT_EQ(a.world.rope_positions(a.rope)[v], b.world.rope_positions(b.rope)[v]) << "vertex " << v;
  }
};

TEST_P(ClothPlaceTest, FluidThatComesAndGoesMovesNoVertex) {
  Parts wet = make(GetParam()), dry = make(GetParam());
  const auto both = [&](int steps) {
    SCOPED_TRACE("after " + std::to_string(wet.world.time()) + " s");
    run(wet.world, steps, dt);
    run(dry.world, steps, dt);
    expect_alike(wet, dry);
  };
  both(3);
  const FluidId water = wet.world.create_fluid({});
  dry.world.create_fluid({});  // cloth that may have to support fluid is solved differently
  wet.world.add_fluid(block(water, {-0.3f, 0, -0.3f}, {0.3f, 0.3f, 0.3f}));
  expect_alike(wet, dry);
  both(3);
  wet.world.add_fluid(block(water, {-0.9f, 1, -0.9f}, {0.9f, 1.6f, 0.9f}));
  expect_alike(wet, dry);
  both(3);
  const std::vector<ParticleId> gone(wet.world.ids().begin(), wet.world.ids().begin() + 50);
  wet.world.remove_particles(gone);
  expect_alike(wet, dry);
  both(3);
  wet.world.create_sink({"", BoxRegion{{-2, -9, -2}, {2, 9, 2}}, false, {}, {}});
  both(1);
  EXPECT_EQ(wet.world.particle_count(), 0u);
  both(3);
  wet.world.density_errors();
  wet.world.diagnostics();
  both(3);
}

TEST_P(ClothPlaceTest, ASinkTakesFluidAndLeavesCloth) {
  Parts p = make(GetParam());
  p.world.add_fluid(block(p.world.create_fluid({}), {-0.2f, 0, -0.2f}, {0.2f, 0.2f, 0.2f}));
  p.world.create_sink({"", BoxRegion{{-9, -9, -9}, {9, 9, 9}}, false, {}, {}});
  p.world.step(dt);
  EXPECT_EQ(p.world.particle_count(), 0u);
  EXPECT_EQ(p.world.cloth_positions(p.cloth).size(), 49u);
  p.world.step(dt);
}

TEST_P(ClothPlaceTest, VerticesAreNoParticles) {
  Parts p = make(GetParam());
  p.world.step(dt);
  EXPECT_EQ(p.world.particle_count(), 0u);
  EXPECT_TRUE(p.world.positions().empty());
  EXPECT_TRUE(p.world.particle_contacts().empty());
  EXPECT_EQ(p.world.diagnostics().particles, 0u);
}

MENISCUS_ON_EACH_DEVICE(ClothIdTest);
MENISCUS_ON_EACH_DEVICE(ClothPlaceTest);

}  // namespace
}  // namespace meniscus::tests
