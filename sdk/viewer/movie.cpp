// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Sends pictures of steps to a video.
#include "sdk/viewer/movie.h"

#include <meniscus/error.h>

namespace meniscus::viewer {

Movie::Movie(const std::filesystem::path& path, const io::Image& size, double step_time, uint64_t steps)
    : video_(path, size.width, size.height, 1 / step_time),
      width_(size.width),
      height_(size.height),
      steps_(steps) {}

void Movie::add(const io::Image& image, uint64_t steps) {
  if (image.width != width_ || image.height != height_)
    throw Error(ErrorCode::invalid_argument, "the size of the window has changed, which ends the video");
  for (; steps_ < steps; ++steps_) video_.add(image);
}

}  // namespace meniscus::viewer
