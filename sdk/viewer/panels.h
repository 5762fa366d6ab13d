// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "sdk/viewer/controls.h"
#include "sdk/viewer/snapshot.h"
#include "sdk/viewer/stage_history.h"

namespace meniscus::viewer {

/// What the panels tell of.
struct Shown {
  const Snapshot& snapshot;
  const StageHistory& history;
  std::span<const std::string> scenes;  ///< that can be opened, by name
  const std::string& scene;             ///< the name of the present one
  bool is_building = false;
  double paint_ms = 0;        ///< of the last picture
  const std::string& notice;  ///< what was done last, such as where a picture was written to
};

/// Dear ImGui's calls for all panels, in one frame.
void draw_panels(Controls& controls, const Shown& shown);

}  // namespace meniscus::viewer
