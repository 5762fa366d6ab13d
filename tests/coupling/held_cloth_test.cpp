// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Cloth whose vertices are held is a wall: bodies, water and grains rest on it, and its holders feel them.
#include <gtest/gtest.h>

#include <string>

#include "tests/cloth_worlds.h"
#include "tests/coupling/body_worlds.h"
#include "tests/rigid_solvers.h"

namespace meniscus::tests {
namespace {

constexpr float dt = 0.016f, gravity = 9.81f;
constexpr int columns = 17;
constexpr int half_second = 31;  // steps

/// A sheet of half a metre, in the plane y = 0.
class HeldCloth : public WithSolver {
 protected:
  World world_{world_def(GetParam(), 0.05f)};
  ClothId cloth_ = world_.create_cloth(sheet(0.5f, 0.5f, columns, columns));

  static std::vector<uint32_t> all() { return vertices_from(0, columns * columns); }
  float weight_of(BodyId id) const { return gravity * world_.body_mass(id).mass; }
  float cloth_weight() const { return gravity * world_.cloth_state(cloth_).mass; }

  AttachmentId hold(const std::vector<uint32_t>& vertices, std::optional<BodyId> holder = {}) {
    AttachmentDef def = attach(cloth_, vertices);
    def.body = holder;
    return world_.create_attachment(def);
  }

  BodyId drop(const Geometry& geometry, float height, float density = 500) {
    BodyDef def = body(geometry, {0, height, 0}, density);
    def.surface.friction = 0.5f;
    return world_.create_body(def);
  }

  /// N, the mean over half a second.
  Vec3 mean_force(AttachmentId id) {
    Vec3 sum{0, 0, 0};
    for (int k = 0; k < half_second; ++k) {
      world_.step(dt);
      sum += world_.attachment_force(id) / float(half_second);
    }
    return sum;
  }

