// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Once warm, a step with a body in the water allocates nothing on the device: not even memory that is given
// back at once. The engine shows the device's own count.
#include <gtest/gtest.h>

#include "tests/engines.h"
#include "tests/worlds.h"

namespace meniscus::tests {
namespace {

/// A cube of 0.2 m that weighs half as much as water.
void add_cube(collision::RigidWorld& rigid, Vec3 position) {
  collision::RigidPart part;
  part.size = {0.1f, 0.1f, 0.1f};
  collision::RigidBodyDef def;
  def.solid.parts = {part};
  def.solid.pose.position = position;
  def.mass = collision::box_mass(part.size, 500);
  rigid.add_body(def);
}

/// A tank's five planes, and the cube.
SolidShapes solids() {
  SolidShapes all;
  const Vec3 normals[] = {{0, 1, 0}, {1, 0, 0}, {-1, 0, 0}, {0, 0, 1}, {0, 0, -1}};
  for (Vec3 normal : normals) {
    collision::Shape plane;
    plane.size = normal;
    plane.offset = normal.y == 1 ? 0 : -0.25f;
    all.shapes.push_back(plane);
  }
  all.fixed = 5;
  collision::Shape cube;
  cube.kind = collision::ShapeKind::box;
  cube.size = {0.1f, 0.1f, 0.1f};
  cube.body = 0;
  all.shapes.push_back(cube);
  all.carried.push_back({5, 0, {}, {-cube.size, cube.size}});
  return all;
}

class BodyAllocationTest : public OnDevice {};

TEST_P(BodyAllocationTest, AWarmStepAllocatesNothingOnTheDevice) {
  collision::RigidWorld rigid({});
  add_cube(rigid, {0, 0.4f, 0});
  const std::unique_ptr<Engine> engine = make_engine_on(GetParam(), engine_def(rigid));
  engine->set_materials(std::vector<ParticleMaterial>{{{1000, 0, 5, 0, 0, 0}, {}, {}}});
  engine->set_shapes(solids());
  ParticleBatch batch;
  for (Vec3 p : lattice(10, 6, 10, engine_spacing, {-0.25f, 0, -0.25f})) {
    batch.position.push_back(pbd::with_w(p, 1 / (1000 * engine_spacing * engine_spacing * engine_spacing)));
    batch.velocity.push_back({0, 0, 0, 0});
    batch.phase.push_back(pbd::phase_fluid);
  }
  engine->append(batch);
  for (int k = 0; k < 80; ++k) engine->step(0.016f, 10);
  ASSERT_GT(engine->body_forces()[0].linear.y, 10);  // it floats: 39 N
  const uint64_t count = engine->device().memory().allocations;
  for (int k = 0; k < 30; ++k) engine->step(0.016f, 10);
  EXPECT_EQ(engine->device().memory().allocations, count);
}

MENISCUS_ON_EACH_DEVICE(BodyAllocationTest);

}  // namespace
}  // namespace meniscus::tests
