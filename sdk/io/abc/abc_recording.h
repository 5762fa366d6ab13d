// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A run as an Alembic file, frame by frame. Optional: built where Alembic is found.
#pragma once

#include <meniscus/scene.h>

#include <filesystem>
#include <memory>

#include "sdk/io/scene_frame.h"
#include "sdk/io/surface_frame.h"

namespace meniscus::io {

/// Throws Error(invalid_argument) if Meniscus was built without Alembic. It names what was missing.
void require_abc();

/// Writes an archive (Ogawa) whose objects have a sample a frame: positions, velocities (units a second),
/// normals, texture coordinates, and the poses of bodies. Objects have the names of the USD stage, as
/// /scene/cloth/NAME. Alembic is y up: where gravity points along −z, /scene has the rotation to that.
/// Polygons are clockwise as seen from outside, which is Alembic's order. The file appears when it is
/// complete.
class AbcRecording {
 public:
  /// `first` is the first frame, which gives the archive its start. Throws Error(io), and what require_abc
  /// throws.
  AbcRecording(const std::filesystem::path& path, const Scene& scene, const ExportContents& contents,
               const BodySurfaces* bodies, const SceneFrame& first);
  ~AbcRecording();
  AbcRecording(const AbcRecording&) = delete;
  AbcRecording& operator=(const AbcRecording&) = delete;

  /// Adds a frame, whose number is one more than that of the last. Throws Error(io).
  void add(const SceneFrame& frame);
  /// Writes the end. Throws Error(io).
  void finish();

 private:
  struct Archive;
  std::unique_ptr<Archive> archive_;
};

}  // namespace meniscus::io
