// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#version 450 core
#include "shared/frame.glsl"
#include "views/hidden.glsl"
flat in vec3 paint;
layout(location = 0) out vec4 color;

void main() {
  if (is_hidden()) discard;
  color = vec4(paint, 1.0);
}
