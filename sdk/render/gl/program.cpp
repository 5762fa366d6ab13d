// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#include "sdk/render/gl/program.h"

#include <meniscus/error.h>

#include <string>

#include "sdk/render/gl/shader_text.h"

namespace meniscus::render {
namespace {

GLuint compiled(GLenum stage, const char* file) {
  const std::string text = shader_text(file);
  const char* source = text.c_str();
  const GLuint shader = glCreateShader(stage);
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  GLint good = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
  if (good) return shader;
  char log[2048] = "";
  glGetShaderInfoLog(shader, sizeof log, nullptr, log);
  glDeleteShader(shader);
  throw Error(ErrorCode::device, std::string("OpenGL refuses the shader ") + file + ": " + log);
}

}  // namespace

Program::Program(const char* vertex, const char* fragment) : handle_(glCreateProgram()) {
  for (const auto& [stage, file] : {std::pair(GL_VERTEX_SHADER, vertex), {GL_FRAGMENT_SHADER, fragment}}) {
    const GLuint shader = compiled(static_cast<GLenum>(stage), file);
    glAttachShader(handle_, shader);
    glDeleteShader(shader);  // as soon as the program lets go of it
  }
  glLinkProgram(handle_);
  GLint good = 0;
  glGetProgramiv(handle_, GL_LINK_STATUS, &good);
  if (good) return;
  char log[2048] = "";
  glGetProgramInfoLog(handle_, sizeof log, nullptr, log);
  throw Error(ErrorCode::device,
              std::string("OpenGL cannot link ") + vertex + " and " + fragment + ": " + log);
}

}  // namespace meniscus::render