  /// Expects that the cloth supports the body at this height, and that the holders feel its weight.
  void expect_supported(BodyId load, AttachmentId holder, float height, const std::string& what,
                        float supported_cloth) {
    run(world_, 100, dt);
    const float weight = weight_of(load);
    EXPECT_NEAR(mean_force(holder).y, -weight - supported_cloth, 0.02f * weight) << what;
    EXPECT_NEAR(world_.body_state(load).pose.position.y, height, 0.008f) << what;
    EXPECT_LT(length(world_.body_state(load).velocity), 0.01f) << what;
  }
};

MENISCUS_WITH_EACH_RIGID_SOLVER(HeldCloth);

struct Solid {
  const char* name;
  Geometry geometry;
  float height;  ///< m, from its centre down
};

const Solid solids[] = {
    {"ball", SphereGeometry{0.1f}, 0.1f},
    {"ball of less than an edge", SphereGeometry{0.012f}, 0.012f},
    {"box", BoxGeometry{{0.1f, 0.05f, 0.08f}}, 0.05f},
    {"plate", BoxGeometry{{0.1f, 0.004f, 0.1f}}, 0.004f},
    {"pad of less than an edge", BoxGeometry{{0.01f, 0.01f, 0.01f}}, 0.01f},
    {"capsule", CapsuleGeometry{0.04f, 0.1f}, 0.14f},
    {"cylinder", CylinderGeometry{0.08f, 0.05f}, 0.05f},
    {"compound",
     CompoundGeometry{{part(BoxGeometry{{0.03f, 0.03f, 0.03f}}, {-0.08f, 0, 0}),
                       part(BoxGeometry{{0.03f, 0.03f, 0.03f}}, {0.08f, 0, 0}),
                       part(BoxGeometry{{0.08f, 0.01f, 0.03f}}, {0, 0, 0})}},
     0.03f},
};

class HeldClothUnder : public HeldCloth {};
MENISCUS_WITH_EACH_RIGID_SOLVER(HeldClothUnder);

TEST_P(HeldClothUnder, BodiesOfEveryShape) {
  for (const Solid& solid : solids) {
    const bool is_cylinder = std::holds_alternative<CylinderGeometry>(solid.geometry);
    if (is_cylinder && GetParam().solver == RigidSolver::device) continue;  // it has none
    World world(world_def(GetParam(), 0.05f));
    world_ = std::move(world);
    cloth_ = world_.create_cloth(sheet(0.5f, 0.5f, columns, columns));
    const std::vector<Vec3> before = copy_of(world_.cloth_positions(cloth_));
    const AttachmentId held = hold(all());
    const BodyId load = drop(solid.geometry, solid.height + 0.1f);
    expect_supported(load, held, solid.height + 0.004f, solid.name, cloth_weight());
    const auto after = world_.cloth_positions(cloth_);
    for (size_t v = 0; v < before.size(); ++v) ASSERT_EQ(after[v], before[v]) << solid.name;
  }
}

// ---- holders ----

TEST_P(HeldCloth, OfAKinematicBodyBearsAsMuch) {
  const BodyId holder = world_.create_body(kinematic(BoxGeometry{{0.3f, 0.02f, 0.3f}}, {0, -1, 0}));
  const AttachmentId held = hold(all(), holder);
  const BodyId load = drop(SphereGeometry{0.1f}, 0.2f);
  expect_supported(load, held, 0.104f, "ball", cloth_weight());
  EXPECT_NEAR(world_.body_state(holder).fluid_force.y, -weight_of(load) - cloth_weight(),
              0.02f * weight_of(load));
}

TEST_P(HeldCloth, OfABodyThatAJointHoldsBearsAsMuch) {
  if (GetParam().solver == RigidSolver::device) GTEST_SKIP() << "the device has no joints";
  BodyDef def = body(BoxGeometry{{0.3f, 0.02f, 0.3f}}, {0, -0.1f, 0}, 1000);
  def.can_sleep = false;
  const BodyId holder = world_.create_body(def);
  JointDef joint;
  joint.a = holder;
  joint.kind = FixedJoint{};
  world_.create_joint(joint);
  const AttachmentId held = hold(all(), holder);
  const BodyId load = drop(BoxGeometry{{0.1f, 0.05f, 0.08f}}, 0.15f);
  expect_supported(load, held, 0.054f, "box", cloth_weight());
}

/// The sheet rides at .5 m/s, and the box on it with it.
TEST_P(HeldCloth, OfAMovingBodyCarriesABoxAlong) {
  const BodyId holder = world_.create_body(kinematic(BoxGeometry{{0.3f, 0.02f, 0.3f}}, {0, -1, 0}));
  const AttachmentId held = hold(all(), holder);
  const BodyId load = drop(BoxGeometry{{0.1f, 0.05f, 0.08f}}, 0.06f);
  run(world_, 30, dt);
  world_.move_body(holder, {{2, -1, 0}, {0, 0, 0, 1}}, 4);
  run(world_, 60, dt);
  const Vec3 force = mean_force(held);
  const BodyState state = world_.body_state(load);
  EXPECT_NEAR(force.y, -weight_of(load) - cloth_weight(), 0.02f * weight_of(load));
  EXPECT_NEAR(force.x, 0, 0.02f * weight_of(load));
  EXPECT_NEAR(state.velocity.x, 0.5f, 0.01f);
  EXPECT_NEAR(state.pose.position.y, 0.054f, 0.003f);
  EXPECT_GT(state.pose.position.x, world_.cloth_positions(cloth_)[144].x - 0.1f);
}

TEST_P(HeldCloth, OfABodyThatRisesLiftsABall) {
  const BodyId holder = world_.create_body(kinematic(BoxGeometry{{0.3f, 0.02f, 0.3f}}, {0, -1, 0}));
  hold(all(), holder);
  const BodyId load = drop(SphereGeometry{0.1f}, 0.11f);
  world_.move_body(holder, {{0, 0, 0}, {0, 0, 0, 1}}, 1);
  run(world_, 63, dt);
  EXPECT_NEAR(world_.body_state(load).pose.position.y, 1.104f, 0.02f);
}

// ---- in part ----

TEST_P(HeldCloth, InPartBearsABallOnWhatIsHeld) {
  std::vector<uint32_t> every_second, middle;
  for (uint32_t v = 0; v < columns * columns; ++v) {
    const uint32_t row = v / columns, column = v % columns;
    if ((row + column) % 2 == 0) every_second.push_back(v);
    if (row > 3 && row < 13 && column > 3 && column < 13) middle.push_back(v);
  }
  for (const auto& vertices : {every_second, middle}) {
    const AttachmentId held = hold(vertices);
    const BodyId load = drop(SphereGeometry{0.1f}, 0.2f);
    expect_supported(load, held, 0.104f, std::to_string(vertices.size()), cloth_weight());
    world_.destroy_body(load);
    world_.destroy_attachment(held);
  }
}

// ---- what flows ----

class HeldClothFlow : public OnDevice {
 protected:
  /// Steps until what was poured is at rest on a held sheet between four walls. Expects that its holder feels
  /// its weight, and that nothing passes.
  void pour(bool grains, bool kinematic_holder) {
    WorldDef def = world_def(GetParam(), 0.03f);
    if (grains) def.iterations = 10;
    World world(def);
    const FluidId fluid = grains ? world.create_granular({}) : world.create_fluid({});
    for (float side : {-1.0f, 1.0f}) {
      world.create_shape(shape(BoxGeometry{{0.05f, 0.4f, 0.3f}}, {side * 0.25f, 0.2f, 0}));
      world.create_shape(shape(BoxGeometry{{0.3f, 0.4f, 0.05f}}, {0, 0.2f, side * 0.25f}));
    }
    const ClothId cloth = world.create_cloth(sheet(0.5f, 0.5f, columns, columns));
    AttachmentDef all = attach(cloth, vertices_from(0, columns * columns));
    if (kinematic_holder)
      all.body = world.create_body(kinematic(BoxGeometry{{0.3f, 0.02f, 0.3f}}, {0, -1, 0}));
    const AttachmentId held = world.create_attachment(all);
    const auto count =
        static_cast<float>(world.add_fluid(block(fluid, {-0.2f, 0.03f, -0.2f}, {0.2f, 0.2f, 0.2f})));
    run(world, 100, dt);
    float force = 0;
    for (int k = 0; k < half_second; ++k) {
      world.step(dt);
      force += world.attachment_force(held).y / float(half_second);
    }
    const float weight = gravity * count * static_cast<float>(world.particle_mass(fluid));
    EXPECT_NEAR(force, -weight - gravity * world.cloth_state(cloth).mass, 0.02f * weight);
    for (Vec3 x : world.positions()) ASSERT_GT(x.y, 0);
  }
};

MENISCUS_ON_EACH_DEVICE(HeldClothFlow);

TEST_P(HeldClothFlow, WaterRestsOnIt) {
  pour(false, false);
  pour(false, true);
}

TEST_P(HeldClothFlow, GrainsRestOnIt) {
  pour(true, false);
  pour(true, true);
}

// ---- faces of attached vertices ----

/// A square that a body holds by its four corners.
class TiedFaces : public WithSolver {
 protected:
  static WorldDef weightless(const SolverCase& which) {
    WorldDef def = world_def(which, 0.05f);
    def.gravity = {0, 0, 0};
    return def;
  }
  World world_{weightless(GetParam())};
  ClothId cloth_ = world_.create_cloth(sheet(0.4f, 0.4f, 2, 2));

