// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The mouse, outside of the panels.
#pragma once

#include "sdk/viewer/canvas.h"
#include "sdk/viewer/simulation.h"

namespace meniscus::viewer {

/// Mouse input outside of the panels. The left button grabs the object under it; on empty space it turns the
/// view. The right button shifts the view, and the wheel zooms.
class Mouse {
 public:
  /// Call it within a frame of ImGui.
  void act(Canvas& canvas, const Snapshot& snapshot, Simulation& simulation);
  /// Whether the camera moved in the last frame.
  bool has_steered() const { return has_steered_; }
  /// The number of grabs so far.
  int grabs() const { return grabs_; }

 private:
  void press(Orbit& orbit, const Picker& picker, const Snapshot& snapshot, Simulation& simulation);
  void move_grab(const Orbit& orbit, Simulation& simulation);
  void draw_grab(const Orbit& orbit, const Snapshot& snapshot) const;

  bool is_turning_ = false, has_steered_ = false;
  std::optional<Grab> grab_;
  BuildNumber build_ = 0;  // build to which the grab belongs
  int grabs_ = 0;
};

}  // namespace meniscus::viewer
