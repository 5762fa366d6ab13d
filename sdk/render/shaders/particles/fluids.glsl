// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
// The looks of fluids and granular materials; see sdk/render/frame/uniforms.h.
layout(std140, binding = 1) uniform Fluids {
  vec4 looks[1024];
};

layout(std140, binding = 2) uniform Extinctions {
  vec4 extinctions[1024];
};
layout(std140, binding = 3) uniform Glows {
  vec4 glows[1024];
};

const vec4 nowhere = vec4(0.0, 0.0, 2.0, 1.0);  // in clip space: what is not drawn

vec4 look_of(uint fluid) {
  return looks[min(fluid, 1023u)];
}
vec3 extinction_of(uint fluid) {
  return extinctions[min(fluid, 1023u)].rgb;
}
vec3 glow_of(uint fluid) {
  return glows[min(fluid, 1023u)].rgb;
}
bool is_grain(uint fluid) {
  return look_of(fluid).w > 0.5;
}
