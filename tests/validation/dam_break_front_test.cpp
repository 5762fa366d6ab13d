// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The front of a collapsing column runs as in the experiment of Martin & Moyce (1952), a column twice as high
// as it is wide. Their gate took its time to open, by an amount that is not known: times are compared but for
// a shift.
#include <array>

#include "tests/validation/measures.h"
#include "tests/validation/scenes.h"

namespace meniscus::tests {
namespace {

constexpr float width = 1, spacing = 0.05f;  // m

struct Reading {
  double time, front;  ///< T = t √(2g / width), Z = front / width
};

constexpr std::array<Reading, 15> experiment{{{.41, 1.11},
                                              {.84, 1.22},
                                              {1.19, 1.44},
                                              {1.43, 1.67},
                                              {1.63, 1.89},
                                              {1.83, 2.11},
                                              {1.98, 2.33},
                                              {2.20, 2.56},
                                              {2.32, 2.78},
                                              {2.51, 3.00},
                                              {2.65, 3.22},
                                              {2.83, 3.44},
                                              {2.98, 3.67},
                                              {3.11, 3.89},
                                              {3.33, 4.11}}};

/// Where water stands on the floor. The few particles ahead of it are spray.
double front(const World& world) {
  std::vector<float> on_floor;
  for (Vec3 p : world.positions()) {
    if (p.y < world.support_radius()) on_floor.push_back(p.x);
  }
  return (percentile(on_floor, 0.99) + 0.5 * spacing) / width;
}

/// Between the two readings around x.
double between(const std::vector<Reading>& run, double Reading::*from, double Reading::*to, double x) {
  size_t k = 1;
  while (k + 1 < run.size() && run[k].*from < x) ++k;
  const Reading &a = run[k - 1], &b = run[k];
  return a.*to + (x - a.*from) / (b.*from - a.*from) * (b.*to - a.*to);
}

double time_at(const std::vector<Reading>& run, double z) {
  return between(run, &Reading::front, &Reading::time, z);
}

double front_at(const std::vector<Reading>& run, double t) {
  return between(run, &Reading::time, &Reading::front, t);
}

class DamBreakFrontTest : public OnDevice {};

void expect_as_in_the_experiment(const WorldDef& def, const std::string& name = "") {
  World world(def);
  record_device(world);
  world.create_shape(tank({0, 0, 0}, {6 * width, 3 * width, 0.4f}));
  world.add_fluid(block(world.create_fluid({}), {0, 0, 0}, {width, 2 * width, 0.4f}));
  std::vector<Reading> run{{0, front(world)}};
  while (run.back().front < 4.2 && world.time() < 2) {
    world.step(frame_time);
    run.push_back({world.time() * std::sqrt(2 * 9.81 / width), front(world)});
  }
  ASSERT_GE(run.back().front, 4.2);

  double shift = 0, worst = 0;
  for (const Reading& r : experiment) shift += (time_at(run, r.front) - r.time) / experiment.size();
  for (const Reading& r : experiment) {
    worst = std::max(worst, std::fabs(front_at(run, r.time + shift) / r.front - 1));
  }
  // The slope of the experiment from T = 1.43 on, where it is even.
  const double slope = (4.11 - 1.67) / (time_at(run, 4.11) - time_at(run, 1.67)), measured = 1.319;
  record(name + "time_shift", shift);
  record(name + "front_error_worst_percent", 100 * worst);
  record(name + "front_speed_error_percent", 100 * std::fabs(slope / measured - 1));
  EXPECT_LE(worst, 0.1) << name;
  EXPECT_NEAR(slope / measured, 1, 0.1) << name;
}

TEST_P(DamBreakFrontTest, RunsAsInTheExperiment) {
  expect_as_in_the_experiment(world_def(GetParam(), spacing));
}

TEST_P(DamBreakFrontTest, SoItDoesWithTheBaselines) {
  WorldDef def = world_def(GetParam(), spacing);
  for (const auto& [solver, name] : {std::pair{DensitySolver::pcisph, "pcisph_"},
                                     {DensitySolver::wcsph, "wcsph_"},
                                     {DensitySolver::dfsph, "dfsph_"}}) {
    def.density.solver = solver;
    expect_as_in_the_experiment(def, name);
  }
}

MENISCUS_ON_EACH_DEVICE(DamBreakFrontTest);

}  // namespace
}  // namespace meniscus::tests
