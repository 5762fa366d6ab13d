// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Light of the preview: a shadow map and ambient obscurance.
#pragma once

#include "sdk/io/preview/raster.h"

namespace meniscus::io {

/// The shadow map of a lamp. The lamp is so far away that its light is nearly parallel.
class Lamp {
 public:
  /// Lights the whole ball; `bias` (m) keeps a surface from shadowing itself.
  Lamp(const Drawing& drawing, Vec3 towards_lamp, Vec3 center, float radius, float bias);

  /// The fraction of the lamp that is visible from a point in the world, 0 to 1, smoothed over a few samples
  /// of the map.
  float visible_from(Vec3 world) const;

 private:
  Raster raster_;
  float bias_;
};

/// The openness of the half-space above each pixel, 0 to 1, from the depths around it. The method is that of
/// McGuire, Mara and Luebke, Scalable Ambient Obscurance, 2012, over a fixed spiral that turns from pixel to
/// pixel. A pixel is a block of `step` by `step` samples; `radius` is in metres.
std::vector<float> ambient_openness(const Raster& raster, int step, float radius);

}  // namespace meniscus::io
