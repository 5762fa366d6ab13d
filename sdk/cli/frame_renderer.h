// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <meniscus/world.h>

#include <filesystem>
#include <memory>

#include "sdk/cli/frame_sample.h"
#include "sdk/io/preview.h"

namespace meniscus::cli {

/// Draws frames by OpenGL, without a screen.
class FrameRenderer {
 public:
  /// `first` is the state before the first frame. Throws Error(device) that says what is missing, where the
  /// renderer was not built or finds no device, and what render::Renderer throws.
  FrameRenderer(std::filesystem::path folder, const io::PreviewScene& scene, const World& world,
                const FrameSample& first);
  ~FrameRenderer();

  io::Image draw(const World& world, const FrameSample& sample);
  /// As FOLDER/frames/render_00001.png. Throws Error(io).
  void write(const World& world, const FrameSample& sample);

 private:
  struct Parts;
  std::filesystem::path folder_;
  std::unique_ptr<Parts> parts_;
};

}  // namespace meniscus::cli
