// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#version 450 core
// Spray, foam and bubbles of a layer over its picture: white, in the light that comes there; what is behind the layer's
// surface is dyed by the layer's fluid before it.
#include "shared/frame.glsl"
#include "light/sky.glsl"
#include "light/shadow.glsl"
#include "fluid/fluid_depth.glsl"
#include "fluid/rest_depth.glsl"
#include "fluid/front_and_rest.glsl"
layout(binding = 3) uniform sampler2D scene_distance;
layout(binding = 4) uniform sampler2D front_foam;  // half as many pixels each way
layout(binding = 11) uniform sampler2D rest_foam;
layout(location = 0) uniform int layer;           // 0: the front; 1: the rest
in vec2 place;
layout(location = 0) out vec4 color;  // times its opacity

// Of the quadratic B-spline, for the three texels around a place that is `f` from the middle one.
vec3 spline(float f) {
  return vec3(0.5 * (0.5 - f) * (0.5 - f), 0.75 - f * f, 0.5 * (0.5 + f) * (0.5 + f));
}

// Of one texel, as of the layer that has the surface; `found`: where that layer is there.
vec3 sums_at(ivec2 texel, float surface, out float found) {
  float rest = rest_depth(2 * texel);
  bool is_rest = rest > 0.0 && (layer == 1 || surface > front_end(texel));
  found = is_rest ? rest : fluid_depth(2 * texel);
  return is_rest ? texelFetch(rest_foam, texel, 0).rgb : texelFetch(front_foam, texel, 0).rgb;
}

// Smoothed over three texels each way, of those that show the same surface.
vec3 smoothed_sums(ivec2 pixel, float surface) {
  vec2 at = 0.5 * vec2(pixel) - 0.25, middle = floor(at + 0.5);
  vec3 across = spline(at.x - middle.x), up_ = spline(at.y - middle.y), sums = vec3(0.0);
  ivec2 last = textureSize(front_foam, 0) - 1;
  float weights = 1e-9;
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 3; ++x) {
      ivec2 texel = clamp(ivec2(middle) + ivec2(x, y) - 1, ivec2(0), last);
      float found;
      vec3 here = sums_at(texel, surface, found);
      float apart = (found - surface) / (2.0 * floor_.z);
      float weight = across[x] * up_[y] * (exp(-apart * apart) + 1e-6);
      sums += weight * here;
      weights += weight;
    }
  }
  return sums / weights;
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  float surface = layer == 1 ? rest_depth(pixel) : fluid_depth(pixel);
  if (layer == 1 && surface <= 0.0) discard;
  vec3 sums = smoothed_sums(pixel, surface);
  if (sums.r + sums.g <= 1e-4) discard;
  float z = surface > 0.0 ? surface : min(texelFetch(scene_distance, pixel, 0).r, lens.w);
  vec3 world = (camera_to_world * vec4(z * view_ray(place), 1.0)).xyz;
  vec3 white = 0.9 * (ambient_light(up.xyz) + 0.32 * sun_light * (surface > 0.0 ? sun_on(world, up.xyz) : vec3(1.0)));

  vec3 glow;
  vec4 depths = layer_at(pixel, z, layer == 1, glow);
  vec3 absorption = depths.rgb / max(depths.a, 1e-6);
  vec3 dyed = white * exp(-2.0 * absorption * (sums.b / max(sums.g, 1e-6) + floor_.z));
  float front = 1.0 - exp(-sums.r), back = 0.55 * (1.0 - exp(-sums.g)) * (1.0 - front);
  color = vec4(front * white + back * dyed, front + back);
}
