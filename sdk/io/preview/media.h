// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What liquids do to light.
#pragma once

#include <meniscus/scene.h>

#include <vector>

namespace meniscus::io {

/// Coefficients of red, green and blue light, 1/m. The scattering is the reduced one, (1 − g) s of a medium
/// with the mean cosine g.
struct Medium {
  Vec3 absorption, scattering;
};

Medium medium_of(Liquid liquid);
/// With the coefficients that the scene gives in place of the liquid's.
Medium medium_of(const SceneLook& look);

/// The light that returns from a deep medium, of white light on it, 0 to 1: Hapke's diffusive reflectance
/// (1 − γ)/(1 + γ), γ² = a/(a + s).
Vec3 reflectance_of(const Medium& medium);

}  // namespace meniscus::io
