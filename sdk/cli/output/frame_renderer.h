// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The OpenGL renderer as the command line uses it.
#pragma once

#include <meniscus/world.h>

#include <array>
#include <memory>
#include <vector>

#include "sdk/cli/output/picture_options.h"
#include "sdk/cli/record/frame_sample.h"

namespace meniscus::cli {

/// Draws frames with OpenGL, without a screen.
class FrameRenderer {
 public:
  /// `first` is the state before the first frame. Throws Error(device) that names what is missing, if the
  /// renderer was not built or finds no device. Throws what render::Renderer and view_choice throw.
  FrameRenderer(const io::PreviewScene& scene, const PictureOptions& options, const World& world,
                const FrameSample& first);
  ~FrameRenderer();

  io::Image draw(const World& world, const FrameSample& sample);
  /// Of the last picture: see render::Renderer::fluid_normals.
  std::vector<std::array<float, 4>> fluid_normals();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace meniscus::cli
