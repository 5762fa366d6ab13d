// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The tuned constants of rods and ropes: symbol or name, unit, why this value, and the test that notices.
#pragma once

namespace meniscus::cloth::rod_tuning {

/// Of the diagonal of a rod's equations: what is added to it. It covers the rounding of an elimination, where
/// rods are unyielding and held at both ends. Later iterations correct the error that it leaves.
/// Test: Rods.NeighboursThatAreHeldDoNoHarm.
inline constexpr float regularisation = 2e-7f;

/// Of the masses' part: the least compliance along a segment of a rope. It bounds Δλ where a rope is
/// unyielding, straight and held at both ends.
/// Test: Rods.RopeCarriesAHundredThousandTimesItsVertex.
inline constexpr float rope_regularisation = 2e-7f;

/// Of the masses' part: the greatest lateral compliance, which stands for infinity. Floats can still resolve
/// the compliance along the segment beside it.
/// Test: Rods.FreeRopeKeepsItsMomentumAndGainsNoEnergy.
inline constexpr float most_lateral = 100;

/// Of the inertia across a segment: the least inertia about its own axis. Were frames much lighter than
/// vertices, floats could not resolve the contribution of the vertices.
/// Test: none.
inline constexpr float least_axial_inertia = 0.01f;

}  // namespace meniscus::cloth::rod_tuning