  void SetUp() override { world_.set_wind({.air_density = 0}); }

  BodyId frame(BodyMotion motion, float top) {
    BodyDef def = body(BoxGeometry{{0.3f, 0.05f, 0.3f}}, {0, top - 0.05f, 0}, 500);
    def.motion = motion;
    return world_.create_body(def);
  }
  void tie_to(BodyId body) {
    AttachmentDef def = attach(cloth_, vertices_from(0, 4));
    def.body = body;
    world_.create_attachment(def);
  }
  BodyId throw_ball(Vec3 from, Vec3 velocity) {
    BodyDef def = body(SphereGeometry{0.03f}, from, 500);
    def.velocity = velocity;
    return world_.create_body(def);
  }
};

MENISCUS_WITH_EACH_RIGID_SOLVER(TiedFaces);

TEST_P(TiedFaces, StopWhatIsNotTheirOwnBody) {
  for (const BodyMotion motion : {BodyMotion::dynamic, BodyMotion::kinematic}) {
    const BodyId holder = frame(motion, -0.5f);
    tie_to(holder);
    const BodyId ball = throw_ball({0.05f, 0.1f, 0.02f}, {0, -1, 0});
    const Momentum before = body_momentum(world_, ball);
    run(world_, 30, dt);
    EXPECT_GT(world_.body_state(ball).pose.position.y, world_.cloth_positions(cloth_)[0].y);
    if (motion == BodyMotion::dynamic) {
      const Momentum after =
          body_momentum(world_, ball) + body_momentum(world_, holder) + cloth_momentum(world_, cloth_);
      EXPECT_LT(norm(after.linear - before.linear), 1e-5 * norm(before.linear));
      EXPECT_LT(body_momentum(world_, holder).linear.y, 0.5 * before.linear.y);
    }
    world_.destroy_body(ball);
    world_.destroy_cloth(cloth_);
    cloth_ = world_.create_cloth(sheet(0.4f, 0.4f, 2, 2));
    world_.destroy_body(holder);
  }
}

TEST_P(TiedFaces, AreNothingToTheirOwnBody) {
  const BodyId holder = frame(BodyMotion::dynamic, 0.01f);  // they lie inside of it
  tie_to(holder);
  run(world_, 30, dt);
  EXPECT_LT(length(world_.body_state(holder).velocity), 1e-4f);
  EXPECT_LT(length(world_.body_state(holder).fluid_force), 1e-2f);
}

TEST_P(TiedFaces, AreNothingToAnyBodyThatAVertexIsTiedTo) {
  if (GetParam().solver == RigidSolver::device) GTEST_SKIP() << "the device has no joints";
  const BodyId holders[] = {frame(BodyMotion::dynamic, 0.01f), frame(BodyMotion::dynamic, 0.02f)};
  JointDef joint;
  joint.a = holders[0];
  joint.b = holders[1];
  joint.kind = FixedJoint{};
  world_.create_joint(joint);
  for (BodyId holder : holders) tie_to(holder);
  run(world_, 30, dt);
  for (BodyId holder : holders) EXPECT_LT(length(world_.body_state(holder).velocity), 1e-3f);
}

// ---- impacts ----

/// All that the holders withstand over an impact is what stopped the ball, and the weights.
TEST_P(HeldCloth, ItsHoldersFeelTheWholeImpact) {
  const BodyId holder = world_.create_body(kinematic(BoxGeometry{{0.3f, 0.02f, 0.3f}}, {0, -1, 0}));
  std::vector<uint32_t> left, right;
  for (uint32_t v = 0; v < columns * columns; ++v) (v % columns < 8 ? left : right).push_back(v);
  const AttachmentId by_world = hold(left), by_body = hold(right, holder);
  BodyDef def = body(SphereGeometry{0.1f}, {-0.02f, 0.5f, 0}, 500);
  def.surface.restitution = 0.7f;
  const BodyId ball = world_.create_body(def);
  const float mass = world_.body_mass(ball).mass;
  Vec3 impulse{0, 0, 0};
  constexpr int steps = 80;
  for (int k = 0; k < steps; ++k) {
    world_.step(dt);
    impulse += dt * (world_.attachment_force(by_world) + world_.attachment_force(by_body));
  }
  const BodyState state = world_.body_state(ball);
  const float weights = (mass + world_.cloth_state(cloth_).mass) * gravity * dt * steps;
  EXPECT_NEAR(impulse.y, -weights - mass * state.velocity.y, 1e-3f * weights);
  EXPECT_NEAR(impulse.x, -mass * state.velocity.x, 1e-3f * weights);
}

}  // namespace
}  // namespace meniscus::tests
