// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
// The rectangle around the picture of an ellipsoid (Sigg, Weyrich, Botsch & Gross 2006, GPU-Based Ray-Casting of
// Quadratic Surfaces).

// The two ends of the picture along one axis of clip space, of the unit ball's image under rows r and w.
vec2 extent(vec4 r, vec4 w) {
  const vec4 ball = vec4(1.0, 1.0, 1.0, -1.0);
  float a = dot(r * ball, r), b = dot(r * ball, w), c = dot(w * ball, w);
  float root = sqrt(max(b * b - a * c, 0.0));
  return vec2(b + root, b - root) / c;
}

// The corner of this vertex, in clip space at w = 1, of the ellipsoid whose axes and centre the columns are.
vec2 picture_corner(mat4 to_view) {
  mat4 rows = transpose(projection * to_view);
  vec2 x = extent(rows[0], rows[3]), y = extent(rows[1], rows[3]);
  return vec2((gl_VertexID & 1) == 0 ? x.x : x.y, (gl_VertexID & 2) == 0 ? y.x : y.y);
}

// One that reaches behind the near plane is left out: its picture has no end.
vec4 place_of(vec2 corner, vec3 middle, float size) {
  return -middle.z - size > lens.z ? vec4(corner, 0.0, 1.0) : nowhere;
}
