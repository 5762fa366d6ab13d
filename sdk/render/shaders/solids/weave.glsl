// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
// Plain weave: threads along u and along v lie over one another in turn. Cloth stays flat: only its normal and its
// colour have them.
const float round_of_threads = 0.5;  // by how much the normal turns at the sides of a thread

// `place`: threads along u and v; `dx`, `dy`: how it changes from pixel to pixel, as the point does.
void weave(vec2 place, vec2 dx, vec2 dy, vec3 along_x, vec3 along_y, inout vec3 normal, inout vec3 albedo) {
  float determinant = dx.x * dy.y - dx.y * dy.x;
  if (abs(determinant) < 1e-12) return;
  // Threads of a few pixels fade into a smooth sheet.
  vec2 wide = abs(dx) + abs(dy);
  float seen = 1.0 - smoothstep(0.2, 0.5, max(wide.x, wide.y));
  vec3 u = normalize((along_x * dy.y - along_y * dx.y) / determinant);
  vec3 v = normalize((along_y * dx.x - along_x * dy.x) / determinant);
  vec2 cell = floor(place), at = fract(place) - 0.5;
  bool u_is_over = mod(cell.x + cell.y, 2.0) < 0.5;
  vec3 ahead = u_is_over ? u : v, across = u_is_over ? v : u;
  vec2 way = 3.14159 * (u_is_over ? at : at.yx);  // along the upper thread, and across it
  normal = normalize(normal + seen * round_of_threads * (sin(way.y) * across + 0.5 * sin(way.x) * ahead));
  albedo *= mix(1.0, 0.72 + 0.42 * cos(way.y) * cos(0.7 * way.x), seen);
}
