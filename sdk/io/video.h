// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// MP4 files, encoded by ffmpeg.
#pragma once

#include <sys/types.h>

#include <cstdio>
#include <filesystem>

#include "sdk/io/png.h"

namespace meniscus::io {

/// An MP4 file that the program ffmpeg encodes from pictures, one by one.
class VideoFile {
 public:
  /// Starts ffmpeg. `rate`: frames per second. Throws Error(invalid_argument) if the name does not end in
  /// .mp4, and Error(io) if the file cannot be made or there is no ffmpeg.
  VideoFile(std::filesystem::path path, int width, int height, double rate);
  /// Without a commit, no file remains.
  ~VideoFile();
  VideoFile(const VideoFile&) = delete;
  VideoFile& operator=(const VideoFile&) = delete;

  /// Adds a picture of the width and height above. Throws Error(io) with ffmpeg's own message if it fails.
  void add(const Image& image);
  /// Throws Error(io), likewise; a file of that name is then unchanged.
  void commit();

  const std::filesystem::path& path() const { return path_; }

 private:
  void start(int width, int height, double rate);
  int finish();  ///< the exit code of ffmpeg
  [[noreturn]] void fail();

  std::filesystem::path path_, part_;
  std::FILE* words_ = nullptr;  // output of ffmpeg
  int to_ffmpeg_ = -1;
  bool failed_ = false;
  pid_t process_ = -1;
};

}  // namespace meniscus::io
