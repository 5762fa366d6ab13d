// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The viewer without its window: the camera, picking and pulling with the mouse, and the world on its own
// thread.
#include <gtest/gtest.h>

#include <chrono>
#include <nlohmann/json.hpp>

#include "sdk/scene/scene_file.h"
#include "sdk/viewer/draft.h"
#include "sdk/viewer/parameters.h"
#include "sdk/viewer/picking.h"
#include "sdk/viewer/simulation.h"

namespace meniscus::viewer {
namespace {

constexpr float aspect = 1.5f;

Orbit orbit_at(Vec3 position, Vec3 target = {0, 0, 0}) {
  return {{position, target, 40}, {0, 1, 0}};
}

TEST(OrbitTest, APointIsSeenWhereItsRayGoesThrough) {
  Orbit orbit = orbit_at({3, 2, 5});
  orbit.turn(0.1f, -0.05f);
  orbit.pan(0.2f, 0.1f);
  for (const Vec3 p : {Vec3{0, 0, 0}, {0.5f, -0.3f, 0.2f}, {-1, 0.4f, -0.7f}}) {
    const Vec3 at = orbit.project(p, aspect);
    const Ray ray = orbit.ray_through(at.x, at.y, aspect);
    EXPECT_NEAR(length(cross(p - ray.from, ray.direction)), 0, 1e-4f);
    EXPECT_NEAR(at.z, dot(p - ray.from, orbit.forward()), 1e-4f);
  }
}

TEST(OrbitTest, TurningKeepsTheTargetAndItsDistance) {
  Orbit orbit = orbit_at({3, 2, 5}, {1, 0, 0});
  const float before = length(orbit.camera().position - orbit.camera().target);
  orbit.turn(0.3f, 0.2f);
  EXPECT_NEAR(length(orbit.camera().position - orbit.camera().target), before, 1e-4f);
  EXPECT_NEAR(length(orbit.camera().target - Vec3{1, 0, 0}), 0, 1e-6f);
  EXPECT_GT(orbit.camera().position.y, 2);  // the scene was pulled down
  orbit.turn(0, 5);                         // far beyond the pole
  EXPECT_GT(orbit.camera().position.y, 0.99f * before);
  EXPECT_LT(orbit.camera().position.y, before);
}

TEST(OrbitTest, APointAtTheTargetsDepthFollowsTheMouseThatShiftsIt) {
  Orbit orbit = orbit_at({0, 0, 4});
  orbit.pan(0.1f, 0.2f);
  const Vec3 at = orbit.project({0, 0, 0}, aspect);
  EXPECT_NEAR(at.x, 0.5f + 0.1f / aspect, 1e-4f);
  EXPECT_NEAR(at.y, 0.5f + 0.2f, 1e-4f);
}

TEST(OrbitTest, TheWheelGoesNearer) {
  Orbit orbit = orbit_at({0, 0, 4});
  orbit.zoom(2);
  EXPECT_NEAR(orbit.camera().position.z, 4 * 0.875f * 0.875f, 1e-4f);
}

TEST(DraftTest, PicturesAreAsCoarseAsTheirTimeAsks) {
  Draft draft;
  draft.took(20, 1);
  EXPECT_EQ(draft.share(), 1);
  draft.took(800, 1);  // a sixteenth of it would be right
  EXPECT_EQ(draft.share(), 0.25f);
  draft.took(50, 0.25f);
  EXPECT_EQ(draft.share(), 0.25f);
  draft.took(4, 0.25f);
  EXPECT_EQ(draft.share(), 0.875f);
}

/// A ball, water, a sheet and a rope side by side, in a container, over a wall that stands still.
const char* const things = R"({
  "name": "things", "frame_time": 0.01,
  "world": { "device": "cpu", "particle_spacing": 0.1, "substeps": 4, "iterations": 4 },
  "fluids": [{ "name": "water" }],
  "shapes": [{ "name": "tank", "geometry": { "type": "container", "half_extents": [3, 3, 3] } },
             { "name": "wall", "geometry": { "type": "box", "half_extents": [0.1, 0.5, 0.1] }, "pose": { "position": [2, 0, 0] } }],
  "bodies": [{ "name": "lift", "motion": "kinematic", "geometry": { "type": "box", "half_extents": [0.1, 0.1, 0.1] },
               "pose": { "position": [-2, 2, 0] } },
             { "name": "ball", "geometry": { "type": "sphere", "radius": 0.3 } }],
  "cloths": [{ "name": "sheet", "geometry": { "type": "sheet", "width": 0.6, "depth": 0.6, "columns": 7, "rows": 7 },
               "pose": { "position": [1, 0, 0], "rotation": { "axis": [1, 0, 0], "degrees": 90 } } }],
  "ropes": [{ "name": "line", "points": [[0, -1, 0], [0.5, -1, 0]], "segments": 10 }],
  "volumes": [{ "fluid": "water", "region": { "type": "box", "lower": [-1.3, -0.3, -0.3], "upper": [-0.7, 0.3, 0.3] } }]
})";

