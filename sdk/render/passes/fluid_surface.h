// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include "sdk/render/passes/tile_lists.h"

namespace meniscus::render {

/// How the depth of the ellipsoids becomes that of a surface.
enum class SurfaceFilter {
  narrow_range,    ///< Truong & Yuksel 2018
  bilateral,       ///< two passes, one an axis
  curvature_flow,  ///< van der Laan, Green & Sainz 2009
  none,
};

/// The fluid's surface as the camera sees it, a number a pixel: see shaders/fluid/found.glsl.
class FluidSurface {
 public:
  FluidSurface(int width, int height);

  /// Throws Error(capacity) where OpenGL's buffers do not hold so many pixels.
  static void check_room(int width, int height);

  /// Starts the ellipsoids, in front of what `scene_distance` holds: see Program::start.
  void draw(const TileLists& lists, const Texture& scene_distance);
  /// Lengths in metres: `reach` is the filter's standard deviation, and what is `threshold` apart in depth is
  /// another surface. `pixels`: reach, seen at the scene's middle.
  void filter(SurfaceFilter filter, float reach, float threshold, float pixels);
  /// For shaders that read it, by shaders/fluid/fluid_depth.glsl.
  void bind() const;

 private:
  void apply(const Program& program, int x, int y, float reach, float threshold);

  int width_, height_;
  DataBuffer first_, second_;
  const DataBuffer* result_ = &first_;
  Program splat_{"fluid/splat.comp.glsl"};
  Program narrow_range_{"fluid/narrow_range.comp.glsl"};
  Program bilateral_{"fluid/bilateral.comp.glsl"};
  Program curvature_flow_{"fluid/curvature_flow.comp.glsl"};
};

}  // namespace meniscus::render
