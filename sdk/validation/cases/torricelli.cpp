// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A vessel drains through a slot in its floor: the discharge coefficient of Torricelli's law.
#include <cmath>
#include <utility>

#include "sdk/validation/cases/cases.h"
#include "sdk/validation/curves.h"
#include "sdk/validation/parts.h"

namespace meniscus::validation {
namespace {

constexpr float slot = 0.2f, level = 0.6f;  // m
constexpr double gravity = 9.81;

struct Drain {
  World world;
  float width;  ///< m, of the vessel
  float across;

  /// m: where the surface would be if it were flat.
  double head() const {
    double inside = 0;
    for (Vec3 p : world.positions()) inside += p.y > 0;
    const double s = double{world.def().particle_spacing};
    return inside * s * s * s / double{width * across};
  }
};

Drain full_vessel(const Settings& settings, float spacing, float width) {
  World world(settings.world(spacing));
  const float across = 8 * spacing, half = 0.5f * width;
  world.create_shape(shape(PlaneGeometry{{0, 0, 1}, 0}));
  world.create_shape(shape(PlaneGeometry{{0, 0, -1}, -across}));
  ShapeDef vessel = tank({-half, 0, 0}, {half, 2 * level, across});
  std::get<ContainerGeometry>(vessel.geometry).openings = {
      {Face::z_low, {}},
      {Face::z_high, {}},
      {Face::y_low, Aabb{{-0.5f * slot, 0, -across}, {0.5f * slot, 0, across}}}};
  world.create_shape(vessel);
  FluidVolumeDef water = block(world.create_fluid({}), {-half, 0, 0}, {half, level, across});
  water.seeding = Seeding::disordered;
  world.add_fluid(water);
  SinkDef below;
  below.region = HalfSpaceRegion{{0, 1, 0}, -2 * slot};
  world.create_sink(below);
  return {std::move(world), width, across};
}

/// By least squares.
double slope_of(const Curve& line) {
  const auto n = static_cast<double>(line.x.size());
  double x = 0, y = 0, xx = 0, xy = 0;
  for (std::size_t k = 0; k < line.x.size(); ++k) {
    x += line.x[k];
    y += line.y[k];
    xx += line.x[k] * line.x[k];
    xy += line.x[k] * line.y[k];
  }
  return (n * xy - x * y) / (n * xx - x * x);
}

/// √h falls by C √(g/2) a/A a second. The vessel is not infinitely wide: v² (1 − (C a/A)²) = 2 g h.
double discharge(double slope, double area_ratio) {
  const double c = -slope / (std::sqrt(0.5 * gravity) * area_ratio);
  return c / std::sqrt(1 + c * c * area_ratio * area_ratio);
}

Result result_of(const Settings& settings) {
  const float spacing = slot / float(settings.choose(10, 16, 40));
  Drain drain = full_vessel(settings, spacing, settings.choose(5.0f, 8.0f, 8.0f) * slot);
  Curve head{"√h"}, fitted{"√h"};
  while (drain.head() > 0.5 * double{level} && drain.world.time() < 5) {
    drain.world.step(1 / 120.0f);
    const double root = std::sqrt(drain.head());
    head.add(drain.world.time(), root);
    if (root * root < 0.85 * double{level}) fitted.add(drain.world.time(), root);
  }
  const double ratio = double{slot / drain.width}, measured = discharge(slope_of(fitted), ratio);
  Curve theory{"Cd = 0.611"};
  for (double t : {fitted.x.front(), fitted.x.back()})
    theory.add(t, fitted.y.front() - 0.611 * std::sqrt(0.5 * gravity) * ratio * (t - fitted.x.front()));
  Result result;
  result.within("Cd", "", measured, 0.58, 0.65, Bar::target);
  result.plots = {{"Level of the vessel", "time (s)", "√h (√m)", {head, theory}}};
  return result;
}

}  // namespace

Case torricelli() {
  return {
      "torricelli", "Torricelli: a vessel drains",
      "Water 0.6 m deep leaves a vessel through a slot 0.2 m wide with sharp edges in its floor. The slot is "
      "at least ten spacings wide, and the vessel five to eight times as wide. The flow is plane, between "
      "smooth walls eight spacings apart. Cd is fitted to √h between 85 % and 50 % of the level, h being the "
      "volume "
      "over the floor's area.",
      "E. Torricelli 1643, v = √(2 g h); contraction to π/(π + 2) = 0.611 at a slot (G. Kirchhoff 1869, in "
      "H. Lamb, Hydrodynamics, art. 75). The interval is that of sharp-edged orifices, 0.58 to 0.65.",
      result_of};
}

}  // namespace meniscus::validation
