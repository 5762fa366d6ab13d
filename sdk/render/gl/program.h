// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "sdk/render/gl/objects.h"

namespace meniscus::render {

/// A vertex and a fragment shader, or a compute shader. Uniforms have fixed places, given in the shaders.
class Program {
 public:
  /// Names of files in sdk/render/shaders. Throws Error(device) with the compiler's words where the driver
  /// refuses them.
  Program(const char* vertex, const char* fragment);

  explicit Program(const char* compute);

  /// Starts the compute shader, which is in use, in so many groups of threads. What comes after sees what it
  /// wrote once show_writes() has been called, and may run beside it until then.
  void start(int groups_x, int groups_y = 1) const;
  static void show_writes();
  /// The same, with image 0 to write to, for each of its pixels: see shaders/shared/pixels.glsl.
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
