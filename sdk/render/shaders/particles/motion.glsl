// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
// Velocities of the particles, three numbers each, if they are known.
layout(std430, binding = 11) readonly restrict buffer Velocities {
  float velocities[];
};
layout(location = 2) uniform int has_velocities;

// In view space, m/s.
vec3 motion_of(uint i) {
  if (has_velocities == 0) return vec3(0.0);
  return mat3(view) * vec3(velocities[3u * i], velocities[3u * i + 1u], velocities[3u * i + 2u]);
}
