// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#version 450 core
// Where the line of sight enters the ellipsoid, as a distance along −z.
#include "frame.glsl"
flat in vec3 from;
flat in float evenness;
noperspective in vec3 direction;
layout(location = 0) out vec2 result;

void main() {
  // From the point nearest to the centre: exact however far the eye is.
  float square = dot(direction, direction);
  float middle = -dot(from, direction) / square;
  vec3 nearest = from + middle * direction;
  float inside = 1.0 - dot(nearest, nearest);
  if (inside < 0.0) discard;
  float distance = middle - sqrt(inside / square);
  result = vec2(distance, evenness);
  gl_FragDepth = to_window_depth(distance);
}
