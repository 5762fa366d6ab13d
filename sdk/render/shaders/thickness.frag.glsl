// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#version 450 core
// A particle's volume, spread as (1 − r²/R²)² over a disc: smooth, and all of it is there.
#include "frame.glsl"
layout(binding = 3) uniform sampler2D solid_depth;  // of the camera alone
layout(location = 2) uniform float radius;
layout(location = 3) uniform float volume;  // m³
layout(location = 4) uniform int hides;     // 1: what lies behind a solid does not count
in vec2 offset;
flat in float distance_, window_depth;
flat in vec3 absorbance;
layout(location = 0) out vec4 result;  // absorbance; metres, or the depth for the smallest of all

void main() {
  float u = 1.0 - dot(offset, offset);
  if (u <= 0.0) discard;
  float metres = volume * 3.0 / (3.14159265 * radius * radius) * u * u;
  if (hides == 1) {
    ivec2 pixel = ivec2(gl_FragCoord.xy * vec2(textureSize(solid_depth, 0)) * viewport.zw * 2.0);
    if (window_depth > texelFetch(solid_depth, pixel, 0).r) discard;
    result = vec4(metres * absorbance, metres);
  } else {
    // As a ball would have it, behind whose top the disc is hung: steps from disc to disc would be seen as shades.
    result = vec4(metres * absorbance, window_depth + 0.5 * radius / to_sun.w * (1.0 - sqrt(u)));
  }
}
