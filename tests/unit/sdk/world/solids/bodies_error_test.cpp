// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Invalid bodies, joints and impulses are refused, and the world does not change.
#include <gtest/gtest.h>

#include "tests/unit/sdk/world/solids/body_worlds.h"

namespace meniscus::tests {
namespace {

constexpr ErrorCode invalid = ErrorCode::invalid_argument;

/// A world with all kinds of things in it, and a twin that is not asked for anything wrong.
class BodyErrorTest : public OnDevice {
 protected:
  struct Parts {
    World world;
    BodyId dynamic, kinematic;
    JointId ball;
  };
  TemporaryFolder folder_;
  Parts tried_ = make(), twin_ = make();
  World& world_ = tried_.world;

  Parts make() const {
    Parts p{World(world_def(GetParam(), 0.05f)), {}, {}, {}};
    p.world.create_shape(open_tank({0.2f, 0.4f, 0.2f}));
    p.world.add_fluid(block(p.world.create_fluid({}), {-0.2f, 0, -0.2f}, {0.2f, 0.15f, 0.2f}));
    p.dynamic = p.world.create_body(body(BoxGeometry{{0.06f, 0.06f, 0.06f}}, {0, 0.25f, 0}));
    p.kinematic = p.world.create_body(tests::kinematic(SphereGeometry{0.05f}, {0.1f, 0.5f, 0}));
    p.ball = p.world.create_joint(joint(BallJoint{}, p.dynamic, p.kinematic));
    return p;
  }

  template <class Call>
  void expect_refused(ErrorCode code, const std::string& named, const Call& call) {
    expect_error(code, named, call);
    EXPECT_EQ(world_.state_hash(), twin_.world.state_hash()) << named;
    EXPECT_EQ(world_.device_bytes(), twin_.world.device_bytes()) << named;
  }
  void expect_refused(ErrorCode code, const std::string& named, const BodyDef& def) {
    expect_refused(code, named, [&] { world_.create_body(def); });
  }
  void expect_refused(const std::string& named, const Geometry& geometry) {
    expect_refused(invalid, named, body(geometry));
    expect_refused(invalid, named, [&] { world_.create_shape(shape(geometry)); });
  }
  template <class Change>
  void expect_refused(const std::string& named,
                      const Change& change) requires std::is_invocable_v<Change, BodyDef&> {
    BodyDef def = body(BoxGeometry{{0.1f, 0.1f, 0.1f}}, {2, 0, 0});
    change(def);
    expect_refused(invalid, named, def);
  }

  /// The next things get the ids that they would have got, and all goes on as in the twin.
  void TearDown() override {
    for (World* world : {&world_, &twin_.world}) {
      const BodyId id = world->create_body(body(SphereGeometry{0.05f}, {-0.1f, 0.4f, 0}));
      EXPECT_EQ(id.index, 2u);
      EXPECT_EQ(world->create_shape(shape(PlaneGeometry{{0, 1, 0}, -1})).index, 1u);
      EXPECT_EQ(world->create_joint(joint(FixedJoint{}, id)).index, 1u);
      run(*world, 3, 0.01f);
    }
    EXPECT_EQ(world_.state_hash(), twin_.world.state_hash());
  }
};

TEST_P(BodyErrorTest, SizesMustBePositive) {
  for (float bad : {0.0f, -1.0f, infinity, not_a_number}) {
    expect_refused("BoxGeometry::half_extents", BoxGeometry{{1, bad, 1}});
    expect_refused("SphereGeometry::radius", SphereGeometry{bad});
    expect_refused("CapsuleGeometry::radius", CapsuleGeometry{bad, 1});
    expect_refused("CylinderGeometry::radius", CylinderGeometry{bad, 1});
    expect_refused("CylinderGeometry::half_height", CylinderGeometry{1, bad});
    expect_refused("MeshGeometry::scale", MeshGeometry{"brick.obj", bad});
  }
  for (float bad : {-1.0f, infinity, not_a_number}) {
    expect_refused("CapsuleGeometry::half_height", CapsuleGeometry{1, bad});
    expect_refused("MeshGeometry::cell_size", MeshGeometry{"brick.obj", 1, bad});
    expect_refused("MeshGeometry::max_error", MeshGeometry{"brick.obj", 1, 0, bad});
  }
}

TEST_P(BodyErrorTest, TheMessageSaysWhatWasGivenAndWhatIsAllowed) {
  expect_refused("SphereGeometry::radius is -3; it must be greater than 0 m", SphereGeometry{-3});
  expect_refused("BoxGeometry::half_extents is (1, 0, 1); it must be greater than 0 m in each component",
                 BoxGeometry{{1, 0, 1}});
  expect_refused("HullGeometry::points is a list of 3; a hull needs at least 4 points, not 3",
                 HullGeometry{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}});
}

TEST_P(BodyErrorTest, WhatHasNoEndCannotFall) {
  expect_refused(invalid, "a PlaneGeometry", body(PlaneGeometry{}));
  expect_refused(invalid, "a PlaneGeometry", kinematic(PlaneGeometry{}));
  expect_refused(invalid, "a HeightFieldGeometry", body(HeightFieldGeometry{2, 2, 1, {0, 0, 0, 0}}));
  expect_refused(invalid, "a HeightFieldGeometry", kinematic(HeightFieldGeometry{2, 2, 1, {0, 0, 0, 0}}));
  expect_refused(invalid, "container", body(ContainerGeometry{}));
}

TEST_P(BodyErrorTest, AHullMustSpanAVolume) {
  expect_refused("HullGeometry::points", HullGeometry{});
  expect_refused("HullGeometry::points", HullGeometry{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}});
  expect_refused("HullGeometry::points", HullGeometry{std::vector<Vec3>(10, Vec3{1, 1, 1})});
  expect_refused("HullGeometry::points", HullGeometry{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, infinity}}});
}

