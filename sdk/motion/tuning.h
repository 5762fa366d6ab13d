// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The tuned constants of motions from files.
#pragma once

namespace meniscus::motion::tuning {

/// Degrees: the most that an operation turns from one keyframe to the next. Keyframes take a line for an arc,
/// which is then off by 0.1 % of its radius.
/// Test: MotionFile.TurnsTheWholeWayBetweenTwoSamples.
inline constexpr double most_turn = 5;

/// Of a length: transforms may scale by so much. Text with few digits rounds.
/// Test: MotionFile.RefusesWhatItCannotFollow.
inline constexpr double scale_tolerance = 1e-4;

}  // namespace meniscus::motion::tuning
