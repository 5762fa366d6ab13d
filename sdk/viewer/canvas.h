// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>

#include "sdk/viewer/draft.h"
#include "sdk/viewer/picking.h"

namespace meniscus::viewer {

/// The picture behind the panels: draws anew where the world, the camera or the size has changed.
class Canvas {
 public:
  /// Of a world that has been built. Throws what render::Renderer throws.
  void show(const Snapshot& snapshot);
  /// Into the window, which is so large in pixels; coarser where it would take too long while things are
  /// `moving`.
  void draw(int width, int height, bool moving);
  /// With all pixels.
  io::Image image();

  /// The camera, to be turned; null before there is something to see.
  Orbit* orbit() { return orbit_ ? &*orbit_ : nullptr; }
  /// Finds what is under the mouse; likewise.
  const Picker* picker() const { return picker_ ? &*picker_ : nullptr; }
  /// After it was turned.
  void camera_moved() { is_painted_ = false; }
  /// Back to where the camera started.
  void see_all();
  /// The next world's own camera is taken, rather than the present one.
  void forget_camera() { orbit_.reset(); }
  /// Around the scene, as the renderer sees it.
  std::optional<Aabb> box() const;
  double paint_ms() const { return paint_ms_; }

 private:
  void paint(float share);

  std::unique_ptr<render::Renderer> renderer_;
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
