// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The legend that explains the colours of a view.
#pragma once

#include "sdk/io/png.h"
#include "sdk/render/frame/views.h"

namespace meniscus::render {

/// The meaning of the colours of a view.
struct LegendEntry {
  const char* name;
  Scale scale;
};

/// The entries of all scales of a view.
std::vector<LegendEntry> legend_of(const ViewData& view);

/// Draws them over the lower left corner of a picture.
void draw_legend(io::Image& image, const ViewData& view);

}  // namespace meniscus::render
