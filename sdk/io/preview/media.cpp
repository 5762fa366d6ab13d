// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Coefficients of liquids at 620, 540 and 460 nm.
#include "sdk/io/preview/media.h"

#include <cmath>

#include "pbd/math/vec.h"

namespace meniscus::io {
namespace {

/// Absorption: Pope & Fry 1997. Scattering: Morel 1974, 3.50e-3 (450 nm/λ)^4.32, which has no preferred
/// direction.
constexpr Medium clear{{0.276f, 0.0474f, 0.0098f}, {0.0009f, 0.0016f, 0.0032f}};
/// Water of the open sea with 0.2 mg/m³ of chlorophyll (C). Absorption: that of water, 0.06 A C^0.65 of
/// particles (Prieur & Sathyendranath 1981, Morel 1991), and 0.2 of that at 440 nm, as exp(−0.014 (λ/nm −
/// 440)), of solutes. Scattering: 1.3 times that of water (salt, Morel 1974), and 0.30 C^0.62 (550 nm/λ) of
/// particles (Gordon & Morel 1983), with a mean cosine of 0.924 (Petzold 1972).
constexpr Medium sea{{0.282f, 0.057f, 0.032f}, {0.0087f, 0.0107f, 0.0142f}};
/// Pure water, and fine matter that scatters all colours alike: an estimate.
constexpr Medium pool{{0.276f, 0.0474f, 0.0098f}, {0.1f, 0.1f, 0.1f}};
/// Whole milk, Jensen, Marschner, Levoy & Hanrahan 2001.
constexpr Medium milk{{1.1f, 2.4f, 14}, {2550, 3210, 3770}};
/// Estimates.
constexpr Medium honey{{4, 20, 120}, {1, 1, 1}};
constexpr Medium oil{{2, 4, 40}, {0.5f, 0.5f, 0.5f}};

float reflectance(float absorption, float scattering) {
  if (scattering <= 0) return 0;
  const float gamma = std::sqrt(absorption / (absorption + scattering));
  return (1 - gamma) / (1 + gamma);
}

}  // namespace

Medium medium_of(Liquid liquid) {
  constexpr Medium media[] = {clear, sea, pool, milk, honey, oil};
  return media[static_cast<int>(liquid)];
}

Medium medium_of(const SceneLook& look) {
  const Medium medium = medium_of(look.liquid);
  return {look.absorption.value_or(medium.absorption), look.scattering.value_or(medium.scattering)};
}

Vec3 reflectance_of(const Medium& medium) {
  const Vec3 &a = medium.absorption, &s = medium.scattering;
  return {reflectance(a.x, s.x), reflectance(a.y, s.y), reflectance(a.z, s.z)};
}

}  // namespace meniscus::io
