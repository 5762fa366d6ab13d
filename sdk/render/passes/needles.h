// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The pass that draws short lines, such as contact normals.
#pragma once

#include "pbd/math/vec.h"
#include "sdk/render/gl/program.h"

namespace meniscus::render {

struct Needle {
  Vec3 from, to;  ///< m
  Vec3 color;     ///< linear RGB
};

/// Lines with the same width in pixels at every distance.
class Needles {
 public:
  Needles();
  void set(std::span<const Needle> needles);
  bool empty() const { return count_ == 0; }
  void draw(float pixels) const;

 private:
  DataBuffer needles_;
  VertexArrayHandle array_;
  GLsizei count_ = 0;
  Program program_{"views/needle.vert.glsl", "views/needle.frag.glsl"};
};

}  // namespace meniscus::render
