// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The geometry files of a run, frame by frame.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <meniscus/scene.h>
#include "sdk/cli/output/background.h"
#include "sdk/cli/record/frame_sample.h"
#include "sdk/io/abc/abc_recording.h"
#include "sdk/io/pvd.h"
#include "sdk/io/scene_frame.h"
#include "sdk/io/surface_frame.h"
#include "sdk/io/usd/usd_recording.h"
#include "sdk/io/usd/usd_scene.h"

namespace meniscus::cli {

/// Writes each frame's particles as FOLDER/frames/frame_00001.ply, .vtp or .obj. Frame 0 is the state before
/// the first step. Beside it are, if the scene
/// has any: spray, foam and bubbles as diffuse_00001, bodies as bodies_00001, cloth as cloth_00001, and ropes
/// as ropes_00001. A scene with cloth or ropes but no fluid has no particles to write. On request, the
/// surface of its fluids is surface_00001. Fixed shapes are FOLDER/frames/shapes.ply, .vtp or .obj. With vtp,
/// FOLDER/particles.pvd, diffuse.pvd, bodies.pvd, cloth.pvd, ropes.pvd and surface.pvd list the frames. With
/// usd, FOLDER/scene.usda has all of it, and with abc FOLDER/scene.abc. With vdb, liquids are
/// liquid_00001.vdb.
///
/// Files are written on a thread of their own, in the order of the frames. At most three frames wait or are
/// being written; then the run waits.
class FrameExporter {
 public:
  /// `formats`: "ply", "vtp", "obj", "usd", "abc" and "vdb"; empty writes nothing. Throws Error(io), and
  /// what BodySurfaces throws.
  /// `ranks`: those of a shared world, 0 without. Each writes its particles with vtp (rank_frames.h).
  FrameExporter(std::filesystem::path folder, const std::vector<std::string>& formats, bool surface,
                const Scene& scene, int ranks = 0);

  /// Takes a frame to write; of the sample it takes the liquid away. Throws Error(io) and
  /// Error(out_of_memory), also for earlier frames.
  void write(FrameSample& sample);
  /// Waits until all is written. Throws likewise.
  void finish();

 private:
  static constexpr std::size_t most_waiting = 3;  // two that wait let a slow disk catch up

  void write_all(const io::SceneFrame& frame);
  void write_shapes() const;
  /// Points of which each rank writes its own to vtp.
  template <class Frame>
  void write_parted(const char* prefix, int frame, const Frame& contents,
                    std::optional<io::PvdFile>& collection) const;
  void write_usd(const io::SceneFrame& frame);
  void write_abc(const io::SceneFrame& frame);
  io::ExportContents contents() const {
    return {.particles = particles_, .surface = surface_, .diffuse = diffuse_};
  }
  /// Writes one kind of frame in all formats of meshes and points.
  template <class Frame>
  void write_files(const char* prefix, int frame, const Frame& contents,
                   std::optional<io::PvdFile>& collection) const;

  std::filesystem::path folder_;
  Scene scene_;
  int ranks_;
  bool ply_, vtp_, obj_, usd_, abc_, vdb_;
  bool any_;                                            // whether there is any format
  bool particles_, diffuse_, cloth_, ropes_, surface_;  // whether there are any
  bool shapes_written_ = false;
  std::optional<io::BodySurfaces> bodies_;
  std::optional<io::PvdFile> particle_collection_, body_collection_, cloth_collection_, rope_collection_,
      surface_collection_, diffuse_collection_;
  std::optional<io::UsdScene> usd_scene_;
  std::optional<io::UsdRecording> usd_recording_;
  std::optional<io::AbcRecording> abc_recording_;
  std::array<io::SceneFrame, most_waiting> frames_;  // used in turn
  std::size_t next_ = 0;
  Background background_{most_waiting};  // last: its thread uses all of the above
};

/// Makes a folder and those above it. Throws Error(io).
void make_folder(const std::filesystem::path& folder);
/// Makes the folder of the frames in a run's folder. Throws Error(io) if that is a symbolic link.
void make_frames_folder(const std::filesystem::path& folder);

}  // namespace meniscus::cli
