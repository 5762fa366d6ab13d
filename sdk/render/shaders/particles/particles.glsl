// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
// The particles of a frame, as the world writes them: centre, radii and rotation of each, ten numbers, and its fluid.
layout(std430, binding = 0) readonly restrict buffer Ellipsoids {
  float ellipsoids[];
};
layout(std430, binding = 1) readonly restrict buffer FluidIndices {
  uint fluid_indices[];
};

struct Particle {
  vec3 centre, radii;
  vec4 rotation;
};

vec3 centre_of(uint i) {
  return vec3(ellipsoids[10u * i], ellipsoids[10u * i + 1u], ellipsoids[10u * i + 2u]);
}

Particle particle(uint i) {
  uint k = 10u * i;
  return Particle(centre_of(i), vec3(ellipsoids[k + 3u], ellipsoids[k + 4u], ellipsoids[k + 5u]),
                  vec4(ellipsoids[k + 6u], ellipsoids[k + 7u], ellipsoids[k + 8u], ellipsoids[k + 9u]));
}

// Not for what is not finite.
bool is_finite(vec3 v) {
  return all(lessThan(abs(v), vec3(1e30)));
}
