// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#include "sdk/render/passes/fluid_surface.h"

#include <algorithm>
#include <cmath>

#include "sdk/render/uniforms.h"

namespace meniscus::render {

FluidSurface::FluidSurface(int width, int height)
    : first_(GL_RG32F, width, height),
      second_(GL_RG32F, width, height),
      window_depth_(GL_DEPTH_COMPONENT32F, width, height),
      ellipsoids_({&first_}, &window_depth_),
      to_first_({&first_}, nullptr),
      to_second_({&second_}, nullptr) {}

void FluidSurface::draw(const Particles& particles, const Texture& solid_depth, const Screen& screen,
                        SurfaceFilter filter, float reach, float threshold, float pixels) {
  glCopyImageSubData(solid_depth.name(), GL_TEXTURE_2D, 0, 0, 0, 0, window_depth_.name(), GL_TEXTURE_2D, 0, 0,
                     0, 0, first_.width(), first_.height(), 1);
  ellipsoids_.use();
  ellipsoids_.clear_color(0, 0, 0, 0, 0);
  glEnable(GL_DEPTH_TEST);
  ellipsoid_.use();
  particles.draw();
  glDisable(GL_DEPTH_TEST);

  result_ = &first_;
  if (filter == SurfaceFilter::none) return;
  if (filter == SurfaceFilter::curvature_flow) {
    // A step spreads depths by √0.4 pixels.
    const int steps = std::clamp(static_cast<int>(pixels * pixels / 0.4f), 1, 120);
    for (int k = 0; k < steps; ++k) apply(curvature_flow_, screen, 1, 0, reach, threshold);
    return;
  }
  const Program& program = filter == SurfaceFilter::bilateral ? bilateral_ : narrow_range_;
  // One axis after the other leaves streaks, which the second round, half as wide, takes out.
  for (const float share : {1.0f, 0.5f}) {
    apply(program, screen, 1, 0, share * reach, threshold);
    apply(program, screen, 0, 1, share * reach, threshold);
  }
}

void FluidSurface::apply(const Program& program, const Screen& screen, int x, int y, float reach,
                         float threshold) {
  const bool into_second = result_ == &first_;
  (into_second ? to_second_ : to_first_).use();
  result_->bind(unit::fluid_depth);
  program.use();
  glUniform2i(0, x, y);
  glUniform1f(1, reach);
  glUniform1f(2, threshold);
  screen.draw();
  result_ = into_second ? &second_ : &first_;
}

}  // namespace meniscus::render
