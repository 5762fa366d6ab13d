// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#version 450 core
// A rectangle around the picture of an ellipsoid (Sigg, Weyrich, Botsch & Gross 2006, GPU-Based Ray-Casting of
// Quadratic Surfaces).
#include "frame.glsl"
layout(location = 0) in vec3 centre_;
layout(location = 1) in vec3 radii;
layout(location = 2) in vec4 rotation;

flat out vec3 from;               // the eye, where the ellipsoid is the unit ball
flat out float evenness;           // how much of the filter it is to get
noperspective out vec3 direction;  // likewise, per unit of distance along −z

vec3 rotate(vec4 q, vec3 v) {
  vec3 t = 2.0 * cross(q.xyz, v);
  return v + q.w * t + cross(q.xyz, t);
}

// The two ends of the picture along one axis of clip space, of the unit ball's image under rows r and w.
vec2 extent(vec4 r, vec4 w) {
  const vec4 ball = vec4(1.0, 1.0, 1.0, -1.0);
  float a = dot(r * ball, r), b = dot(r * ball, w), c = dot(w * ball, w);
  float root = sqrt(max(b * b - a * c, 0.0));
  return vec2(b + root, b - root) / c;
}

void main() {
  mat3 turn = mat3(view) * mat3(rotate(rotation, vec3(1, 0, 0)), rotate(rotation, vec3(0, 1, 0)),
                                rotate(rotation, vec3(0, 0, 1)));
  vec3 middle = (view * vec4(centre_, 1.0)).xyz;
  mat3 axes = mat3(turn[0] * radii.x, turn[1] * radii.y, turn[2] * radii.z);
  mat4 rows = transpose(projection * mat4(vec4(axes[0], 0.0), vec4(axes[1], 0.0), vec4(axes[2], 0.0), vec4(middle, 1.0)));
  vec2 x = extent(rows[0], rows[3]), y = extent(rows[1], rows[3]);
  vec2 corner = vec2((gl_VertexID & 1) == 0 ? x.x : x.y, (gl_VertexID & 2) == 0 ? y.x : y.y);
  mat3 inverse_axes = transpose(mat3(turn[0] / radii.x, turn[1] / radii.y, turn[2] / radii.z));
  from = -(inverse_axes * middle);
  direction = inverse_axes * vec3(corner * lens.xy, -1.0);
  // A drop on its own, which is smaller than what has neighbours, is to keep its shape.
  evenness = mix(0.2, 1.0, smoothstep(0.65, 0.95, pow(radii.x * radii.y * radii.z, 1.0 / 3.0) / floor_.z));
  // One that reaches behind the near plane is left out: its picture has no end.
  float size = max(radii.x, max(radii.y, radii.z));
  gl_Position = -middle.z - size > lens.z ? vec4(corner, 0.0, 1.0) : vec4(0.0, 0.0, 2.0, 1.0);
}