TEST_P(BodyErrorTest, ACompoundHasSolidPartsAlone) {
  expect_refused("CompoundGeometry::parts is empty", CompoundGeometry{});
  for (const Geometry& bad :
       {Geometry{PlaneGeometry{}}, Geometry{ContainerGeometry{}},
        Geometry{HeightFieldGeometry{2, 2, 1, {0, 0, 0, 0}}}, Geometry{CompoundGeometry{{CompoundPart{}}}}}) {
    expect_refused("CompoundPart::geometry", CompoundGeometry{{CompoundPart{}, CompoundPart{bad, {}}}});
  }
  expect_refused("SphereGeometry::radius", CompoundGeometry{{CompoundPart{SphereGeometry{-1}, {}}}});
  expect_refused("CompoundPart::pose",
                 CompoundGeometry{{CompoundPart{BoxGeometry{}, {{0, not_a_number, 0}}}}});
  expect_refused("CompoundPart::pose", CompoundGeometry{{CompoundPart{BoxGeometry{}, {{}, {0, 0, 0, 0}}}}});
}

// The first part's distance field goes again when the second part fails.
TEST_P(BodyErrorTest, ACompoundWithOneBadMeshLeavesNothing) {
  CompoundGeometry parts;
  parts.parts.push_back({MeshGeometry{folder_.write("good.obj", brick_obj), 0.1f}, {}});
  parts.parts.push_back({MeshGeometry{folder_.missing()}, {}});
  // A table of fields keeps the room of one that is gone: give both worlds this.
  for (World* world : {&world_, &twin_.world}) {
    const BodyId id = world->create_body(body(parts.parts[0].geometry, {4, 0, 0}));
    world->destroy_body(id);
  }
  expect_refused(ErrorCode::io, "missing.obj", body(parts));
  expect_refused(ErrorCode::io, "missing.obj", kinematic(parts));
  expect_refused(ErrorCode::io, "missing.obj", [&] { world_.create_shape(shape(parts)); });
}

TEST_P(BodyErrorTest, AMeshErrorNamesTheFileAndTheFace) {
  expect_refused(ErrorCode::io, "missing.obj", body(MeshGeometry{folder_.missing()}));
  const MeshGeometry open{folder_.write("open.obj", open_brick_obj)};
  expect_refused(ErrorCode::mesh, "open.obj' has an open edge at face 0", body(open));
  const MeshGeometry flat{folder_.write("flat.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 3 2\n")};
  expect_refused(ErrorCode::mesh, "volume", body(flat));
}

