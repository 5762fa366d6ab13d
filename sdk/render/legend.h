// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include "sdk/io/png.h"
#include "sdk/render/frame/views.h"

namespace meniscus::render {

/// What the colours of a view mean.
struct LegendEntry {
  const char* name;
  Scale scale;
};

/// Those of all scales that a view has.
std::vector<LegendEntry> legend_of(const ViewData& view);

/// Draws them over the lower left corner of a picture.
void draw_legend(io::Image& image, const ViewData& view);

}  // namespace meniscus::render
