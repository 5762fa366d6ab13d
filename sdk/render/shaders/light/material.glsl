// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
// Surfaces that light does not pass.
vec3 lit(vec3 albedo, float gloss, vec3 world, vec3 normal) {
  vec3 sun = sun_light * sun_on(world, normal) * max(dot(normal, to_sun.xyz), 0.0);
  vec3 to_eye = normalize(eye.xyz - world);
  float shine = pow(max(dot(normal, normalize(to_sun.xyz + to_eye)), 0.0), 60.0);
  float edge = pow(1.0 - max(dot(normal, to_eye), 0.0), 5.0);
  vec3 ahead = reflect(-to_eye, normal), reflected = gloss > 0.1 ? sky(ahead) : clear_sky(dot(ahead, up.xyz));
  return albedo * (sun / 3.14159 * 2.0 + ambient_light(normal)) + gloss * (0.25 * sun * shine + edge * reflected);
}
