// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include "sdk/io/cloth_frame.h"
#include "sdk/io/particle_frame.h"
#include "sdk/io/png.h"
#include "sdk/scene/scene.h"

namespace meniscus::io {

/// What stands around the particles, and how to look at them.
struct PreviewScene {
  std::vector<Vec3>
      fluid_colors;  ///< linear RGB, by ParticleFrame::fluids; a fluid beyond the end is water blue
  std::size_t first_granular = ~std::size_t{0};  ///< among these: from here on they are of grains
  std::vector<Vec3> cloth_colors, rope_colors;   ///< likewise, by their order in the scene
  std::vector<ShapeDef> shapes;
  std::vector<BodyDef> bodies;
  Vec3 gravity{0, -9.81f, 0};         ///< m/s²; up is the other way
  float particle_spacing = 0.05f;     ///< m
  std::optional<SceneCamera> camera;  ///< left out: a view that holds everything
  int width = 1280, height = 720;     ///< pixels
};

/// The scene's own settings; the particles' fluids count in the order of its list.
PreviewScene preview_of(const Scene& scene);

/// Draws the particles as spheres, cloth and ropes among the solids, on the CPU. Fast fluid and spray are
/// whiter, grains are dull. Needs positions, velocities and fluids of the frame, and without its density
/// errors knows fast from slow alone. `states` are of the scene's bodies, in their order; without any, the
/// bodies are where they start. Equal input gives equal bytes. May throw what solid_triangles throws, and
/// Error(invalid_argument) where there are states, but not one a body.
Image render_preview(const ParticleFrame& frame, const PreviewScene& scene,
                     std::span<const BodyState> states = {}, const ClothFrame& cloth = {},
                     const RopeFrame& ropes = {});

}  // namespace meniscus::io
