// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#version 450 core
// Takes the steps out of edges, along which it averages (after Lottes's FXAA).
#include "shared/frame.glsl"
#include "shared/pixels.glsl"
layout(binding = 2) uniform sampler2D image;  // a: luma
layout(binding = 0, rgba8) writeonly restrict uniform image2D smoothed;

vec4 color_of(vec2 place) {
  return textureLod(image, place, 0.0);
}
float luma_at(ivec2 pixel, ivec2 apart) {
  return texelFetch(image, clamp(pixel + apart, ivec2(0), ivec2(viewport.xy) - 1), 0).a;
}

vec4 color_at(ivec2 pixel) {
  vec2 place = (vec2(pixel) + 0.5) * viewport.zw;
  vec2 texel = 1.0 / vec2(textureSize(image, 0));
  vec4 here = color_of(place);
  float a = luma_at(pixel, ivec2(-1, -1)), b = luma_at(pixel, ivec2(1, -1));
  float c = luma_at(pixel, ivec2(-1, 1)), d = luma_at(pixel, ivec2(1, 1));
  float low = min(here.a, min(min(a, b), min(c, d))), high = max(here.a, max(max(a, b), max(c, d)));
  if (high - low < max(0.03, 0.10 * high)) return here;
  vec2 along = vec2((c + d) - (a + b), (a + c) - (b + d));
  float least = min(abs(along.x), abs(along.y)) + max(0.03 * (a + b + c + d), 0.008);
  along = clamp(along / least, -8.0, 8.0) * texel;
  vec4 near = 0.5 * (color_of(place - along / 6.0) + color_of(place + along / 6.0));
  vec4 far = 0.5 * near + 0.25 * (color_of(place - 0.5 * along) + color_of(place + 0.5 * along));
  return far.a < low || far.a > high ? near : far;
}

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (!is_outside(pixel)) imageStore(smoothed, pixel, color_at(pixel));
}
