// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#version 450 core
// The ellipsoids of one tile by ray casting: where the line of sight first enters one, and how much of the filter that
// one is to get. Threads first take a particle each and write down the pictures of those that are not hidden; then a
// row of threads draws one picture at a time.
#include "shared/frame.glsl"
#include "shared/exposure.glsl"
#include "particles/fluids.glsl"
#include "particles/quadric.glsl"
#include "particles/particles.glsl"
#include "particles/ellipsoid.glsl"
#include "particles/motion.glsl"
#include "tiles/tiles.glsl"
#include "fluid/wall_clip.glsl"
#include "fluid/fluid_depth.glsl"
#include "fluid/front_and_rest.glsl"
layout(local_size_x = 256) in;
layout(binding = 3) uniform sampler2D scene_distance;
layout(std430, binding = 9) writeonly restrict buffer FoundSurface {
  float found_surface[];
};
layout(location = 0) uniform ivec2 tiles;
layout(location = 1) uniform int layer;  // 0: the first surface; 1: that of the rest, behind the front layer

const uint group_size = 256u;
const uint row = 32u;         // threads, 8 by 4 pixels
const uint round_size = 64u;  // particles, between two looks at what is hidden
const int size = 32;

const float drop_size = 0.6;      // of the radius of a ball with a particle's volume
const float most_stretch = 2.5;  // stays within the disc by which particles are listed

const int block = 8;                   // pixels
const int blocks = size / block;

// Of an ellipsoid, at the pixel that is d from where its centre is seen. In the space where it is the unit ball the
// line of sight is D = D0 + E per unit of distance, where D0 leads to the centre and E is linear in d. It meets the
// ball where M = D² − (away D0 × E)² ≥ 0, at the distance (away D0·D − √M) / D²: exact however far the eye is.
struct Picture {
  vec4 place;   // of the centre, pixels in the tile; its distance; D0²
  vec4 slope;   // D0·E for a pixel along x, and along y; as whole numbers the least distance, and the filter's share
  vec4 square;  // E² = x² d.x² + 2 xy d.x d.y + y² d.y²; w: the pixels of the tile, from first to last
  vec4 across;  // (away D0 × E)², likewise; w: one more than the vessel whose walls it reaches, or 0
};

shared Picture pictures[round_size];  // those that walls may cut from the end on
shared uint picture_count, cut_count;
shared uint nearest[size * size];
shared float begins[size * size];  // what has its centre nearer belongs to the front layer
shared uint farthest[blocks * blocks];  // no pixel of the block shows anything further away

// Where the rest begins behind the first surface; 0 where nothing follows.
float rest_begin(ivec2 pixel) {
  if (layer == 0) return -1e30;
  pixel = min(pixel, ivec2(viewport.xy) - 1);
  float first = fluid_depth(pixel), end = front_end(texel_of(pixel));
  return first > 0.0 && first < end && end < no_gap ? end : 0.0;
}

// What the scene hides is further away; of equal ones the scene comes last. Nothing is seen where no rest is.
uint limit_at(ivec2 pixel, float begin) {
  ivec2 last = ivec2(viewport.xy) - 1;
  return begin == 0.0 ? 0u : floatBitsToUint(texelFetch(scene_distance, min(pixel, last), 0).r) | share_bits;
}

ivec4 in_tile(ivec4 pixels, ivec2 corner) {
  return ivec4(max(pixels.xy - corner, 0), min(pixels.zw - corner, size - 1));
}

// Also where there are no pixels.
bool is_hidden(ivec4 pixels, uint least) {
  if (pixels.x > pixels.z || pixels.y > pixels.w) return true;
  pixels /= block;
  for (int y = pixels.y; y <= pixels.w; ++y) {
    for (int x = pixels.x; x <= pixels.z; ++x) {
      if (farthest[y * blocks + x] >= least) return false;
    }
  }
  return true;
}

