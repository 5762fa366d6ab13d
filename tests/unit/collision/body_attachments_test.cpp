// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tests of vertices that are attached to bodies.
#include <gtest/gtest.h>

#include "tests/bench/harness/cloth_solid_bench.h"

#include "pbd/math/vec.h"
#include "tests/devices.h"

namespace meniscus::tests {
namespace {

using collision::ShapeKind;

class BodyAttachments : public OnDevice {};
MENISCUS_ON_EACH_DEVICE(BodyAttachments);

constexpr float dt = 1 / 60.0f;

/// A sheet of 0.4 × 0.4 m that hangs in the plane z = 0, its upper row held.
ClothSolidSetup hanging_sheet(pbd::DeviceKind device) {
  constexpr uint32_t columns = 9;
  ClothSolidSetup setup;
  setup.device = device;
  setup.mesh = cloth::make_sheet(0.4f, 0.4f, columns, columns);
  for (Vec3& v : setup.mesh.vertices) v = {v.x, -v.z, 0};
  setup.fabric = {0.2f, 20000, 20000, 5000, 1e-5f, false, false};
  setup.damping = 0.02f;
  setup.substeps = 16;
  for (uint32_t k = 0; k < columns; ++k) setup.held.push_back(k);
  return setup;
}

SolidSetup ball(float mass, Vec3 at) {
  SolidSetup solid;
  solid.size = {0.05f, 0, 0};
  solid.pose.position = at;
  solid.mass = mass;
  solid.motion = SolidSetup::Motion::dynamic;
  solid.damping = 0.9f;
  return solid;
}

/// Attaches the lowest row to a body at this position.
void tie_lowest_row(ClothSolidSetup& setup, Vec3 body) {
  for (uint32_t v = 72; v < 81; ++v) setup.attachments.push_back({v, 0, setup.mesh.vertices[v] - body});
}

Vec3 sum_of(const std::vector<Vec3>& values) {
  Vec3 sum{0, 0, 0};
  for (Vec3 v : values) sum += v;
  return sum;
}

TEST_P(BodyAttachments, HangABodyFromClothInBalance) {
  for (float mass : {0.1f, 1.0f}) {
    ClothSolidSetup setup = hanging_sheet(GetParam());
    const Vec3 at{0, -0.3f, 0};
    setup.solids = {ball(mass, at)};
    setup.solids[0].can_sleep = false;  // asleep it would not notice what it weighs
    tie_lowest_row(setup, at);
    const auto bench = make_cloth_solid_bench(setup);
    for (int k = 0; k < 180; ++k) bench->step(dt);
    Vec3 attachments{0, 0, 0}, held{0, 0, 0};
    constexpr int steps = 30;
    for (int k = 0; k < steps; ++k) {
      bench->step(dt);
      attachments += sum_of(bench->attachment_impulses());
      held += sum_of(bench->reactions());
    }
    const float time = steps * dt;
    constexpr float rows = 8.5f / 9;  // about: of the cloth that is not held
    EXPECT_NEAR(attachments.y / time, -mass * 9.81f, 0.01f * mass * 9.81f) << mass;
    EXPECT_NEAR(held.y / time, -(mass + 0.032f * rows) * 9.81f, 0.01f * (mass + 0.032f) * 9.81f) << mass;
    EXPECT_LT(length(bench->rigid().velocity(0)), 0.01f) << mass;
    EXPECT_NEAR(bench->rigid().pose(0).position.y, at.y, 0.02f) << mass;
  }
}

TEST_P(BodyAttachments, KeepMomentum) {
  ClothSolidSetup setup = hanging_sheet(GetParam());
  setup.gravity = {0, 0, 0};
  setup.held.clear();
  setup.velocity = {0.5f, 2, -1};
  const Vec3 at{0.02f, -0.3f, 0.01f};
  setup.solids = {ball(0.05f, at)};
  setup.solids[0].damping = 0;
  setup.solids[0].velocity = {0, -1, 0};
  tie_lowest_row(setup, at);
  const std::vector<float> masses = cloth::build_constraints(setup.mesh, setup.fabric).masses;
  const auto bench = make_cloth_solid_bench(setup);
  const auto momentum = [&] {
    double p[3] = {0, 0, 0};
    const std::vector<Vec3> v = bench->velocities();
    for (size_t i = 0; i < v.size(); ++i) {
      p[0] += masses[i] * v[i].x;
      p[1] += masses[i] * v[i].y;
      p[2] += masses[i] * v[i].z;
    }
    const Vec3 ball = bench->rigid().velocity(0);
    return Vec3{static_cast<float>(p[0] + 0.05 * ball.x), static_cast<float>(p[1] + 0.05 * ball.y),
                static_cast<float>(p[2] + 0.05 * ball.z)};
  };
  const Vec3 before = momentum();
  for (int k = 0; k < 60; ++k) bench->step(dt);
  EXPECT_LT(length(momentum() - before), 2e-6f * 0.13f);  // kg·m/s: of what moved
}

TEST_P(BodyAttachments, LetAKinematicBodyDragCloth) {
  ClothSolidSetup setup = hanging_sheet(GetParam());
  setup.held.clear();
  const Vec3 at{0, 0.25f, 0};
  setup.solids = {ball(1, at)};
  setup.solids[0].motion = SolidSetup::Motion::kinematic;
  setup.solids[0].velocity = {1, 0, 0};
  for (uint32_t v = 0; v < 9; ++v) setup.attachments.push_back({v, 0, setup.mesh.vertices[v] - at});
  const auto bench = make_cloth_solid_bench(setup);
  for (int k = 0; k < 60; ++k) bench->step(dt);
  const Vec3 moved = bench->rigid().pose(0).position - at;
  EXPECT_NEAR(moved.x, 1, 1e-3f);
  for (const collision::BodyAttachment& attachment : setup.attachments) {
    const Vec3 off = bench->positions()[attachment.vertex] - (setup.mesh.vertices[attachment.vertex] + moved);
    EXPECT_LT(length(off), 1e-3f);
  }
}

TEST_P(BodyAttachments, StayCalmAtMassRatiosOfAThousand) {
  const float cloth = 0.2f * 0.4f * 0.4f;
  for (float mass : {1e-3f * cloth, 1e3f * cloth}) {
    ClothSolidSetup setup = hanging_sheet(GetParam());
    const Vec3 at{0, -0.3f, 0};
    setup.solids = {ball(mass, at)};
    tie_lowest_row(setup, at);
    const auto bench = make_cloth_solid_bench(setup);
    for (int k = 0; k < 120; ++k) bench->step(dt);
    float fastest = length(bench->rigid().velocity(0));
    for (Vec3 v : bench->velocities()) fastest = std::max(fastest, length(v));
    EXPECT_LT(fastest, 0.5f) << mass;
  }
}

TEST_P(BodyAttachments, OfOneVertexToTwoBodiesAreBothThere) {
  ClothSolidSetup setup = hanging_sheet(GetParam());
  setup.gravity = {0, 0, 0};
  setup.held.clear();
  setup.solids = {ball(0.01f, {-1, 0, 0}), ball(0.01f, {1, 0, 0})};
  setup.solids[0].velocity = {-1, 0, 0};
  setup.solids[1].velocity = {1, 0, 0};
  const Vec3 v = setup.mesh.vertices[40];
  setup.attachments = {{40, 1, v - Vec3{1, 0, 0}}, {40, 0, v - Vec3{-1, 0, 0}}};
  const auto bench = make_cloth_solid_bench(setup);
  for (int k = 0; k < 30; ++k) bench->step(dt);
  EXPECT_LT(length(bench->rigid().velocity(0) - bench->rigid().velocity(1)), 0.2f);
  EXPECT_LT(length(bench->positions()[40] - v), 0.01f);
}

TEST_P(BodyAttachments, OfAHeldVertexHoldAFreeBody) {
  for (bool by_a_body : {true, false}) {
    ClothSolidSetup setup = hanging_sheet(GetParam());
    if (by_a_body) setup.held.clear();
    setup.solids = {ball(0.5f, {0, -1, 0}), ball(1, {1, 0, 0})};
    setup.solids[0].can_sleep = false;
    setup.solids[1].motion = SolidSetup::Motion::kinematic;
    const Vec3 v = setup.mesh.vertices[4];
    setup.attachments = {{4, 0, v - Vec3{0, -1, 0}}};
    if (by_a_body) setup.attachments.push_back({4, 1, v - Vec3{1, 0, 0}});
    const auto bench = make_cloth_solid_bench(setup);
    for (int k = 0; k < 30; ++k) bench->step(dt);
    EXPECT_LT(length(bench->rigid().pose(0).position - Vec3{0, -1, 0}), 2e-3f) << by_a_body;
    EXPECT_NEAR(bench->attachment_impulses()[0].y / dt, -0.5f * 9.81f, 0.05f * 0.5f * 9.81f) << by_a_body;
    // Here `moved` is all that a vertex withstands which the world holds; else its body gets it.
    if (by_a_body) {
      EXPECT_GT(bench->attachment_impulses()[1].y / dt, 0.5f * 9.81f);
    }
  }
}

}  // namespace
}  // namespace meniscus::tests
