// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sdk/cli/record/frame_sample.h"
#include "sdk/io/pvd.h"
#include "sdk/io/surface_frame.h"
#include "sdk/scene/scene.h"

namespace meniscus::cli {

/// Writes each frame's particles as FOLDER/frames/frame_00001.ply, .vtp or .obj, and beside it, where the
/// scene has any, its spray, foam and bubbles as diffuse_00001, its bodies as bodies_00001, its cloth as
/// cloth_00001 and its ropes as ropes_00001. A scene with cloth or ropes but no fluid has no particles to
/// write. Where it is asked for, the surface of its fluids is surface_00001. With vtp, FOLDER/particles.pvd,
/// diffuse.pvd, bodies.pvd, cloth.pvd, ropes.pvd and surface.pvd list them.
class FrameExporter {
 public:
  /// `formats`: of "ply", "vtp" and "obj", or empty for nothing. Throws Error(io), and what BodySurfaces
  /// throws.
  FrameExporter(std::filesystem::path folder, const std::vector<std::string>& formats, bool surface,
                const Scene& scene);

  /// Throws Error(io).
  void write(const FrameSample& sample);

 private:
  /// One kind of thing in all formats.
  template <class Frame>
  void write_files(const char* prefix, int frame, const Frame& contents,
                   std::optional<io::PvdFile>& collection) const;

  std::filesystem::path folder_;
  bool ply_, vtp_, obj_;
  bool particles_, diffuse_, cloth_, ropes_, surface_;  // whether there are any
  std::optional<io::BodySurfaces> bodies_;
  std::optional<io::PvdFile> particle_collection_, body_collection_, cloth_collection_, rope_collection_,
      surface_collection_, diffuse_collection_;
};

/// Makes a folder and those above it. Throws Error(io).
void make_folder(const std::filesystem::path& folder);

}  // namespace meniscus::cli
