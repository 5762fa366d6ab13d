// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
// What all shaders know of a frame; see sdk/render/frame/uniforms.h.
layout(std140, binding = 0) uniform Frame {
  mat4 view, projection, camera_to_world, world_to_sun;
  vec4 eye, to_sun, up, lens, viewport, ground, floor_, centre;
};

// View space at a pixel's place in [0, 1]², of depth 1.
vec3 view_ray(vec2 place) {
  return vec3((2.0 * place - 1.0) * lens.xy, -1.0);
}

// The same in the world, at a pixel.
vec3 world_ray(vec2 pixel) {
  return mat3(camera_to_world) * view_ray((pixel + 0.5) * viewport.zw);
}

// What the depth buffer holds at a distance along −z, and back.
float to_window_depth(float distance) {
  float n = lens.z, f = lens.w;
  return f * (distance - n) / (distance * (f - n));
}
float to_distance(float window_depth) {
  float n = lens.z, f = lens.w;
  return n * f / (f - window_depth * (f - n));
}