TEST_P(BodyErrorTest, MaterialsAreChecked) {
  for (float bad : {-1.0f, infinity, not_a_number}) {
    expect_refused("SurfaceDef::friction", [&](BodyDef& d) { d.surface.friction = bad; });
    expect_refused("SurfaceDef::adhesion", [&](BodyDef& d) { d.surface.adhesion = bad; });
    expect_refused("SurfaceDef::solid_friction", [&](BodyDef& d) { d.surface.solid_friction = bad; });
  }
  for (float bad : {-0.1f, 1.1f, not_a_number}) {
    expect_refused("SurfaceDef::restitution", [&](BodyDef& d) { d.surface.restitution = bad; });
    expect_refused("SurfaceDef::solid_restitution", [&](BodyDef& d) { d.surface.solid_restitution = bad; });
    expect_refused("BodyDef::linear_damping", [&](BodyDef& d) { d.linear_damping = bad; });
    expect_refused("BodyDef::angular_damping", [&](BodyDef& d) { d.angular_damping = bad; });
  }
}

TEST_P(BodyErrorTest, MassAndStateAreChecked) {
  for (float bad : {0.0f, -1.0f, infinity, not_a_number}) {
    expect_refused("BodyDef::density", [&](BodyDef& d) { d.density = bad; });
    expect_refused("BodyDef::mass", [&](BodyDef& d) { d.mass = bad; });
  }
  expect_refused("BodyDef::pose", [](BodyDef& d) { d.pose.position.z = not_a_number; });
  expect_refused("BodyDef::pose", [](BodyDef& d) { d.pose.rotation = {0, 0, 0, 2}; });
  expect_refused("BodyDef::velocity", [](BodyDef& d) { d.velocity.x = infinity; });
  expect_refused("BodyDef::angular_velocity", [](BodyDef& d) { d.angular_velocity.x = not_a_number; });
}

// Floats must hold the inverses as well.
TEST_P(BodyErrorTest, AMassIsNoSmallerAndNoLargerThanFloatsCanDivideBy) {
  expect_refused("BodyDef::mass is 1e-30", [](BodyDef& d) { d.mass = 1e-30f; });
  expect_refused("BodyDef::mass is 3e+38", [](BodyDef& d) { d.mass = 3e38f; });
  expect_refused("BodyDef::density is 1e-30", [](BodyDef& d) { d.density = 1e-30f; });
  expect_refused(invalid, "BodyDef::density", body(SphereGeometry{1e-9f}));
  expect_refused(invalid, "BodyDef::density", body(SphereGeometry{1e6f}));
}

TEST_P(BodyErrorTest, MotionsAreChecked) {
  expect_refused("BodyDef::motion is 2", [](BodyDef& d) { d.motion = static_cast<BodyMotion>(2); });
  BodyDef guided = kinematic(BoxGeometry{});
  guided.velocity = {0, 1, 0};
  expect_refused(invalid, "BodyDef::velocity is (0, 1, 0)", guided);
  guided.velocity = {0, 0, 0};
  guided.angular_velocity = {0, 0, -2};
  expect_refused(invalid, "BodyDef::angular_velocity is (0, 0, -2)", guided);
}

TEST_P(BodyErrorTest, KeyframesAreOfKinematicBodiesAndInOrder) {
  expect_refused("BodyDef::keyframes is a list of 1; keyframes are for kinematic bodies alone",
                 [](BodyDef& d) {
                   d.keyframes = {{0, {}}};
                 });
  const auto guided = [&](std::vector<Keyframe> keys) {
    BodyDef def = kinematic(BoxGeometry{});
    def.keyframes = std::move(keys);
    return def;
  };
  expect_refused(invalid, "Keyframe::time", guided({{-1, {}}}));
  expect_refused(invalid, "Keyframe::time", guided({{not_a_number, {}}}));
  expect_refused(invalid, "the times of keyframes must increase", guided({{1, {}}, {1, {}}}));
  expect_refused(invalid, "the times of keyframes must increase", guided({{0, {}}, {2, {}}, {1, {}}}));
  expect_refused(invalid, "Keyframe::pose", guided({{0, {{0, 0, 0}, {0, 0, 0, 0}}}}));
}