Scene scene_of(const char* text) {
  return parse_scene(nlohmann::json::parse(text));
}

TEST(SnapshotTest, SprayAndFoamAreInIt) {
  const Scene scene = scene_of(R"({
    "name": "splash", "frame_time": 0.01,
    "world": { "device": "cpu", "particle_spacing": 0.05, "substeps": 2, "iterations": 4, "diffuse": {} },
    "fluids": [{ "name": "water" }],
    "shapes": [{ "name": "tank", "geometry": { "type": "container", "half_extents": [0.5, 1, 0.5] } }],
    "volumes": [{ "fluid": "water", "region": { "type": "box", "lower": [-0.5, -1, -0.5], "upper": [0.5, -0.7, 0.5] } },
                { "fluid": "water", "region": { "type": "box", "lower": [-0.2, -0.6, -0.2], "upper": [0.2, -0.2, 0.2] },
                  "velocity": [0, -5, 0] }]
  })");
  BuiltScene built = build_scene(scene);
  for (int k = 0; k < 30; ++k) built.world.step(0.01f);
  const Snapshot snapshot = snapshot_of(built, scene);
  ASSERT_GT(snapshot.diffuse.size(), 0u);
  EXPECT_EQ(snapshot.moment().diffuse.size(), built.world.diffuse().size());
}

class PickTest : public testing::Test {
 protected:
  const Scene scene_ = scene_of(things);
  BuiltScene built_ = build_scene(scene_);

  std::optional<Grab> pick(Vec3 from, Vec3 to) const {
    return Picker(scene_).pick({from, normalized_or(to - from, {0, 0, -1})}, snapshot_of(built_, scene_));
  }
  /// Pulls what is met there by a metre up, and does not let go for a second and a half.
  Vec3 pulled(Vec3 at) {
    std::optional<Grab> grab = pick(at + Vec3{0, 0, 9}, at);
    EXPECT_TRUE(grab);
    if (!grab) return at;
    grab->target = grab->target + Vec3{0, 1, 0};
    Vec3 place{0, 0, 0};
    for (int step = 0; step < 150; ++step) {
      place = pull(*grab, built_, scene_, scene_.frame_time);
      built_.world.step(scene_.frame_time);
    }
    return place;
  }
};

TEST_F(PickTest, TheMouseFindsEachKindOfThing) {
  const auto ball = pick({0.1f, 0.1f, 9}, {0.1f, 0.1f, 0});
  ASSERT_TRUE(ball && std::holds_alternative<HeldBody>(ball->held));
  EXPECT_EQ(std::get<HeldBody>(ball->held).index, 1u);
  EXPECT_NEAR(ball->target.z, std::sqrt(0.09f - 0.02f), 0.02f);
  const auto water = pick({-1, 0, 9}, {-1, 0, 0});
  ASSERT_TRUE(water && std::holds_alternative<HeldParticles>(water->held));
  EXPECT_GT(std::get<HeldParticles>(water->held).ids.size(), 10u);
  const auto cloth = pick({1, 0, 9}, {1, 0, 0});
  ASSERT_TRUE(cloth && std::holds_alternative<HeldVertices>(cloth->held));
  EXPECT_FALSE(std::get<HeldVertices>(cloth->held).of_rope);
  EXPECT_EQ(std::get<HeldVertices>(cloth->held).vertices.size(),
            13u);  // no further than two edges from the middle
  const auto rope = pick({0.25f, -1, 9}, {0.25f, -1, 0});
  ASSERT_TRUE(rope && std::holds_alternative<HeldVertices>(rope->held));
  EXPECT_TRUE(std::get<HeldVertices>(rope->held).of_rope);
  EXPECT_EQ(std::get<HeldVertices>(rope->held).vertices, std::vector<uint32_t>{5});
}

