// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The requests of the user that panels and keys pass to the viewer.
#pragma once

#include <optional>
#include <string>

#include "sdk/render/frame/views.h"
#include "sdk/viewer/parameters.h"

namespace meniscus::viewer {

/// The requests of the user: panels and keys write them, and the viewer executes them.
struct Controls {
  // Values that hold until they change.
  Parameters parameters;
  render::ViewChoice view;
  std::optional<Liquid> liquid;  ///< how all fluids look; none: as the scene says
  double pace = 1;               ///< factor of real time; 0: as fast as possible
  bool panels = true;            ///< whether the panels are shown
  bool movie = false;            ///< whether steps go to a video

  // Requests that are executed once.
  std::optional<std::string> open;  ///< a scene, by name
  std::optional<bool> play;
  bool step = false, reset = false, frame_all = false, screenshot = false;
  bool parameters_changed = false;

  void clear_requests() {
    open.reset();
    play.reset();
    step = reset = frame_all = screenshot = parameters_changed = false;
  }
};

}  // namespace meniscus::viewer
