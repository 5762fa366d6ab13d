// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#version 450 core
// Fluid over what is behind it: what it mirrors (Fresnel, by Schlick), what it lets through, bent and dyed
// (Beer and Lambert), and what its depths send back. The rest is drawn first, over the scene, and then the front layer,
// over that.
#include "shared/frame.glsl"
#include "light/sky.glsl"
#include "light/shadow.glsl"
#include "light/material.glsl"
#include "light/ground.glsl"
#include "light/ground_color.glsl"
#include "fluid/surface.glsl"
#include "fluid/front_and_rest.glsl"
layout(local_size_x = 64) in;  // of 16 × 16 pixels; see Program::start_over
layout(binding = 2) uniform sampler2D scene_color;
layout(binding = 3) uniform sampler2D scene_distance;
layout(location = 0) uniform int layer;  // 0: the front; 1: the rest
layout(binding = 0, rgba16f) writeonly restrict uniform image2D lit_color;

const float index = 1.333, f0 = 0.02;
const int side = 16, group_size = 64;
shared int shown[side * side];  // pixels that show the layer
shared int shown_count;

// At so many metres from the eye.
vec3 mirrored(vec3 world, vec3 direction, float away) {
  float along;
  if (!meets_ground(world, direction, along)) return sky(direction);
  // Of what a pixel shows of the ground, about: surfaces are not flat.
  float wide = 6.0 * lens.y * viewport.w * (away + along) / max(-dot(ground.xyz, direction), 0.02);
  return ground_color(world + along * direction, direction, vec2(wide / floor_.x), 1.0);
}

// Whether what lies behind is drawn at a pixel, as it is not where the first surface belongs to what lies behind.
bool shows_behind(vec2 place, float z, float end) {
  float first = fluid_depth(ivec2(place * viewport.xy));
  return textureLod(scene_distance, place, 0.0).r > z && (layer == 1 || first < end);
}

// What is seen through the surface at `here` (view space), after `metres` of fluid that end at the distance `end`.
vec3 behind(vec3 here, vec3 normal, float metres, vec2 place, float end) {
  vec3 bent = refract(normalize(here), normal, 1.0 / index);
  // Even the thinnest drop bends what is behind it.
  vec3 there = here + min(metres + 2.0 * floor_.z, 0.5 * floor_.y) * bent;
  vec2 at = clamp(0.5 + 0.5 * there.xy / (-there.z * lens.xy), 0.0, 1.0);
  return textureLod(scene_color, shows_behind(at, -here.z, end) ? at : place, 0.0).rgb;
}

// By how much the normal turns from this pixel to the next, squared, about. An edge does not count.
float bend_at(ivec2 pixel, float z) {
  vec2 bends = vec2(0.0);
  for (int axis = 0; axis < 2; ++axis) {
    ivec2 step = ivec2(1 - axis, axis);
    float a = fluid_depth(pixel - step), b = fluid_depth(pixel + step);
    if (max(abs(a - z), abs(b - z)) > 2.0 * floor_.z) a = b = z;
    bends[axis] = (a + b - 2.0 * z) / (2.0 * z * lens[axis] * viewport[2 + axis]);
  }
  return dot(bends, bends);
}

// The sun as a smooth surface mirrors it: a lobe, wider and fainter by as much as the surface is bent within a pixel
// (Kaplanyan, Hill, Patney & Lefohn 2016). Else small drops would sparkle by chance.
float highlight(float facing, float bend) {
  const float power = 700.0;
  float wider = power / (1.0 + 0.5 * power * bend);
  return (wider / power) * (wider / power) * pow(facing, wider);
}

// Of a pixel that shows the layer.
vec3 color_at(ivec2 pixel) {
  float z = fluid_depth(pixel);
  vec2 place = (vec2(pixel) + 0.5) * viewport.zw;
  vec3 here = surface_point(pixel, z), view_normal = surface_normal(pixel, z);
  vec3 world = (camera_to_world * vec4(here, 1.0)).xyz;
  vec3 n = mat3(camera_to_world) * view_normal, to_eye = normalize(eye.xyz - world);
  vec3 scatter;
  vec4 depths = layer_at(pixel, z, layer == 1, scatter);
  depths *= max(depths.a, floor_.z) / max(depths.a, 1e-6);  // no surface without a particle behind it
  vec3 passed = exp(-depths.rgb);
  vec3 sun = sun_light * sun_on(world, n);

  vec3 glow = scatter * (0.35 * ambient_light(n) + 0.12 * sun * (0.5 + 0.5 * dot(n, to_sun.xyz)));
  vec3 through = behind(here, view_normal, depths.a, place, front_end(texel_of(pixel))) * passed + glow * (1.0 - passed);

  float facing = clamp(dot(n, to_eye), 0.0, 1.0);
  float fresnel = f0 + (1.0 - f0) * pow(1.0 - facing, 5.0);
  float shine = highlight(max(dot(n, normalize(to_sun.xyz + to_eye)), 0.0), bend_at(pixel, z));
  return mix(through, mirrored(world, reflect(-to_eye, n), length(here)), fresnel) + 3.5 * shine * sun;
}

void put(ivec2 pixel, vec3 color) {
  imageStore(lit_color, pixel, vec4(color, 1.0));
}

// First the pixels are found that show the layer. Mesa's rasteriser skips loops but no branches.
void main() {
  int self = int(gl_LocalInvocationID.x);
  ivec2 corner = ivec2(gl_WorkGroupID.xy) * side;
  if (self == 0) shown_count = 0;
  barrier();
  for (int k = self; k < side * side; k += group_size) {
    ivec2 pixel = corner + ivec2(k % side, k / side);
    if (any(greaterThanEqual(pixel, ivec2(viewport.xy)))) continue;
    if (shows_layer(pixel))
      shown[atomicAdd(shown_count, 1)] = k;
    else
      put(pixel, texelFetch(scene_color, pixel, 0).rgb);
  }
  barrier();
  for (int k = self; k < shown_count; k += group_size) {
    ivec2 pixel = corner + ivec2(shown[k] % side, shown[k] / side);
    put(pixel, color_at(pixel));
  }
}
