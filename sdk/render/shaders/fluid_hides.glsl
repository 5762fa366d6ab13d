// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
// Whether the fluid is before this fragment, or at it.
layout(binding = 4) uniform sampler2D fluid_depth;

bool is_in_fluid() {
  float z = texelFetch(fluid_depth, ivec2(gl_FragCoord.xy), 0).r;
  return z > 0.0 && to_window_depth(z) <= gl_FragCoord.z;
}
