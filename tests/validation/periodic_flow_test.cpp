// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Viscous flows between periodic axes, for which the Navier–Stokes equations have solutions.
#include <gtest/gtest.h>

#include <cmath>

#include "sdk/validation/cases/periodic_flow.h"
#include "tests/worlds.h"

namespace meniscus::tests {
namespace {

using namespace validation;

constexpr double pi = 3.14159265358979;
constexpr float frame = PeriodicFlow::frame;

class PeriodicFlowTest : public OnDevice {};

/// Taylor & Green 1937: the amplitude decays with 2 ν k². The Reynolds number of one period is 20.
TEST_P(PeriodicFlowTest, ATaylorGreenVortexDecaysAtTheAnalyticRate) {
  const std::vector<float> viscosities{0.01f, 0.02f, 0.05f};
  const std::vector<VortexDecay> decays = taylor_green(world_def(GetParam(), 0.05f), viscosities);
  for (size_t n = 0; n < decays.size(); ++n) {
    EXPECT_TRUE(decays[n].monotone) << viscosities[n] << " m²/s";
    EXPECT_NEAR(decays[n].rate, 1, 0.05) << viscosities[n] << " m²/s";
  }
}

TEST_P(PeriodicFlowTest, CouettesProfileIsLinear) {
  EXPECT_LT(couette_flow(world_def(GetParam(), 1), 8).error, 0.03);
}

/// The layer at a wall and the next are further apart than others. There the velocity is too steep. So the
/// flow is 3 % faster than it should be.
TEST_P(PeriodicFlowTest, PoiseuillesProfileIsAParabola) {
  const ProfileFit fit = poiseuille_flow(world_def(GetParam(), 1), 10);
  EXPECT_LT(fit.error, 0.05);
  EXPECT_NEAR(fit.scale, 1, 0.045);
  EXPECT_LT(fit.shape, 0.025);
}

/// A film on a belt that starts at once: the mean velocity is U (1 − Σ 2/q² exp(−q² ν t/H²)), with
/// q = (n + ½) π.
TEST_P(PeriodicFlowTest, AFilmOverABeltHasItsViscosity) {
  constexpr float s = 0.02f, height = 8 * s, speed = 0.5f, viscosity = 0.01f;
  PeriodicFlow flow(world_def(GetParam(), s), 8 * s, viscosity);
  World& world = flow.world;
  flow.set_gravity({0, -9.81f, 0});
  const ShapeId floor = world.create_shape(flow_wall(1, 0, 0));
  flow.fill(height);
  run(world, 30, frame);  // the surface settles
  world.destroy_shape(floor);
  world.create_shape(flow_wall(1, 0, speed));
  flow.set_velocities([](Vec3) { return Vec3{0, 0, 0}; });
  const auto expected = [&](double time) {  // as a fraction of the speed; time: ν t/H²
    double mean = 1;
    for (int n = 0; n < 100; ++n)
      mean -= 2 / std::pow((n + 0.5) * pi, 2) * std::exp(-std::pow((n + 0.5) * pi, 2) * time);
    return mean;
  };
  const auto viscous_time = [&] {
    double mean = 0, low = 0, high = 4;
    for (Vec3 v : world.velocities()) mean += double{v.x / speed} / double(world.particle_count());
    for (int k = 0; k < 50; ++k) (expected(0.5 * (low + high)) < mean ? low : high) = 0.5 * (low + high);
    return low;
  };
  for (int frames = 12; frames <= 42; frames += 10) {
    run(world, frames == 12 ? 12 : 10, frame);
    const double exact = double{viscosity} * frames * double{frame} / (double{height} * double{height});
    EXPECT_NEAR(viscous_time() / exact, 1, 0.1) << "after " << frames << " frames";
  }
}

MENISCUS_ON_EACH_DEVICE(PeriodicFlowTest);

}  // namespace
}  // namespace meniscus::tests
