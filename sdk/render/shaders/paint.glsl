// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
// The colour of a solid or of cloth, and its normal.
in vec3 world, world_normal;
flat in vec4 paint;

const float cloth_gloss = 0.05, solid_gloss = 0.35;

vec3 painted(out vec3 n, out float gloss) {
  n = normalize(world_normal);
  vec3 albedo = paint.rgb;
  gloss = paint.a < 0.25 ? solid_gloss : cloth_gloss;
  if (paint.a > 0.75) {
    vec3 a, b;
    plane_axes(n, a, b);
    vec2 at = vec2(dot(a, world), dot(b, world)) / floor_.x;
    albedo = tiles(at, fwidth(at), albedo);
  }
  // Cloth is seen from both sides, and is darker at the back. Which side it is says the triangle: at an outline the
  // smooth normal may point away from the eye on the front, too.
  vec3 flat_normal = cross(dFdx(world), dFdy(world));
  if (dot(n, flat_normal) * dot(flat_normal, eye.xyz - world) < 0.0) {
    n = -n;
    if (paint.a > 0.25 && paint.a < 0.75) albedo *= 0.6;
  }
  return albedo;
}
