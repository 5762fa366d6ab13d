// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The camera, light and ground that stay the same from frame to frame.
#pragma once

#include "sdk/io/preview/preview.h"
#include "sdk/render/frame/uniforms.h"

namespace meniscus::render {

/// A box around the whole scene except planes, which are infinite.
struct Bounds {
  Vec3 lower{1e30f, 1e30f, 1e30f}, upper{-1e30f, -1e30f, -1e30f};

  void add(Vec3 p) {
    lower = min(lower, p);
    upper = max(upper, p);
  }
  bool empty() const { return !(lower.x <= upper.x); }
  Vec3 centre() const { return 0.5f * (lower + upper); }
  float radius() const { return 0.5f * length(upper - lower); }
};

/// The constants of all frames: camera, light, and ground.
struct Stage {
  Vec3 up{0, 1, 0};
  Vec3 to_sun{0, 1, 0};
  SceneCamera camera;
  Vec3 centre{0, 0, 0};  ///< m
  float radius = 1;      ///< m, of a ball around everything that casts shadows
  Vec3 ground_normal{0, 1, 0};
  float ground_offset = 0;  ///< m along the normal
  float tile = 1;           ///< m
  float spacing = 0.05f;    ///< m, of particles
  float dye_length = 1;     ///< m of fluid that give light the fluid's colour
};

/// Uses the scene's own camera and ground. Without a camera, the view contains everything; without a ground,
/// one lies beneath everything.
Stage stage_of(const io::PreviewScene& scene, const Bounds& bounds);

/// For a picture of this size, in pixels.
FrameUniforms uniforms_of(const Stage& stage, int width, int height);

/// Throws Error(invalid_argument) if there are more than most_fluids.
FluidUniforms fluid_uniforms_of(const io::PreviewScene& scene);
MediaUniforms media_uniforms_of(const io::PreviewScene& scene, const Stage& stage);

}  // namespace meniscus::render
