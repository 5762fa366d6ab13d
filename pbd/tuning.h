// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The tuned constants of the solver, of contacts and of the neighbour search: symbol or name, unit, why this
// value, and the test that notices.
#pragma once

namespace meniscus::pbd {

namespace chebyshev_tuning {

/// The square of 1.5: the spectrum's lower end is bound · (1.5/m)². The least eigenvalue that m iterations
/// still resolve is near it.
/// Test: PoolTest.Settles.
inline constexpr float resolved2 = 2.25f;

/// Of the bound: the spectrum's lower end is at most this. With one iteration it would otherwise lie above
/// the upper end.
/// Test: none.
inline constexpr float most_low = 0.5f;

}  // namespace chebyshev_tuning

namespace contact_tuning {

/// Of a contact's radius: how much the distances at which particles stop differ. Otherwise particles in a
/// corner could end at the very same point, where no force separates them.
/// Test: none.
inline constexpr float radius_spread = 0.01f;

/// Contact radii: adhesion acts up to this distance. A particle that sticks rests at one radius, and must not
/// leave by a small disturbance.
/// Test: BodyFluidTest.ADropHangsUnderAPlateThatItSticksTo.
inline constexpr float adhesion_reach = 2;

/// Of the support radius less the contact radius: in a substep with longer motions, motions end at the
/// surfaces that they meet. Contacts are found within this reach, and the solve may double a motion.
/// Test: BodySweepTest.APlateTakesParticlesAlong.
inline constexpr float fast_motion = 0.5f;

}  // namespace contact_tuning

namespace nearness_tuning {

/// Of the gap: a motion is stopped no nearer than this. A smaller margin would take more steps.
/// Test: SelfContactGeometry.StopsBeforeTheyMeet.
inline constexpr float nearest_stop = 0.75f;

/// Steps of conservative advancement. Pairs that graze take the most, and after these the motion stops early.
/// Test: SelfContactGeometry.SeesWhatGoesThrough.
inline constexpr int most_steps = 64;

}  // namespace nearness_tuning

namespace search_tuning {

/// Reaches: the largest rounding error of coordinates with which coarse positions are used. Coarse positions
/// err by up to 0.003 themselves, where kernels almost vanish.
/// Test: NeighbourTest.OfManyParticlesFarFromTheOriginAreThoseOfASlab.
inline constexpr float most_coarse_slack = 0.004f;

/// Particles in a cube of one reach, as h = 2 s.
/// Test: NeighbourStrips.AreAsWideAsKeepsIndicesClose.
inline constexpr float particles_in_cube = 8;

/// How many times its mean a layer of cells may hold. A fluid seldom fills its extent evenly.
/// Test: NeighbourStrips.AreAsWideAsKeepsIndicesClose.
inline constexpr float unevenness = 1.5f;

/// Support radii: particles that are nearer to a seam have ghosts. It exceeds 1 by the rounding of positions,
/// which may leave a particle just beyond a seam.
/// Test: PeriodicTest.AShiftByHalfAnExtentChangesNothing.
inline constexpr float seam_reach = 1.01f;

}  // namespace search_tuning

}  // namespace meniscus::pbd
