// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <meniscus/outputs.h>

#include <span>

#include "sdk/render/gl/program.h"

namespace meniscus::render {

/// The particles of a frame, as arrays that shaders read one element an instance of.
class Particles {
 public:
  Particles();

  /// Equally many of both. Those that are not finite are left out.
  void set(std::span<const Ellipsoid> ellipsoids, std::span<const uint32_t> fluids);
  /// Four corners each.
  void draw() const;

 private:
  DataBuffer ellipsoids_, fluids_;
  VertexArrayHandle array_;
  GLsizei count_ = 0;
};

}  // namespace meniscus::render
