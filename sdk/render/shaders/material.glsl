// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
// Matt surfaces, and the ground's tiles.
vec3 lit(vec3 albedo, float gloss, vec3 world, vec3 normal) {
  vec3 sun = sun_light * sun_on(world, normal) * max(dot(normal, to_sun.xyz), 0.0);
  vec3 to_eye = normalize(eye.xyz - world);
  float shine = pow(max(dot(normal, normalize(to_sun.xyz + to_eye)), 0.0), 60.0);
  float edge = pow(1.0 - max(dot(normal, to_eye), 0.0), 5.0);
  vec3 reflected = sky(reflect(-to_eye, normal));
  return albedo * (sun / 3.14159 * 2.0 + ambient_light(normal)) + gloss * (0.25 * sun * shine + edge * reflected);
}

// Two tones, with seams: lines of one width in the picture would flicker, so they fade with distance.
vec3 tiles(vec2 at, vec3 tone) {
  vec2 cell = floor(at), inside = abs(fract(at) - 0.5);
  vec2 wide = fwidth(at);
  float blur = clamp(max(wide.x, wide.y) * 1.5, 0.0, 1.0);
  float even = mod(cell.x + cell.y, 2.0);
  vec2 seam = smoothstep(0.5 - 0.018 - wide, vec2(0.5 - 0.010), inside);
  float line = max(seam.x, seam.y) * (1.0 - blur);
  return tone * mix(mix(0.86, 1.0, even), 0.93, blur) * (1.0 - 0.30 * line);
}

// Two axes along a plane.
void plane_axes(vec3 normal, out vec3 a, out vec3 b) {
  a = normalize(abs(normal.x) < 0.7 ? vec3(1.0, 0.0, 0.0) - normal.x * normal : vec3(0.0, 0.0, 1.0) - normal.z * normal);
  b = cross(normal, a);
}
