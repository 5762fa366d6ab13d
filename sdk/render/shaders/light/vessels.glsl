// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
// Containers as boxes that rays are cast at; see sdk/render/passes/vessels.h.
struct Vessel {
  mat4 to_box;      // from the world to where its sides are parallel to the axes
  vec4 half_size;   // m
  uvec4 parts;      // bits of its faces: walls of glass, floors; where its openings begin and end
};
struct Opening {
  vec4 low, high;  // m; w of low: the face
};
layout(std430, binding = 5) readonly restrict buffer Vessels {
  uvec4 vessel_count;
  Vessel vessels[];
};
layout(std430, binding = 6) readonly restrict buffer Openings {
  uvec4 opening_count;
  Opening openings[];
};

// A ray in a vessel's box, and how far along it comes in and goes out, by which faces.
struct Passage {
  vec3 from, direction;
  float enter, leave;
  int enter_face, leave_face;
};

int axis_of(vec3 ways, float way) {
  return way == ways.x ? 0 : way == ways.y ? 1 : 2;
}

// False where it passes by the vessel.
bool passes(uint vessel, vec3 direction, out Passage p) {
  mat4 to_box = vessels[vessel].to_box;
  p.from = (to_box * vec4(eye.xyz, 1.0)).xyz;
  p.direction = mat3(to_box) * direction;
  p.direction += 1e-20 * vec3(equal(p.direction, vec3(0.0)));
  vec3 inverse = 1.0 / p.direction, middle = -p.from * inverse, reach = abs(inverse) * vessels[vessel].half_size.xyz;
  vec3 enter = middle - reach, leave = middle + reach;
  p.enter = max(enter.x, max(enter.y, enter.z));
  p.leave = min(leave.x, min(leave.y, leave.z));
  int a = axis_of(enter, p.enter), b = axis_of(leave, p.leave);
  p.enter_face = 2 * a + int(p.direction[a] < 0.0);
  p.leave_face = 2 * b + int(p.direction[b] > 0.0);
  return p.enter <= p.leave;
}

// Whether a face is one of `faces`, and not open there.
bool is_part(uint vessel, uint faces, int face, vec3 at) {
  if ((faces >> uint(face) & 1u) == 0u) return false;
  for (uint k = vessels[vessel].parts.z; k < vessels[vessel].parts.w; ++k) {
    if (int(openings[k].low.w) != face) continue;
    // Along the face's normal an opening has no borders.
    bvec3 inside = bvec3(ivec3(greaterThan(at, openings[k].low.xyz)) * ivec3(lessThan(at, openings[k].high.xyz)));
    inside[face / 2] = true;
    if (all(inside)) return false;
  }
  return true;
}

// Of a face, in the world, towards the inside.
vec3 inward_normal(uint vessel, int face) {
  vec3 normal = vec3(0.0);
  normal[face / 2] = face % 2 == 0 ? 1.0 : -1.0;
  return normal * mat3(vessels[vessel].to_box);
}
