// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "sdk/render/frame/views.h"
#include "sdk/viewer/parameters.h"

namespace meniscus::viewer {

/// What the user has asked for; the panels and keys write it, and the viewer does it.
struct Controls {
  // What holds until it is changed.
  Parameters parameters;
  render::ViewChoice view;
  double pace = 1;     ///< times real time; 0: as fast as it can
  bool panels = true;  ///< are shown

  // What is done once.
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
