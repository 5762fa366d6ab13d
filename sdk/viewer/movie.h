// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A video of what the window shows.
#pragma once

#include "sdk/io/video.h"

namespace meniscus::viewer {

/// A video with one picture for each step. It lasts as long as the steps that it shows.
class Movie {
 public:
  /// Throws what VideoFile throws. `step_time`: s.
  Movie(const std::filesystem::path& path, const io::Image& size, double step_time, uint64_t steps);

  /// Adds the picture after so many steps: again for each step that no picture was of, but not the same step
  /// twice. Throws Error(invalid_argument) if the size is another, and what VideoFile::add throws.
  void add(const io::Image& image, uint64_t steps);
  /// Without this call no file remains.
  void end() { video_.commit(); }

  const std::filesystem::path& path() const { return video_.path(); }

 private:
  io::VideoFile video_;
  int width_, height_;
  uint64_t steps_;
};

}  // namespace meniscus::viewer
