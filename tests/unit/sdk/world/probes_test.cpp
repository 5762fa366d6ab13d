// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Pressures and forces of water at rest, which are known.
#include <gtest/gtest.h>

#include "tests/worlds.h"

namespace meniscus::tests {
namespace {

constexpr float s = 0.05f;
constexpr double gravity = 9.81, density = 1000;

class ProbesTest : public OnDevice {
 protected:
  World world_{world_def(GetParam(), s)};
  FluidId water_ = world_.create_fluid({});

  /// A column of 0.4 × 0.8 × 0.4 m on a floor that is a shape of its own.
  ShapeId make_column() {
    const ShapeId floor = world_.create_shape(shape(PlaneGeometry{{0, 1, 0}, 0}));
    walls_ = world_.create_shape(tank({0, -1, 0}, {0.4f, 2, 0.4f}));
    world_.add_fluid(block(water_, {0, 0, 0}, {0.4f, 0.8f, 0.4f}));
    return floor;
  }

  ProbeId force_on(ShapeId id) {
    ProbeDef def;
    def.kind = ProbeKind::wall_force;
    def.shape = id;
    return world_.create_probe(def);
  }

  ProbeId pressure_at(Vec3 point) {
    ProbeDef def;
    def.point = point;
    return world_.create_probe(def);
  }

  ProbeId pressure_on_wall(const Aabb& patch, float area) {
    ProbeDef def;
    def.kind = ProbeKind::wall_pressure;
    def.shape = walls_;
    def.patch = patch;
    def.area = area;
    return world_.create_probe(def);
  }

  /// Of the pressures() of the particles between two heights.
  double mean_read_out(float lower, float upper) const {
    double sum = 0, count = 0;
    for (size_t i = 0; i < world_.particle_count(); ++i) {
      const float y = world_.positions()[i].y;
      if (y < lower || y > upper) continue;
      sum += world_.pressures()[i];
      ++count;
    }
    return sum / count;
  }

  /// Each probe's mean over the last steps, once the column has come to rest.
  std::vector<double> settled(const std::vector<ProbeId>& probes) {
    run(world_, 150, 0.01f);
    std::vector<double> sums(probes.size(), 0);
    for (int k = 0; k < 100; ++k) {
      world_.step(0.01f);
      for (size_t p = 0; p < probes.size(); ++p) sums[p] += world_.probe(probes[p]) / 100;
    }
    return sums;
  }

  double weight() const {
    return gravity * double{world_.particle_mass(water_)} * static_cast<double>(world_.particle_count());
  }

  ShapeId walls_;
};

TEST_P(ProbesTest, AColumnAtRestPressesAsItsWeightAndDepthSay) {
  const ProbeId on_floor = force_on(make_column()), on_walls = force_on(walls_);
  EXPECT_EQ(world_.particle_count(), 8u * 16 * 8);
  std::vector<ProbeId> probes{on_floor,
                              pressure_on_wall({{-0.01f, 0.1f, 0.1f}, {0.01f, 0.5f, 0.3f}}, 0.4f * 0.2f)};
  for (float y : {0.2f, 0.4f, 0.6f}) probes.push_back(pressure_at({0.2f, y, 0.2f}));
  const std::vector<double> found = settled(probes);
  EXPECT_NEAR(found[0] / weight(), 1, 0.01);
  EXPECT_NEAR(found[1] / (density * gravity * 0.5), 1, 0.15);
  double error = 0;
  for (size_t k = 0; k < 3; ++k) {
    const double expected = density * gravity * (0.6 - 0.2 * static_cast<double>(k));
    EXPECT_NEAR(found[2 + k] / expected, 1, 0.15) << "probe " << k;
    error += (found[2 + k] / expected - 1) / 3;
  }
  EXPECT_NEAR(error, 0, 0.08);
  EXPECT_LT(world_.probe(on_walls), 0.05 * weight());  // opposite walls carry the same force
  EXPECT_NEAR(mean_read_out(0.3f, 0.5f) / (density * gravity * 0.4), 1, 0.15);
}

TEST_P(ProbesTest, WithoutFluidThereIsNothing) {
  const ProbeId point = pressure_at({0, 0, 0}), force = force_on(world_.create_shape(shape(PlaneGeometry{})));
  EXPECT_EQ(world_.probe(point), 0);
  world_.step(0.01f);
  EXPECT_EQ(world_.probe(point), 0);
  EXPECT_EQ(world_.probe(force), 0);
}

TEST_P(ProbesTest, EachIdKeepsItsProbeWhenOthersGo) {
  const ShapeId floor = make_column();
  const ProbeId first = pressure_at({9, 9, 9}), force = force_on(floor);
  run(world_, 40, 0.01f);
  const double before = world_.probe(force);
  EXPECT_GT(before, 0.5 * weight());
  world_.destroy_probe(first);
  world_.step(0.01f);
  EXPECT_NEAR(world_.probe(force) / weight(), 1, 0.3);
  const ProbeId late = pressure_at({9, 9, 9});
  world_.step(0.01f);
  EXPECT_EQ(world_.probe(late), 0);
  EXPECT_NEAR(world_.probe(force) / weight(), 1, 0.3);
}

TEST_P(ProbesTest, OthersComeAndGoWithoutATrace) {
  const ProbeId force = force_on(make_column()), gone = pressure_at({0.2f, 0.4f, 0.2f});
  run(world_, 5, 0.016f);
  const double before = world_.probe(force);
  EXPECT_GT(before, 100);
  world_.destroy_probe(gone);
  EXPECT_EQ(world_.probe(force), before);
  EXPECT_EQ(world_.probe(pressure_at({0.1f, 0.1f, 0.1f})), 0);
  EXPECT_EQ(world_.probe(force), before);
}

TEST_P(ProbesTest, AProbeOfADestroyedShapeDoesNotFollowItsSuccessor) {
  const ShapeId floor = make_column();
  const ProbeId force = force_on(floor);
  world_.destroy_shape(floor);
  world_.create_shape(shape(PlaneGeometry{{0, 1, 0}, 0}));  // takes the old one's place
  run(world_, 30, 0.01f);
  double found = 0;
  try {
    found = world_.probe(force);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::not_found);
  }
  EXPECT_EQ(found, 0);
}

MENISCUS_ON_EACH_DEVICE(ProbesTest);

}  // namespace
}  // namespace meniscus::tests
