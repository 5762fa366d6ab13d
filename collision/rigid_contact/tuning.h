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

}  // namespace meniscus::collision::rigid_contact_tuning
