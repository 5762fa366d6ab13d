// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sdk/cli/output/frame_renderer.h"
#include "sdk/io/contact_sheet.h"
#include "sdk/io/video.h"

namespace meniscus::cli {

/// What a run leaves to look at: FOLDER/preview.png always, and what OpenGL draws where that is asked for:
/// FOLDER/frames/render_00001.png, FOLDER/contact_sheet.png, and a video.
class FramePictures {
 public:
  /// Makes everything ready, but neither the folder nor anything in it. `first` is the state before the first
  /// frame. Throws what FrameRenderer and VideoFile throw.
  FramePictures(const PictureOptions& options, std::filesystem::path folder, const io::PreviewScene& picture,
                const Scene& scene, const World& world, const FrameSample& first);

  /// Throws Error(io), and Error(device) where OpenGL fails.
  void add(const World& world, const FrameSample& sample);
  /// Writes what remains; `last` is the state after the last frame. Throws likewise.
  void finish(const World& world, const FrameSample& last);

  /// What there is beside preview.png, as the summary of a run lists it.
  std::vector<std::string> files() const;

 private:
  std::filesystem::path folder_;
  io::PreviewScene picture_;
  bool each_frame_;  // as a file
  std::optional<FrameRenderer> renderer_;
  std::optional<io::ContactSheet> sheet_;
  std::optional<io::VideoFile> video_;
};

}  // namespace meniscus::cli
