// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The picture of the world behind the viewer's panels.
#pragma once

#include <memory>
#include <optional>

#include "sdk/viewer/draft.h"
#include "sdk/viewer/picking.h"

namespace meniscus::viewer {

/// The picture behind the panels. It is redrawn when the world, the camera or the size has changed.
class Canvas {
 public:
  /// Shows a world that has been built. Throws what render::Renderer throws.
  void show(const Snapshot& snapshot);
  /// Shows all fluids as this liquid; none: as the scene says.
  void set_liquid(std::optional<Liquid> liquid);
  /// Draws into the window of this size in pixels. It is coarser while things are `moving`, if it would take
  /// too long.
  void draw(int width, int height, bool moving);
  /// The picture at full resolution.
  io::Image image();

  /// The camera, which callers may turn; null before there is a world.
  Orbit* orbit() { return orbit_ ? &*orbit_ : nullptr; }
  /// Finds what is under the mouse; null before there is a world.
  const Picker* picker() const { return picker_ ? &*picker_ : nullptr; }
  /// Call it after the camera has moved.
  void camera_moved() { is_painted_ = false; }
  /// Returns the camera to its start.
  void see_all();
  /// The next world uses its own camera, not the present one.
  void forget_camera() { orbit_.reset(); }
  /// The box around the scene, as the renderer computes it.
  std::optional<Aabb> box() const;
  double paint_ms() const { return paint_ms_; }

 private:
  void paint(float share);
  void apply_liquid();

  std::unique_ptr<render::Renderer> renderer_;
  std::shared_ptr<const Scene> scene_;
  std::optional<Liquid> liquid_;
  std::optional<Orbit> orbit_;
  std::optional<Picker> picker_;
  SceneCamera home_;
  Vec3 up_{0, 1, 0};
  BuildNumber build_ = 0;
  int width_ = 0, height_ = 0;
  bool is_painted_ = false, was_draft_ = false;
  Draft draft_;
  double paint_ms_ = 0;
};

}  // namespace meniscus::viewer
