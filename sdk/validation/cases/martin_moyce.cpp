// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The collapse of a column of water, against the experiment of Martin & Moyce (1952).
#include <cmath>
#include <string>

#include "sdk/validation/cases/cases.h"
#include "sdk/validation/cases/dam_column.h"
#include "sdk/validation/curves.h"

namespace meniscus::validation {
namespace {

/// For each resolution two spacings: so many particles over the width of the column.
Result result_of(const Settings& settings) {
  Result result;
  Plot front{"Front on the floor", "T = t √(2g/a)", "front over a", {}};
  Plot height{"Height at the wall", "T = t √(2g/a)", "height over that at the start", {}};
  for (const bool fine : {false, true}) {
    const int across = settings.choose(10, 20, 80) * (fine ? 2 : 1);
    DamMotion motion = collapse({column_world(settings, 1, across), 1, 10}, 9);
    const std::string name = "a/s = " + std::to_string(across);
    const double shift = best_shift(motion.front, martin_moyce_front(), 0.5);
    const double front_error = 100 * rms_relative_error(motion.front, martin_moyce_front());
    const char* early =
        "Nearly all of it is one shift in time. The simulated gate vanishes at once, and that of the "
        "experiment "
        "did not.";
    result.at_most("front, RMS, " + name, "%", front_error, 10, Bar::target, early);
    result.at_most("front, RMS, " + name, "%", front_error, 5, Bar::target, early);
    result.tell("best shift of T, " + name, "", shift);
    result.at_most("front, RMS with that shift, " + name, "%",
                   100 * rms_relative_error(motion.front, martin_moyce_front(), shift), 5, Bar::hard);
    const double height_error = 100 * rms_relative_error(motion.height, martin_moyce_height());
    const char* late =
        "The last reading is a sixth of the start's height, where the water is few particles deep.";
    result.at_most("height at the wall, RMS, " + name, "%", height_error, 10, Bar::hard, late);
    result.at_most("height at the wall, RMS, " + name, "%", height_error, 5, Bar::target, late);
    motion.front.name = motion.height.name = name;
    front.curves.push_back(motion.front);
    height.curves.push_back(motion.height);
  }
  front.curves.push_back(martin_moyce_front());
  height.curves.push_back(martin_moyce_height());
  result.plots = {front, height};
  return result;
}

}  // namespace

Case martin_moyce() {
  return {
      "martin-moyce", "Collapse of a column of water: Martin & Moyce",
      "A column of water a wide and 2a high collapses in a channel 0.4a wide with smooth walls, at two "
      "spacings s. The front is the 99th percentile of x within a support radius of the floor. The height "
      "is that of y within a support radius of the wall. Only ratios count, so a is 1 m. A step "
      "of 16 ms has a substep for each five spacings in a, and at least 4. At full resolution the density is "
      "solved on the pressure grid before its ten iterations.",
      "J. C. Martin & W. J. Moyce, An experimental study of the collapse of liquid columns on a rigid "
      "horizontal plane, Phil. Trans. R. Soc. A 244 (1952), n² = 2, a = 2.25 in. No time is shifted, as "
      "the release of their gate is not known: the best shift is told apart.",
      result_of};
}

}  // namespace meniscus::validation
