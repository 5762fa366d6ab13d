// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Archimedes: the draft of a box, and the density at which bodies neither sink nor rise.
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "sdk/validation/cases/cases.h"
#include "sdk/validation/cases/floating_box.h"
#include "sdk/validation/parts.h"

namespace meniscus::validation {
namespace {

Result draft_result(const Settings& settings) {
  Result result;
  const int height = settings.choose(6, 12, 32);
  const std::vector<float> densities = settings.choose<std::vector<float>>({500}, {500}, {250, 500, 750});
  const Bar bar = settings.resolution == Resolution::quick ? Bar::target : Bar::hard;
  for (const float density : densities) {
    const DraftMeasure measure = measure_draft(settings.world(1), {density, 0.8f / float(height), height});
    const std::string name = ", " + std::to_string(std::lround(density)) + " kg/m³";
    result.about_zero("draft, error over the height" + name, "%", 100 * measure.error, 3, bar,
                      "The box is few spacings high.");
    result.at_most("tilt" + name, "°", measure.tilt, 1, bar);
    result.at_most("speed" + name, "m/s", measure.speed, 0.01, bar);
  }
  return result;
}

Result neutral_result(const Settings& settings) {
  const float size = 0.4f, r = 0.5f * size;
  const WorldDef def = settings.world(settings.choose(0.05f, 0.05f, 0.025f));
  std::vector<std::pair<std::string, Geometry>> bodies{{"ball", SphereGeometry{r}},
                                                       {"box", BoxGeometry{{r, r, r}}},
                                                       {"capsule", CapsuleGeometry{0.7f * r, 0.5f * r}}};
  if (settings.resolution == Resolution::quick) bodies.resize(1);
  Result result;
  for (const auto& [name, geometry] : bodies) {
    const float seconds = settings.choose(1.0f, 2.0f, 3.0f);
    const double light = rise(def, size, geometry, 980, seconds),
                 heavy = rise(def, size, geometry, 1020, seconds);
    result.within("neutral density, " + name, "kg/m³", 980 + 40 * light / (light - heavy), 980, 1020,
                  Bar::hard);
  }
  return result;
}

}  // namespace

Case draft() {
  return {
      "draft", "Draft of a floating box",
      "A box of 0.8 m height on a base of 1.2 × 1.2 m floats for 10 s in a tank with six spacings of water "
      "around it, with xsph at 50 1/s. The surface is measured relative to that of a pool without the box.",
      "Archimedes: the draft is the height times the ratio of densities.", draft_result};
}

Case neutral_density() {
  return {
      "neutral-density", "Neutral density of bodies",
      "Bodies 0.4 m in size are let go in mid water, with 980 and 1020 kg/m³. The neutral density is where "
      "the way would be 0 between the two.",
      "Archimedes: 1000 kg/m³.", neutral_result};
}

}  // namespace meniscus::validation
