// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "sdk/scene/scene.h"

namespace meniscus::viewer {

/// What the user has asked for; the panels and keys write it, and the viewer does it.
struct Controls {
  // What holds until it is changed.
  Scene scene;                     ///< with what was changed by hand
  bool scene_needs_reset = false;  ///< some of which the present world does not have
  double pace = 1;                 ///< times real time; 0: as fast as it can
  bool panels = true;              ///< are shown

  // What is done once.
  std::optional<std::string> open;  ///< a scene, by name
  std::optional<bool> play;
  bool step = false, reset = false, frame_all = false, screenshot = false;
  bool scene_changed = false;  ///< by what a running world can take over

  void clear_requests() {
    open.reset();
    play.reset();
    step = reset = frame_all = screenshot = scene_changed = false;
  }
};

}  // namespace meniscus::viewer
