// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
// The ground beneath the scene.
bool meets_ground(vec3 from, vec3 direction, out float along) {
  float towards = dot(ground.xyz, direction);
  along = (ground.w - dot(ground.xyz, from)) / towards;
  return towards < 0.0 && along > 0.0;
}

vec3 ground_color(vec3 world, vec3 direction) {
  vec3 a, b;
  plane_axes(ground.xyz, a, b);
  vec2 at = vec2(dot(a, world), dot(b, world)) / floor_.x;
  vec3 color = lit(tiles(at, vec3(0.18, 0.185, 0.19)), 0.02, world, ground.xyz);
  float away = max(length(world - centre.xyz) / floor_.w - 1.2, 0.0);
  vec3 level = normalize(direction - dot(direction, up.xyz) * up.xyz);
  return mix(sky(level), color, exp(-0.16 * away * away));
}
