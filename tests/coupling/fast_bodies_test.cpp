// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Fast bodies and cloth that cannot tear: nothing passes, momentum is kept, and no energy is added.
#include <gtest/gtest.h>

#include <cstring>
#include <string>
#include <vector>

#include "tests/coupling/crossings.h"

namespace meniscus::tests {
namespace {

constexpr float frame = 1 / 60.0f, width = 1, stiffness = 20000;
constexpr int columns = 41;

/// kg·m²/s², of all vertices and the body.
double kinetic_energy(const World& world, ClothId cloth, BodyId body) {
  const auto v = world.cloth_velocities(cloth);
  const auto triangles = world.cloth_triangles(cloth);
  const double share = double{world.cloth_state(cloth).mass} / static_cast<double>(triangles.size());
  double energy = 0;
  for (uint32_t corner : triangles) energy += 0.5 * share * dot(Sum3(v[corner]), Sum3(v[corner]));
  const BodyState state = world.body_state(body);
  const Sum3 velocity = state.velocity, turning = state.angular_velocity;
  return energy + 0.5 * double{world.body_mass(body).mass} * dot(velocity, velocity) +
         0.5 * dot(turning, spin(world, body));
}

/// J, of warp and weft. The strips at the border are half as wide.
double elastic_energy(const World& world, ClothId cloth) {
  const auto x = world.cloth_positions(cloth);
  const double edge = double{width} / (columns - 1);
  double energy = 0;
  const auto add = [&](int a, int b, bool at_border) {
    const double longer = norm(Sum3(x[size_t(b)]) - Sum3(x[size_t(a)])) - edge;
    if (longer > 0) energy += (at_border ? 0.25 : 0.5) * double{stiffness} * longer * longer;
  };
  for (int row = 0; row < columns; ++row) {
    for (int column = 0; column < columns; ++column) {
      const int v = row * columns + column;
      if (column + 1 < columns) add(v, v + 1, row == 0 || row + 1 == columns);
      if (row + 1 < columns) add(v, v + columns, column == 0 || column + 1 == columns);
    }
  }
  return energy;
}

/// A sheet of a square metre and 0.5 kg in the plane y = 0, and a body that hits it.
template <class Geometry>
struct Impact {
  World world;
  ClothId cloth;
  BodyId body;
  Crossings<Geometry> crossings;
  double energy, most_energy;
  Momentum before;
  double drift = 0;  ///< of the momentum, over Σ m · speed
  float dt;

  Impact(pbd::DeviceKind device, const BodyDef& def, const Geometry& geometry, int substeps, bool is_held)
      : world(still(device)),
        cloth(world.create_cloth(square())),
        body(world.create_body(def)),
        crossings(world, cloth, body, geometry),
        dt(frame / float(substeps)) {
    world.set_wind({.air_density = 0});
    if (is_held) world.create_attachment(attach(cloth, border()));
    energy = most_energy = total_energy();
    before = momentum();
  }
  void run(int steps) {
    for (int k = 0; k < steps; ++k) {
      world.step(dt);
      crossings.count();
      most_energy = std::max(most_energy, total_energy());
      drift = std::max(drift, norm(momentum().linear - before.linear) / before.gross);
    }
  }
  double total_energy() const { return kinetic_energy(world, cloth, body) + elastic_energy(world, cloth); }
  Momentum momentum() const { return cloth_momentum(world, cloth) + body_momentum(world, body); }

  static WorldDef still(pbd::DeviceKind device) {
    WorldDef def = world_def(device, 0.05f);
    def.gravity = {0, 0, 0};
    def.substeps = 1;
    return def;
  }
  static ClothDef square() {
    ClothDef def = sheet(width, width, columns, columns);
    def.fabric.density = 0.5f;
    def.fabric.warp_stiffness = def.fabric.weft_stiffness = stiffness;
    return def;
  }
  static std::vector<uint32_t> border() {
    std::vector<uint32_t> vertices;
    for (uint32_t v = 0; v < columns * columns; ++v) {
      const uint32_t row = v / columns, column = v % columns;
      if (row == 0 || row + 1 == columns || column == 0 || column + 1 == columns) vertices.push_back(v);
    }
    return vertices;
  }
};

BodyDef thrown(float mass, float height, float speed, float turning = 0) {
  BodyDef def;
  def.mass = mass;
  def.pose.position = {0.013f, height, 0.021f};
  def.velocity = {0, -speed, 0};
  def.angular_velocity = turning * Vec3{0.6f, 0.5f, 0.6245f};
  return def;
}

class FastBodies : public OnDevice {
 protected:
  /// Throws a body at a sheet that is held at its border, and at a free one, with 2, 4 and 16 substeps a
  /// frame, for so many halves of a frame.
  template <class Geometry>
  void expect_stopped(const Geometry& geometry, BodyDef def, int halves, double energy = 1.01) {
    def.geometry = geometry;
    for (bool is_held : {true, false}) {
      for (int substeps : {2, 4, 16}) {
        Impact<Geometry> impact(GetParam(), def, geometry, substeps, is_held);
        impact.run(halves * substeps / 2);
        EXPECT_LT(impact.most_energy, energy * impact.energy) << is_held << ", " << substeps;
        expect_stopped(impact, std::string(is_held ? "held, " : "free, ") + std::to_string(substeps),
                       is_held);
      }
    }
  }

