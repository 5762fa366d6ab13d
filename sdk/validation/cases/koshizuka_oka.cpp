// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The collapse of a column of water in a short tank, against the experiment of Koshizuka & Oka (1996).
#include <algorithm>
#include <cmath>

#include "sdk/validation/cases/cases.h"
#include "sdk/validation/cases/dam_column.h"
#include "sdk/validation/curves.h"

namespace meniscus::validation {
namespace {

const Curve readings{"Koshizuka & Oka 1996",
                     {.381, .769, 1.153, 1.537, 1.935, 2.323, 2.719, 3.096},
                     {1.111, 1.252, 1.505, 1.892, 2.241, 2.615, 3.003, 3.624},
                     true};

/// How far the curve is out of the band between the two experiments, at their worst reading, over the front.
double outside_band(const Curve& front) {
  double worst = 0;
  for (double t : readings.x) {
    const double a = value_at(readings, t), b = value_at(martin_moyce_front(), t), z = value_at(front, t);
    worst = std::max({worst, (std::min(a, b) - z) / z, (z - std::max(a, b)) / z});
  }
  return worst;
}

Result result_of(const Settings& settings) {
  const int across = settings.choose(20, 40, 160);
  constexpr float width = 0.146f;  // m
  DamMotion motion = collapse({column_world(settings, width, across), width, 4}, 3.8);
  Result result;
  result.at_most(
      "front, RMS", "%", 100 * rms_relative_error(motion.front, readings), 10, Bar::target,
      "About half of it is one shift in time, which is told below: the simulated gate vanishes at once.");
  result.at_most("front, furthest out of the band between the two experiments", "%",
                 100 * outside_band(motion.front), 0, Bar::target,
                 "The front runs ahead of both experiments by nearly the same time from the start on.");
  const double shift = best_shift(motion.front, readings, 0.5);
  result.tell("best shift of T", "", shift);
  result.tell("front, RMS with that shift", "%", 100 * rms_relative_error(motion.front, readings, shift));
  motion.front.name = "L/s = " + std::to_string(across);
  result.plots = {{"Front on the floor",
                   "T = t √(2g/L)",
                   "front over L",
                   {motion.front, readings, martin_moyce_front()}}};
  return result;
}

}  // namespace

Case koshizuka_oka() {
  return {
      "koshizuka-oka", "Collapse of a column of water: Koshizuka & Oka",
      "A column of water L = 0.146 m wide and 2L high collapses in a tank 4L long and 0.4L wide with smooth "
      "walls. The density is solved as in the collapse of Martin & Moyce.",
      "S. Koshizuka & Y. Oka, Moving-particle semi-implicit method for fragmentation of incompressible "
      "fluid, Nucl. Sci. Eng. 123 (1996). The band is what lies between their readings and those of Martin "
      "& Moyce (1952).",
      result_of};
}

}  // namespace meniscus::validation
