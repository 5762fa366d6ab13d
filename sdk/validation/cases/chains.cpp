// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Chains: the catenary of a rope and of a strip of cloth, and the swing of a chain that hangs.
#include <cmath>
#include <string>

#include "sdk/validation/cases/cases.h"
#include "sdk/validation/cases/hanging_chain.h"
#include "sdk/validation/curves.h"

namespace meniscus::validation {
namespace {

void judge(Result& result, const std::string& what, const Catenary& found) {
  const Catenary exact = exact_catenary(found.length);
  const std::string name = what + " of " + (found.length < 1.5f ? "1.2" : "2") + " m";
  result.about_zero("sag over that of theory less 1, " + name, "%", 100 * double{found.sag / exact.sag - 1},
                    1, Bar::hard);
  result.about_zero("angle at its ends over that of theory less 1, " + name, "%",
                    100 * double{found.end_angle / exact.end_angle - 1}, 1, Bar::hard);
}

Result catenary_result(const Settings& settings) {
  Result result;
  const WorldDef def = settings.world(0.05f);
  for (float length : {1.2f, 2.0f}) {
    judge(result, "rope", hang_rope(def, length, 1));
    if (settings.resolution != Resolution::quick) judge(result, "strip of cloth", hang_strip(def, length));
  }
  return result;
}

Result chain_result(const Settings& settings) {
  constexpr double exact = 1.6684;  // s: 4π √(L/g)/2.4048
  const Curve end = swing_chain(settings.world(0.05f), settings.choose(20, 40, 80));
  Result result;
  result.about_zero("period over that of theory less 1", "%", 100 * (period_of(end) / exact - 1), 1,
                    Bar::target);
  Curve theory{"theory"};
  for (double t : end.x) theory.add(t, end.y.front() * std::cos(2 * M_PI * t / exact));
  result.plots = {{"End of a chain that hangs", "time (s)", "displacement (m)", {end, theory}}};
  return result;
}

}  // namespace

Case catenary() {
  return {
      "catenary", "Catenary of a rope and of a strip of cloth",
      "A rope of 40 unyielding segments hangs between two points 1 m apart for a minute, with one substep a "
      "frame. A strip of cloth of 40 squares does so in dense air, with 40 substeps.",
      "The catenary: sag .2923 m and 51.95° for a length of 1.2 m, .7964 m and 77.07° for 2 m.",
      catenary_result};
}

Case chain() {
  return {"chain", "Swing of a chain that hangs",
          "A rope of 1 m with unyielding segments hangs from one end. It starts at rest in the shape of its "
          "first "
          "mode, 2 cm wide.",
          "D. Bernoulli 1732: the shape is J₀(2.4048 √(z/L)), and the period 4π √(L/g)/2.4048 = 1.6684 s.",
          chain_result};
}

}  // namespace meniscus::validation
