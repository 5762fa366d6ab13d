// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The preview: a picture of a world that is rasterised on the CPU.
#pragma once

#include <meniscus/scene.h>
#include "sdk/io/cloth_frame.h"
#include "sdk/io/particle_frame.h"
#include "sdk/io/png.h"
#include "sdk/io/preview/media.h"

namespace meniscus::io {

/// The scene around the particles, and the view of it.
struct PreviewScene {
  /// Linear RGB, by ParticleFrame::fluids. A fluid beyond the end is water blue.
  std::vector<Vec3> fluid_colors;
  /// Of the same fluids, for the renderer; a fluid without one, or beyond the end, is shown by its colour.
  std::vector<std::optional<Medium>> media;
  std::size_t first_granular = ~std::size_t{0};  ///< index among these from which they are grains
  std::vector<Vec3> cloth_colors, rope_colors;   ///< linear RGB, in the order of the scene
  std::vector<ShapeDef> shapes;
  std::vector<BodyDef> bodies;
  Vec3 gravity{0, -9.81f, 0};         ///< m/s²; up is the opposite direction
  float particle_spacing = 0.05f;     ///< m
  std::optional<SceneCamera> camera;  ///< not set: a view that contains everything
  int width = 1280, height = 720;     ///< pixels
};

/// The scene's own settings. Fluids count in the order of its list.
PreviewScene preview_of(const Scene& scene);

/// Draws the particles as spheres, cloth and ropes among the solids, on the CPU. Fast fluid and spray are
/// whiter; grains are dull. The frame needs positions, velocities and fluids. Without density errors,
/// whiteness depends on speed alone. `states` are of the scene's bodies, in their order; without any, the
/// bodies are at their start. Equal input gives equal bytes. May throw what solid_triangles throws, and
/// Error(invalid_argument) if the number of states is neither 0 nor that of the bodies.
Image render_preview(const ParticleFrame& frame, const PreviewScene& scene,
                     std::span<const BodyState> states = {}, const ClothFrame& cloth = {},
                     const RopeFrame& ropes = {});

}  // namespace meniscus::io
