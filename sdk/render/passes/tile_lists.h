// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Lists of the particles that may cover each tile of a picture.
#pragma once

#include "sdk/render/passes/particles.h"

namespace meniscus::render {

/// Lists of the particles that may cover each tile of a picture. With them, one group of threads can draw a
/// tile in its own fast memory. The GPU counts, sums and lists the particles. The shader assigns the entries
/// of a list to strands, which are in order; within a strand there is no order.
class TileLists {
 public:
  /// The lists are made by a shader that includes shaders/tiles/list.glsl and knows what a particle covers.
  TileLists(const char* shader, int tile_size) : list_(shader), tile_size_(tile_size) {}

  /// Sets the size of the picture in pixels. `radius` of the discs, m.
  void set(int width, int height, float radius);
  /// Builds the lists of all these pictures concurrently.
  static void build(std::span<TileLists* const> all, const Particles& particles);
  /// Starts a program that is in use, with this many groups of threads along the sides of a tile. Its uniform
  /// 0 is the number of tiles.
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
  int cleared_ = 0;          // number of lists whose cursors are 0 when a picture begins
};

}  // namespace meniscus::render
