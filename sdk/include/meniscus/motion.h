// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Motions of bodies from files of other programs.
#pragma once

#include <meniscus/bodies.h>

namespace meniscus {

/// A file with the poses of one rigid thing over time, and how to take it. Axes stay as in the file: `pose`
/// turns them.
///
///   .usda       OpenUSD as text: the transform of a prim and of all above it, from time samples of its
///               xformOps. Times are time codes over timeCodesPerSecond, and lengths are in metersPerUnit.
///               References, layers and value clips are not followed.
///   .csv, .tum, .txt   a line a pose: time in s, x, y, z, then the quaternion x, y, z, w, separated by
///               commas or spaces. This is the format of the TUM benchmark (Sturm et al. 2012). Lines that
///               begin with # and a first line of names are skipped.
struct MotionFile {
  std::string file{};  ///< its path
  std::string prim{};  ///< path of the prim in a .usda, as /World/Arm; empty: the only prim with time samples
  float start = 0;     ///< s, added to the file's times; a first one below 0 by rounding alone is then 0
  float scale = 1;     ///< metres a unit; in a .usda a factor to metersPerUnit
  Pose pose{};         ///< of the file's frame in the world
};

/// The keyframes for BodyDef::keyframes, in the order of their times. Transforms that scale are an error, as
/// a body is rigid. `read_file` takes the place of the file system, as WorldDef::read_file. Throws Error(io)
/// if the file cannot be read, and Error(invalid_argument) for another extension. Throws Error(parse), with
/// the line, if it is not understood. Also throws it if there is no such prim, if times do not increase, if
/// a value is not finite, and above 64 MiB, 1,000,000 keyframes of a prim or 1,024 operations.
std::vector<Keyframe> read_keyframes(const MotionFile& motion, const FileReader& read_file = {});

}  // namespace meniscus
