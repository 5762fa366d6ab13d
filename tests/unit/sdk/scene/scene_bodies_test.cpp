// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Bodies, joints and properties of solids in scene files.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

#include "sdk/scene/scene_file.h"

namespace meniscus {
namespace {

namespace fs = std::filesystem;

constexpr const char* text = R"({
  "name": "x",
  "world": {"rigid": {"substeps": 3, "iterations": 40}},
  "fluids": [{"groups": 6, "mask": 4294967295}],
  "shapes": [
    {"name": "floor", "geometry": {"type": "plane"}, "friction": 0.1, "restitution": 0.2, "adhesion": 30,
     "solid_friction": 0.4, "solid_restitution": 0.5, "groups": 2, "mask": 3},
    {"name": "stairs", "geometry": {"type": "compound", "parts": [
       {"geometry": {"type": "box"}},
       {"geometry": {"type": "sphere", "radius": 2},
        "pose": {"position": [0, 1, 0], "rotation": {"axis": [1, 0, 0], "degrees": 180}}}]}}
  ],
  "bodies": [
    {"name": "crate", "geometry": {"type": "box", "half_extents": [1, 2, 3]}, "pose": {"position": [4, 5, 6]},
     "velocity": [1, 2, 3], "angular_velocity": [4, 5, 6], "density": 700, "mass": 80,
     "friction": 0.3, "restitution": 0.25, "adhesion": 20, "solid_friction": 0.6, "solid_restitution": 0.7,
     "groups": 4, "mask": 5, "linear_damping": 0.01, "angular_damping": 0.02, "can_sleep": false},
    {"name": "lid", "motion": "kinematic", "geometry": {"type": "container"}, "loop": true, "keyframes": [
       {"time": 0.5, "position": [0, 1, 0]},
       {"time": 2, "position": [0, 2, 0], "rotation": {"axis": [0, 0, 1], "degrees": 90}}]},
    {"name": "stone", "geometry": {"type": "hull", "points": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]}}
  ],
  "joints": [
    {"type": "fixed", "name": "f", "a": "crate", "b": "lid", "bodies_collide": true},
    {"type": "hinge", "name": "h", "a": "crate", "lower": -90, "upper": 45, "motor_speed": 2, "motor_torque": 3,
     "frame": {"position": [1, 1, 1]}},
    {"type": "slider", "name": "s", "a": "lid", "lower": -1, "upper": 2, "motor_speed": 4, "motor_force": 5},
    {"type": "ball", "name": "b", "a": "stone"},
    {"type": "spring", "name": "p", "a": "stone", "b": "crate", "stiffness": [1, 2, 3], "damping": [4, 5, 6],
     "angular_stiffness": [7, 8, 9], "angular_damping": [10, 11, 12], "held": ["z", "x"], "angular_held": ["y"]}
  ]
})";

Scene scene() {
  return parse_scene(nlohmann::json::parse(text));
}

TEST(SceneBodies, WorldAndFilters) {
  const Scene s = scene();
  EXPECT_EQ(s.world.rigid.substeps, 3);
  EXPECT_EQ(s.world.rigid.iterations, 40);
  EXPECT_EQ(s.fluids.at(0).filter.groups, 6u);
  EXPECT_EQ(s.fluids.at(0).filter.mask, 0xffffffffu);
  EXPECT_EQ(s.shapes.at(0).filter.groups, 2u);
  EXPECT_EQ(s.shapes.at(0).filter.mask, 3u);
  EXPECT_EQ(s.shapes.at(1).filter.groups, CollisionFilter().groups) << "left out, the default";
  EXPECT_EQ(s.shapes.at(1).filter.mask, CollisionFilter().mask);
}

