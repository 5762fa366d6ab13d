// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include "sdk/viewer/canvas.h"
#include "sdk/viewer/simulation.h"

namespace meniscus::viewer {

/// What the mouse does where no panel is under it. The left button takes hold of what is there, and where
/// nothing is turns the view; the right one shifts the view, and the wheel takes it nearer.
class Mouse {
 public:
  /// Within a frame of ImGui's.
  void act(Canvas& canvas, const Snapshot& snapshot, Simulation& simulation);
  /// The camera, in the last frame.
  bool has_steered() const { return has_steered_; }
  /// How often it has taken hold of something.
  int grabs() const { return grabs_; }

 private:
  void press(Orbit& orbit, const Picker& picker, const Snapshot& snapshot, Simulation& simulation);
  void move_grab(const Orbit& orbit, Simulation& simulation);
  void draw_grab(const Orbit& orbit, const Snapshot& snapshot) const;

  bool is_turning_ = false, has_steered_ = false;
  std::optional<Grab> grab_;
  BuildNumber build_ = 0;  // that the grab is of
  int grabs_ = 0;
};

}  // namespace meniscus::viewer
