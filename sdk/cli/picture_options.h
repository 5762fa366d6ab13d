// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "sdk/io/preview.h"

namespace meniscus::cli {

struct PictureOptions {
  /// What OpenGL draws: `frames`, every one; `last`, preview.png alone; `auto`, the same where there is a
  /// device for it; empty: nothing, and preview.png comes from the rasteriser on the CPU.
  std::string render;
  std::string size;    ///< as in 1280x720, which it is where it is empty
  std::string camera;  ///< of Scene::cameras; empty: Scene::camera
};

/// The scene as it is to be looked at. Throws Error(invalid_argument) for a size that is none, or for a
/// camera that the scene does not have.
io::PreviewScene picture_scene(const Scene& scene, const PictureOptions& options);

}  // namespace meniscus::cli
