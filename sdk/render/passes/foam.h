// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The passes that draw spray, foam and bubbles.
#pragma once

#include <meniscus/outputs.h>

#include <span>

#include "sdk/render/frame/uniforms.h"
#include "sdk/render/gl/program.h"
#include "sdk/render/passes/screen.h"

namespace meniscus::render {

/// Spray, foam and bubbles. Their amounts along each line of sight, before a layer's surface and behind it,
/// are summed up as a volume with half as many pixels each way, so that their order does not count. Then they
/// are blended over the picture of the layer.
class Foam {
 public:
  /// The size is that of the picture.
  struct Sums {
    Sums(int width, int height)
        : front(GL_RGBA16F, (width + 1) / 2, (height + 1) / 2),
          rest(GL_RGBA16F, (width + 1) / 2, (height + 1) / 2) {}
    Texture front, rest;
    Target target{{&front, &rest}, nullptr};
  };

  Foam();

  void set(std::span<const DiffuseParticle> particles);
  /// Sums up the amounts; the fluid's surfaces and layers must be bound.
  void gather(const FrameUniforms& frame, const Texture& scene_distance, const Sums& sums);
  /// Draws over the present target, which shows the layer. The surfaces and layers must be bound.
  void lay_over_rest(const Screen& screen, const Sums& sums) const { lay_over(screen, sums, 1); }
  void lay_over_front(const Screen& screen, const Sums& sums) const { lay_over(screen, sums, 0); }

 private:
  void lay_over(const Screen& screen, const Sums& sums, int layer) const;

  VertexArrayHandle array_;
  DataBuffer particles_;
  GLsizei count_ = 0;
  Program gather_{"foam/foam.vert.glsl", "foam/foam.frag.glsl"};
  Program lay_over_{"screen/screen.vert.glsl", "foam/foam_over.frag.glsl"};
};

}  // namespace meniscus::render