// A drop on its own stands for many small ones. It is drawn smaller than its volume, and as long as its way while a
// picture is exposed. `stretch`: by how much.
mat3 stretched(mat3 axes, vec3 motion, float alone, out float stretch) {
  float way = exposure * length(motion);
  stretch = 1.0 + alone * min(way / (drop_size * floor_.z), most_stretch - 1.0);
  if (stretch <= 1.0) return axes;
  vec3 ahead = normalize(motion);
  float across = inversesqrt(stretch);
  return across * axes + (stretch - across) * outerProduct(ahead, transpose(axes) * ahead);
}

vec3 form(vec3 a, vec3 b) {
  return vec3(dot(a, a), 2.0 * dot(a, b), dot(b, b));
}

// Of a particle that is not hidden.
void look_at(uint i, ivec2 corner) {
  Particle p = particle(i);
  float wide = pow(p.radii.x * p.radii.y * p.radii.z, 1.0 / 3.0) / floor_.z, alone = 1.0 - smoothstep(0.63, 0.80, wide);
  p.radii *= mix(1.0, drop_size, alone);
  vec3 middle = (view * vec4(p.centre, 1.0)).xyz;
  float stretch, away = -middle.z;
  mat3 axes = stretched(axes_of(p, turn_of(p.rotation)), motion_of(i), alone, stretch);
  float reach = stretch * longest(p.radii);
  if (!is_seen(middle, reach)) return;
  uint least = floatBitsToUint(0.9999 * (away - reach));
  if (is_hidden(in_tile(pixels_of_ball(middle, reach), corner), least)) return;
  ivec4 pixels = in_tile(pixels_of(axes, reach, middle), corner);
  if (is_hidden(pixels, least)) return;

  mat3 inverse_axes = inverse(axes);
  vec2 pixel = 2.0 * viewport.zw * lens.xy, place = (middle.xy / away + lens.xy) / pixel - 0.5 - vec2(corner);
  vec3 to_middle = inverse_axes * (middle / away), x = inverse_axes[0] * pixel.x, y = inverse_axes[1] * pixel.y;
  // A drop on its own is to keep its shape.
  uint share = uint(mix(0.2, 1.0, smoothstep(0.65, 0.95, wide)) * float(share_bits) + 0.5);
  uint rectangle = uint(pixels.x) | uint(pixels.y) << 8 | uint(pixels.z) << 16 | uint(pixels.w) << 24;
  uint vessel = clipping_vessel(p.centre, reach);
  uint place_ = vessel == 0u ? atomicAdd(picture_count, 1u) : round_size - 1u - atomicAdd(cut_count, 1u);
  pictures[place_] =
      Picture(vec4(place, away, dot(to_middle, to_middle)),
              vec4(dot(to_middle, x), dot(to_middle, y), uintBitsToFloat(least), uintBitsToFloat(share)),
              vec4(form(x, y), uintBitsToFloat(rectangle)),
              vec4(form(away * cross(to_middle, x), away * cross(to_middle, y)), uintBitsToFloat(vessel)));
}

// A row's threads side by side. `is_cut`: walls may cut it.
void draw(Picture p, bool is_cut, ivec2 corner, int thread) {
  ivec4 pixels = ivec4(uvec4(floatBitsToUint(p.square.w)) >> uvec4(0, 8, 16, 24) & 255u);
  uint least = floatBitsToUint(p.slope.z), share = floatBitsToUint(p.slope.w), vessel = floatBitsToUint(p.across.w);
  for (int y = pixels.y + thread / 8; y <= pixels.w; y += 4) {
    for (int x = pixels.x + thread % 8; x <= pixels.z; x += 8) {
      if (nearest[y * size + x] < least || p.place.z < begins[y * size + x]) continue;
      vec2 d = vec2(x, y) - p.place.xy;
      vec3 products = vec3(d.x * d.x, d.x * d.y, d.y * d.y);
      float along = p.place.w + dot(p.slope.xy, d), square = along + dot(p.slope.xy, d) + dot(p.square.xyz, products);
      float inside = square - dot(p.across.xyz, products);
      if (inside < 0.0) continue;
      float root = sqrt(inside), distance = (p.place.z * along - root) / square;
      if (is_cut && !clip_at_walls(vessel - 1u, world_ray(vec2(corner + ivec2(x, y))), distance,
                                        (p.place.z * along + root) / square))
        continue;
      atomicMin(nearest[y * size + x], (floatBitsToUint(distance) & ~share_bits) | share);
    }
  }
}

