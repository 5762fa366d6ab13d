// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The uniform blocks of the shaders, as C++ structs in std140 layout.
#pragma once

#include <array>

#include "sdk/render/frame/view.h"

namespace meniscus::render {

using Float4 = std::array<float, 4>;

constexpr Float4 float4(Vec3 v, float w = 0) {
  return {v.x, v.y, v.z, w};
}

/// Data of a frame for all shaders: the block Frame of shaders/shared/frame.glsl, member by member (std140).
struct FrameUniforms {
  Matrix4 view, projection, camera_to_world;
  Matrix4 world_to_sun;  ///< clip space of the shadow map
  Float4 eye;            ///< m; w: radius of the bars along the edges of vessels, m
  Float4 to_sun;         ///< unit; w: radius of the ball that casts shadows, m
  Float4 up;             ///< unit; w: 1 if fluid gathers light
  Float4 lens;           ///< tangents of half the opening angles; near and far planes, m
  Float4 viewport;       ///< width and height in pixels, and their inverses
  Float4 ground;         ///< normal, and its offset, m
  /// m: size of a tile; the scene's radius; the spacing of particles; the distance from the scene's middle at
  /// which haze begins.
  Float4 floor;
  Float4 centre;  ///< of the scene, m; w: the path on which a fluid gives light its colour, m
};

inline constexpr unsigned frame_binding = 0;
inline constexpr std::size_t most_fluids = 1024;  ///< what every driver supports

/// Appearance of fluids and granular materials: the block Fluids of shaders/particles/fluids.glsl.
struct FluidUniforms {
  std::array<Float4, most_fluids> looks;  ///< linear RGB; w: 1 for grains
};

/// How fluids take in light: the blocks Extinctions and Glows of shaders/particles/fluids.glsl. Two blocks:
/// one has no more room on some drivers.
struct MediaUniforms {
  std::array<Float4, most_fluids> extinctions;  ///< RGB, on the path that colours are given for
  std::array<Float4, most_fluids> glows;        ///< RGB that returns from deep fluid in white light, 0 to 1
};

inline constexpr unsigned fluids_binding = 1, extinctions_binding = 2, glows_binding = 3;

/// Texture units.
namespace unit {
inline constexpr unsigned shadow = 0, fluid_shadow = 1, color = 2, depth = 3, foam = 4, front_layer = 5,
                          values = 6, distances = 7, normals = 8, rest_layer = 9, layer_slices = 10,
                          rest_foam = 11, rest_shadow = 12, shadow_depths = 13, caustics = 14,
                          shadow_spans = 15;
}

}  // namespace meniscus::render
