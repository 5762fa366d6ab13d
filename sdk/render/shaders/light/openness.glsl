// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
// How much of the sky things nearby leave open, from what the picture shows of them (after McGuire, Osman, Bukowski &
// Hennessy 2011, The Alchemy Screen-Space Ambient Obscurance). Needs scene_distance.
const int open_samples = 12;

// Of the point that the pixel shows. The samples are the same in each pixel, so that nothing is noisy.
float openness(ivec2 pixel, vec3 world, vec3 normal) {
  float reach = 0.15 * floor_.y, distance = texelFetch(scene_distance, pixel, 0).r;
  float pixels = min(reach * viewport.y / (2.0 * lens.y * distance), 0.15 * viewport.y), hidden = 0.0;
  if (pixels < 2.0) return 1.0;
  for (int k = 0; k < open_samples; ++k) {
    float angle = 2.39996 * float(k), away = pixels * sqrt((float(k) + 0.5) / float(open_samples));
    ivec2 place = clamp(pixel + ivec2(round(away * vec2(cos(angle), sin(angle)))), ivec2(0), ivec2(viewport.xy) - 1);
    vec3 way = eye.xyz + texelFetch(scene_distance, place, 0).r * world_ray(vec2(place)) - world;
    float square = dot(way, way), near = max(1.0 - square / (reach * reach), 0.0);
    hidden += near * max(dot(way, normal) * inversesqrt(square + 1e-12) - 0.15, 0.0);
  }
  return clamp(1.0 - 3.0 * hidden / float(open_samples), 0.25, 1.0);
}