TEST(SceneBodies, Surfaces) {
  const Scene s = scene();
  const SurfaceDef& floor = s.shapes.at(0).surface;
  EXPECT_FLOAT_EQ(floor.friction, 0.1f);
  EXPECT_FLOAT_EQ(floor.restitution, 0.2f);
  EXPECT_FLOAT_EQ(floor.adhesion, 30);
  EXPECT_FLOAT_EQ(floor.solid_friction, 0.4f);
  EXPECT_FLOAT_EQ(floor.solid_restitution, 0.5f);
  const SurfaceDef& crate = s.bodies.at(0).def.surface;
  EXPECT_FLOAT_EQ(crate.friction, 0.3f);
  EXPECT_FLOAT_EQ(crate.restitution, 0.25f);
  EXPECT_FLOAT_EQ(crate.adhesion, 20);
  EXPECT_FLOAT_EQ(crate.solid_friction, 0.6f);
  EXPECT_FLOAT_EQ(crate.solid_restitution, 0.7f);
  EXPECT_FLOAT_EQ(s.bodies.at(1).def.surface.solid_friction, SurfaceDef().solid_friction);
}

TEST(SceneBodies, DynamicBody) {
  const Scene s = scene();
  const BodyDef& crate = s.bodies.at(0).def;
  EXPECT_EQ(crate.name, "crate");
  EXPECT_EQ(crate.motion, BodyMotion::dynamic);
  EXPECT_FLOAT_EQ(std::get<BoxGeometry>(crate.geometry).half_extents.z, 3);
  EXPECT_FLOAT_EQ(crate.pose.position.y, 5);
  EXPECT_FLOAT_EQ(crate.velocity.x, 1);
  EXPECT_FLOAT_EQ(crate.angular_velocity.z, 6);
  EXPECT_FLOAT_EQ(crate.density, 700);
  ASSERT_TRUE(crate.mass.has_value());
  EXPECT_FLOAT_EQ(*crate.mass, 80);
  EXPECT_EQ(crate.filter.groups, 4u);
  EXPECT_EQ(crate.filter.mask, 5u);
  EXPECT_FLOAT_EQ(crate.linear_damping, 0.01f);
  EXPECT_FLOAT_EQ(crate.angular_damping, 0.02f);
  EXPECT_FALSE(crate.can_sleep);
  EXPECT_FALSE(s.bodies.at(2).def.mass.has_value());
}

TEST(SceneBodies, KinematicBody) {
  const Scene s = scene();
  const BodyDef& lid = s.bodies.at(1).def;
  EXPECT_EQ(lid.motion, BodyMotion::kinematic);
  EXPECT_TRUE(std::holds_alternative<ContainerGeometry>(lid.geometry));
  EXPECT_TRUE(lid.loop);
  ASSERT_EQ(lid.keyframes.size(), 2u);
  EXPECT_FLOAT_EQ(lid.keyframes[0].time, 0.5f);
  EXPECT_EQ(lid.keyframes[0].pose.rotation.w, 1);
  EXPECT_FLOAT_EQ(lid.pose.position.y, 1) << "it starts at the first";
  EXPECT_FLOAT_EQ(lid.keyframes[1].pose.position.y, 2);
  EXPECT_FLOAT_EQ(lid.keyframes[1].pose.rotation.z, std::sqrt(0.5f));
}

TEST(SceneBodies, HullsAndCompounds) {
  const Scene s = scene();
  const auto& stairs = std::get<CompoundGeometry>(s.shapes.at(1).geometry);
  ASSERT_EQ(stairs.parts.size(), 2u);
  EXPECT_TRUE(std::holds_alternative<BoxGeometry>(stairs.parts[0].geometry));
  EXPECT_FLOAT_EQ(std::get<SphereGeometry>(stairs.parts[1].geometry).radius, 2);
  EXPECT_FLOAT_EQ(stairs.parts[1].pose.position.y, 1);
  EXPECT_FLOAT_EQ(stairs.parts[1].pose.rotation.x, 1);
  const auto& stone = std::get<HullGeometry>(s.bodies.at(2).def.geometry);
  ASSERT_EQ(stone.points.size(), 4u);
  EXPECT_FLOAT_EQ(stone.points[3].z, 1);
}

