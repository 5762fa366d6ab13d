// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include "sdk/render/gl/objects.h"

namespace meniscus::render {

/// A vertex and a fragment shader. Uniforms have fixed places, given in the shaders.
class Program {
 public:
  /// Names of files in sdk/render/shaders. Throws Error(device) with the compiler's words where the driver
  /// refuses them.
  Program(const char* vertex, const char* fragment);

  void use() const { glUseProgram(handle_); }
  GLuint name() const { return handle_; }

 private:
  ProgramHandle handle_;
};

}  // namespace meniscus::render
