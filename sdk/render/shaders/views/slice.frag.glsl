// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#version 450 core
// Signed distances: blue inside of solids, red outside, with lines at tenths of the range and a dark one at the surface.
#include "shared/frame.glsl"
#include "views/hidden.glsl"
layout(binding = 6) uniform sampler2D colors;
layout(binding = 7) uniform sampler2D distances;
layout(location = 3) uniform vec2 range;  // m
in vec2 place;
layout(location = 0) out vec4 color;

void main() {
  float distance = texture(distances, place).r, step = 0.1 * range.y;
  float wide = max(fwidth(distance), 1e-9);
  vec3 c = texture(colors, vec2((distance - range.x) / (range.y - range.x), 0.5)).rgb;
  float near_line = abs(distance / step - round(distance / step)) * step / wide;
  c *= mix(0.70, 1.0, smoothstep(0.4, 1.2, near_line));
  c *= smoothstep(0.8, 2.0, abs(distance) / wide);
  bool is_known = distance < 0.999 * range.y;
  color = vec4(c, is_known ? 0.85 : 0.35);
  if (is_hidden()) discard;
}