TEST(SceneBodies, Joints) {
  const Scene s = scene();
  ASSERT_EQ(s.joints.size(), 5u);
  EXPECT_EQ(s.joints[0].def.name, "f");
  EXPECT_EQ(s.joints[0].a, "crate");
  EXPECT_EQ(s.joints[0].b, "lid");
  EXPECT_TRUE(s.joints[0].def.bodies_collide);
  EXPECT_TRUE(std::holds_alternative<FixedJoint>(s.joints[0].def.kind));

  EXPECT_EQ(s.joints[1].b, "") << "the world";
  EXPECT_FLOAT_EQ(s.joints[1].def.frame.position.x, 1);
  const auto& hinge = std::get<HingeJoint>(s.joints[1].def.kind);
  EXPECT_FLOAT_EQ(hinge.lower.value(), -float(M_PI) / 2) << "degrees in the file, radians in the world";
  EXPECT_FLOAT_EQ(hinge.upper.value(), float(M_PI) / 4);
  EXPECT_FLOAT_EQ(hinge.motor_speed, 2);
  EXPECT_FLOAT_EQ(hinge.motor_torque, 3);

  const auto& slider = std::get<SliderJoint>(s.joints[2].def.kind);
  EXPECT_FLOAT_EQ(slider.lower.value(), -1);
  EXPECT_FLOAT_EQ(slider.upper.value(), 2);
  EXPECT_FLOAT_EQ(slider.motor_speed, 4);
  EXPECT_FLOAT_EQ(slider.motor_force, 5);
  EXPECT_TRUE(std::holds_alternative<BallJoint>(s.joints[3].def.kind));
}

TEST(SceneBodies, SpringsCanBeHeld) {
  const Scene s = scene();
  const auto& spring = std::get<SpringJoint>(s.joints.at(4).def.kind);
  constexpr float held = std::numeric_limits<float>::infinity();
  EXPECT_EQ(spring.stiffness.x, held);
  EXPECT_FLOAT_EQ(spring.stiffness.y, 2);
  EXPECT_EQ(spring.stiffness.z, held);
  EXPECT_FLOAT_EQ(spring.damping.z, 6);
  EXPECT_FLOAT_EQ(spring.angular_stiffness.x, 7);
  EXPECT_EQ(spring.angular_stiffness.y, held);
  EXPECT_FLOAT_EQ(spring.angular_damping.y, 11);
}

TEST(SceneBodies, MaximumErrorOfAMesh) {
  const Scene s = parse_scene(nlohmann::json::parse(
      R"({"name": "x", "bodies": [{"name": "a",
          "geometry": {"type": "mesh", "file": "a.obj", "max_error": 0.01}}]})"));
  EXPECT_FLOAT_EQ(std::get<MeshGeometry>(s.bodies.at(0).def.geometry).max_error, 0.01f);
}

TEST(SceneBodies, CopiesStandOnALattice) {
  const Scene s = parse_scene(nlohmann::json::parse(R"({"name": "x", "bodies": [
      {"name": "lone", "geometry": {"type": "box"}},
      {"name": "lift", "motion": "kinematic", "geometry": {"type": "box"},
       "keyframes": [{"time": 0}, {"time": 1, "position": [0, 5, 0]}],
       "copies": {"count": [2, 1, 3], "step": [10, 20, 30]}}],
      "joints": [{"type": "ball", "name": "j", "a": "lift_5", "b": "lone"}]})"));
  const std::vector<BodyDef> bodies = bodies_of(s);
  ASSERT_EQ(bodies.size(), 1u + 6u);
  EXPECT_EQ(bodies[0].name, "lone");
  EXPECT_EQ(bodies[1].name, "lift_0");
  EXPECT_FLOAT_EQ(bodies[1].pose.position.x, 0);
  EXPECT_FLOAT_EQ(bodies[2].pose.position.x, 10) << "x fastest";
  EXPECT_EQ(bodies[6].name, "lift_5");
  EXPECT_FLOAT_EQ(bodies[6].pose.position.z, 60);
  EXPECT_FLOAT_EQ(bodies[6].keyframes.at(1).pose.position.y, 5);
  EXPECT_FLOAT_EQ(bodies[6].keyframes.at(1).pose.position.z, 60) << "its way is moved, too";
}

