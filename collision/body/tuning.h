// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The tuned constants of bodies among particles, and of face points: symbol or name, unit, why this value,
// and the test that notices.
#pragma once

#include <cstdint>

namespace meniscus::collision {

namespace body_tuning {

/// The greatest cosine between the normals of two contacts between which a particle has no room. They face
/// each other within 60°.
/// Test: BodyKernels.AParticleBetweenTwoBodiesHoldsThemApart.
inline constexpr float facing = -0.5f;

/// Parts that a body is split into for each of its attachments. Half of it is for its contacts.
/// Test: BodyKernels.TiesStandApartAndLeaveHalfOfTheBody.
inline constexpr float splits = 2;

/// Of the largest friction: a contact with less sticks. At the limit rounding decides.
/// Test: HeldCloth.OfAMovingBodyCarriesABoxAlong.
inline constexpr float sticking = 0.999f;

}  // namespace body_tuning

namespace face_tuning {

/// Contact radii: a face gets a point where it is nearer than its vertices by this much. Flat contact needs
/// none.
/// Test: FaceContacts.AreNotNeededOnWhatIsSmoothAndLarge.
inline constexpr float slack = 0.25f;

/// Contact radii: a point is needed within this distance. Beyond it the solve seldom brings a face to the
/// solid.
/// Test: FaceContacts.KeepClothFromWhatIsFixed.
inline constexpr float reach = 2;

/// Contact radii: a face meets a solid at this distance during its motion. It is less than where points stop.
/// Test: FaceContacts.KeepOutWhatIsThrown.
inline constexpr float touch = 0.5f;

/// Steps without need after which points are disabled. Enabling them again repeats a step.
/// Test: none.
inline constexpr uint32_t longest_idle = 100;

// ---- the fail-safe ----

/// Rounds of the fail-safe. Faces that share a vertex may undo each other's motion in one. What the rounds
/// leave, the contacts of the next substep correct.
/// Test: ClothSolids.TheBunny.
inline constexpr int rounds = 3;

/// Contact radii: a face nearer than `least` is moved out to `enough`. A slow face is moved by little,
/// because a great weight may press it there.
/// Test: ClothSolids.ABallThatIsHit.
inline constexpr float least = 0.25f, enough = 0.3f, enough_when_fast = 0.5f;

/// Contact radii: the tolerance of the nearest point of a face at the end of its motion.
/// Test: none.
inline constexpr float end_tolerance = 0.01f;

/// The least weight of a point's vertices that can move. With less, they would be thrown far.
/// Test: none.
inline constexpr float least_free = 0.05f;

// ---- the nearest point of a face ----

/// Steps of the descent from a sample. Along an edge steps are short and many.
/// Test: FaceNearest.IsTheLeastDistanceOverTheFaceForAllKinds.
inline constexpr int descent_steps = 24;

/// Of the face's radius: the first step beyond the surface, and by what a step is scaled when it succeeds or
/// fails. It shrinks faster than it grows, so that the descent ends.
/// Test: FaceNearest.IsTheLeastDistanceOverTheFaceForAllKinds.
inline constexpr float first_step = 0.5f, longer = 1.5f, shorter = 0.25f;

/// Of the tolerance: a step must gain at least this. Less is rounding.
/// Test: FaceNearest.IsTheLeastDistanceOverTheFaceForAllKinds.
inline constexpr float least_gain = 0.01f;

/// How many times the last displacement is repeated at most. A descent along a valley seldom needs more.
/// Test: none.
inline constexpr float most_repeated = 100;

/// Of the dip: a shape that may not be convex is nearer than the corners if a sample is by this much. A few
/// samples seldom find the deepest point.
/// Test: FaceContacts.KeepClothFromTheBunny.
inline constexpr float sampled_dip = 0.25f;

/// Steps of conservative advancement of a face. After these it is tested where they end and at its own end.
/// Test: none.
inline constexpr int advance_steps = 256;

/// Of the touching distance: the tolerance of the nearest point during the motion, and how far a face
/// advances at least.
/// Test: FaceContacts.KeepOutWhatIsThrown.
inline constexpr float advance_tolerance = 0.02f, advance = 0.5f;

}  // namespace face_tuning

/// The fail-safe between bodies and cloth.
namespace zone_tuning {

/// Contact radii: a body that would come nearer to a face unites with it. Contacts keep more.
/// Test: FastBodies.ASmallBallAt150.
inline constexpr float least = 0.1f;

/// Of the distance at the start of the substep: no face comes nearer than this. So what starts very near does
/// not pass either.
/// Test: none.
inline constexpr float kept = 0.5f;

/// Rounds of the fail-safe. In the last one all of the piece joins.
/// Test: FastBodies.ASmallBallAt150.
inline constexpr uint32_t rounds = 8;

/// Of the size of a face: no body moves further in a substep, relative to cloth that it meets. With more,
/// the iterations leave cloth stretched.
/// Test: FastBodies.ABall.
inline constexpr float most_motion = 0.6f;

/// Sizes of a face: cloth that is nearer to a body than this is about to meet it.
/// Test: FastBodies.ABall.
inline constexpr float surroundings = 2;

/// Substeps of a step that a fast body may ask for.
/// Test: none.
inline constexpr int most_substeps = 256;

/// Lanes of the sums over a zone.
/// Test: none.
inline constexpr uint32_t lanes = 64;

/// Steps of conservative advancement. A face that slides along the body for longer unites with it.
/// Test: none.
inline constexpr int advance_steps = 256;

}  // namespace zone_tuning

}  // namespace meniscus::collision
