// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Shading of the preview.
#pragma once

#include "sdk/io/png.h"
#include "sdk/io/preview/raster.h"

namespace meniscus::io {

/// The light of the picture, and the lengths on which it depends.
struct Studio {
  Vec3 up{0, 1, 0};
  Vec3 towards_lamp{0, 1, 0};
  Vec3 center{0, 0, 0};  ///< m, centre of the objects shown
  float radius = 1;      ///< m, of a ball around them
  float grain = 0.05f;   ///< m, the smallest detail: a particle
};

/// Lights the raster, draws the edges that nothing hides, and averages blocks of `step` by `step` samples.
Image shade(const Raster& raster, const Drawing& drawing, const Studio& studio, int step);

}  // namespace meniscus::io
