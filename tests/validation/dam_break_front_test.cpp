// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The front of a collapsing column runs as in the experiment of Martin & Moyce (1952), a column twice as high
// as it is wide. Their gate took its time to open, by an amount that is not known: times are compared but for
// a shift.
#include "sdk/validation/cases/dam_column.h"
#include "sdk/validation/curves.h"
#include "tests/validation/measures.h"
#include "tests/validation/scenes.h"

namespace meniscus::tests {
namespace {

using validation::Curve;

constexpr float spacing = 0.05f;  // m; the column is 1 m wide

class DamBreakFrontTest : public OnDevice {};

void expect_as_in_the_experiment(const WorldDef& def, const std::string& name = "") {
  record_device(World(def));
  const Curve run = validation::collapse({def}, 4.2).front, &experiment = validation::martin_moyce_front();
  ASSERT_GE(run.y.back(), 4.2);

  double shift = 0, worst = 0;
  const std::size_t readings = experiment.x.size();
  for (std::size_t k = 0; k < readings; ++k)
    shift += (x_at(run, experiment.y[k]) - experiment.x[k]) / static_cast<double>(readings);
  for (std::size_t k = 0; k < readings; ++k)
    worst = std::max(worst, std::fabs(value_at(run, experiment.x[k] + shift) / experiment.y[k] - 1));
  // The slope of the experiment from T = 1.43 on, where it is even.
  const double slope = (4.11 - 1.67) / (x_at(run, 4.11) - x_at(run, 1.67)), measured = 1.319;
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
