// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The viewer's panels.
#pragma once

#include <span>

#include "sdk/viewer/controls.h"
#include "sdk/viewer/snapshot.h"
#include "sdk/viewer/stage_history.h"

namespace meniscus::viewer {

/// The data that the panels show.
struct Shown {
  const Snapshot& snapshot;
  const StageHistory& history;
  std::span<const std::string> scenes;  ///< names of the scenes that can be opened
  const std::string& scene;             ///< the name of the present one
  bool is_building = false;
  double paint_ms = 0;        ///< time of the last picture
  const std::string& notice;  ///< the last action, such as the file of a screenshot
};

/// Calls Dear ImGui for all panels of one frame.
void draw_panels(Controls& controls, const Shown& shown);

}  // namespace meniscus::viewer
