// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Viscous flows between periodic axes, for which the Navier–Stokes equations have solutions.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "tests/worlds.h"

namespace meniscus::tests {
namespace {

constexpr double pi = 3.14159265358979;
constexpr float frame = 1 / 60.0f;

/// A world without gravity, 8 spacings long along z, and with one fluid of 1000 kg/m³.
class PeriodicFlow {
 public:
  /// `length_y`: 0 if y is not periodic.
  PeriodicFlow(pbd::DeviceKind device, float spacing, float length_x, float kinematic_viscosity,
               float length_y = 0)
      : def_(make_def(device, spacing, length_x, length_y)), world(def_) {
    fluid_.dynamic_viscosity = 1000 * kinematic_viscosity;
    fluid_.xsph = 0;
    id_ = world.create_fluid(fluid_);
  }

  void fill(float height) {
    world.add_fluid(block(id_, {0, 0, 0}, {def_.periodic.x->high, height, def_.periodic.z->high}));
  }
  void set_viscosity(float kinematic) {
    fluid_.dynamic_viscosity = 1000 * kinematic;
    world.set_fluid(id_, fluid_);
  }
  void set_gravity(Vec3 gravity) {
    def_.gravity = gravity;
    world.set_def(def_);
  }
  void set_velocities(const std::function<Vec3(Vec3)>& wanted) {
    std::vector<Vec3> impulses;
    const float mass = world.particle_mass(id_);
    for (size_t i = 0; i < world.particle_count(); ++i)
      impulses.push_back(mass * (wanted(world.positions()[i]) - world.velocities()[i]));
    const std::vector<ParticleId> ids(world.ids().begin(), world.ids().end());
    world.apply_impulses(ids, impulses);
  }
  /// A second and a half in which fluid without viscosity is stirred and comes to rest: it is no lattice any
  /// more.
  void stir(float speed) {
    const FluidDef before = fluid_;
    fluid_.dynamic_viscosity = 0;
    world.set_fluid(id_, fluid_);
    std::mt19937 random(3);
    set_velocities([&](Vec3) { return random_vector(random, speed); });
    run(world, 60, frame);
    fluid_.xsph = 20;
    world.set_fluid(id_, fluid_);
    run(world, 30, frame);
    fluid_ = before;
    world.set_fluid(id_, fluid_);
  }

 private:
  static WorldDef make_def(pbd::DeviceKind device, float spacing, float length_x, float length_y) {
    WorldDef def = world_def(device, spacing);
    def.gravity = {0, 0, 0};
    def.periodic.x = PeriodicExtent{0, length_x};
    if (length_y > 0) def.periodic.y = PeriodicExtent{0, length_y};
    def.periodic.z = PeriodicExtent{0, 8 * spacing};
    return def;
  }

  WorldDef def_;
  FluidDef fluid_;
  FluidId id_{};

