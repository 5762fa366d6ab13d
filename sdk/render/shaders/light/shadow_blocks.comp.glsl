// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#version 450 core
// The least and the greatest depth of each block of 8 × 8 texels of the shadow map.
layout(local_size_x = 16, local_size_y = 16) in;
layout(binding = 13) uniform sampler2D shadow_depths;
layout(binding = 0, rg32f) writeonly restrict uniform image2D spans;
const int block = 8;

void main() {
  ivec2 place = ivec2(gl_GlobalInvocationID.xy);
  vec2 texel = 1.0 / vec2(textureSize(shadow_depths, 0)), span = vec2(1.0, 0.0);
  for (int k = 0; k < block * block / 4; ++k) {
    vec2 corner = vec2(block * place + 2 * ivec2(k % (block / 2), k / (block / 2)) + 1);
    vec4 depths = textureGather(shadow_depths, corner * texel);
    span.x = min(span.x, min(min(depths.x, depths.y), min(depths.z, depths.w)));
    span.y = max(span.y, max(max(depths.x, depths.y), max(depths.z, depths.w)));
  }
  imageStore(spans, place, vec4(span, 0.0, 0.0));
}
