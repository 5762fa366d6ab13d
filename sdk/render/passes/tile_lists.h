// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include "sdk/render/passes/particles.h"

namespace meniscus::render {

/// Which particles may cover some of each tile of a picture, so that one group of threads can draw a tile in
/// its own fast memory: counted, summed up and listed on the GPU. A list's strands follow one another, which
/// the shader chooses; else it is in no order.
class TileLists {
 public:
  /// By a shader that includes shaders/tiles/list.glsl and knows what a particle covers.
  TileLists(const char* shader, int tile_size) : list_(shader), tile_size_(tile_size) {}

  /// Of a picture of this size in pixels. `radius` of the discs, m.
  void set(int width, int height, float radius);
  /// Of all of these pictures, side by side.
  static void build(std::span<TileLists* const> all, const Particles& particles);
  /// Starts a program that is in use, with so many groups of threads along the sides of a tile; its uniform 0
  /// is the tiles' number.
  void start(const Program& program, int groups = 1) const;

 private:
  void reserve(const Particles& particles);
  void clear_cursors();
  void bind() const;
  void list(const Particles& particles, bool writes) const;
  void allot() const;
  int lists() const { return across_ * down_ + 1; }

  Program list_, allot_{"tiles/allot.comp.glsl"};
  int tile_size_;
  int across_ = 0, down_ = 0;
  float radius_ = 0;
  DataBuffer starts_, cursors_, entries_;
  DataBuffer next_cursors_;  // of the next picture
  int cleared_ = 0;          // how many lists' cursors are 0 where a picture begins
};

}  // namespace meniscus::render
