// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include "sdk/io/preview/raster.h"

namespace meniscus::io {

/// What a lamp sees: a shadow map. The lamp stands so far off that its light is nearly parallel.
class Lamp {
 public:
  /// Lights all of the ball; `bias` (m) keeps a surface from shadowing itself.
  Lamp(const Drawing& drawing, Vec3 towards_lamp, Vec3 center, float radius, float bias);

  /// The share of the lamp that a point in the world sees, 0 to 1; softened over a few samples of the map.
  float visible_from(Vec3 world) const;

 private:
  Raster raster_;
  float bias_;
};

/// How open the half-space above each pixel is, 0 to 1, from the depths of its surroundings: after McGuire,
/// Mara and Luebke, Scalable Ambient Obscurance, 2012, over a fixed spiral that turns from pixel to pixel. A
/// pixel is a block of `step` by `step` samples; `radius` in metres.
std::vector<float> ambient_openness(const Raster& raster, int step, float radius);

}  // namespace meniscus::io
