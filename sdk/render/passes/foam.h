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

/// Spray, foam and bubbles. Their amounts along each line of sight, before the fluid's surface and behind it,
/// are summed up, so that their order does not count. Then they are blended over the picture.
class Foam {
 public:
  Foam();

  void set(std::span<const DiffuseParticle> particles);
  /// Sums up the amounts; the fluid's surface must be bound. `spacing` of the fluid's particles, m.
  void gather(const FrameUniforms& frame, const Texture& scene_distance, float spacing,
              const Target& to_sums);
  /// Draws over the present target; the thickness map is bound already.
  void lay_over(const Screen& screen, const Texture& sums) const;

 private:
  VertexArrayHandle array_;
  DataBuffer particles_;
  GLsizei count_ = 0;
  Program gather_{"foam/foam.vert.glsl", "foam/foam.frag.glsl"};
  Program lay_over_{"screen/screen.vert.glsl", "foam/foam_over.frag.glsl"};
};

}  // namespace meniscus::render
