// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Standing waves in tanks, against the dispersion relation of linear theory.
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "sdk/validation/cases/cases.h"
#include "sdk/validation/curves.h"
#include "sdk/validation/parts.h"

namespace meniscus::validation {
namespace {

constexpr double gravity = 9.81, pi = std::numbers::pi;

struct Tank {
  float length, depth;  ///< m
  int mode;
  bool wide;  ///< without end across, else five spacings between walls

  double wave_number() const { return mode * pi / double{length}; }
  double frequency() const {  // rad/s
    return std::sqrt(gravity * wave_number() * std::tanh(wave_number() * double{depth}));
  }
  std::string name() const {
    return std::to_string(int(length)) + " m, mode " + std::to_string(mode) + (wide ? ", wide" : ", narrow");
  }
};

struct FilledTank {
  World world;
  FluidId water;
};

FilledTank filled(const Settings& settings, const Tank& t, float spacing) {
  WorldDef def = settings.world(spacing);
  const float across = (t.wide ? 8 : 5) * spacing;
  if (t.wide) def.periodic.z = PeriodicExtent{0, across};
  World world(def);
  ShapeDef walls = tank({0, 0, 0}, {t.length, 3 * t.depth, across});
  if (t.wide) std::get<ContainerGeometry>(walls.geometry).openings = {{Face::z_low, {}}, {Face::z_high, {}}};
  world.create_shape(walls);
  const FluidId id = world.create_fluid({});
  FluidVolumeDef water = block(id, {0, 0, 0}, {t.length, t.depth, across});
  water.seeding = Seeding::disordered;
  world.add_fluid(water);
  return {std::move(world), id};
}

/// Gives the water the velocities of the mode, with which the surface would rise by `height` at the walls.
void push(FilledTank& tank, const Tank& t, double height) {
  World& world = tank.world;
  const double k = t.wave_number(), scale = height * t.frequency() / std::sinh(k * double{t.depth});
  const float mass = world.particle_mass(tank.water);
  std::vector<Vec3> impulses;
  for (Vec3 p : world.positions()) {
    const double x = k * double{p.x}, y = k * double{p.y};
    impulses.push_back({static_cast<float>(-scale * std::cosh(y) * std::sin(x)) * mass,
                        static_cast<float>(scale * std::sinh(y) * std::cos(x)) * mass, 0});
  }
  const std::vector<ParticleId> ids(world.ids().begin(), world.ids().end());
  world.apply_impulses(ids, impulses);
}

/// ∝ the surface's height in the mode, as the water keeps its volume: the mean of cos kx.
double amplitude(const World& world, const Tank& t) {
  double sum = 0;
  for (Vec3 p : world.positions()) sum += std::cos(t.wave_number() * double{p.x});
  return sum / static_cast<double>(world.particle_count());
}

std::vector<Tank> tanks(const Settings& settings) {
  std::vector<Tank> all{
      {2, 1, 1, true}, {1, 0.5f, 1, false}, {2, 1, 1, false}, {2, 1, 2, true}, {1, 0.5f, 1, true}};
  if (settings.resolution == Resolution::quick) all.resize(2);
  return all;
}

Result result_of(const Settings& settings) {
  Result result;
  Plot plot{"First mode of a tank 2 m long with 1 m of water",
            "time over the period of theory",
            "height at the wall over the depth",
            {}};
  const double periods = settings.choose(3.3, 4.3, 4.3);
  for (const Tank& t : tanks(settings)) {
    const float spacing = t.depth / float(settings.choose(10, 20, 50));
    FilledTank tank = filled(settings, t, spacing);
    World& world = tank.world;
    run(world, settings.choose(1, 2, 2), 0.016f);
    push(tank, t, 0.05 * double{t.depth});
    const double start = world.time(), exact = 2 * pi / t.frequency();
    Curve wave{t.wide ? "wide" : "narrow"};
    while (world.time() < start + periods * exact) {
      world.step(0.016f);
      wave.add((world.time() - start) / exact, 2 * amplitude(world, t));
    }
    result.about_zero("period over that of theory less 1, " + t.name(), "%",
                      100 * (fitted_wave(wave, 1).period - 1), 3, Bar::target,
                      "The water is few spacings deep, and the wave loses half of its height in a period.");
    if (t.length > 1 && t.mode == 1) plot.curves.push_back(wave);
  }
  result.plots = {plot};
  return result;
}

}  // namespace

Case sloshing() {
  return {
      "sloshing", "Sloshing in tanks",
      "Water that was seeded without order rests for 2 s. Then it gets the velocities of a standing wave, "
      "with which the surface rises by a twentieth of the depth. Tanks are 2 m long with 1 m of water, and "
      "1 m long with 0.5 m. Narrow ones are five spacings wide between smooth walls. Wide ones have no end "
      "across. The wave is the mean of cos kx over the particles. Its period is that of the damped wave that "
      "fits best.",
      "Linear theory: ω² = g k tanh(k d), k = nπ/L, for mode n (H. Lamb, Hydrodynamics, 6th ed. 1932, art. "
      "228). Periods: 1.671 s and 1.134 s for L = 2 m, 1.182 s for L = 1 m.",
      result_of};
}

}  // namespace meniscus::validation
