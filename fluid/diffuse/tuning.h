// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The tuned constants of spray, foam and bubbles: symbol or name, unit, why this value, and the test that
// notices.
#pragma once

namespace meniscus::fluid::diffuse_tuning {

/// The least |Σ x w|, in support radii, at a surface. Inside the fluid the sum is the noise of disorder.
/// Test: none.
inline constexpr float least_normal = 0.05f;

/// The least cosine between the normal and the velocity at a crest, as in the source. Other surfaces do not
/// move outwards.
/// Test: DiffuseTest.RatesAreInProportionAndZeroMakesNone.
inline constexpr float crest_cosine = 0.6f;

/// The most particles that a fluid particle creates in a step. It bounds the work of a very long step.
/// Test: none.
inline constexpr float most_births = 64;

}  // namespace meniscus::fluid::diffuse_tuning