 public:
  World world;
};

ShapeDef wall(float direction, float height, float belt_speed) {
  ShapeDef def = shape(PlaneGeometry{{0, direction, 0}, direction * height});
  def.surface.slip_length = 0;
  def.surface.belt_velocity = {belt_speed, 0, 0};
  return def;
}

/// The velocities along x over a profile.
struct ProfileFit {
  double error;  ///< L2, over that of the profile
  double scale;  ///< of the profile that fits best
  double shape;  ///< L2, from that one
};

/// Over layers of one spacing, of the mean of so many frames.
ProfileFit fit_profile(World& world, float spacing, int layers, int frames,
                       const std::function<double(double)>& exact) {
  std::vector<double> sum(static_cast<size_t>(layers)), count(static_cast<size_t>(layers));
  for (int k = 0; k < frames; ++k) {
    world.step(frame);
    for (size_t i = 0; i < world.particle_count(); ++i) {
      const int layer = static_cast<int>(world.positions()[i].y / spacing);
      const auto n = static_cast<size_t>(std::clamp(layer, 0, layers - 1));
      sum[n] += double{world.velocities()[i].x};
      ++count[n];
    }
  }
  double along = 0, norm = 0, error = 0, shape = 0;
  for (size_t n = 0; n < sum.size(); ++n) {
    const double x = exact((double(n) + 0.5) * double{spacing}), u = sum[n] / count[n];
    along += u * x;
    norm += x * x;
    error += (u - x) * (u - x);
  }
  for (size_t n = 0; n < sum.size(); ++n) {
    const double x = along / norm * exact((double(n) + 0.5) * double{spacing}), u = sum[n] / count[n];
    shape += (u - x) * (u - x);
  }
  return {std::sqrt(error / norm), along / norm, std::sqrt(shape / norm)};
}

class PeriodicFlowTest : public OnDevice {};

/// Taylor & Green 1937: the amplitude decays with 2 ν k². The Reynolds number of one period is 20.
TEST_P(PeriodicFlowTest, ATaylorGreenVortexDecaysAtTheAnalyticRate) {
  constexpr float s = 0.05f, length = 1;
  PeriodicFlow flow(GetParam(), s, length, 0.01f, length);
  World& world = flow.world;
  flow.fill(length);
  flow.stir(1);
  const double k = 2 * pi / double{length};
  const auto vortices = [&](Vec3 x) {
    return Vec3{float(std::sin(k * x.x) * std::cos(k * x.y)), float(-std::cos(k * x.x) * std::sin(k * x.y)),
                0};
  };
  const auto amplitude = [&] {
    double along = 0, norm = 0;
    for (size_t i = 0; i < world.particle_count(); ++i) {
      const Vec3 u = vortices(world.positions()[i]);
      along += double{dot(u, world.velocities()[i])};
      norm += double{dot(u, u)};
    }
    return along / norm;
  };
  for (const float viscosity : {0.01f, 0.02f, 0.05f}) {
    flow.set_viscosity(viscosity);
    flow.set_velocities([&](Vec3 x) { return 20 * viscosity / length * vortices(x); });
    const double first = amplitude(), rate = 2 * double{viscosity} * k * k;
    const int frames = static_cast<int>(0.8 / (rate * double{frame}));
    double last = first;
    for (int n = 1; n <= frames; ++n) {
      world.step(frame);
      const double now = amplitude();
      EXPECT_LT(now, last) << "after " << n << " frames";
      last = now;
    }
    EXPECT_NEAR(std::log(first / last) / (frames * double{frame}) / rate, 1, 0.05) << viscosity << " m²/s";
  }
}

TEST_P(PeriodicFlowTest, CouettesProfileIsLinear) {
  constexpr float s = 0.05f, height = 0.4f, speed = 0.5f;
  PeriodicFlow flow(GetParam(), s, 8 * s, 0.1f);
  flow.world.create_shape(wall(1, 0, 0));
  flow.world.create_shape(wall(-1, height, speed));
  flow.fill(height);
  run(flow.world, 60, frame);  // five times the slowest decay
  const ProfileFit fit =
      fit_profile(flow.world, s, 8, 20, [&](double y) { return double{speed} * y / double{height}; });
  EXPECT_LT(fit.error, 0.03);
}

/// Fluid that is no lattice has 5 % less viscosity than it should. So the flow is that much faster, and its
/// profile keeps its shape.
TEST_P(PeriodicFlowTest, PoiseuillesProfileIsAParabola) {
  constexpr float s = 0.04f, height = 0.4f, speed = 0.5f, viscosity = 0.1f;
  PeriodicFlow flow(GetParam(), s, 8 * s, viscosity);
  flow.world.create_shape(wall(1, 0, 0));
  flow.world.create_shape(wall(-1, height, 0));
  flow.fill(height);
  flow.stir(1);
  flow.set_gravity({8 * viscosity * speed / (height * height), 0, 0});
  run(flow.world, 60, frame);
  const ProfileFit fit = fit_profile(flow.world, s, 10, 20, [&](double y) {
    return 4 * double{speed} * y * (double{height} - y) / (double{height} * double{height});
  });
  EXPECT_LT(fit.error, 0.07);
  EXPECT_NEAR(fit.scale, 1, 0.06);
  EXPECT_LT(fit.shape, 0.03);
}

/// A film on a belt that starts at once: the mean velocity is U (1 − Σ 2/q² exp(−q² ν t/H²)), with
/// q = (n + ½) π.
TEST_P(PeriodicFlowTest, AFilmOverABeltHasItsViscosity) {
  constexpr float s = 0.02f, height = 8 * s, speed = 0.5f, viscosity = 0.01f;
  PeriodicFlow flow(GetParam(), s, 8 * s, viscosity);
  World& world = flow.world;
  flow.set_gravity({0, -9.81f, 0});
  const ShapeId floor = world.create_shape(wall(1, 0, 0));
  flow.fill(height);
  run(world, 30, frame);  // the surface settles
  world.destroy_shape(floor);
  world.create_shape(wall(1, 0, speed));
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
