// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
// The looks of the fluids; see sdk/render/uniforms.h.
layout(std140, binding = 1) uniform Fluids {
  vec4 absorption[16];
};
