// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#include "sdk/viewer/mouse.h"

#include <imgui.h>

namespace meniscus::viewer {

void Mouse::act(Canvas& canvas) {
  const ImGuiIO& io = ImGui::GetIO();
  Orbit* orbit = canvas.orbit();
  if (!orbit || io.WantCaptureMouse) return;
  const float x = io.MouseDelta.x / io.DisplaySize.y, y = io.MouseDelta.y / io.DisplaySize.y;
  const bool moves = io.MouseDelta.x != 0 || io.MouseDelta.y != 0;
  const bool shifts = io.MouseDown[ImGuiMouseButton_Right] || io.MouseDown[ImGuiMouseButton_Middle];
  if (shifts && moves)
    orbit->pan(x, y);
  else if (io.MouseDown[ImGuiMouseButton_Left] && moves)
    orbit->turn(x, y);
  if (io.MouseWheel != 0) orbit->zoom(io.MouseWheel);
  if (io.MouseWheel != 0 || (moves && (shifts || io.MouseDown[ImGuiMouseButton_Left]))) canvas.camera_moved();
}

}  // namespace meniscus::viewer
