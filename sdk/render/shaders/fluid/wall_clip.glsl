// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
// Fluid ends at the planes of the walls that hold it, which its ellipsoids would reach through.
#include "light/vessels.glsl"

uint closed_faces(uint vessel) {
  return vessels[vessel].parts.x | vessels[vessel].parts.y;
}

// The box without faces that are missing as a whole: there it has no end.
void walls_of(uint vessel, out vec3 low, out vec3 high) {
  high = vessels[vessel].half_size.xyz;
  low = -high;
  uint faces = closed_faces(vessel);
  for (int axis = 0; axis < 3; ++axis) {
    if ((faces >> uint(2 * axis) & 1u) == 0u) low[axis] = -1e9;
    if ((faces >> uint(2 * axis + 1) & 1u) == 0u) high[axis] = 1e9;
  }
}

// One more than the vessel that holds a ball whose centre is at `centre_` and that reaches a wall; 0 if there is none.
// A particle may be pressed a little into a wall.
uint clipping_vessel(vec3 centre_, float reach) {
  for (uint k = 0u; k < vessel_count.x; ++k) {
    vec3 low, high, at = (vessels[k].to_box * vec4(centre_, 1.0)).xyz;
    walls_of(k, low, high);
    float inside = min(min(at.x - low.x, min(at.y - low.y, at.z - low.z)),
                       min(high.x - at.x, min(high.y - at.y, high.z - at.z)));
    if (inside > -0.25 * floor_.z && inside < reach) return k + 1u;
  }
  return 0u;
}

// Cuts what lies in a vessel, from `begin` to `end` per unit of the direction, to what is before its walls. Openings let
// fluid through. False if nothing is left.
bool clip_at_walls(uint vessel, vec3 direction, inout float begin, float end) {
  vec3 low, high;
  walls_of(vessel, low, high);
  mat4 to_box = vessels[vessel].to_box;
  vec3 from = (to_box * vec4(eye.xyz, 1.0)).xyz, along = mat3(to_box) * direction;
  along += 1e-20 * vec3(equal(along, vec3(0.0)));
  vec3 a = (low - from) / along, b = (high - from) / along, enter = min(a, b), leave = max(a, b);
  float first = max(enter.x, max(enter.y, enter.z)), last = min(leave.x, min(leave.y, leave.z));
  int axis = axis_of(enter, first), face = 2 * axis + int(along[axis] < 0.0);
  if (first > begin && first <= last && is_part(vessel, closed_faces(vessel), face, from + first * along)) begin = first;
  axis = axis_of(leave, last);
  face = 2 * axis + int(along[axis] > 0.0);
  bool ends = first > last || is_part(vessel, closed_faces(vessel), face, from + last * along);
  return begin <= end && !(ends && begin > last);
}
