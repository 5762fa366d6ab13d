// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// OpenGL shader programs.
#pragma once

#include <string>

#include "sdk/render/gl/objects.h"

namespace meniscus::render {

/// A vertex and a fragment shader, or a compute shader. Uniforms have fixed locations, which the shaders
/// give.
class Program {
 public:
  /// The arguments are names of files in sdk/render/shaders. Throws Error(device) with the compiler's message
  /// if the driver refuses them.
  Program(const char* vertex, const char* fragment);

  explicit Program(const char* compute);

  /// Starts the compute shader, which must be in use, in this many groups of threads. Later commands see its
  /// writes only after show_writes(), and may run concurrently until then.
  void start(int groups_x, int groups_y = 1) const;
  static void show_writes();
  /// The same for each pixel of `image`, which is bound as image 0 for writing: see
  /// shaders/shared/pixels.glsl.
  void start_over(const Texture& image) const;
  void run_over(const Texture& image) const {
    start_over(image);
    show_writes();
  }
  void use() const { glUseProgram(handle_); }
  GLuint name() const { return handle_; }

 private:
  void add(GLenum stage, const char* file);
  void link(const std::string& files);

  ProgramHandle handle_;
};

}  // namespace meniscus::render
