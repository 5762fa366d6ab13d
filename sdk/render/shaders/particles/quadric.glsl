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

// Its corners, in clip space at w = 1, for the ellipsoid whose axes and centre the columns are.
void picture_of(mat4 to_view, out vec2 low, out vec2 high) {
  mat4 rows = transpose(projection * to_view);
  vec2 x = extent(rows[0], rows[3]), y = extent(rows[1], rows[3]);
  low = vec2(x.x, y.x);
  high = vec2(x.y, y.y);
}

// One that reaches behind the near plane is left out: its picture has no end.
bool is_seen(vec3 middle, float size) {
  return -middle.z - size > lens.z;
}
