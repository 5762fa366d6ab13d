// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The tuned constants of the fluid's surface: symbol or name, unit, why this value, and the test that
// notices.
#pragma once

namespace meniscus::fluid::surface_tuning {

/// λ: the fraction by which a particle's centre moves to the mean of its neighbours. Yu & Turk take 0.9 to 1,
/// and less leaves bumps.
/// Test: SurfaceMeshTest.APoolEndsHalfASpacingAboveItsTopParticles.
inline constexpr float smoothing = 0.9f;

/// k: the longest radius over the shortest, at most. It keeps sheets thick enough to be seen.
/// Test: AnisotropyTest.ASheetIsFlatHoweverItIsTurned.
inline constexpr float longest_over_shortest = 4;

/// The ellipsoid replaces the ball as slope · Σw − offset rises from 0 to 1, with Σw over that of a flat
/// surface. It rises from a sixth, about two neighbours, to more than half. A thin layer has 0.6.
/// Test: AnisotropyTest.ASheetIsFlatHoweverItIsTurned.
inline constexpr float ellipsoid_slope = 2.6f, ellipsoid_offset = 0.44f;

/// Sweeps of Jacobi's method for the axes of an ellipsoid. They converge quadratically, and five reach the
/// precision of floats.
/// Test: PrincipalAxes.MakeUpTheMatrixAgain.
inline constexpr int jacobi_sweeps = 5;

/// Radii of an ellipsoid: how far a particle influences the field of the mesh. The fields of neighbours must
/// overlap for the surface to be smooth.
/// Test: SurfaceMeshTest.APoolEndsHalfASpacingAboveItsTopParticles.
inline constexpr float reach = 1.5f;

/// Of an edge: a vertex of the mesh keeps at least this far from its nodes. At a node the vertices of several
/// edges would coincide.
/// Test: none.
inline constexpr float least_from_node = 1e-3f;

/// m/s: the unit of velocities that are summed at nodes, and the largest component. With the field's unit of
/// 2⁻²⁰ a sum of 2⁷ full contributions at this speed fits 63 bits.
/// Test: SurfaceVelocityTest.AUniformVelocityIsThatOfEachVertex.
inline constexpr float speed_unit = 1.0f / (1 << 22), fastest = 8192;

}  // namespace meniscus::fluid::surface_tuning
