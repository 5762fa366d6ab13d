// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include "sdk/viewer/canvas.h"

namespace meniscus::viewer {

/// What the mouse does where no panel is under it: the left button turns the view, the right one shifts it,
/// and the wheel takes it nearer.
class Mouse {
 public:
  /// Within a frame of ImGui's.
  void act(Canvas& canvas);
};

}  // namespace meniscus::viewer
