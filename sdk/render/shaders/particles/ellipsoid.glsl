// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
// A particle of fluid in view space, as its axes, and what of the picture it may cover.
vec3 rotate(vec4 q, vec3 v) {
  vec3 t = 2.0 * cross(q.xyz, v);
  return v + q.w * t + cross(q.xyz, t);
}

mat3 turn_of(vec4 rotation) {
  return mat3(view) * mat3(rotate(rotation, vec3(1, 0, 0)), rotate(rotation, vec3(0, 1, 0)), rotate(rotation, vec3(0, 0, 1)));
}

float longest(vec3 radii) {
  return max(radii.x, max(radii.y, radii.z));
}

mat3 axes_of(Particle p, mat3 turn) {
  return mat3(turn[0] * p.radii.x, turn[1] * p.radii.y, turn[2] * p.radii.z);
}

// Pixels, from first to last; first > last where nothing of it is seen. No axis is longer than `reach`.
ivec4 pixels_of(mat3 axes, float reach, vec3 middle) {
  if (!is_seen(middle, reach)) return ivec4(0, 0, -1, -1);
  vec2 low, high;
  picture_of(mat4(vec4(axes[0], 0.0), vec4(axes[1], 0.0), vec4(axes[2], 0.0), vec4(middle, 1.0)), low, high);
  // Centres of pixels lie at halves.
  vec2 first = (0.5 * low + 0.5) * viewport.xy - 0.5, last = (0.5 * high + 0.5) * viewport.xy - 0.5;
  return ivec4(ceil(clamp(first, vec2(0.0), viewport.xy)), floor(clamp(last, vec2(-1.0), viewport.xy - 1.0)));
}

// Of a ball that is seen, and some around it: quicker than pixels_of.
ivec4 pixels_of_ball(vec3 middle, float radius) {
  // Tangents of the angles to both sides of its middle, no nearer to the axis than they are.
  vec2 axis = middle.xy / -middle.z, apart = radius / (-middle.z - radius) * (1.0 + abs(axis));
  vec2 first = 0.5 * ((axis - apart) / lens.xy + 1.0) * viewport.xy, last = 0.5 * ((axis + apart) / lens.xy + 1.0) * viewport.xy;
  return ivec4(floor(clamp(first, vec2(0.0), viewport.xy)), ceil(clamp(last, vec2(-1.0), viewport.xy - 1.0)));
}
