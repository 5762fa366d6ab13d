// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A taut sheet of cloth between water at two levels, against the equation of a membrane.
#include <string>

#include "sdk/validation/cases/cases.h"
#include "sdk/validation/cases/parted_tank.h"

namespace meniscus::validation {
namespace {

Curve over_height(const std::string& name, const std::vector<double>& bulge, bool points) {
  Curve curve{name, {}, {}, points};
  for (std::size_t n = 0; n < bulge.size(); ++n)
    curve.add(double{PartedTank::height} * static_cast<double>(n) / static_cast<double>(bulge.size() - 1),
              bulge[n]);
  return curve;
}

Result result_of(const Settings& settings) {
  Result result;
  Plot plot{"Bulge of the sheet", "height over the floor (m)", "bulge (m)", {}};
  for (const float right : {0.0f, 0.15f}) {
    if (settings.resolution == Resolution::quick && right > 0) continue;
    PartedTank tank(settings.world(1), 0.35f, right);
    const std::vector<double> measured = tank.bulge_at_rest(), theory = exact_bulge(tank.volume);
    const std::string name = right > 0 ? ", over water" : ", over air";
    result.at_most("largest deviation over the largest bulge" + name, "%",
                   100 * largest_difference(measured, theory) / largest(theory), 10, Bar::hard);
    plot.curves.push_back(over_height("theory" + name, theory, false));
    plot.curves.push_back(over_height("measured" + name, measured, true));
  }
  result.plots = {plot};
  return result;
}

}  // namespace

Case membrane() {
  return {
      "membrane", "Membrane: cloth between two levels of water",
      "A taut sheet parts a tank, held along its top and its bottom 0.4 m apart. Water stands 0.35 m high on "
      "its left, and 0 or 0.15 m on its right. The spacing is 25 mm at each resolution.",
      "T w'' = −Δp, with the tension T from the stretch, by finite differences.", result_of};
}

}  // namespace meniscus::validation
