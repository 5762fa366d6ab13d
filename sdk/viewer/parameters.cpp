// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Keeps the changes to a scene's document.
#include "sdk/viewer/parameters.h"

#include <imgui.h>

#include <algorithm>
#include <array>

#include "sdk/scene/scene_file.h"
#include "sdk/viewer/parameter_fields.h"

namespace meniscus::viewer {
namespace {

bool starts_with(const std::string& text, std::string_view start) {
  return text.compare(0, start.size(), start) == 0;
}

}  // namespace

bool changes_at_once(const std::string& path) {
  static constexpr std::array all_of = {"world.density", "world.rigid", "world.cloth", "wind"};
  static constexpr std::array these = {"frame_time",        "world.gravity",    "world.substeps",
                                       "world.iterations",  "world.cfl_number", "world.min_substeps",
                                       "world.max_substeps"};
  static constexpr std::array of_fluids = {"].dynamic_viscosity", "].xsph", "].vorticity_confinement",
                                           "].cohesion", "].surface_tension"};
  const auto is_below = [&](const char* key) { return starts_with(path, key); };
  const auto ends = [&](std::string_view key) {
    return path.size() > key.size() && path.compare(path.size() - key.size(), key.size(), key) == 0;
  };
  return std::any_of(all_of.begin(), all_of.end(), is_below) ||
         std::any_of(these.begin(), these.end(), [&](const char* key) { return is_below(key); }) ||
         (starts_with(path, "fluids[") && std::any_of(of_fluids.begin(), of_fluids.end(), ends));
}

Parameters::Parameters() : schema_(nlohmann::ordered_json::parse(scene_schema())) {}

void Parameters::open(nlohmann::json document) {
  document_ = std::move(document);
  changes_.clear();
  needs_reset_ = false;
}

bool Parameters::draw() {
  ParameterFields fields(changes_at_once);
  fields.draw_object(schema_, document_, "");
  for (const auto& [path, value] : fields.changes()) {
    changes_[path] = value.dump();
    needs_reset_ |= !changes_at_once(path);
  }
  return !fields.changes().empty();
}

std::string Parameters::as_options() const {
  std::string options;
  for (const auto& [path, value] : changes_) {
    if (!options.empty()) options += ' ';
    options.append("--set '").append(path).append("=").append(value).append("'");
  }
  return options;
}

}  // namespace meniscus::viewer
