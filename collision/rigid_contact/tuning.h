// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The tuned constants of contacts among solids on the device: symbol or name, unit, why this value, and the
// test that notices.
#pragma once

namespace meniscus::collision::rigid_contact_tuning {

/// Sine of the angle below which two edges count as parallel. Their common normal is lost in rounding.
/// Test: RigidManifold.TurnedBoxesHaveTheirDistance.
inline constexpr float parallel = 1e-3f;

/// Of the least half extent: a face is kept until another face, or a pair of edges, is so much further apart.
/// Boxes that lie flat then keep the features that carry their warm start.
/// Test: RigidManifold.FlatBoxesTouchAtFourCorners.
inline constexpr float face_preference = 0.02f;

/// Of the radius of a hull: triangles whose corners lie so near a common plane are one face. Points of a file
/// with five digits do. Test: RigidHull.ARoundedBoxHasSixFaces.
inline constexpr float hull_flatness = 2e-4f;

/// Of the least half extent: corners that lie so much higher than the lowest one count as level. Which four
/// of them a contact keeps then does not change while a hull trembles by rounding. Test:
/// RigidHull.APrismOf16SidesRests.
inline constexpr float level = 1e-3f;

/// Cosine of the angle below which two normals count as one.
/// Test: RigidHull.ACapsuleLiesOnAFaceAtTwoPoints.
inline constexpr float same_normal = 0.999f;

/// Sine of the angle by which a part may extend into a ground from one of its vertices that touches there.
/// Vertices of a face that is level to so much touch together.
/// Test: RigidGround.APlankLiesFlushOnABlock.
inline constexpr float facing = 0.1f;

/// Of the radius: how far apart resting parts still have a contact. It keeps what they start from.
/// Test: none.
inline constexpr float margin = 0.02f;

/// Of the radius: the most by which fast small parts reach for one another. Cells of the grid are wider by
/// it. Test: RigidDeviceTuning.PartsThatCloseInByTheirReachMeet.
inline constexpr float most_reach = 0.25f;

/// Of the rate of small steps: the frequency of a contact's spring. At a quarter, pyramids tremble. At a
/// sixteenth, a stack of 10 sinks by 0.7 %.
/// Test: RigidDevice.AStackOf10Stands.
inline constexpr float frequency = 0.125f;

/// Of critical damping, of that spring.
/// Test: RigidDevice.AStackOf10Stands.
inline constexpr float damping = 3;

/// 1/s, times the radius of the smaller part: the fastest removal of overlaps.
/// Test: RigidDeviceTuning.OverlapsGoAtTheirBound.
inline constexpr float push_rate = 30;

/// rad: the most by which a body tumbles in a step, a quarter of half a turn, as in Bullet.
/// Test: none.
inline constexpr float most_turn = 0.7853982f;

/// The most rounds of colouring. A round gives one contact of a body a colour, so there are as many as a body
/// has contacts, or some more. What has no colour after the last one is solved one by one.
/// Test: RigidDeviceTuning.ABodyOfMoreContactsThanColoursRests.
inline constexpr unsigned colour_rounds = 64;

/// Of these, where there are many contacts, how many are launches of their own. The others are one launch.
/// Results do not depend on it. Test: none.
inline constexpr unsigned launched_rounds = 24;

/// Rounds over the points of a contact that bounces.
/// Test: RigidContactTest.BouncesTheSameFromAnyHeight.
inline constexpr int bounce_rounds = 8;

/// Of the median radius: parts above are large, and no cell holds them.
/// Test: RigidDeviceTuning.PartsOfAllSizesFindOneAnother.
inline constexpr float large = 2;

}  // namespace meniscus::collision::rigid_contact_tuning
