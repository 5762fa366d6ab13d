// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sdk/io/vtp.h"

namespace meniscus::cli {

/// Writes each frame's particles as FOLDER/frames/frame_00001.ply or .vtp; with vtp, FOLDER/particles.pvd
/// lists them.
class FrameExporter {
 public:
  /// `formats`: of "ply" and "vtp", or empty for nothing. Throws Error(io).
  FrameExporter(std::filesystem::path folder, const std::vector<std::string>& formats);

  /// Throws Error(io).
  void write(int frame, const io::ParticleFrame& particles);

 private:
  std::filesystem::path folder_;
  bool ply_, vtp_;
  std::optional<io::PvdFile> collection_;
};

/// Makes a folder and those above it. Throws Error(io).
void make_folder(const std::filesystem::path& folder);

}  // namespace meniscus::cli
