// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#version 450 core
// Surfaces in the colours of their normals in the world; the sky is dark.
#include "shared/frame.glsl"
#include "fluid/surface.glsl"
layout(binding = 3) uniform sampler2D scene_distance;
layout(location = 0) out vec4 color;

vec3 point_at(ivec2 pixel) {
  pixel = clamp(pixel, ivec2(0), textureSize(scene_distance, 0) - 1);
  return surface_point(pixel, min(texelFetch(scene_distance, pixel, 0).r, 0.999 * lens.w));
}

// To the side on which depth changes less, so that edges stay sharp.
vec3 slope(ivec2 pixel, ivec2 axis, vec3 here) {
  vec3 back = here - point_at(pixel - axis), on = point_at(pixel + axis) - here;
  if (back == vec3(0.0)) return on;  // at the picture's edge
  if (on == vec3(0.0)) return back;
  return abs(back.z) < abs(on.z) ? back : on;
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  float fluid = fluid_depth(pixel);
  vec3 here = point_at(pixel), c = vec3(0.12);
  bool is_fluid = fluid > 0.0 && fluid <= -here.z * 1.0001;
  if (is_fluid || -here.z < 0.99 * lens.w) {
    vec3 n;
    if (is_fluid)
      n = surface_normal(pixel, fluid);
    else
      n = normalize(cross(slope(pixel, ivec2(1, 0), here), slope(pixel, ivec2(0, 1), here)));
    c = 0.5 + 0.5 * (mat3(camera_to_world) * n);
  }
  color = vec4(c, dot(c, vec3(0.299, 0.587, 0.114)));
}
