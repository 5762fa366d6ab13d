// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "sdk/io/preview/preview.h"

namespace meniscus::cli {

struct PictureOptions {
  /// What OpenGL draws: `frames`, every one, a contact sheet and preview.png; `last`, preview.png alone;
  /// `auto`, the sheet and preview.png where there is a device for it; empty: nothing, and preview.png comes
  /// from the rasteriser on the CPU.
  std::string render;
  std::string video;   ///< a file for every frame, whatever `render` is; empty: none
  std::string size;    ///< as in 1280x720, which it is where it is empty
  std::string camera;  ///< of Scene::cameras; empty: Scene::camera
  std::string filter;  ///< of the fluid's surface: narrow-range, bilateral, curvature-flow or none
  bool anisotropic = true;
  std::vector<std::string> views;  ///< what is shown of what is measured; see render::view_names

  bool any() const { return !render.empty() || !video.empty(); }
};

/// The scene as it is to be looked at. Throws Error(invalid_argument) for a size that is none, for a camera
/// that the scene does not have, and for a look of fluid that OpenGL is not asked to draw.
io::PreviewScene picture_scene(const Scene& scene, const PictureOptions& options);

/// One of the scene's named cameras. Throws Error(invalid_argument).
SceneCamera camera_named(const std::string& name, const Scene& scene);

}  // namespace meniscus::cli