void find_farthest() {
  for (uint k = gl_LocalInvocationID.x; k < uint(blocks * blocks); k += group_size) farthest[k] = 0u;
  if (gl_LocalInvocationID.x == 0u) picture_count = cut_count = 0u;
  barrier();
  // Of four pixels a thread.
  int x = int(gl_LocalInvocationID.x) % size, y = int(gl_LocalInvocationID.x) / size * 4;
  uint most = 0u;
  for (int k = 0; k < 4; ++k) most = max(most, nearest[(y + k) * size + x]);
  atomicMax(farthest[y / block * blocks + x / block], most);
  barrier();
}

// As of the rest in most tiles.
bool shows_nothing() {
  uint most = 0u;
  for (int k = 0; k < blocks * blocks; ++k) most = max(most, farthest[k]);
  return most == 0u;
}

// From front to back: after the first, most of what is inside of the fluid is hidden.
void draw_list(int list, ivec2 corner) {
  uint begin = list_begin(list), end = begin + list_count(list), self = gl_LocalInvocationID.x;
  for (; begin < end; begin += round_size) {
    if (self < min(round_size, end - begin)) look_at(tile_entries[begin + self], corner);
    barrier();
    uint count = picture_count, cut = round_size - cut_count;
    // Apart, since Mesa's rasteriser skips loops but no branches.
    for (uint k = self / row; k < count; k += group_size / row) draw(pictures[k], false, corner, int(self % row));
    for (uint k = cut + self / row; k < round_size; k += group_size / row)
      draw(pictures[k], true, corner, int(self % row));
    barrier();
    if (count > 0u || cut < round_size) find_farthest();
  }
}

void put(ivec2 pixel, float found) {
  if (all(lessThan(pixel, ivec2(viewport.xy)))) found_surface[place_of(pixel)] = found;
}

float marked(ivec2 pixel, float begin, uint found) {
  if (begin == 0.0) return without_share(fluid_surface[place_of(min(pixel, ivec2(viewport.xy) - 1))]);
  if (found >= limit_at(pixel, begin)) return nothing;
  return uintBitsToFloat(float(found & share_bits) < 0.6 * float(share_bits) ? found | drop_bit : found);
}

void main() {
  int own = int(gl_WorkGroupID.y) * tiles.x + int(gl_WorkGroupID.x), all = tiles.x * tiles.y;
  int first = int(gl_LocalInvocationID.x);
  ivec2 corner = ivec2(gl_WorkGroupID.xy) * size;
  if (list_count(own) + list_count(all) == 0u) {
    for (int k = first; k < size * size; k += int(group_size))
      put(corner + ivec2(k % size, k / size), nothing);
    return;
  }
  for (int k = first; k < size * size; k += int(group_size)) {
    ivec2 pixel = corner + ivec2(k % size, k / size);
    begins[k] = rest_begin(pixel);
    nearest[k] = limit_at(pixel, begins[k]);
  }
  barrier();
  find_farthest();
  if (!shows_nothing()) {
    draw_list(all, corner);
    draw_list(own, corner);
  }
  for (int k = first; k < size * size; k += int(group_size)) {
    ivec2 pixel = corner + ivec2(k % size, k / size);
    put(pixel, marked(pixel, begins[k], nearest[k]));
  }
}
