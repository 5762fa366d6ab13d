// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The passes that find where fluid bends the light of the sun to.
#pragma once

#include "sdk/render/passes/fluid_thickness.h"

namespace meniscus::render {

/// Caustics (Shah, Konttinen & Pattanaik 2007, Caustics Mapping): light goes through the first surface that
/// the sun sees, and on to what is below it.
class Caustics {
 public:
  /// Needs the depths of solids bound, and FluidThickness::sun() of the same moment.
  void draw(const Texture& sun) const;
  void bind() const { bundles_.bind(unit::caustics); }

 private:
  Texture half_{GL_R32F, FluidThickness::sun_size, FluidThickness::sun_size};
  Texture surface_{GL_R32F, FluidThickness::sun_size, FluidThickness::sun_size};
  Texture bundles_{GL_R32UI, FluidThickness::sun_size, FluidThickness::sun_size};
  Program flatten_{"caustics/flatten.comp.glsl"};
  Program gather_{"caustics/gather.comp.glsl"};
};

}  // namespace meniscus::render
