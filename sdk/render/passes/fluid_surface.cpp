// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#include "sdk/render/passes/fluid_surface.h"

#include <algorithm>
#include <cmath>

#include "sdk/render/uniforms.h"

namespace meniscus::render {

FluidSurface::FluidSurface(int width, int height)
    : first_(GL_RG32F, width, height), second_(GL_RG32F, width, height) {}

void FluidSurface::draw(const TileLists& lists, const Texture& scene_distance) {
  scene_distance.bind(unit::depth);
  first_.bind_image(0);
  splat_.use();
  lists.start(splat_);
  result_ = &first_;
}

void FluidSurface::filter(SurfaceFilter filter, float reach, float threshold, float pixels) {
  if (filter == SurfaceFilter::none) return;
  if (filter == SurfaceFilter::curvature_flow) {
    // A step spreads depths by √0.4 pixels.
    const int steps = std::clamp(static_cast<int>(pixels * pixels / 0.4f), 1, 120);
    for (int k = 0; k < steps; ++k) apply(curvature_flow_, 1, 0, reach, threshold);
    return;
  }
  const Program& program = filter == SurfaceFilter::bilateral ? bilateral_ : narrow_range_;
  // One axis after the other leaves streaks, which the second round, half as wide, takes out.
  for (const float share : {1.0f, 0.5f}) {
    apply(program, 1, 0, share * reach, threshold);
    apply(program, 0, 1, share * reach, threshold);
  }
}

void FluidSurface::apply(const Program& program, int x, int y, float reach, float threshold) {
  const Texture& into = result_ == &first_ ? second_ : first_;
  result_->bind(unit::fluid_depth);
  program.use();
  glUniform2i(0, x, y);
  glUniform1f(1, reach);
  glUniform1f(2, threshold);
  program.run_over(into);
  result_ = &into;
}

}  // namespace meniscus::render
