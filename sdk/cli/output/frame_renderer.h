// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <meniscus/world.h>

#include <memory>

#include "sdk/cli/output/picture_options.h"
#include "sdk/cli/record/frame_sample.h"

namespace meniscus::cli {

/// Draws frames by OpenGL, without a screen.
class FrameRenderer {
 public:
  /// `first` is the state before the first frame. Throws Error(device) that says what is missing, where the
  /// renderer was not built or finds no device, and what render::Renderer and view_choice throw.
  FrameRenderer(const io::PreviewScene& scene, const PictureOptions& options, const World& world,
                const FrameSample& first);
  ~FrameRenderer();

  io::Image draw(const World& world, const FrameSample& sample);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace meniscus::cli
