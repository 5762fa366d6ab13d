// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The passes that draw the fluid's depth and filter it to a surface.
#pragma once

#include "sdk/render/passes/tile_lists.h"

namespace meniscus::render {

/// The filter that turns the depth of the ellipsoids into that of a surface.
enum class SurfaceFilter {
  narrow_range,    ///< Truong & Yuksel 2018
  bilateral,       ///< two passes, one per axis
  curvature_flow,  ///< van der Laan, Green & Sainz 2009
  none,
};

/// The fluid's surfaces as the camera sees them, one number per pixel: see shaders/fluid/found.glsl. The
/// first belongs to the front layer, and the second to the rest behind it, as FluidThickness tells them
/// apart.
class FluidSurface {
 public:
  FluidSurface(int width, int height);

  /// Throws Error(capacity) if OpenGL's buffers do not hold that many pixels.
  static void check_room(int width, int height);

  /// Starts drawing the ellipsoids that lie in front of `scene_distance`: see Program::start.
  void draw_front(const TileLists& lists, const Particles& particles, const Texture& scene_distance);
  /// Starts the same for the rest; the first surface must not be filtered yet, and the layers must be bound.
  void draw_rest(const TileLists& lists, const Particles& particles, const Texture& scene_distance);
  /// Lengths in metres: `reach` is the filter's standard deviation. Depths that differ by `threshold` belong
  /// to different surfaces. `pixels`: reach, as seen at the scene's middle.
  void filter(SurfaceFilter filter, float reach, float threshold, float pixels);
  /// Binds it for shaders that read it by shaders/fluid/fluid_depth.glsl: the first surface, or the rest's.
  void bind_front() const;
  void bind_rest() const;
  /// Binds the rest's for shaders that read both, by shaders/fluid/rest_depth.glsl.
  void bind_rest_too() const;

 private:
  /// A surface, and room for its next filtering.
  struct Layer {
    DataBuffer first, second;
    const DataBuffer* result = &first;
  };
  void draw(Layer& layer, int index, const TileLists& lists, const Particles& particles,
            const Texture& scene_distance);
  void apply(const Program& program, int x, int y, float reach, float threshold);

  int width_, height_;
  Layer layers_[2];
  Program splat_{"fluid/splat.comp.glsl"};
  Program narrow_range_{"fluid/narrow_range.comp.glsl"};
  Program bilateral_{"fluid/bilateral.comp.glsl"};
  Program curvature_flow_{"fluid/curvature_flow.comp.glsl"};
};

}  // namespace meniscus::render
