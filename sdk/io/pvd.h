// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// ParaView collections, which list frames with their times.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

namespace meniscus::io {

/// A ParaView collection: the frames of a run with their times. It is a valid file after every add().
class PvdFile {
 public:
  /// Throws Error(io).
  explicit PvdFile(std::filesystem::path path);

  /// `file` is relative to the collection's folder; `time` is in seconds. Throws Error(io).
  void add(double time, const std::filesystem::path& file);

 private:
  void write_and_close(const std::string& text);

  std::filesystem::path path_;
  std::ofstream stream_;
};

}  // namespace meniscus::io
