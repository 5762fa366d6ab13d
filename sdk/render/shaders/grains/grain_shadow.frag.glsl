// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#version 450 core
in vec2 offset;

void main() {
  if (dot(offset, offset) > 1.0) discard;
}
