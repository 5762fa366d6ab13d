// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
// Light from above: a clear sky, paler towards the horizon, and a sun.
#include "shared/random.glsl"

const vec3 sun_light = vec3(2.55, 2.40, 2.12);
const vec3 zenith = vec3(0.06, 0.16, 0.38), horizon = vec3(0.52, 0.62, 0.73), below = vec3(0.22, 0.23, 0.24);

// Value noise, smooth, 0 to 1.
float noise(vec2 p) {
  ivec2 cell = ivec2(floor(p));
  vec2 f = fract(p);
  f = f * f * (3.0 - 2.0 * f);
  return mix(mix(random(cell), random(cell + ivec2(1, 0)), f.x),
             mix(random(cell + ivec2(0, 1)), random(cell + 1), f.x), f.y);
}

// Without clouds, at the sine of an angle.
vec3 clear_sky(float height) {
  return mix(mix(horizon, zenith, pow(clamp(height, 0.0, 1.0), 0.55)), below, smoothstep(0.0, -0.10, height));
}

vec3 sky(vec3 direction) {
  float height = dot(direction, up.xyz);
  vec3 color = clear_sky(height);
  if (height > 0.02) {
    // On a ceiling, so that clouds draw together towards the horizon.
    vec3 a = normalize(cross(up.xyz, to_sun.xyz)), b = cross(a, up.xyz);
    vec2 at = 1.3 * vec2(dot(direction, a), dot(direction, b)) / (height + 0.15);
    float cloud = 0.55 * noise(at) + 0.28 * noise(2.1 * at + 5.0) + 0.17 * noise(4.3 * at + 9.0);
    color = mix(color, vec3(0.80, 0.82, 0.85), 0.75 * smoothstep(0.45, 0.75, cloud) * smoothstep(0.02, 0.25, height));
  }
  return color;
}

// Even light from all of the sky, and from the ground, on a surface.
vec3 ambient_light(vec3 normal) {
  return mix(vec3(0.16, 0.16, 0.16), vec3(0.38, 0.46, 0.56), 0.5 + 0.5 * dot(normal, up.xyz));
}
