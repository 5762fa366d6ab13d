// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The tuned constants of grains: symbol or name, unit, why this value, and the test that notices.
#pragma once

namespace meniscus::collision::grain_tuning {

/// Diameters: contacts are found for grains nearer than this. They may touch before the substep's end.
/// Test: GrainsTest.CloudsThatCollideKeepTheirMomentum.
inline constexpr float reach = 1.15f;

/// Fraction of the last substep's impulses to start from. The rest has to be found again from overlaps, so a
/// pile is softer the smaller this is.
/// Test: GrainsTest.RestUnderTwentyLayers.
inline constexpr float warm_start = 0.985f;

/// 1/s: the rate at which overlaps from before the substep are removed. At once, they would throw grains
/// apart.
/// Test: GrainsTest.OverlapsComeApartWithoutABlast.
inline constexpr float recovery_rate = 15;

/// The largest fraction of an overlap that is removed in a substep. A mode of which the solve relieves the
/// fraction ε is stable with warm starting while recovery < ε + 1 − warm_start.
/// Test: GrainsTest.RestUnderTwentyLayers.
inline constexpr float most_recovery = 0.06f;

/// Bound of the solve's spectrum. It includes the effect of what else pushes on grains between iterations.
/// Test: GrainsTest.ARowWhoseHalvesMeetDoesNotFlyApart.
inline constexpr float spectral_bound = 1.1f;

/// The slope of a heap of frictionless grains, and by how much it grows with the μ of contacts. Both are
/// fitted to columns of about 2000 grains that collapse.
/// Test: GrainsValidation.AngleOfReposeFollowsFriction.
inline constexpr float frictionless_slope = 0.18f, slope_of_friction = 1.4f;

}  // namespace meniscus::collision::grain_tuning
