// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The geometry files of a run, frame by frame.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <meniscus/scene.h>
#include "sdk/cli/record/frame_sample.h"
#include "sdk/io/pvd.h"
#include "sdk/io/surface_frame.h"

namespace meniscus::cli {

/// Writes each frame's particles as FOLDER/frames/frame_00001.ply, .vtp or .obj. Frame 0 is the state before
/// the first step. Beside it are, if the scene
/// has any: spray, foam and bubbles as diffuse_00001, bodies as bodies_00001, cloth as cloth_00001, and ropes
/// as ropes_00001. A scene with cloth or ropes but no fluid has no particles to write. On request, the
/// surface of its fluids is surface_00001. With vtp, FOLDER/particles.pvd, diffuse.pvd, bodies.pvd,
/// cloth.pvd, ropes.pvd and surface.pvd list them.
class FrameExporter {
 public:
  /// `formats`: "ply", "vtp" and "obj"; empty writes nothing. Throws Error(io), and what BodySurfaces throws.
  FrameExporter(std::filesystem::path folder, const std::vector<std::string>& formats, bool surface,
                const Scene& scene);

  /// Throws Error(io) and Error(out_of_memory).
  void write(const FrameSample& sample);

 private:
  void write_all(const FrameSample& sample);
  /// Writes one kind of frame in all formats.
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
/// Makes the folder of the frames in a run's folder. Throws Error(io) if that is a symbolic link.
void make_frames_folder(const std::filesystem::path& folder);

}  // namespace meniscus::cli
