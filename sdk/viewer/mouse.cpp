// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Turns mouse input into camera moves and grabs.
#include "sdk/viewer/mouse.h"

#include <imgui.h>

namespace meniscus::viewer {
namespace {

float aspect() {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  return size.x / size.y;
}

Ray ray_under_mouse(const Orbit& orbit) {
  const ImGuiIO& io = ImGui::GetIO();
  return orbit.ray_through(io.MousePos.x / io.DisplaySize.x, io.MousePos.y / io.DisplaySize.y, aspect());
}

/// Turns, shifts and zooms; returns whether it did.
bool steer(Orbit& orbit, bool turns) {
  const ImGuiIO& io = ImGui::GetIO();
  const float x = io.MouseDelta.x / io.DisplaySize.y, y = io.MouseDelta.y / io.DisplaySize.y;
  const bool shifts = io.MouseDown[ImGuiMouseButton_Right] || io.MouseDown[ImGuiMouseButton_Middle];
  const bool moves = (x != 0 || y != 0) && (shifts || turns);
  if (moves && shifts) orbit.pan(x, y);
  if (moves && !shifts) orbit.turn(x, y);
  if (io.MouseWheel != 0) orbit.zoom(io.MouseWheel);
  return moves || io.MouseWheel != 0;
}

}  // namespace

void Mouse::act(Canvas& canvas, const Snapshot& snapshot, Simulation& simulation) {
  const ImGuiIO& io = ImGui::GetIO();
  Orbit* orbit = canvas.orbit();
  has_steered_ = false;
  if (!orbit) return;
  if (build_ != snapshot.build) grab_.reset();
  if (!io.MouseDown[ImGuiMouseButton_Left]) {
    is_turning_ = false;
    if (grab_) simulation.hold({});
    grab_.reset();
  }
  if (!io.WantCaptureMouse) {
    if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) press(*orbit, *canvas.picker(), snapshot, simulation);
    has_steered_ = steer(*orbit, is_turning_);
    if (has_steered_) canvas.camera_moved();
  }
  if (!grab_) return;
  move_grab(*orbit, simulation);
  draw_grab(*orbit, snapshot);
}

void Mouse::press(Orbit& orbit, const Picker& picker, const Snapshot& snapshot, Simulation& simulation) {
  grab_ = picker.pick(ray_under_mouse(orbit), snapshot);
  build_ = snapshot.build;
  is_turning_ = !grab_;
  if (!grab_) return;
  ++grabs_;
  simulation.hold(grab_);
}

/// Moves the target across the line of sight, at the depth of the grab.
void Mouse::move_grab(const Orbit& orbit, Simulation& simulation) {
  const Ray ray = ray_under_mouse(orbit);
  const Vec3 ahead = orbit.forward();
  const float along = dot(grab_->target - ray.from, ahead) / dot(ray.direction, ahead);
  const Vec3 target = ray.from + along * ray.direction;
  if (target == grab_->target) return;
  grab_->target = target;
  simulation.hold(grab_);
}

void Mouse::draw_grab(const Orbit& orbit, const Snapshot& snapshot) const {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  const auto seen = [&](Vec3 p) {
    const Vec3 at = orbit.project(p, aspect());
    return ImVec2{at.x * size.x, at.y * size.y};
  };
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const ImVec2 target = seen(grab_->target), held = seen(snapshot.held.value_or(grab_->target));
  const float em = ImGui::GetFontSize();
  list.AddLine(held, target, IM_COL32(255, 255, 255, 200), 0.12f * em);
  list.AddCircleFilled(held, 0.3f * em, IM_COL32(255, 190, 60, 255));
  list.AddCircle(target, 0.45f * em, IM_COL32(255, 255, 255, 230), 0, 0.12f * em);
}

}  // namespace meniscus::viewer
