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
    def.iterations = substeps > 8 ? 3 : 40 / substeps;
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
  static void expect_held(pbd::DeviceKind device, int substeps, bool is_clip) {
    World w = world(device, substeps);
    const std::vector<float> loads{0.5f, 0.9f, 1.05f};
    std::vector<ClothId> strips;
    for (size_t k = 0; k < loads.size(); ++k) strips.push_back(grip(w, float(k), loads[k], is_clip));
    run(w, 30, dt);
    std::vector<double> before;
    for (const ClothId strip : strips) before.push_back(gripped_height(w, strip));
    run(w, 120, dt);
    for (size_t k = 0; k < loads.size(); ++k) {
      const double creep = (before[k] - gripped_height(w, strips[k])) / 2;  // m/s
      if (loads[k] < 1)
        EXPECT_LT(std::fabs(creep), 1e-4) << "at " << loads[k] << " of the limit, " << substeps << " substeps";
      else
        EXPECT_GT(creep, 0.01) << "at " << loads[k] << " of the limit, " << substeps << " substeps";
    }
  }
};

TEST_P(GrippedCloth, HangsFromAPadUpToCoulombsLimit) {
  for (const int substeps : {4, 8, 16}) expect_held(GetParam(), substeps, false);
}

TEST_P(GrippedCloth, HangsFromAClipUpToCoulombsLimit) {
  for (const int substeps : {4, 8, 16}) expect_held(GetParam(), substeps, true);
}

MENISCUS_ON_EACH_DEVICE(GrippedCloth);

}  // namespace
}  // namespace meniscus::tests
