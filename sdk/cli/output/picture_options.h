// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The options of the command line that concern pictures.
#pragma once

#include <string>
#include <vector>

#include "sdk/io/preview/preview.h"

namespace meniscus::cli {

struct PictureOptions {
  /// What OpenGL draws. `frames`: every frame, a contact sheet and preview.png. `last`: preview.png alone.
  /// `auto`: the sheet and preview.png, if there is a device. Empty: nothing; the rasteriser on the CPU makes
  /// preview.png.
  std::string render;
  std::string video;   ///< a file with every frame, whatever `render` is; empty: none
  std::string size;    ///< such as 1280x720, the default if it is empty
  std::string camera;  ///< one of Scene::cameras; empty: Scene::camera
  std::string filter;  ///< of the fluid's surface: narrow-range, bilateral, curvature-flow or none
  bool anisotropic = true;
  std::vector<std::string> views;  ///< measured quantities to show; see render::view_names

  int samples = 1;     ///< see render::StillSettings, as the two below
  float aperture = 0;  ///< m
  float shutter = 0;   ///< s
  bool caustics = false;

  bool any() const { return !render.empty() || !video.empty(); }
};

/// The scene with the picture options applied. Throws Error(invalid_argument) for an invalid size, and for a
/// camera that the scene does not have.
io::PreviewScene picture_scene(const Scene& scene, const PictureOptions& options);

/// One of the scene's named cameras. Throws Error(invalid_argument).
SceneCamera camera_named(const std::string& name, const Scene& scene);

}  // namespace meniscus::cli
