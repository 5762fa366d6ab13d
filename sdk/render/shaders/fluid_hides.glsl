// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
// Whether the fluid is before this fragment, or at it; or the ground.
layout(binding = 4) uniform sampler2D fluid_depth;

bool is_in_fluid() {
  float z = texelFetch(fluid_depth, ivec2(gl_FragCoord.xy), 0).r;
  return z > 0.0 && to_window_depth(z) <= gl_FragCoord.z;
}

bool is_in_ground() {
  vec3 here = to_distance(gl_FragCoord.z) * view_ray(gl_FragCoord.xy * viewport.zw);
  return is_under_ground((camera_to_world * vec4(here, 1.0)).xyz, 0.0);
}
