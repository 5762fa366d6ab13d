// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sdk/io/particle_frame.h"
#include "sdk/io/pvd.h"
#include "sdk/io/surface_frame.h"

namespace meniscus::cli {

/// Writes each frame's particles as FOLDER/frames/frame_00001.ply, .vtp or .obj, and its bodies, where the
/// scene has any, as bodies_00001 beside it. With vtp, FOLDER/particles.pvd and bodies.pvd list them.
class FrameExporter {
 public:
  /// `formats`: of "ply", "vtp" and "obj", or empty for nothing. Throws Error(io), and what BodySurfaces
  /// throws.
  FrameExporter(std::filesystem::path folder, const std::vector<std::string>& formats,
                const std::vector<BodyDef>& bodies);

  /// `states` in the order of the bodies. Throws Error(io).
  void write(int frame, const io::ParticleFrame& particles, std::span<const BodyState> states);

 private:
  /// One kind of thing in all formats.
  template <class Frame>
  void write_files(const char* prefix, int frame, const Frame& contents,
                   std::optional<io::PvdFile>& collection);

  std::filesystem::path folder_;
  bool ply_, vtp_, obj_;
  std::optional<io::BodySurfaces> bodies_;
  std::optional<io::PvdFile> particle_collection_, body_collection_;
};

/// Makes a folder and those above it. Throws Error(io).
void make_folder(const std::filesystem::path& folder);

}  // namespace meniscus::cli
