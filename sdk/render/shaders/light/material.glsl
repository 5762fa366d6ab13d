// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
// Surfaces that light does not pass, or only as it passes cloth.

// `fibres`: 1 for cloth, which also lets light through, and shines at low angles where its fibres catch it. `open`: the
// part of the sky that things nearby do not hide.
vec3 lit(vec3 albedo, float gloss, float fibres, float open, vec3 world, vec3 normal) {
  float facing_sun = dot(normal, to_sun.xyz);
  vec3 sun = sun_light * sun_on(world, normal) * max(facing_sun, 0.0);
  vec3 to_eye = normalize(eye.xyz - world);
  float shine = pow(max(dot(normal, normalize(to_sun.xyz + to_eye)), 0.0), 60.0);
  float level = 1.0 - max(dot(normal, to_eye), 0.0), edge = pow(level, 5.0);
  vec3 ahead = reflect(-to_eye, normal), reflected = gloss > 0.1 ? sky(ahead) : clear_sky(dot(ahead, up.xyz));
  vec3 even = open * ambient_light(normal);
  vec3 color = albedo * (sun / 3.14159 * 2.0 + even) + gloss * (0.25 * sun * shine + open * edge * reflected);
  if (fibres > 0.0) {
    color += 0.35 * fibres * sqrt(albedo) * level * level * level * (sun / 3.14159 + even);
    if (fibres > 0.9 && facing_sun < 0.0)
      color += 0.30 * albedo * sqrt(albedo) * sun_light * sun_on(world, -normal) * -facing_sun;
  }
  return color;
}
