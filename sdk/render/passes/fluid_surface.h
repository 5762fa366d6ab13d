// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include "sdk/render/passes/particles.h"
#include "sdk/render/passes/screen.h"

namespace meniscus::render {

/// How the depth of the ellipsoids becomes that of a surface.
enum class SurfaceFilter {
  narrow_range,    ///< Truong & Yuksel 2018
  bilateral,       ///< two passes, one an axis
  curvature_flow,  ///< van der Laan, Green & Sainz 2009
  none,
};

/// The fluid's surface as the camera sees it: in red its distance along −z in each pixel, 0 where there is
/// none; in green how much of the filter is due there, less in drops on their own.
class FluidSurface {
 public:
  FluidSurface(int width, int height);

  /// In front of what `solid_depth` holds. Lengths in metres: `reach` is the filter's standard deviation, and
  /// what is `threshold` apart in depth is another surface. `pixels`: reach, seen at the scene's middle.
  void draw(const Particles& particles, const Texture& solid_depth, const Screen& screen,
            SurfaceFilter filter, float reach, float threshold, float pixels);
  const Texture& depth() const { return *result_; }

 private:
  void apply(const Program& program, const Screen& screen, int x, int y, float reach, float threshold);

  Texture first_, second_, window_depth_;
  Target ellipsoids_, to_first_, to_second_;
  const Texture* result_ = &first_;
  Program ellipsoid_{"ellipsoid.vert.glsl", "ellipsoid.frag.glsl"};
  Program narrow_range_{"screen.vert.glsl", "narrow_range.frag.glsl"};
  Program bilateral_{"screen.vert.glsl", "bilateral.frag.glsl"};
  Program curvature_flow_{"screen.vert.glsl", "curvature_flow.frag.glsl"};
};

}  // namespace meniscus::render
