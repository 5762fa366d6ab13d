// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
// The ground beneath the scene.
bool meets_ground(vec3 from, vec3 direction, out float along) {
  float towards = dot(ground.xyz, direction);
  along = (ground.w - dot(ground.xyz, from)) / towards;
  return towards < 0.0 && along > 0.0;
}

// Whether the ground hides what is there, or level with it by so many metres.
bool is_under_ground(vec3 world, float margin) {
  return dot(ground.xyz, world) < ground.w + margin && dot(ground.xyz, eye.xyz) > ground.w;
}
