// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The tuned constants of a world's cloth: symbol or name, unit, why this value, and the test that notices.
#pragma once

namespace meniscus::cloth_world_tuning {

/// Mean edges: the thickness of cloth that is given none. A thicker one would fill folds of the mesh.
/// Test: none.
inline constexpr float default_thickness = 0.25f;

/// Radii of the circle that a particle's water fills: cloth takes up and gives water within this, and an edge
/// more. Nearer vertices alone might hold less than a particle.
/// Test: WetCloth.TakesUpWhatItHoldsAndNoMore.
inline constexpr double wetting_reach = 1.5;

/// Of an edge: a vertex whose neighbours are lower by no more than this is a lowest place, where water drips.
/// A level hem must drip, too.
/// Test: WetCloth.HungUpItDripsAndIsHeavierByWhatItKeeps.
inline constexpr float level = 0.02f;

}  // namespace meniscus::cloth_world_tuning
