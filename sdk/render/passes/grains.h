// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include "sdk/render/passes/particles.h"

namespace meniscus::render {

/// Sand and the like: balls that light does not pass.
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
