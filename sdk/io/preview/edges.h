// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Straight lines in the preview.
#pragma once

#include "sdk/io/preview/raster.h"

namespace meniscus::io {

struct EdgePen {
  Vec3 color;
  float opacity;
  float thickness;  ///< samples
  float bias;       ///< m: surfaces no further than this in front of the edge do not hide it
};

/// Draws one straight line into the colours of the raster's samples.
void draw_edge(const Edge& edge, const EdgePen& pen, const Raster& raster, std::vector<Vec3>& colors);

}  // namespace meniscus::io
