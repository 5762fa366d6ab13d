// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include "sdk/render/passes/particles.h"

namespace meniscus::render {

/// Which particles may cover some of each tile of a picture, so that one group of threads can draw a tile in
/// its own fast memory: counted, summed up and listed on the GPU. Lists have their particles in no order.
class TileLists {
 public:
  /// By a shader that includes shaders/list.glsl and knows what a particle covers.
  TileLists(const char* shader, int tile_size) : list_(shader), tile_size_(tile_size) {}

  /// Of a picture of this size in pixels. `radius` of the discs, m.
  void build(const Particles& particles, int width, int height, float radius);
  /// Runs a program that is in use, with a group of threads a tile; its uniform 0 is the tiles' number.
  void run(const Program& program) const;

 private:
  Program list_, scan_{"scan.comp.glsl"};
  int tile_size_;
  int across_ = 0, down_ = 0;
  DataBuffer starts_, cursors_, entries_;
};

}  // namespace meniscus::render
