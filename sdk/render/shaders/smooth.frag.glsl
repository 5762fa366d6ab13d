// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#version 450 core
// Takes the steps out of edges, along which it averages (after Lottes's FXAA).
layout(binding = 2) uniform sampler2D image;  // a: luma
in vec2 place;
layout(location = 0) out vec4 color;

void main() {
  vec2 texel = 1.0 / vec2(textureSize(image, 0));
  vec4 here = texture(image, place);
  float a = textureOffset(image, place, ivec2(-1, -1)).a, b = textureOffset(image, place, ivec2(1, -1)).a;
  float c = textureOffset(image, place, ivec2(-1, 1)).a, d = textureOffset(image, place, ivec2(1, 1)).a;
  float low = min(here.a, min(min(a, b), min(c, d))), high = max(here.a, max(max(a, b), max(c, d)));
  color = here;
  if (high - low < max(0.03, 0.10 * high)) return;
  vec2 along = vec2((c + d) - (a + b), (a + c) - (b + d));
  float least = min(abs(along.x), abs(along.y)) + max(0.03 * (a + b + c + d), 0.008);
  along = clamp(along / least, -8.0, 8.0) * texel;
  vec4 near = 0.5 * (texture(image, place - along / 6.0) + texture(image, place + along / 6.0));
  vec4 far = 0.5 * near + 0.25 * (texture(image, place - 0.5 * along) + texture(image, place + 0.5 * along));
  color = far.a < low || far.a > high ? near : far;
}
