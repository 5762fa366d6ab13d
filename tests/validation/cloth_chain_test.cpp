// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A chain between two points 1 m apart hangs as a catenary. Its parameter a is from sinh(1/2a) = L/2a: the
// sag is a (cosh(1/2a) − 1), and at its ends it is atan sinh(1/2a) steep.
#include "tests/validation/cloth_worlds.h"

namespace meniscus::tests {
namespace {

struct Catenary {
  float length, sag, end_angle;  // m, m, degrees
};
constexpr Catenary catenaries[] = {{1.2f, 0.2923f, 51.95f}, {2, 0.7964f, 77.07f}};
constexpr int segments = 40;

/// The slope at the end itself, from those of the first two segments.
float end_angle(const std::vector<Vec3>& x) {
  const auto angle = [&](size_t k) {
    const Vec3 d = x[k + 1] - x[k];
    return std::atan2(-d.y, d.x) * 180 / 3.14159265f;
  };
  return angle(0) + 0.5f * (angle(0) - angle(1));
}

void expect_catenary(const std::vector<Vec3>& x, const Catenary& expected) {
  float sag = 0;
  for (Vec3 p : x) sag = std::max(sag, -p.y);
  record("sag_of_" + std::to_string(expected.length), sag);
  record("angle_of_" + std::to_string(expected.length), end_angle(x));
  EXPECT_NEAR(sag, expected.sag, 0.01f * expected.sag) << "length " << expected.length;
  EXPECT_NEAR(end_angle(x), expected.end_angle, 0.01f * expected.end_angle) << "length " << expected.length;
}

class ClothChain : public OnDevice {};

// The loss of long substeps brings a rope without air to rest.
TEST_P(ClothChain, ARopeHangsAsACatenary) {
  for (const Catenary& c : catenaries) {
    for (int substeps : {1, 4}) {
      World world(cloth_world(GetParam(), substeps, 10));
      const float depth = 0.5f * std::sqrt(c.length * c.length - 1);
      RopeDef def = rope({{-0.5f, 0, 0}, {0, -depth, 0}, {0.5f, 0, 0}}, segments);
      def.youngs_modulus = unyielding;
      def.damping = 0.05f;
      const RopeId id = world.create_rope(def);
      world.create_attachment(attach(id, {0, segments}));
      run(world, 60 * 60, frame);
      expect_catenary(copy_of(world.rope_positions(id)), c);
    }
  }
}

// Starts straight and compressed, with substeps of half a millisecond. The air is so dense that the strip
// sinks into its shape. Otherwise it may turn once about itself on the way, and then it hangs flatter by 1.4
// %.
TEST_P(ClothChain, AStripOfClothHangsAsACatenary) {
  for (const Catenary& c : catenaries) {
    World world(cloth_world(GetParam(), 40, 10));
    ClothDef def = sheet(c.length, c.length / segments, segments + 1, 2);
    def.stretch = {1 / c.length, 1, 1};
    def.self_collision = def.tethers = false;
    def.fabric.warp_stiffness = def.fabric.weft_stiffness = unyielding;
    def.fabric.bending_stiffness = def.fabric.stretch_damping = def.fabric.lift = 0;
    const ClothId id = world.create_cloth(def);
    world.create_attachment(attach(id, column_of(def, 0) + column_of(def, segments)));
    settle(world, 20, 3000);
    std::vector<Vec3> middle;
    for (int k = 0; k <= segments; ++k)
      middle.push_back(mean_of(world.cloth_positions(id), column_of(def, k)));
    expect_catenary(middle, c);
  }
}

MENISCUS_ON_EACH_DEVICE(ClothChain);

}  // namespace
}  // namespace meniscus::tests
