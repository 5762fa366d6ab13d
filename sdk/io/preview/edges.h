// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include "sdk/io/preview/raster.h"

namespace meniscus::io {

struct EdgePen {
  Vec3 color;
  float opacity;
  float thickness;  ///< samples
  float bias;       ///< m: what lies no further than this in front of the edge does not hide it
};

/// Draws one straight line into the colours of the raster's samples.
void draw_edge(const Edge& edge, const EdgePen& pen, const Raster& raster, std::vector<Vec3>& colors);

}  // namespace meniscus::io
