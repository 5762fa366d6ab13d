// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
// Thin bars along the edges of vessels, and of their openings. Groups of 16 × 16 pixels first put down which bars may
// reach them.
struct Bar {
  vec4 from, to;  // m
};
layout(std430, binding = 7) readonly restrict buffer Bars {
  uvec4 bar_count;
  Bar bars[];
};

const uint bar_threads = 256u;  // of a group; so many bars at a time
shared uint near_bars[bar_threads];
shared uint near_count;

struct BarHit {
  float distance;  // along −z
  uint bar;
  vec3 normal;
};

// Whether the bar comes near to a square of 16 pixels, from how far its picture, a line, passes its middle.
bool is_near(Bar bar, vec2 middle) {
  vec4 a = view * vec4(bar.from.xyz, 1.0), b = view * vec4(bar.to.xyz, 1.0);
  if (min(-a.z, -b.z) < lens.z) {
    if (max(-a.z, -b.z) < lens.z) return false;
    vec4 cut = mix(a, b, (-lens.z - a.z) / (b.z - a.z));
    if (a.z > b.z) a = cut;
    else b = cut;
  }
  vec2 scale = 0.5 * viewport.xy / lens.xy, from = (a.xy / -a.z) * scale + 0.5 * viewport.xy;
  vec2 way = (b.xy / -b.z) * scale + 0.5 * viewport.xy - from;
  float along = clamp(dot(middle - from, way) / max(dot(way, way), 1e-12), 0.0, 1.0);
  // Half of a square's diagonal, and what is not a line after all.
  float reach = 12.0 + 1.5 * eye.w * scale.y / (min(-a.z, -b.z));
  return distance(middle, from + along * way) < reach;
}

// Of a ball; else of the bar between its ends.
bool meets_end(vec3 centre_, vec3 direction, out float along) {
  vec3 way = centre_ - eye.xyz;
  float square = dot(direction, direction), nearest = dot(way, direction) / square;
  vec3 off = nearest * direction - way;
  float inside = eye.w * eye.w - dot(off, off);
  along = nearest - sqrt(max(inside, 0.0) / square);
  return inside >= 0.0;
}

void meet(uint k, vec3 direction, inout BarHit hit) {
  vec3 from = bars[k].from.xyz, way = bars[k].to.xyz - from, away = from - eye.xyz;
  float size = dot(way, way);
  // Across the bar, where it is a disc.
  vec3 across = direction - dot(direction, way) / size * way, off = away - dot(away, way) / size * way;
  float square = max(dot(across, across), 1e-12), nearest = dot(off, across) / square;
  vec3 apart = nearest * across - off;
  float inside = eye.w * eye.w - dot(apart, apart);
  if (inside < 0.0) return;
  float along = nearest - sqrt(inside / square);
  float part = dot(along * direction - away, way) / size;
  if (part < 0.0 || part > 1.0) {
    part = clamp(part, 0.0, 1.0);
    if (!meets_end(from + part * way, direction, along)) return;
  }
  if (along < lens.z || along > hit.distance || (along == hit.distance && k > hit.bar)) return;
  hit = BarHit(along, k, (along * direction - away - part * way) / eye.w);
}

// The nearest bar at a pixel, nearer than `distance`; all threads of a group take part.
BarHit find_bar(vec2 pixel, float distance) {
  BarHit hit = BarHit(distance, ~0u, vec3(0.0));
  vec3 direction = world_ray(pixel);
  for (uint first = 0u; first < bar_count.x; first += bar_threads) {
    if (first > 0u) barrier();
    if (gl_LocalInvocationIndex == 0u) near_count = 0u;
    barrier();
    uint own = first + gl_LocalInvocationIndex;
    if (own < bar_count.x && is_near(bars[own], vec2(16u * gl_WorkGroupID.xy) + 8.0)) near_bars[atomicAdd(near_count, 1u)] = own;
    barrier();
    for (uint k = 0u; k < near_count; ++k) meet(near_bars[k], direction, hit);
  }
  return hit;
}
