// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#version 450 core
// Spray, foam and bubbles over the picture: white, in the light that comes there; what is behind the surface is
// dyed by the fluid before it.
#include "shared/frame.glsl"
#include "light/sky.glsl"
#include "light/shadow.glsl"
#include "fluid/fluid_depth.glsl"
layout(binding = 2) uniform sampler2D foam_sums;
layout(binding = 3) uniform sampler2D scene_distance;
layout(binding = 5) uniform sampler2D thickness_map;  // absorbance; metres
in vec2 place;
layout(location = 0) out vec4 color;  // times its opacity

// Over three pixels each way: one piece alone is a haze rather than a grain of salt.
vec3 smoothed_sums(ivec2 pixel) {
  vec3 sums = vec3(0.0);
  ivec2 last = textureSize(foam_sums, 0) - 1;
  for (int y = -1; y <= 1; ++y) {
    for (int x = -1; x <= 1; ++x)
      sums += float((2 - abs(x)) * (2 - abs(y))) * texelFetch(foam_sums, clamp(pixel + ivec2(x, y), ivec2(0), last), 0).rgb;
  }
  return sums / 16.0;
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec3 sums = smoothed_sums(pixel);
  if (sums.r + sums.g <= 0.0) discard;
  float surface = fluid_depth(pixel);
  float z = surface > 0.0 ? surface : min(texelFetch(scene_distance, pixel, 0).r, lens.w);
  vec3 world = (camera_to_world * vec4(z * view_ray(place), 1.0)).xyz;
  vec3 white = 0.9 * (ambient_light(up.xyz) + 0.32 * sun_light * (surface > 0.0 ? sun_on(world, up.xyz) : vec3(1.0)));

  vec4 depths = texture(thickness_map, place);
  vec3 absorption = depths.rgb / max(depths.a, 1e-6);
  vec3 dyed = white * exp(-2.0 * absorption * (sums.b / max(sums.g, 1e-6) + floor_.z));
  float front = 1.0 - exp(-sums.r), back = 0.55 * (1.0 - exp(-sums.g)) * (1.0 - front);
  color = vec4(front * white + back * dyed, front + back);
}
