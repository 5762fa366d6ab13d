// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#version 450 core
// The fluid's surface as the sun sees it, smoothed along one axis of the map: a particle's disc would be a lens of its
// own. 2 where there is none.
#include "shared/frame.glsl"
layout(local_size_x = 16, local_size_y = 16) in;
layout(binding = 2) uniform sampler2D depths;
layout(binding = 0, r32f) writeonly restrict uniform image2D smoothed;
layout(location = 0) uniform ivec2 axis;
layout(location = 1) uniform int channel;  // of the depths

float depth_at(ivec2 texel) {
  float depth = texelFetch(depths, texel, 0)[channel];
  return depth < 1.0 ? depth : 2.0;
}

void main() {
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy), last = textureSize(depths, 0) - 1;
  float texels = floor_.z / to_sun.w * 0.5 * float(last.x + 1), wide = 2.2 * texels;  // of a spacing; of the Gaussian
  int reach = int(min(2.0 * wide, 40.0));
  float here = depth_at(texel), sum = 0.0, weights = 0.0;
  for (int k = -reach; k <= reach && here < 1.0; ++k) {
    float depth = depth_at(clamp(texel + k * axis, ivec2(0), last));
    // What is two spacings deeper is another surface.
    if (abs(depth - here) * 2.0 * to_sun.w > 2.0 * floor_.z) continue;
    float weight = exp(-0.5 * float(k * k) / (wide * wide));
    sum += weight * depth;
    weights += weight;
  }
  imageStore(smoothed, texel, vec4(weights > 0.0 ? sum / weights : 2.0));
}
