// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
// A group of threads takes four rows of 64 pixels along the filter's axis, and reads them and what lies beyond their ends
// into its own memory: of a texture a multiprocessor reads few pixels at a time.
layout(local_size_x = 64, local_size_y = 4) in;

const int long_ = 64, rows = 4, margin = 48;  // pixels
const int most_samples = 24;                  // to each side

shared vec2 near[rows][long_ + 2 * margin];
shared bool has_fluid;

ivec2 along_axis(ivec2 v) {
  return axis.x == 1 ? v : v.yx;
}

ivec2 own_pixel() {
  return along_axis(ivec2(gl_GlobalInvocationID.xy));
}

// False where there is no fluid in the rows.
bool read_rows() {
  ivec2 first = ivec2(gl_WorkGroupID.xy) * ivec2(long_, rows);
  int row = int(gl_LocalInvocationID.y);
  has_fluid = false;
  barrier();
  if (surface_at(own_pixel()).r > 0.0) has_fluid = true;
  barrier();
  if (!has_fluid) return false;
  for (int k = int(gl_LocalInvocationID.x); k < long_ + 2 * margin; k += long_)
    near[row][k] = surface_at(along_axis(first + ivec2(k - margin, row)));
  barrier();
  return true;
}

// So many pixels along the axis.
vec2 surface_beside(int pixels) {
  if (abs(pixels) > margin) return surface_at(own_pixel() + pixels * axis);
  return near[gl_LocalInvocationID.y][int(gl_LocalInvocationID.x) + margin + pixels];
}

// How much shorter a way along the surface looks where it leads away from the eye, from the depths so many
// pixels to each side: a filter is to reach equally far along it in all directions.
float foreshortening(float distance, int apart, float pixels_per_metre) {
  float a = surface_beside(apart).r, b = surface_beside(-apart).r;
  if (min(a, b) <= 0.0 || max(abs(a - distance), abs(b - distance)) > threshold) return 1.0;
  float slope = (a - b) * pixels_per_metre / float(2 * apart);
  return max(inversesqrt(1.0 + slope * slope), 0.3);
}

// Pixels to each side, and from one sample to the next: two standard deviations, at this distance.
void choose_samples(vec2 here, out int samples, out int stride, out float falloff) {
  float pixels_per_metre = viewport.y / (2.0 * lens.y * here.r), pixels = here.g * reach * pixels_per_metre;
  pixels *= foreshortening(here.r, max(int(pixels), 1), pixels_per_metre);
  int radius = int(ceil(2.0 * pixels));
  stride = max((radius + most_samples - 1) / most_samples, 1);
  samples = radius / stride;
  falloff = -0.5 * float(stride * stride) / (pixels * pixels);
}

// Weights of samples at 1, 2, 3 and so on times a length: exp(falloff k²).
struct Weights {
  float at, next, ratio;
};
Weights weights_of(float falloff) {
  float first = exp(falloff);
  return Weights(1.0, first, first * first);
}
void advance(inout Weights w) {
  w.at *= w.next;
  w.next *= w.ratio;
}

vec2 filtered(vec2 here);

void filter_row() {
  ivec2 pixel = own_pixel();
  vec2 result = vec2(0.0);
  if (read_rows()) {
    vec2 here = surface_beside(0);
    result = here.r > 0.0 ? filtered(here) : here;
  }
  if (all(lessThan(pixel, ivec2(viewport.xy)))) imageStore(result_depth, pixel, vec4(result, 0.0, 0.0));
}
