// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
// Three strands that are laid into a rope. The rope stays a tube: only its normal and its colour have them.
const float lay = 0.45;    // radians around the rope for each radius along it
const float depth = 0.35;  // of the creases between strands, in radii

// `place`: the angle, and the way along in radii; `dx`, `dy`: how it changes from pixel to pixel, as the point does.
void twist(vec2 place, vec2 dx, vec2 dy, vec3 along_x, vec3 along_y, inout vec3 normal, inout vec3 albedo) {
  float determinant = dx.x * dy.y - dx.y * dy.x, phase = 1.5 * (place.x - lay * place.y);
  if (abs(determinant) < 1e-12) return;
  // Strands of a few pixels fade into a smooth tube.
  float wide = 1.5 * (abs(dx.x - lay * dx.y) + abs(dy.x - lay * dy.y)), seen = 1.0 - smoothstep(0.5, 1.2, wide);
  vec3 around = (along_x * dy.y - along_y * dx.y) / determinant, ahead = (along_y * dx.x - along_x * dy.x) / determinant;
  float radius = length(around), slope = -1.5 * depth * radius * sin(phase) * sign(cos(phase));
  vec3 rise = slope * (around / dot(around, around) - lay * ahead / max(dot(ahead, ahead), 1e-20));
  normal = normalize(normal - seen * rise);
  albedo *= mix(1.0, 0.55 + 0.5 * abs(cos(phase)), seen);
}
