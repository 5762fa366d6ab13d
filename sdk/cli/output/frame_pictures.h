// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The pictures and the video of a run.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sdk/cli/output/frame_renderer.h"
#include "sdk/io/contact_sheet.h"
#include "sdk/io/video.h"

namespace meniscus::cli {

/// The pictures of a run: FOLDER/preview.png always, and on request what OpenGL draws:
/// FOLDER/frames/render_00001.png, FOLDER/contact_sheet.png, and a video.
class FramePictures {
 public:
  /// Prepares everything, but makes neither the folder nor any file in it. `first` is the state before the
  /// first frame. Throws what FrameRenderer and VideoFile throw.
  FramePictures(const PictureOptions& options, std::filesystem::path folder, const io::PreviewScene& picture,
                const Scene& scene, const World& world, const FrameSample& first);

  /// Throws Error(io), and Error(device) if OpenGL fails.
  void add(const World& world, const FrameSample& sample);
  /// Writes the remaining files; `last` is the state after the last frame. Throws likewise.
  void finish(const World& world, const FrameSample& last);

  /// The files beside preview.png, as the summary of a run lists them.
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
