// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The passes that draw grains and their shadows.
#pragma once

#include "sdk/render/passes/particles.h"

namespace meniscus::render {

/// Grains such as sand: opaque balls.
class Grains {
 public:
  void draw_shadows(const Particles& particles) const {
    shadow_.use();
    particles.draw();
  }
  void draw(const Particles& particles) const {
    ball_.use();
    particles.draw();
  }

 private:
  Program shadow_{"grains/grain_shadow.vert.glsl", "grains/grain_shadow.frag.glsl"};
  Program ball_{"grains/grain.vert.glsl", "grains/grain.frag.glsl"};
};

}  // namespace meniscus::render
