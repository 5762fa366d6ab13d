// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Viscous flows between periodic axes, for which the Navier–Stokes equations have solutions.
#include "sdk/validation/cases/periodic_flow.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "pbd/math/vec.h"
#include "sdk/validation/parts.h"

namespace meniscus::validation {
namespace {

constexpr float wall_speed = 0.5f, middle_speed = 0.5f, viscosity = 0.1f;  // m/s, m/s, m²/s

WorldDef flow_world(WorldDef def, float length_x, float length_y) {
  def.gravity = {0, 0, 0};
  def.periodic.x = PeriodicExtent{0, length_x};
  if (length_y > 0) def.periodic.y = PeriodicExtent{0, length_y};
  def.periodic.z = PeriodicExtent{0, 8 * def.particle_spacing};
  return def;
}

Vec3 random_vector(std::mt19937& random, float magnitude) {
  std::uniform_real_distribution<float> range(-magnitude, magnitude);
  const float x = range(random), y = range(random), z = range(random);
  return {x, y, z};
}

/// Over layers of one spacing, of the mean of so many frames.
ProfileFit fit_profile(World& world, int layers, int frames, double (*exact)(double)) {
  const double spacing = double{world.def().particle_spacing};
  std::vector<double> sum(static_cast<size_t>(layers)), count(static_cast<size_t>(layers));
  for (int k = 0; k < frames; ++k) {
    world.step(PeriodicFlow::frame);
    for (size_t i = 0; i < world.particle_count(); ++i) {
      const int layer = static_cast<int>(double{world.positions()[i].y} / spacing);
      const auto n = static_cast<size_t>(std::clamp(layer, 0, layers - 1));
      sum[n] += double{world.velocities()[i].x};
      ++count[n];
    }
  }
  ProfileFit fit{};
  fit.measured = {"measured", {}, {}, true};
  double along = 0, norm = 0;
  for (size_t n = 0; n < sum.size(); ++n) {
    const double y = (double(n) + 0.5) * spacing, x = exact(y), u = sum[n] / count[n];
    fit.measured.add(y, u);
    along += u * x;
    norm += x * x;
    fit.error += (u - x) * (u - x);
  }
  for (size_t n = 0; n < sum.size(); ++n) {
    const double x = along / norm * exact(fit.measured.x[n]), u = fit.measured.y[n];
    fit.shape += (u - x) * (u - x);
  }
  fit.error = std::sqrt(fit.error / norm);
  fit.scale = along / norm;
  fit.shape = std::sqrt(fit.shape / norm);
  return fit;
}

}  // namespace

PeriodicFlow::PeriodicFlow(const WorldDef& base, float length_x, float kinematic_viscosity, float length_y)
    : def_(flow_world(base, length_x, length_y)), world(def_) {
  fluid_.dynamic_viscosity = 1000 * kinematic_viscosity;
  fluid_.xsph = 0;
  id_ = world.create_fluid(fluid_);
}

void PeriodicFlow::fill(float height) {
  world.add_fluid(block(id_, {0, 0, 0}, {def_.periodic.x->high, height, def_.periodic.z->high}));
}

void PeriodicFlow::set_viscosity(float kinematic) {
  fluid_.dynamic_viscosity = 1000 * kinematic;
  world.set_fluid(id_, fluid_);
}

void PeriodicFlow::set_gravity(Vec3 gravity) {
  def_.gravity = gravity;
  world.set_def(def_);
}

void PeriodicFlow::set_velocities(const std::function<Vec3(Vec3)>& wanted) {
  std::vector<Vec3> impulses;
  const float mass = world.particle_mass(id_);
  for (size_t i = 0; i < world.particle_count(); ++i)
    impulses.push_back(mass * (wanted(world.positions()[i]) - world.velocities()[i]));
  const std::vector<ParticleId> ids(world.ids().begin(), world.ids().end());
  world.apply_impulses(ids, impulses);
}

void PeriodicFlow::stir(float speed) {
  const FluidDef before = fluid_;
  fluid_.dynamic_viscosity = 0;
  world.set_fluid(id_, fluid_);
  std::mt19937 random(3);
  set_velocities([&](Vec3) { return random_vector(random, speed); });
  run(60);
  fluid_.xsph = 20;
  world.set_fluid(id_, fluid_);
  run(30);
  fluid_ = before;
  world.set_fluid(id_, fluid_);
}

void PeriodicFlow::run(int frames) {
  run_steps(world, frames, frame);
}

ShapeDef flow_wall(float direction, float height, float belt_speed) {
  ShapeDef def = shape(PlaneGeometry{{0, direction, 0}, direction * height});
  def.surface.slip_length = 0;
  def.surface.belt_velocity = {belt_speed, 0, 0};
  return def;
}

double couette_velocity(double y) {
  return double{wall_speed} * y / double{channel_height};
}

double poiseuille_velocity(double y) {
  const double height = double{channel_height};
  return 4 * double{middle_speed} * y * (height - y) / (height * height);
}

ProfileFit couette_flow(WorldDef def, int layers) {
  def.particle_spacing = channel_height / float(layers);
  PeriodicFlow flow(def, 8 * def.particle_spacing, viscosity);
  flow.world.create_shape(flow_wall(1, 0, 0));
  flow.world.create_shape(flow_wall(-1, channel_height, wall_speed));
  flow.fill(channel_height);
  flow.run(60);  // five times the slowest decay
  return fit_profile(flow.world, layers, 20, couette_velocity);
}

ProfileFit poiseuille_flow(WorldDef def, int layers) {
  def.particle_spacing = channel_height / float(layers);
  PeriodicFlow flow(def, 8 * def.particle_spacing, viscosity);
  flow.world.create_shape(flow_wall(1, 0, 0));
  flow.world.create_shape(flow_wall(-1, channel_height, 0));
  flow.fill(channel_height);
  flow.stir(1);
  flow.set_gravity({8 * viscosity * middle_speed / (channel_height * channel_height), 0, 0});
  flow.run(60);
  return fit_profile(flow.world, layers, 20, poiseuille_velocity);
}

std::vector<VortexDecay> taylor_green(const WorldDef& def, const std::vector<float>& viscosities) {
  constexpr float length = 1;  // m
  PeriodicFlow flow(def, length, 0.01f, length);
  World& world = flow.world;
  flow.fill(length);
  flow.stir(1);
  const double k = 2 * std::numbers::pi / double{length};
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
  std::vector<VortexDecay> decays;
  for (const float nu : viscosities) {
    flow.set_viscosity(nu);
    flow.set_velocities([&](Vec3 x) { return 20 * nu / length * vortices(x); });
    const double first = amplitude(), rate = 2 * double{nu} * k * k;
    const int frames = static_cast<int>(0.8 / (rate * double{PeriodicFlow::frame}));
    VortexDecay decay;
    decay.amplitude.add(0, 1);
    for (int n = 1; n <= frames; ++n) {
      world.step(PeriodicFlow::frame);
      const double now = amplitude() / first;
      decay.monotone = decay.monotone && now < decay.amplitude.y.back();
      decay.amplitude.add(rate * n * double{PeriodicFlow::frame}, now);
    }
    decay.rate = -std::log(decay.amplitude.y.back()) / decay.amplitude.x.back();
    decays.push_back(decay);
  }
  return decays;
}

}  // namespace meniscus::validation
