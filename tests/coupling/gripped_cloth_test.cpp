// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Friction that holds cloth for seconds under a pull near the limit of Coulomb's law.
#include <gtest/gtest.h>

#include "tests/cloth_worlds.h"
#include "tests/coupling/body_worlds.h"

namespace meniscus::tests {
namespace {

constexpr float dt = 1 / 60.0f, gravity = 9.81f, force = 5;
const Quat y_to_z{std::sqrt(0.5f), 0, 0, std::sqrt(0.5f)};

class GrippedCloth : public OnDevice {
 protected:
  static World world(pbd::DeviceKind device, int substeps) {
    WorldDef def = world_def(device, 0.02f);
    def.substeps = substeps;
    return World(def);
  }
  /// A strip of 0.12 N that hangs between two faces. A motor presses them together with 5 N. The weight is
  /// `load` times Σ μ N over both faces. They are a pad and a wall, or the jaws of a clip.
  static ClothId grip(World& world, float x, float load, bool is_clip) {
    constexpr float width = 0.2f, length = 0.3f, top = 0.12f, depth = 0.022f;
    ClothDef strip = sheet(width, length, 11, 16, {x, 0, 0});
    strip.pose.rotation = y_to_z;
    strip.fabric.thickness = 0.004f;
    strip.fabric.drag = strip.fabric.lift = 0;
    const float friction = strip.fabric.density * width * length * gravity / (2 * force * load);
    BodyDef pad = body(BoxGeometry{{0.11f, 0.03f, 0.02f}}, {x, top, depth}, 100);
    pad.mass = 0.5f;
    pad.surface.friction = friction;
    JointDef rail;
    rail.a = world.create_body(pad);
    rail.frame = {pad.pose.position, y_to_z};
    rail.kind = SliderJoint{.motor_speed = 1, .motor_force = force};
    if (is_clip) {
      pad.pose.position.z = -depth;
      rail.b = world.create_body(pad);
      JointDef mount;
      mount.a = *rail.b;
      mount.frame.position = pad.pose.position;
      mount.kind = FixedJoint{};
      world.create_joint(mount);
    } else {
      ShapeDef wall = shape(BoxGeometry{{0.12f, 1, 0.1f}}, {x, 0, -0.102f});
      wall.surface.friction = friction;
      world.create_shape(wall);
    }
    world.create_joint(rail);
    return world.create_cloth(strip);
  }
  /// m, the mean height of the rows between the faces.
  static double gripped_height(const World& world, ClothId strip) {
    const auto x = world.cloth_positions(strip);
    double sum = 0;
    for (size_t k = 0; k < 33; ++k) sum += double{x[k].y} / 33;
    return sum;
  }
  /// m/s, after a fifth of a second.
  static double creep(World& world, ClothId strip, int frames) {
    run(world, 12, dt);
    const double before = gripped_height(world, strip);
    run(world, frames, dt);
    return (before - gripped_height(world, strip)) / (double{dt} * frames);
  }
};

TEST_P(GrippedCloth, HangsForSecondsFromAPad) {
  for (const float load : {0.5f, 0.9f}) {
    World w = world(GetParam(), 4);
    const ClothId strip = grip(w, 0, load, false);
    EXPECT_LT(std::fabs(creep(w, strip, 132)), 1e-4) << "at " << load << " of the limit";
  }
}

TEST_P(GrippedCloth, HangsFromAPadAndAClipAtAnySubsteps) {
  for (const int substeps : {4, 8, 16}) {
    World w = world(GetParam(), substeps);
    const ClothId padded = grip(w, 0, 0.9f, false), clipped = grip(w, 1, 0.88f, true);
    run(w, 12, dt);
    const double before[] = {gripped_height(w, padded), gripped_height(w, clipped)};
    run(w, 30, dt);
    EXPECT_LT(before[0] - gripped_height(w, padded), 5e-5) << "a pad at " << substeps << " substeps";
    EXPECT_LT(before[1] - gripped_height(w, clipped), 5e-5) << "a clip at " << substeps << " substeps";
  }
}

TEST_P(GrippedCloth, SlipsBeyondTheLimit) {
  for (const bool is_clip : {false, true}) {
    World w = world(GetParam(), 4);
    const ClothId strip = grip(w, 0, 1.05f, is_clip);
    EXPECT_GT(creep(w, strip, 12), 0.01) << (is_clip ? "clip" : "pad");
  }
}

MENISCUS_ON_EACH_DEVICE(GrippedCloth);

}  // namespace
}  // namespace meniscus::tests
