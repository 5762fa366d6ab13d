// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#version 450 core
#include "shared/frame.glsl"
layout(location = 0) in vec3 position;
layout(location = 0) uniform mat4 model;

void main() {
  gl_Position = world_to_sun * model * vec4(position, 1.0);
}
