// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Dynamic bodies with concave meshes among solids: what is hollow holds things, and what has a hole hangs.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/coupling/body_worlds.h"
#include "tests/rigid_solvers.h"
#include "tests/unit/collision/turned_shapes.h"

namespace meniscus::tests {
namespace {

class ConcaveBodiesTest : public WithSolver {
 protected:
  static MeshGeometry mesh(const char* name, const collision::TriangleMesh& mesh) {
    const std::string path = (std::filesystem::path(testing::TempDir()) / name).string();
    std::ofstream(path) << obj_of(mesh);
    return {path};
  }
  World world_{world_def(GetParam(), 0.1f)};
};

TEST_P(ConcaveBodiesTest, ABowlHoldsBalls) {
  world_.create_shape(shape(PlaneGeometry{}));
  const MeshGeometry bowl = mesh("meniscus_bowl.obj", collision::bowl_mesh(0.5f, 0.44f));
  const BodyId holder = world_.create_body(body(bowl, {0, 0.5f, 0}, 2000));
  std::vector<BodyId> balls;
  for (int k = 0; k < 3; ++k)
    balls.push_back(world_.create_body(
        body(SphereGeometry{0.1f}, {0.1f * float(k - 1), 0.65f + 0.25f * float(k), 0.02f}, 500)));
  run(world_, 150, 1.0f / 60);
  const Pose pose = world_.body_state(holder).pose;
  EXPECT_NEAR(pose.position.y, 0.5f, 0.02f);
  for (const BodyId ball : balls) {
    const Vec3 p = world_.body_state(ball).pose.position - pose.position;
    EXPECT_LT(length(p), 0.44f - 0.1f + 0.02f) << "in the bowl";
    EXPECT_GT(length(p), 0.2f) << "near its wall, not on its lid";
    EXPECT_LT(p.y, -0.05f);
  }
}

TEST_P(ConcaveBodiesTest, ARingHangsOnAPeg) {
  ShapeDef peg = shape(CapsuleGeometry{0.05f, 1}, {0, 1, 0});  // along z
  peg.pose.rotation = {0.70710678f, 0, 0, 0.70710678f};
  world_.create_shape(peg);
  const MeshGeometry ring = mesh("meniscus_ring.obj", collision::ring_mesh(0.4f, 0.08f));
  BodyDef def = body(ring, {0.05f, 0.75f, 0}, 1000);
  def.pose.rotation = {0.70710678f, 0, 0, 0.70710678f};  // its axis is along z, too
  const BodyId id = world_.create_body(def);
  run(world_, 240, 1.0f / 60);
  const Vec3 p = world_.body_state(id).pose.position;
  EXPECT_NEAR(p.y, 1 + 0.05f - 0.32f, 0.03f) << "it hangs by its inner rim";
  EXPECT_NEAR(p.x, 0, 0.25f);
  EXPECT_NEAR(p.z, 0, 0.1f);
}

TEST_P(ConcaveBodiesTest, ARingPassesWhatFitsIntoItsHole) {
  world_.create_shape(shape(SphereGeometry{0.2f}));
  const MeshGeometry ring = mesh("meniscus_ring.obj", collision::ring_mesh(0.4f, 0.08f));
  BodyDef def = body(ring, {0, 1, 0}, 1000);
  def.velocity = {0, -60, 0};
  const BodyId id = world_.create_body(def);
  run(world_, 4, 1.0f / 60);
  EXPECT_LT(world_.body_state(id).pose.position.y, -2);
}

MENISCUS_WITH_EACH_RIGID_SOLVER(ConcaveBodiesTest);

}  // namespace
}  // namespace meniscus::tests
