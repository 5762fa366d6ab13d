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

/// Of MotionFile::start: a first time that is below 0 by less is 0. Text with six digits rounds by so much.
/// Test: MotionFile.BeginsAtZeroWhereTheStartHasFewDigits.
inline constexpr float start_tolerance = 5e-6f;

}  // namespace meniscus::motion::tuning