TEST_F(PickTest, WhatCannotMoveIsNotFoundAndHidesWhatIsBehind) {
  EXPECT_FALSE(pick({0, 2, 9}, {0, 2, 0}));    // nothing but the container
  EXPECT_FALSE(pick({2, 0, 9}, {2, 0, 0}));    // the wall
  EXPECT_FALSE(pick({-2, 2, 9}, {-2, 2, 0}));  // what moves by itself
  EXPECT_FALSE(pick({9, 0, 0}, {0, 0, 0}));    // the ball, behind the wall
  EXPECT_TRUE(pick({0, 9, 0}, {0, 0, 0}));     // the ball, from above
}

TEST_F(PickTest, WhatIsHeldComesToTheTargetAgainstItsWeight) {
  EXPECT_NEAR(length(pulled({0, 0, 0}) - Vec3{0, 1, 0.3f}), 0, 0.1f);
}
TEST_F(PickTest, WaterComesAlong) {
  EXPECT_GT(pulled({-1, 0.2f, 0}).y, 0.8f);
}
TEST_F(PickTest, ClothComesAlong) {
  EXPECT_GT(pulled({1, 0, 0}).y, 0.6f);
}
TEST_F(PickTest, RopesComeAlong) {
  EXPECT_GT(pulled({0.25f, -1, 0}).y, -0.4f);
}

TEST(ParametersTest, WhatTakesEffectAtOnceIsKnown) {
  EXPECT_TRUE(changes_at_once("world.gravity"));
  EXPECT_TRUE(changes_at_once("world.density.artificial_pressure.strength"));
  EXPECT_TRUE(changes_at_once("fluids[0].dynamic_viscosity"));
  EXPECT_TRUE(changes_at_once("wind.velocity"));
  EXPECT_FALSE(changes_at_once("world.particle_spacing"));
  EXPECT_FALSE(changes_at_once("fluids[0].rest_density"));
  EXPECT_FALSE(changes_at_once("cloths[0].fabric.density"));
}

class SimulationTest : public testing::Test {
 protected:
  /// Waits for a snapshot of which this is true.
  template <class Test>
  std::shared_ptr<const Snapshot> wait_for(const Test& test) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (std::chrono::steady_clock::now() < end) {
      if (const auto s = simulation_.latest(); s && test(*s)) return s;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    ADD_FAILURE() << "no such snapshot came";
    return std::make_shared<Snapshot>();
  }
  std::shared_ptr<Scene> open() {
    auto scene = std::make_shared<Scene>(scene_of(things));
    simulation_.open(scene);
    return scene;
  }
  Simulation simulation_{[] {}};
};

TEST_F(SimulationTest, StepsArePlayedSingleAndReset) {
  const auto scene = open();
  EXPECT_EQ(wait_for([](const Snapshot& s) { return s.build == 1; })->steps, 0u);
  simulation_.step();
  simulation_.step();
  EXPECT_NEAR(wait_for([](const Snapshot& s) { return s.steps == 2; })->time, 0.02, 1e-6);
  simulation_.set_pace(0);
  simulation_.play(true);
  EXPECT_TRUE(wait_for([](const Snapshot& s) { return s.steps >= 5; })->playing);
  simulation_.play(false);
  wait_for([](const Snapshot& s) { return !s.playing; });
  simulation_.open(scene);
  EXPECT_EQ(wait_for([](const Snapshot& s) { return s.build == 2; })->steps, 0u);
}

TEST_F(SimulationTest, ARunningWorldTakesOverWhatItCan) {
  auto changed = std::make_shared<Scene>(*open());
  changed->frame_time = 0.005f;
  changed->world.gravity = {0, 0, 0};
  changed->fluids[0].rest_density = 2000;  // for the next reset
  changed->world.kernel = SmoothingKernel::wendland_c2;
  simulation_.change(changed);
  simulation_.step();
  const auto s = wait_for([](const Snapshot& now) { return now.steps == 1; });
  EXPECT_NEAR(s->time, 0.005, 1e-6);
  EXPECT_EQ(s->error, "");
  EXPECT_NEAR(s->bodies[1].velocity.y, 0, 1e-6f);
}

TEST_F(SimulationTest, ASceneThatCannotBeBuiltLeavesThePresentOne) {
  open();
  wait_for([](const Snapshot& s) { return s.build == 1; });
  auto broken = std::make_shared<Scene>(scene_of(things));
  broken->fluids[0].dynamic_viscosity = -1;
  simulation_.open(broken);
  const auto s = wait_for([](const Snapshot& now) { return !now.error.empty(); });
  EXPECT_NE(s->error.find("viscosity"), std::string::npos);
  EXPECT_EQ(s->build, 1u);
  simulation_.step();
  EXPECT_EQ(wait_for([](const Snapshot& now) { return now.steps == 1; })->error, "");
}

}  // namespace
}  // namespace meniscus::viewer
