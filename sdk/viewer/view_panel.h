// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include "sdk/render/frame/views.h"

namespace meniscus::viewer {

/// The choice of what is shown, and what the colours of `shown` mean.
void draw_view_panel(render::ViewChoice& choice, const render::ViewData& shown);

}  // namespace meniscus::viewer
