// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A ball of heavy cloth, filled with air, floats as deep as Archimedes says.
#include "tests/validation/cloth_worlds.h"

namespace meniscus::tests {
namespace {

constexpr float spacing = 0.04f;                                  // m
constexpr float radius = 0.2f;                                    // m, of the hull
constexpr float tank_half = radius + 6 * spacing, depth = 0.36f;  // m
constexpr double gravity = 9.81, density = 1000;                  // m/s², kg/m³

struct FloatingHull {
  World world;
  ClothId hull;
  double volume = 0;  ///< m³, of the water

  FloatingHull(pbd::DeviceKind device, DensitySolver solver) : world(settings(device, solver)) {
    const Vec3 centre{0, depth + 0.3f * radius, 0};
    world.set_wind({});
    world.create_shape(tank({-tank_half, 0, -tank_half}, {tank_half, 1, tank_half}));
    ClothDef def;
    def.geometry = ClothSphere{radius, 8};
    def.pose.position = centre;
    def.fabric.density = 20;
    def.inflation = InflationDef{10000};
    def.self_collision = false;
    hull = world.create_cloth(def);
    FluidDef water;
    water.xsph = 50;
    world.add_fluid(
        block(world.create_fluid(water), {-tank_half, 0, -tank_half}, {tank_half, depth, tank_half}));
    std::vector<ParticleId> within;
    for (size_t i = 0; i < world.particle_count(); ++i)
      if (length(world.positions()[i] - centre) < radius + 0.25f * spacing) within.push_back(world.ids()[i]);
    world.remove_particles(within);
    volume = std::pow(double{spacing}, 3) * static_cast<double>(world.particle_count());
  }

  static WorldDef settings(pbd::DeviceKind device, DensitySolver solver) {
    WorldDef def = world_def(device, spacing);
    def.substeps = 16;
    def.density.solver = solver;
    return def;
  }

  /// m³ of the hull below a level.
  double displaced(double level) const {
    const auto x = world.cloth_positions(hull);
    const auto t = world.cloth_triangles(hull);
    double sum = 0;
    for (size_t k = 0; k < t.size(); k += 3) {
      const Vec3 a = x[t[k]], b = x[t[k + 1]], c = x[t[k + 2]];
      const double base = 0.5 * double{cross(b - a, c - a).y};  // of the column above the triangle
      sum -= base * std::max(0.0, level - double{(a.y + b.y + c.y) / 3});
    }
    return std::fabs(sum);
  }
  /// m: what water and hull fill together.
  double level() const {
    double y = depth;
    for (int k = 0; k < 60; ++k)
      y = 0.5 * y + 0.5 * (volume + displaced(y)) / (4 * double{tank_half * tank_half});
    return y;
  }
  size_t leaked() const {
    const Vec3 centre = world.cloth_state(hull).centre;
    const auto inside = [&](Vec3 p) { return length(p - centre) < 0.7f * radius; };
    return static_cast<size_t>(std::ranges::count_if(world.positions(), inside));
  }
};

class ClothHull : public OnDevice {
 protected:
  void expect_archimedes(DensitySolver solver) const {
    FloatingHull boat(GetParam(), solver);
    const double weight = gravity * double{boat.world.cloth_state(boat.hull).mass};
    run(boat.world, 60, frame);
    constexpr int frames = 60;
    double uplift = 0;
    for (int k = 0; k < frames; ++k) {
      boat.world.step(frame);
      uplift += density * gravity * boat.displaced(boat.level()) / frames;
    }
    RecordProperty("archimedes_over_weight", std::to_string(uplift / weight));
    EXPECT_NEAR(uplift / weight, 1, 0.05);
    EXPECT_EQ(boat.leaked(), 0u);
  }
};

TEST_P(ClothHull, FloatsAsDeepAsArchimedesSays) {
  expect_archimedes(DensitySolver::chebyshev);
}

TEST_P(ClothHull, FloatsAsDeepByThePressureGrid) {
  expect_archimedes(DensitySolver::grid);
}

MENISCUS_ON_EACH_DEVICE(ClothHull);

}  // namespace
}  // namespace meniscus::tests
