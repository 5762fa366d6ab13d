// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>

#include "sdk/viewer/orbit.h"
#include "sdk/viewer/snapshot.h"

namespace meniscus::viewer {

/// The picture behind the panels: draws anew where the world, the camera or the size has changed.
class Canvas {
 public:
  /// Of a world that has been built. Throws what render::Renderer throws.
  void show(const Snapshot& snapshot);
  /// Into the window, which is so large in pixels.
  void draw(int width, int height);
  io::Image image() const;

  /// The camera, to be turned; null before there is something to see.
  Orbit* orbit() { return orbit_ ? &*orbit_ : nullptr; }
  /// After it was turned.
  void camera_moved() { is_painted_ = false; }
  /// Back to where the camera started.
  void see_all();
  /// The next world's own camera is taken, rather than the present one.
  void forget_camera() { orbit_.reset(); }
  double paint_ms() const { return paint_ms_; }

 private:
  std::unique_ptr<render::Renderer> renderer_;
  std::optional<Orbit> orbit_;
  SceneCamera home_;
  Vec3 up_{0, 1, 0};
  BuildNumber build_ = 0;
  int width_ = 0, height_ = 0;
  bool is_painted_ = false;
  double paint_ms_ = 0;
};

}  // namespace meniscus::viewer