TEST_P(BodyErrorTest, JointsAreChecked) {
  const BodyId a = tried_.dynamic;
  const auto refused = [&](const std::string& named, const JointKind& kind) {
    expect_refused(invalid, named, [&] { world_.create_joint(joint(kind, a)); });
  };
  refused("HingeJoint: lower and upper must come together", HingeJoint{0.0f, {}});
  refused("HingeJoint::lower is -4 rad; it must be at least -180 and at most 180 degrees",
          HingeJoint{-4.0f, 1.0f});
  refused("HingeJoint::lower is 1; lower must not be above upper", HingeJoint{1.0f, -1.0f});
  refused("HingeJoint::upper", HingeJoint{0.0f, not_a_number});
  refused("HingeJoint::motor_speed", HingeJoint{{}, {}, infinity, 1});
  refused("HingeJoint::motor_torque", HingeJoint{{}, {}, 1, -1});
  refused("SliderJoint: lower and upper must come together", SliderJoint{{}, 1.0f});
  refused("SliderJoint::lower", SliderJoint{1.0f, 0.0f});
  refused("SliderJoint::lower is -inf", SliderJoint{-infinity, infinity});
  refused("SliderJoint::motor_speed", SliderJoint{{}, {}, not_a_number, 1});
  refused("SliderJoint::motor_force", SliderJoint{{}, {}, 1, infinity});
  refused("SpringJoint::stiffness", SpringJoint{{-1, 0, 0}});
  refused("SpringJoint::damping", SpringJoint{{1, 1, 1}, {0, not_a_number, 0}});
  refused("SpringJoint::damping", SpringJoint{{1, 1, 1}, {0, infinity, 0}});
  refused("SpringJoint::angular_stiffness", SpringJoint{{}, {}, {0, 0, -1}});
  refused("SpringJoint::angular_damping", SpringJoint{{}, {}, {1, 1, 1}, {0, 0, -1}});
  JointDef def = joint(BallJoint{}, a);
  def.frame.rotation = {1, 1, 1, 1};
  expect_refused(invalid, "JointDef::frame", [&] { world_.create_joint(def); });
  expect_refused(invalid, "JointDef::b", [&] { world_.create_joint(joint(BallJoint{}, a, a)); });
}

TEST_P(BodyErrorTest, PushesAreChecked) {
  const BodyId d = tried_.dynamic, k = tried_.kinematic;
  const Vec3 none{0, 0, 0}, bad{0, not_a_number, 0};
  const auto refused = [&](const std::string& named, const auto& call) {
    expect_refused(invalid, named, call);
  };
  refused("velocity", [&] { world_.set_body_velocity(d, bad, none); });
  refused("angular_velocity", [&] { world_.set_body_velocity(d, none, bad); });
  refused("force", [&] { world_.apply_force(d, bad, none); });
  refused("point", [&] { world_.apply_force(d, none, bad); });
  refused("torque", [&] { world_.apply_torque(d, bad); });
  refused("impulse", [&] { world_.apply_impulse(d, bad, none); });
  refused("point", [&] { world_.apply_impulse(d, none, bad); });
  refused("pose", [&] { world_.set_body_pose(d, {bad}); });
  refused("set_body_velocity is for dynamic", [&] { world_.set_body_velocity(k, none, none); });
  refused("apply_force is for dynamic", [&] { world_.apply_force(k, none, none); });
  refused("apply_torque is for dynamic", [&] { world_.apply_torque(k, none); });
  refused("apply_impulse is for dynamic", [&] { world_.apply_impulse(k, none, none); });
  refused("move_body is for kinematic", [&] { world_.move_body(d, {}, 1); });
  refused("target", [&] { world_.move_body(k, {bad}, 1); });
  refused("duration", [&] { world_.move_body(k, {}, 0); });
}

TEST_P(BodyErrorTest, QueriesAreChecked) {
  const Vec3 none{0, 0, 0}, bad{0, infinity, 0};
  expect_refused(invalid, "from", [&] { world_.cast_ray(bad, none); });
  expect_refused(invalid, "to", [&] { world_.cast_ray(none, bad); });
  expect_refused(invalid, "centre", [&] { world_.overlap_ball(bad, 1); });
  expect_refused(invalid, "radius", [&] { world_.overlap_ball(none, 0); });
  expect_refused(invalid, "pose", [&] { world_.overlap_box({bad}, {1, 1, 1}); });
  expect_refused(invalid, "half_extents", [&] { world_.overlap_box({}, bad); });
  expect_refused(invalid, "half_extents is (1, -1, 1)", [&] { world_.overlap_box({}, {1, -1, 1}); });
}

TEST_P(BodyErrorTest, TheRigidSolverIsChecked) {
  for (int bad : {0, -1, 100000}) {
    WorldDef def = world_def(GetParam(), 0.05f);
    def.rigid.substeps = bad;
    expect_error(invalid, "RigidSolverDef::substeps", [&] { World world(def); });
    def.rigid = {1, bad};
    expect_error(invalid, "RigidSolverDef::iterations", [&] { World world(def); });
  }
}

MENISCUS_ON_EACH_DEVICE(BodyErrorTest);

}  // namespace
}  // namespace meniscus::tests
