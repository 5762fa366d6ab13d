// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <sys/types.h>

#include <cstdio>
#include <filesystem>

#include "sdk/io/png.h"

namespace meniscus::io {

/// An MP4 file, written by the program ffmpeg from pictures that it is given one by one.
class VideoFile {
 public:
  /// Starts ffmpeg. `rate`: frames a second. Throws Error(invalid_argument) for a name that does not end in
  /// .mp4; Error(io) where the file cannot be made, or there is no ffmpeg.
  VideoFile(std::filesystem::path path, int width, int height, double rate);
  /// Without a commit, nothing stays.
  ~VideoFile();
  VideoFile(const VideoFile&) = delete;
  VideoFile& operator=(const VideoFile&) = delete;

  /// Of the width and height above. Throws Error(io) with ffmpeg's own words where it fails.
  void add(const Image& image);
  /// Throws Error(io), likewise; a file of that name is then as it was.
  void commit();

  const std::filesystem::path& path() const { return path_; }

 private:
  void start(int width, int height, double rate);
  int finish();  ///< what ffmpeg exited with
  [[noreturn]] void fail();

  std::filesystem::path path_, part_;
  std::FILE* words_ = nullptr;  // what ffmpeg says
  int to_ffmpeg_ = -1;
  bool failed_ = false;
  pid_t process_ = -1;
};

}  // namespace meniscus::io
