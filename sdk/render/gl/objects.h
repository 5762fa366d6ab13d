// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Owners of OpenGL objects. Each deletes its object, and needs the context that made it to be current.
#pragma once

#include <epoxy/gl.h>

#include <cstddef>
#include <span>
#include <utility>

namespace meniscus::render {

/// The name of one OpenGL object.
template <void (*destroy)(GLuint)>
class Handle {
 public:
  Handle() = default;
  explicit Handle(GLuint name) : name_(name) {}
  Handle(Handle&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(name_, other.name_);
    return *this;
  }
  ~Handle() {
    if (name_) destroy(name_);
  }

  operator GLuint() const { return name_; }

 private:
  GLuint name_ = 0;
};

void delete_buffer(GLuint name);
void delete_texture(GLuint name);
void delete_framebuffer(GLuint name);
void delete_vertex_array(GLuint name);
void delete_program(GLuint name);
void delete_sampler(GLuint name);

using BufferHandle = Handle<delete_buffer>;
using TextureHandle = Handle<delete_texture>;
using FramebufferHandle = Handle<delete_framebuffer>;
using VertexArrayHandle = Handle<delete_vertex_array>;
using ProgramHandle = Handle<delete_program>;
using SamplerHandle = Handle<delete_sampler>;

/// An array in GPU memory, which is always rewritten as a whole.
class DataBuffer {
 public:
  DataBuffer();

  template <class T>
  void write(std::span<const T> values) {
    write_bytes(values.data(), values.size_bytes());
  }
  /// Resizes to this many bytes; the contents are lost.
  void resize(std::size_t bytes);
  /// Resizes to at least this many bytes; the contents are lost if it grows.
  void reserve(std::size_t bytes) {
    if (bytes > room_) resize(bytes);
  }
  GLuint name() const { return handle_; }

 private:
  void write_bytes(const void* data, std::size_t bytes);

  BufferHandle handle_;
  std::size_t room_ = 0;
};

/// A 2D texture of one format, without mipmaps, clamped to its edges.
class Texture {
 public:
  Texture(GLenum format, int width, int height, GLenum filter = GL_NEAREST);

  GLuint name() const { return handle_; }
  int width() const { return width_; }
  int height() const { return height_; }
  void bind(GLuint unit) const { glBindTextureUnit(unit, handle_); }
  /// Binds it for compute shaders to write to, or for GL_READ_WRITE.
  void bind_image(unsigned unit, GLenum access = GL_WRITE_ONLY) const {
    glBindImageTexture(unit, handle_, 0, GL_FALSE, 0, access, format_);
  }
  /// For depth textures: sampling compares depths, and returns the fraction that is nearer.
  void compare_depths();

 private:
  TextureHandle handle_;
  GLenum format_;
  int width_, height_;
};

/// A framebuffer of a pass: colours, a depth, or both. All textures have one size, and must outlive it.
class Target {
 public:
  Target(std::initializer_list<const Texture*> colors, const Texture* depth);

  /// Makes it the current target, with the viewport over all of it.
  void use() const;
  void clear_color(int index, float r, float g, float b, float a) const;
  void clear_depth() const;
  GLuint name() const { return handle_; }

 private:
  FramebufferHandle handle_;
  int width_ = 0, height_ = 0;
};

/// An empty vertex array, for shaders that make their own vertices.
VertexArrayHandle make_vertex_array();
/// Reads texels as they are, also those of depth textures that compare depths otherwise.
SamplerHandle make_plain_sampler();

}  // namespace meniscus::render