  template <class Geometry>
  void expect_stopped(const Impact<Geometry>& impact, const std::string& what, bool is_held) {
    EXPECT_EQ(impact.crossings.most_inside(), 0) << what;
    EXPECT_EQ(impact.crossings.passed(), 0) << what;
    EXPECT_LT(kinetic_energy(impact.world, impact.cloth, impact.body), 0.98 * impact.energy) << "no impact";
    if (!is_held) {
      EXPECT_LT(impact.drift, 1e-5) << what;
    }
  }
};
MENISCUS_ON_EACH_DEVICE(FastBodies);

TEST_P(FastBodies, ABall) {
  expect_stopped(SphereGeometry{0.05f}, thrown(0.5f, 0.1f, 20), 3);
}

/// With one substep a frame, the fewest.
TEST_P(FastBodies, ABallReboundsFromASheetThatIsHeld) {
  const SphereGeometry ball{0.05f};
  BodyDef def = thrown(0.5f, 0.1f, 20);
  def.geometry = ball;
  Impact<SphereGeometry> impact(GetParam(), def, ball, 1, true);
  float lowest = 0;
  for (int k = 0; k < 6; ++k) {
    impact.run(1);
    lowest = std::min(lowest, impact.world.body_state(impact.body).pose.position.y);
  }
  EXPECT_GT(lowest, -0.25f);
  EXPECT_GT(impact.world.body_state(impact.body).velocity.y, 10);
}

TEST_P(FastBodies, ASmallBallAt150) {
  expect_stopped(SphereGeometry{0.01f}, thrown(0.02f, 0.3f, 150), 1);
}

TEST_P(FastBodies, ALargeBallAt60) {
  expect_stopped(SphereGeometry{0.15f}, thrown(0.43f, 0.2f, 60), 1);
}

/// Where a zone takes its turn, cloth beside it is stretched.
TEST_P(FastBodies, ABoxThatSpins) {
  expect_stopped(BoxGeometry{{0.04f, 0.04f, 0.04f}}, thrown(0.5f, 0.15f, 20, 100), 3, 1.07);
}

TEST_P(FastBodies, ARodThatSpins) {
  expect_stopped(CapsuleGeometry{0.015f, 0.1f}, thrown(0.5f, 0.2f, 20, 100), 3);
}

/// A sheet that falls, and a ball of 5 cm beside or far from it. The report of the last of some steps.
struct Fall {
  StepReport report;
  std::vector<Vec3> cloth;

  Fall(pbd::DeviceKind device, float speed, Vec3 position, bool collides = true) {
    WorldDef def = world_def(device, 0.05f);
    def.substeps = 3;
    World world(def);
    const ClothId sheet = world.create_cloth(Impact<SphereGeometry>::square());
    BodyDef ball = thrown(0.5f, 0, speed);
    ball.geometry = SphereGeometry{0.05f};
    ball.pose.position = position;
    if (!collides) ball.filter.mask = 0;
    world.create_body(ball);
    for (int k = 0; k < 2; ++k) report = world.step(frame);
    const auto x = world.cloth_positions(sheet);
    cloth.assign(x.begin(), x.end());
  }
};

bool have_same_bits(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Vec3)) == 0;
}

/// The substeps of the world are a minimum, and the report has their number.
TEST_P(FastBodies, GetMoreSubstepsAtCloth) {
  const Fall fast(GetParam(), 20, {0.013f, 0.6f, 0.021f}), slow(GetParam(), 0.5f, {0.013f, 0.2f, 0.021f});
  EXPECT_GE(fast.report.substeps, 20);
  EXPECT_LE(fast.report.substeps, 40);
  EXPECT_EQ(slow.report.substeps, 3);
}

/// A fast body that is far away, or does not collide with cloth, costs no substeps, and cloth keeps its bits.
TEST_P(FastBodies, ElsewhereChangeNothing) {
  const Vec3 far{20, 0.5f, 0}, near{0.013f, 0.6f, 0.021f};
  const Fall still(GetParam(), 0, far), fast(GetParam(), 20, far), unmet(GetParam(), 20, near, false);
  EXPECT_EQ(still.report.substeps, 3);
  EXPECT_EQ(fast.report.substeps, 3);
  EXPECT_EQ(unmet.report.substeps, 3);
  EXPECT_TRUE(have_same_bits(still.cloth, fast.cloth));
  EXPECT_TRUE(have_same_bits(still.cloth, unmet.cloth));
}

/// Checks the count itself: a ball that does not collide with the sheet passes through it.
TEST_P(FastBodies, ThatDoNotCollideAreCounted) {
  BodyDef def = thrown(0.5f, 0.2f, 20);
  const SphereGeometry ball{0.05f};
  def.geometry = ball;
  def.filter.mask = 0;
  Impact<SphereGeometry> impact(GetParam(), def, ball, 16, true);
  impact.run(9);
  EXPECT_GT(impact.crossings.inside(), 8);
  EXPECT_EQ(impact.crossings.passed(), 0);
  impact.run(16);
  EXPECT_EQ(impact.crossings.inside(), 0);
  EXPECT_GE(impact.crossings.passed(), 1);
}

}  // namespace
}  // namespace meniscus::tests
