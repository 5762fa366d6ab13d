// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The tuned constants of contacts with shapes: symbol or name, unit, why this value, and the test that
// notices.
#pragma once

namespace meniscus::collision::shape_tuning {

/// Of the contact radius: where points of faces stop. Resting cloth then touches with its vertices before the
/// points push; see face_points_kernels.h.
/// Test: FaceContacts.LetClothRestOnABall.
inline constexpr float face_radius = 0.7f;

/// s, in which an overlapping particle leaves a solid by one contact radius. If it left at once, it would get
/// the speed of that displacement.
/// Test: PlacedWater.IsNotThrownOutOfASolid.
inline constexpr float exit_time = 0.02f;

/// Contact radii: a swept motion ends at this distance from the surface. At the full radius, a particle at
/// rest on the surface would be stopped by rounding.
/// Test: BodySweepTest.APlateTakesParticlesAlong.
inline constexpr float touch = 0.5f;

/// Of `touch`: how far from the surface an advancing motion stays, and the least that it advances. A motion
/// that slides along the surface must still advance.
/// Test: VesselTest.AClosedOneIsShakenAndSpunForThreeSeconds.
inline constexpr float advance = 0.5f;

/// Touches: the margin within which a motion may still meet a surface, by the distances at its ends. It is
/// twice what is needed, because fields are not exact.
/// Test: BoxesInDamTest.NothingEndsInABox.
inline constexpr float sweep_margin = 4;

/// Steps of a swept motion. With more, it stops where it is.
/// Test: none.
inline constexpr int sweep_steps = 256;

/// Fixed surfaces that a motion may slide along in a substep. A corner has three.
/// Test: VesselTest.AnOpenOneIsCarriedForThreeSeconds.
inline constexpr int fixed_hits = 4;

/// The same for moving surfaces. After a hit the whole motion is tested again.
/// Test: BodySweepTest.ManySmallPlatesTakeAParticleEachAlong.
inline constexpr int moving_hits = 8;

/// The square of a fraction of the contact radius: a shorter motion ends without a test.
/// Test: none.
inline constexpr float no_motion2 = 1e-6f;

/// Contact radii: a particle this far beyond a closed wall is outside its container. Particles sink in less
/// during a solve.
/// Test: OpeningTest.FluidRunsOutOfAHoleInTheFloorAndAwayBelow.
inline constexpr float outside_depth = -2;

/// Substeps of gravity: a contact that is slower than this does not bounce. A contact at rest gains about one
/// within a substep.
/// Test: RestitutionTest.ARestingContactDoesNotBounce.
inline constexpr float resting_substeps = 4;

/// The greatest cosine between the normals of two contacts that oppose each other. Flatter pairs are solved
/// one by one.
/// Test: PinchedCloth.HoldsACrateOnASlope.
inline constexpr float opposed = -0.9f;

/// A vertex sticks to one of two surfaces if its slip there is at most this fraction of its slip on the
/// other. In between it slips on both.
/// Test: PinchedCloth.LetsACrateSlideByCoulombsLaw.
inline constexpr float sticking = 0.1f;

}  // namespace meniscus::collision::shape_tuning
