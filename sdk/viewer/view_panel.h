// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The panel that chooses what is shown, and its colour scales.
#pragma once

#include "sdk/render/frame/views.h"

namespace meniscus::viewer {

/// Draws the choice of how all fluids look; none: as the scene says.
void draw_liquid_choice(std::optional<Liquid>& liquid);

/// Draws the choice of the view, and the colour scales of `shown`.
void draw_view_panel(render::ViewChoice& choice, const render::ViewData& shown);

}  // namespace meniscus::viewer
