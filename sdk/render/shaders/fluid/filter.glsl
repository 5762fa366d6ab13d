// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
// What the filters of the fluid's surface have in common. They read memory rather than a texture, of which a GPU reads
// fewer pixels at a time.
#include "fluid/fluid_depth.glsl"
layout(local_size_x = 32, local_size_y = 8) in;  // see FluidSurface
layout(std430, binding = 9) writeonly restrict buffer FilteredSurface {
  float filtered_surface[];
};
layout(location = 0) uniform ivec2 axis;       // pixels, from one to the next along the filter
layout(location = 1) uniform float reach;      // m, one standard deviation
layout(location = 2) uniform float threshold;  // m: what is further apart in depth is another surface

const int most_samples = 24;  // to each side

float share_of(float found) {
  return float(floatBitsToUint(found) & share_bits) / float(share_bits);
}

// A pixel's place among those along the filter: its own, how far it is to the next one's, and to those at the picture's
// edges, beyond which there is what lies at them.
struct Row {
  int here, step, ahead, behind;
};

Row row_of(ivec2 pixel) {
  ivec2 last = ivec2(viewport.xy) - 1;
  int step = axis.x + axis.y * int(viewport.x), before = pixel.x * axis.x + pixel.y * axis.y;
  return Row(place_of(pixel), step, (last.x * axis.x + last.y * axis.y - before) * step, before * step);
}
float ahead(Row row, int places) {
  return fluid_surface[row.here + min(places, row.ahead)];
}
float behind(Row row, int places) {
  return fluid_surface[row.here - min(places, row.behind)];
}

// Samples to each side, places from one to the next, and e^-(1/2 (k / standard deviation)²) for k = 1.
struct Samples {
  int count, stride;
  float weight;
};

// How much shorter a way along the surface looks where it leads away from the eye, from the depths so many
// pixels to each side: a filter is to reach equally far along it in all directions.
float foreshortening(Row row, float distance, int apart, float pixels_per_metre) {
  float a = abs(ahead(row, apart * row.step)), b = abs(behind(row, apart * row.step));
  if (max(abs(a - distance), abs(b - distance)) > threshold) return 1.0;
  float slope = (a - b) * pixels_per_metre / float(2 * apart);
  return max(inversesqrt(1.0 + slope * slope), 0.3);
}

// Two standard deviations, at this distance.
Samples choose_samples(Row row, float found) {
  float distance = abs(found), pixels_per_metre = viewport.y / (2.0 * lens.y * distance);
  float pixels = share_of(found) * reach * pixels_per_metre;
  pixels *= foreshortening(row, distance, max(int(pixels), 1), pixels_per_metre);
  int radius = int(ceil(2.0 * pixels)), stride = max((radius + most_samples - 1) / most_samples, 1);
  return Samples(radius / stride, stride * row.step, exp(-0.5 * float(stride * stride) / (pixels * pixels)));
}

// A Gauss curve's values one after the other: e^-ck² from e^-c.
struct Weights {
  float at, ratio, square;
};
Weights weights_of(float first) {
  return Weights(1.0, first, first * first);
}
void advance(inout Weights w) {
  w.at *= w.ratio;
  w.ratio *= w.square;
}

// So far away, the rest as it was.
float moved(float found, float distance) {
  uint kept = floatBitsToUint(found) & (share_bits | drop_bit);
  return uintBitsToFloat(((floatBitsToUint(distance) + (share_bits + 1u) / 2u) & ~share_bits) | kept);
}

float filtered(ivec2 pixel, float found);

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, ivec2(viewport.xy)))) return;
  float found = fluid_surface[place_of(pixel)];
  filtered_surface[place_of(pixel)] = is_nothing_at(found) ? nothing : moved(found, filtered(pixel, found));
}
