// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A drop without gravity: its swing against Rayleigh's theory, and its pressure against Laplace's law.
#include <cmath>
#include <numbers>

#include "sdk/validation/cases/cases.h"
#include "sdk/validation/curves.h"
#include "sdk/validation/parts.h"

namespace meniscus::validation {
namespace {

constexpr float large = 0.5f, small = 0.25f, tension = 100, frame = 0.016f;  // m, m, N/m, s
constexpr double density = 1000;                                             // kg/m³

struct Drop {
  World world;

  Drop(const Settings& settings, float radius, float xsph) : world(weightless(settings)) {
    FluidDef def;
    def.surface_tension = tension;
    def.xsph = xsph;
    world.add_fluid({.fluid = world.create_fluid(def), .region = BallRegion{radius}});
  }
  static WorldDef weightless(const Settings& settings) {
    WorldDef def = settings.world(large / settings.choose(8.0f, 12.0f, 24.0f));
    def.gravity = {0, 0, 0};
    return def;
  }

  /// v = 0.25/s · (−x, 2y, −z), for which the water needs no other density.
  void stretch() {
    const std::vector<ParticleId> ids(world.ids().begin(), world.ids().end());
    std::vector<Vec3> impulses;
    const float volume =
        world.def().particle_spacing * world.def().particle_spacing * world.def().particle_spacing;
    for (Vec3 p : world.positions())
      impulses.push_back(0.25f * float(density) * volume * Vec3{-p.x, 2 * p.y, -p.z});
    world.apply_impulses(ids, impulses);
  }
  /// Length along y over width, less 1.
  double elongation() const {
    double along = 0, across = 0;
    for (Vec3 p : world.positions()) {
      along += double{p.y * p.y};
      across += 0.5 * double{p.x * p.x + p.z * p.z};
    }
    return std::sqrt(along / across) - 1;
  }
  /// m, of the ball with the same second moment.
  double size() const {
    double square = 0;
    for (Vec3 p : world.positions()) square += double{dot(p, p)};
    return std::sqrt(square / static_cast<double>(world.particle_count()) * 5 / 3);
  }
  /// Pa, mean over what is within half of this distance from the centre.
  double pressure_within(double distance) const {
    double sum = 0, count = 0;
    for (std::size_t k = 0; k < world.particle_count(); ++k) {
      if (double{length(world.positions()[k])} > 0.5 * distance) continue;
      sum += double{world.pressures()[k]};
      ++count;
    }
    return sum / count;
  }
};

double rayleigh_period(double size) {
  return 2 * std::numbers::pi / std::sqrt(8 * double{tension} / (density * std::pow(size, 3)));
}

Curve swing_of(Drop& drop) {
  Curve elongation{"drop", {}, {}};
  drop.stretch();
  const double end = 2.2 * rayleigh_period(drop.size());
  while (drop.world.time() < end) {
    drop.world.step(frame);
    elongation.add(drop.world.time(), drop.elongation());
  }
  return elongation;
}

struct Rest {
  double size, pressure;  ///< m, Pa
};

Rest rest_of(const Settings& settings, float radius) {
  Drop drop(settings, radius, 20);
  run(drop.world, 2, frame);
  double pressure = 0;
  constexpr int frames = 60;
  for (int k = 0; k < frames; ++k) {
    drop.world.step(frame);
    pressure += drop.pressure_within(drop.size()) / frames;
  }
  return {drop.size(), pressure};
}

Result result_of(const Settings& settings) {
  Result result;
  Drop drop(settings, large, 0.5f);
  const Curve elongation = swing_of(drop);
  const double period = 100 * (period_of(elongation) / rayleigh_period(drop.size()) - 1);
  result.about_zero("period over that of theory less 1", "%", period, 8, Bar::hard);
  result.about_zero("period over that of theory less 1", "%", period, 5, Bar::target,
                    "The reason is not known.");
  const Rest a = rest_of(settings, small), b = rest_of(settings, large);
  const double laplace = 2 * double{tension} * (1 / a.size - 1 / b.size);
  result.about_zero(
      "difference of pressures over that of Laplace's law less 1", "%",
      100 * ((a.pressure - b.pressure) / laplace - 1), 10, Bar::target,
      "The pressure that holds attracted particles apart is several times as large, and it is less "
      "in smaller drops.");
  result.plots = {{"Length over width, less 1", "time (s)", "", {elongation}}};
  return result;
}

}  // namespace

Case drop() {
  return {
      "drop", "A drop with surface tension: Rayleigh and Laplace",
      "A ball of water with a radius of 0.5 m and a surface tension of 100 N/m is stretched without gravity, "
      "and swings. Another one and one of half its radius come to rest with xsph at 20 1/s. The pressure is "
      "the "
      "mean of the inner half over a second. It contains what holds attracted particles apart, so the two "
      "are "
      "compared.",
      "Lord Rayleigh, On the capillary phenomena of jets, Proc. R. Soc. 29 (1879): ω² = 8 σ/(ρ R³). "
      "Laplace's "
      "law: Δp = 2 σ/R.",
      result_of};
}

}  // namespace meniscus::validation
