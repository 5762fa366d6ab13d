// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#version 450 core
// A rectangle around the picture of a particle of fluid.
#include "frame.glsl"
#include "fluids.glsl"
#include "quadric.glsl"
layout(location = 0) in vec3 centre_;
layout(location = 1) in vec3 radii;
layout(location = 2) in vec4 rotation;
layout(location = 3) in uint fluid;

flat out vec3 from;               // the eye, where the ellipsoid is the unit ball
flat out float evenness;           // how much of the filter it is to get
noperspective out vec3 direction;  // likewise, per unit of distance along −z

vec3 rotate(vec4 q, vec3 v) {
  vec3 t = 2.0 * cross(q.xyz, v);
  return v + q.w * t + cross(q.xyz, t);
}

void main() {
  mat3 turn = mat3(view) * mat3(rotate(rotation, vec3(1, 0, 0)), rotate(rotation, vec3(0, 1, 0)),
                                rotate(rotation, vec3(0, 0, 1)));
  vec3 middle = (view * vec4(centre_, 1.0)).xyz;
  mat3 axes = mat3(turn[0] * radii.x, turn[1] * radii.y, turn[2] * radii.z);
  vec2 corner = picture_corner(mat4(vec4(axes[0], 0.0), vec4(axes[1], 0.0), vec4(axes[2], 0.0), vec4(middle, 1.0)));
  mat3 inverse_axes = transpose(mat3(turn[0] / radii.x, turn[1] / radii.y, turn[2] / radii.z));
  from = -(inverse_axes * middle);
  direction = inverse_axes * vec3(corner * lens.xy, -1.0);
  // A drop on its own, which is smaller than what has neighbours, is to keep its shape.
  evenness = mix(0.2, 1.0, smoothstep(0.65, 0.95, pow(radii.x * radii.y * radii.z, 1.0 / 3.0) / floor_.z));
  gl_Position = is_grain(fluid) ? nowhere : place_of(corner, middle, max(radii.x, max(radii.y, radii.z)));
}
