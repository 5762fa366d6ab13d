// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Pictures as a lens and a shutter take them: the mean of several (Haeberli & Akeley 1990, The Accumulation
// Buffer).
#pragma once

#include "sdk/render/renderer.h"

namespace meniscus::render {

struct StillSettings {
  int samples = 1;     ///< 1 to 4096: pictures whose mean is taken
  float aperture = 0;  ///< m, ≥ 0: diameter of the lens. What is as far away as the camera's target is sharp.
  float shutter =
      0;  ///< s, ≥ 0: how long it is open, centred at the moment. Things go straight on meanwhile.
};

/// Draws the moment with the renderer's camera, which is the same afterwards. Equal input gives equal bytes.
/// Throws Error(invalid_argument) for settings out of range and what Renderer::load and Renderer::image
/// throw.
io::Image draw_still(Renderer& renderer, const Moment& moment, const StillSettings& settings);

}  // namespace meniscus::render
