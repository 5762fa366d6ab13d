// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A sheet on a slope holds up to atan μ, and slides beyond it as Coulomb has it.
#include "tests/validation/cloth_worlds.h"

namespace meniscus::tests {
namespace {

class ClothFriction : public OnDevice {
 protected:
  /// m in the second from half a second on.
  float slide(float friction, float degrees) {
    World world(cloth_world(GetParam(), 10, 2));
    ShapeDef slope = shape(PlaneGeometry{});
    slope.pose.rotation = about_z(degrees);
    slope.surface.friction = friction;
    world.create_shape(slope);
    ClothDef def = sheet(0.5f, 0.5f, 17, 17);
    def.fabric.thickness = 0.008f;
    def.fabric.drag = def.fabric.lift = 0;
    def.pose.rotation = slope.pose.rotation;
    def.pose.position = rotate(slope.pose.rotation, {0, 0.0045f, 0});
    const ClothId id = world.create_cloth(def);
    run(world, 30, frame);
    const Vec3 before = world.cloth_state(id).centre;
    run(world, 60, frame);
    return length(world.cloth_state(id).centre - before);
  }
};

TEST_P(ClothFriction, HoldsBelowTheAngleOfFrictionAndSlidesAboveIt) {
  for (float friction : {0.2f, 0.5f, 0.8f}) {
    const float critical = std::atan(friction);
    for (float beyond : {-2.0f, 2.0f}) {
      const float degrees = critical * 180 / 3.14159265f + beyond, angle = degrees * 3.14159265f / 180;
      const float moved = slide(friction, degrees);
      record("moved_at_" + std::to_string(friction) + "_by_" + std::to_string(int(beyond)), moved);
      if (beyond < 0) {
        EXPECT_LT(moved, 1e-4f) << "friction " << friction;
      } else {
        const float acceleration = 9.81f * (std::sin(angle) - friction * std::cos(angle));
        EXPECT_NEAR(moved, acceleration, 0.2f * acceleration)
            << "friction " << friction;  // ½ a (1.5² − 0.5²)
      }
    }
  }
}

MENISCUS_ON_EACH_DEVICE(ClothFriction);

}  // namespace
}  // namespace meniscus::tests