/// A folder with a tetrahedron, and a scene file in it.
class SceneHull : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("meniscus_hull_" + std::to_string(getpid()) + "_" +
                                           testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::create_directories(folder_);
    std::ofstream(folder_ / "tetra.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
                                            "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
  }
  void TearDown() override { fs::remove_all(folder_); }

  Scene read(const std::string& geometry) const {
    const fs::path path = folder_ / "scene.json";
    std::ofstream(path) << R"({"name": "x", "bodies": [{"name": "a", "geometry": )" << geometry << "}]}";
    return read_scene(path);
  }

  std::string message(const std::string& geometry) const {
    try {
      read(geometry);
    } catch (const Error& error) {
      return error.what();
    }
    return "no error";
  }

  fs::path folder_;
};

TEST_F(SceneHull, TakesTheVerticesOfAFile) {
  const Scene s = read(R"({"type": "hull", "file": "tetra.obj", "scale": 2, "points": [[-1, -1, -1]]})");
  const std::vector<Vec3>& points = std::get<HullGeometry>(s.bodies.at(0).def.geometry).points;
  ASSERT_EQ(points.size(), 5u) << "its own, and those of the file";
  EXPECT_FLOAT_EQ(points[0].x, -1);
  float extent = 0;
  for (const Vec3 p : points) extent += p.x + p.y + p.z;
  EXPECT_FLOAT_EQ(extent, 3 * 2 - 3);
}

TEST_F(SceneHull, FilesOfPartsAreFromTheScenesFolder) {
  const Scene s = read(R"({"type": "compound", "parts": [
      {"geometry": {"type": "mesh", "file": "tetra.obj"}}, {"geometry": {"type": "hull", "file": "tetra.obj"}}]})");
  const auto& parts = std::get<CompoundGeometry>(s.bodies.at(0).def.geometry).parts;
  EXPECT_EQ(std::get<MeshGeometry>(parts.at(0).geometry).file, (folder_ / "tetra.obj").string());
  EXPECT_EQ(std::get<HullGeometry>(parts.at(1).geometry).points.size(), 4u);
}

TEST_F(SceneHull, AFileThatIsNotThereIsNamedWithItsPlace) {
  const std::string head = (folder_ / "scene.json").string() + ": bodies[0].geometry.";
  const std::string tail = "cannot read mesh file \"" + (folder_ / "none.obj").string() + "\"";
  EXPECT_EQ(message(R"({"type": "hull", "file": "none.obj"})"), head + "file: " + tail);
  EXPECT_EQ(message(R"({"type": "mesh", "file": "none.obj"})"), head + "file: " + tail);
  EXPECT_EQ(message(R"({"type": "compound", "parts": [{"geometry": {"type": "hull", "file": "none.obj"}}]})"),
            head + "parts[0].geometry.file: " + tail);
}

TEST_F(SceneHull, AFileThatIsNoMeshIsNamedWithItsPlace) {
  std::ofstream(folder_ / "bad.obj") << "v 0 0 0\n";
  const std::string text_of_error = message(R"({"type": "hull", "file": "bad.obj"})");
  EXPECT_NE(text_of_error.find("bodies[0].geometry.file: "), std::string::npos) << text_of_error;
  EXPECT_NE(text_of_error.find("bad.obj"), std::string::npos) << text_of_error;
}

TEST(SceneBodies, BulletMayTakeAsManyIterationsAsAWorldAllows) {
  const Scene scene =
      parse_scene(nlohmann::json::parse(R"({"name": "x", "world": {"rigid": {"iterations": 10000}}})"));
  EXPECT_EQ(scene.world.rigid.iterations, 10000);
  EXPECT_NO_THROW(World world(scene.world));
}

}  // namespace
}  // namespace meniscus
