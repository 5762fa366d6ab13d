// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What evidence is measured by: neighbourhoods, streaks, stable steps, and limits of time.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <thread>

#include "pbd/math/vec.h"
#include "sdk/cli/evidence/particle_measures.h"
#include "sdk/cli/evidence/stable_step.h"
#include "sdk/cli/evidence/streaks.h"

namespace meniscus::cli {
namespace {

std::vector<Vec3> lattice(int n, float spacing) {
  std::vector<Vec3> positions;
  for (int i = 0; i < n * n * n; ++i)
    positions.push_back(spacing *
                        Vec3{float(i % n - n / 2), float(i / n % n - n / 2), float(i / n / n - n / 2)});
  return positions;
}

TEST(ParticleMeasures, FindTheNearestNeighbour) {
  std::vector<Vec3> positions = lattice(5, 0.1f);
  for (const float distance : nearest_distances(positions, 0.2f)) EXPECT_NEAR(distance, 0.1f, 1e-5f);
  positions.push_back({0.03f, 0, 0});
  EXPECT_NEAR(nearest_distances(positions, 0.2f).back(), 0.03f, 1e-5f);
  positions.push_back({9, 9, 9});
  EXPECT_EQ(nearest_distances(positions, 0.2f).back(), 0.2f) << "nobody is near";
}

TEST(ParticleMeasures, ARigidRotationHasTwiceItsRateAsVorticity) {
  const std::vector<Vec3> positions = lattice(9, 0.1f);
  const Vec3 rate{0.5f, -1, 2};
  std::vector<Vec3> velocities;
  for (const Vec3 p : positions) velocities.push_back(cross(rate, p) + Vec3{3, 0, 0});
  const std::vector<Vec3> curls = vorticity_of(positions, velocities, 0.2f);
  const Vec3 centre = curls[curls.size() / 2];  // its neighbours are on all sides
  EXPECT_LT(length(centre - 2 * rate), 1e-4f);
  EXPECT_EQ(length(vorticity_of(std::vector<Vec3>(3, Vec3{0, 0, 0}), std::vector<Vec3>(3, rate), 0.2f)[0]), 0)
      << "too few for a curl";
}

/// Normals that tilt by `tilt(x, y)` radians about the picture's upright.
template <class Tilt>
NormalPicture tilted(const Tilt& tilt) {
  NormalPicture picture{64, 64, {}};
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const float angle = static_cast<float>(tilt(x, y));
      picture.pixels.push_back({std::sin(angle), 0, std::cos(angle), 2});
    }
  }
  return picture;
}

TEST(Streaks, ShowAsARatioBelowOne) {
  const auto noise = [](int seed) {
    return 0.2 * std::fmod(std::abs(std::sin(seed * 12.9898) * 43758.5453), 1.0);
  };
  const Roughness columns = roughness_of(tilted([&](int x, int) { return noise(x); }), 0.1f);
  EXPECT_NEAR(columns.ratio(), std::sqrt(0.5), 0.1) << "half of the offsets along axes see nothing";
  const Roughness both = roughness_of(tilted([&](int x, int y) { return noise(64 * y + x); }), 0.1f);
  EXPECT_NEAR(both.ratio(), 1, 0.05) << "noise has no direction";
  EXPECT_NEAR(roughness_of(tilted([](int, int) { return 0.3; }), 0.1f).axes, 0, 1e-4) << "a plane is smooth";
}

TEST(Streaks, DifferentSurfacesDoNotCount) {
  NormalPicture picture = tilted([](int x, int) { return x < 32 ? 0.0 : 1.0; });
  EXPECT_GT(roughness_of(picture, 0.1f).axes, 1);
  for (int i = 0; i < 64 * 64; ++i) picture.pixels[i][3] = i % 64 < 32 ? 2.0f : 3.0f;
  EXPECT_NEAR(roughness_of(picture, 0.1f).axes, 0, 1e-4);
}

RunFigures run_of(double error, double gain = 0) {
  RunFigures run;
  run.substeps = {2, 2};
  run.error_mean = {error, error};
  run.gain = gain;
  return run;
}

TEST(StableStepSearch, BracketsTheLimit) {
  const double limit = 0.0135;
  const StableStep found =
      find_stable_step({}, {}, [&](double step) { return run_of(step <= limit ? 0.01 : 0.2); });
  EXPECT_LE(found.asked, limit);
  EXPECT_GT(found.broke, limit);
  EXPECT_LT(found.broke / found.asked, 1.2) << "two bisections of a factor of two";
  EXPECT_DOUBLE_EQ(found.made, found.asked / 2) << "the solver halved the step";
  EXPECT_NE(found.reason.find("density error 20"), std::string::npos) << found.reason;
  EXPECT_LE(found.runs, 7);
}

TEST(StableStepSearch, EndsWhereAllOrNothingHolds) {
  const StableStep all = find_stable_step({}, {}, [](double) { return run_of(0); });
  EXPECT_DOUBLE_EQ(all.asked, StepSearch{}.longest);
  EXPECT_EQ(all.runs, 1);
  const StableStep none = find_stable_step({}, {}, [](double) { return run_of(0, 1); });
  EXPECT_EQ(none.asked, 0);
  EXPECT_EQ(none.runs, 9);
}

TEST(StableBounds, NameWhatBreaks) {
  EXPECT_EQ(broken_by(run_of(0.01), {}), "");
  EXPECT_EQ(broken_by(run_of(0.01, 0.2), {}), "gains 20 % of energy");
  EXPECT_NE(broken_by(run_of(std::nan("")), {}), "");
  RunFigures run = run_of(0);
  run.outside = 3;
  EXPECT_EQ(broken_by(run, {}), "3 particles outside");
  EXPECT_TRUE(is_lost(run, {}));
}

TEST(RunBudget, EndsAtItsLimit) {
  RunBudget budget(1e-9);
  std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_TRUE(budget.spent());
  EXPECT_FALSE(budget.interrupted());
  EXPECT_NE(budget.reason().find("limit"), std::string::npos);
}

TEST(RunBudget, HasNoLimitByDefault) {
  RunBudget budget(0);
  EXPECT_FALSE(budget.spent());
  EXPECT_EQ(budget.reason(), "");
  std::raise(SIGTERM);
  EXPECT_TRUE(budget.spent());
  EXPECT_NE(budget.reason().find("signal"), std::string::npos);
}

}  // namespace
}  // namespace meniscus::cli
