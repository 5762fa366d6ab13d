// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The tuned constants of rigid bodies: symbol or name, unit, why this value, and the test that notices.
#pragma once

namespace meniscus::collision::rigid_tuning {

/// Of the smallest half extent: Bullet's collision margin. A larger one rounds edges; a smaller one needs the
/// slow solve of penetration more often.
/// Test: RigidRest.IsQuietAtAnySize.
inline constexpr float margin = 0.04f;

/// Of the smallest inner distance: the most by which a hull is shrunk for its margin.
/// Test: none.
inline constexpr float most_shrinkage = 0.25f;

/// Points that a hull is reduced to at most. Contacts of larger hulls take long, and differ by little.
/// Test: none.
inline constexpr int most_hull_points = 200;

/// Of √(g r): below this speed, for two seconds, a body may fall asleep. Small bodies sleep at lower speeds
/// than large ones.
/// Test: BodyMotionTest.ABodyAtRestFallsAsleepUnlessItMayNot.
inline constexpr float sleep_speed = 0.01f;

/// Of the inner radius: a body that moves further in a step is swept, with a ball of the second size. A
/// larger ball would meet the ground that the body rests on.
/// Test: RigidContactTest.FastSmallBallsDoNotPassThroughAThinWall.
inline constexpr float swept_motion = 0.5f, swept_radius = 0.4f;

/// s: the time over which a body's usual push is averaged. Waves around a floating body last longer.
/// Test: none.
inline constexpr float smoothing_time = 0.1f;

/// Of its weight: a change of push by more wakes a body.
/// Test: none.
inline constexpr float waking_change = 0.1f;

/// Steps of gravity: a contact slower than this does not bounce, because it is at rest.
/// Test: RigidRest.IsQuietAtAnySize.
inline constexpr float resting_steps = 4;

/// s: the time over which it is averaged how much a body gives way among solids.
/// Test: LoadedBodies.ALightRaftFloatsAsDeepAsWhatItCarries.
inline constexpr float yielding_time = 0.02f;

/// Of its weight: a push that says little about how much a body gives way.
/// Test: none.
inline constexpr float slight_push = 0.01f;

/// The least fraction by which a body gives way. A body that solids hold is as heavy as this.
/// Test: none.
inline constexpr float least_yielding = 1e-4f;

/// Steps of Newton's method for the tumbling of a body. It converges quadratically.
/// Test: none.
inline constexpr int newton_steps = 3;

/// m/s²: the least gravity by which speeds of sleep and pushes of waking are scaled.
/// Test: none.
inline constexpr float least_gravity = 1;

}  // namespace meniscus::collision::rigid_tuning
