// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Creates and deletes OpenGL objects.
#include "sdk/render/gl/objects.h"

#include <meniscus/error.h>

#include <string>
#include <vector>

namespace meniscus::render {

void delete_buffer(GLuint name) {
  glDeleteBuffers(1, &name);
}
void delete_texture(GLuint name) {
  glDeleteTextures(1, &name);
}
void delete_framebuffer(GLuint name) {
  glDeleteFramebuffers(1, &name);
}
void delete_vertex_array(GLuint name) {
  glDeleteVertexArrays(1, &name);
}
void delete_program(GLuint name) {
  glDeleteProgram(name);
}
void delete_sampler(GLuint name) {
  glDeleteSamplers(1, &name);
}

DataBuffer::DataBuffer() {
  GLuint name = 0;
  glCreateBuffers(1, &name);
  handle_ = BufferHandle(name);
}

void DataBuffer::write_bytes(const void* data, std::size_t bytes) {
  if (bytes == 0) return;
  glNamedBufferData(handle_, static_cast<GLsizeiptr>(bytes), data, GL_STREAM_DRAW);
  room_ = bytes;
}

void DataBuffer::resize(std::size_t bytes) {
  glNamedBufferData(handle_, static_cast<GLsizeiptr>(bytes), nullptr, GL_DYNAMIC_COPY);
  room_ = bytes;
}

Texture::Texture(GLenum format, int width, int height, GLenum filter)
    : format_(format), width_(width), height_(height) {
  GLuint name = 0;
  glCreateTextures(GL_TEXTURE_2D, 1, &name);
  handle_ = TextureHandle(name);
  glTextureStorage2D(name, 1, format, width, height);
  glTextureParameteri(name, GL_TEXTURE_MIN_FILTER, static_cast<GLint>(filter));
  glTextureParameteri(name, GL_TEXTURE_MAG_FILTER, static_cast<GLint>(filter));
  glTextureParameteri(name, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTextureParameteri(name, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

void Texture::compare_depths() {
  glTextureParameteri(handle_, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  glTextureParameteri(handle_, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
}

Target::Target(std::initializer_list<const Texture*> colors, const Texture* depth) {
  GLuint name = 0;
  glCreateFramebuffers(1, &name);
  handle_ = FramebufferHandle(name);
  std::vector<GLenum> attachments;
  const auto attach = [&](GLenum place, const Texture& texture) {
    glNamedFramebufferTexture(name, place, texture.name(), 0);
    width_ = texture.width();
    height_ = texture.height();
  };
  for (const Texture* color : colors) {
    attachments.push_back(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(attachments.size()));
    attach(attachments.back(), *color);
  }
  if (depth) attach(GL_DEPTH_ATTACHMENT, *depth);
  glNamedFramebufferDrawBuffers(name, static_cast<GLsizei>(attachments.size()), attachments.data());
  const GLenum status = glCheckNamedFramebufferStatus(name, GL_FRAMEBUFFER);
  if (status != GL_FRAMEBUFFER_COMPLETE) {
    throw Error(ErrorCode::device, "OpenGL cannot draw into pictures of " + std::to_string(width_) + " x " +
                                       std::to_string(height_) + " pixels (framebuffer status " +
                                       std::to_string(status) + ")");
  }
}

void Target::use() const {
  glBindFramebuffer(GL_FRAMEBUFFER, handle_);
  glViewport(0, 0, width_, height_);
}

void Target::clear_color(int index, float r, float g, float b, float a) const {
  const float color[] = {r, g, b, a};
  glClearNamedFramebufferfv(handle_, GL_COLOR, index, color);
}

void Target::clear_depth() const {
  const float far = 1;
  glClearNamedFramebufferfv(handle_, GL_DEPTH, 0, &far);
}

SamplerHandle make_plain_sampler() {
  GLuint name = 0;
  glCreateSamplers(1, &name);
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    glSamplerParameteri(name, filter, GL_NEAREST);
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
    glSamplerParameteri(name, wrap, GL_CLAMP_TO_EDGE);
  return SamplerHandle(name);
}

VertexArrayHandle make_vertex_array() {
  GLuint name = 0;
  glCreateVertexArrays(1, &name);
  return VertexArrayHandle(name);
}

}  // namespace meniscus::render
