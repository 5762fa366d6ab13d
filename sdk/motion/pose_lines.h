// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Reads poses from lines of numbers.
#pragma once

#include <meniscus/bodies.h>

#include <string_view>
#include <vector>

namespace meniscus::motion {

/// A line a pose: time, x, y, z, and the quaternion x, y, z, w, with commas, semicolons or spaces between
/// (Sturm et al. 2012). Throws FileDefect, with the line, for another line.
std::vector<Keyframe> read_pose_lines(std::string_view text);

}  // namespace meniscus::motion
