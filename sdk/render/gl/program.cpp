// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Compiles, links and dispatches shaders.
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
  add(GL_VERTEX_SHADER, vertex);
  add(GL_FRAGMENT_SHADER, fragment);
  link(std::string(vertex) + " and " + fragment);
}

Program::Program(const char* compute) : handle_(glCreateProgram()) {
  add(GL_COMPUTE_SHADER, compute);
  link(compute);
}

void Program::add(GLenum stage, const char* file) {
  const GLuint shader = compiled(stage, file);
  glAttachShader(handle_, shader);
  glDeleteShader(shader);  // deleted once the program releases it
}

void Program::link(const std::string& files) {
  glLinkProgram(handle_);
  GLint good = 0;
  glGetProgramiv(handle_, GL_LINK_STATUS, &good);
  if (good) return;
  char log[2048] = "";
  glGetProgramInfoLog(handle_, sizeof log, nullptr, log);
  throw Error(ErrorCode::device, "OpenGL cannot link " + files + ": " + log);
}

void Program::start(int groups_x, int groups_y) const {
  glDispatchCompute(static_cast<GLuint>(groups_x), static_cast<GLuint>(groups_y), 1);
}

void Program::show_writes() {
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT |
                  GL_TEXTURE_FETCH_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT |
                  GL_TEXTURE_UPDATE_BARRIER_BIT);
}

void Program::start_over(const Texture& image) const {
  constexpr int side = 16;
  image.bind_image(0);
  start((image.width() + side - 1) / side, (image.height() + side - 1) / side);
}

}  // namespace meniscus::render
