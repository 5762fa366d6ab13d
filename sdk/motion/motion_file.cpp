// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Reads the keyframes of bodies from files of other programs.
#include <meniscus/error.h>
#include <meniscus/motion.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "collision/mesh/file/bytes.h"
#include "collision/mesh/file/defect.h"
#include "pbd/host_memory.h"
#include "sdk/fields/fields.h"
#include "sdk/motion/pose_lines.h"
#include "sdk/motion/tuning.h"
#include "sdk/motion/usda_transform.h"
#include "sdk/world/check/check.h"

namespace meniscus {

namespace {

constexpr uint64_t most_bytes = uint64_t{1} << 26;

std::string extension_of(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
  return extension;
}

std::vector<Keyframe> read(const MotionFile& motion, const FileReader& read_file) {
  const collision::FileSource files(read_file);
  const std::string extension = extension_of(motion.file);
  const bool is_usda = extension == ".usda";
  if (!is_usda && extension != ".csv" && extension != ".tum" && extension != ".txt")
    throw Error(ErrorCode::invalid_argument, "motion file '" + motion.file +
                                                 "' is none of .usda, .csv, .tum and .txt; usdcat of OpenUSD "
                                                 "makes .usda from .usdc");
  if (!files.has(motion.file))
    throw Error(ErrorCode::io, "motion file '" + motion.file + "' is not there, or is not a file");
  uint64_t left = most_bytes;
  const std::string text = files.read(motion.file, left);
  return is_usda ? motion::poses_of(motion::read_usda(text), motion.prim) : motion::read_pose_lines(text);
}

/// Takes the poses of a file into the world.
void place(std::vector<Keyframe>& keyframes, const MotionFile& motion) {
  for (Keyframe& k : keyframes) {
    k.time += motion.start;
    k.pose = motion.pose * Pose{motion.scale * k.pose.position, k.pose.rotation};
  }
  // A start that takes the first time away has few digits.
  float& first = keyframes.front().time;
  if (first < 0 && first > -motion::tuning::start_tolerance * std::fabs(motion.start)) first = 0;
}

void expect_finite(const std::vector<Keyframe>& keyframes) {
  for (size_t k = 0; k < keyframes.size(); ++k) {
    const Vec3 x = keyframes[k].pose.position;
    const Quat q = keyframes[k].pose.rotation;
    for (const float number : {keyframes[k].time, x.x, x.y, x.z, q.x, q.y, q.z, q.w})
      if (!std::isfinite(number))
        throw collision::FileDefect("has its pose " + std::to_string(k) +
                                    " at a time or place beyond all floats");
  }
}

void expect_later_and_later(const std::vector<Keyframe>& keyframes) {
  for (size_t k = 1; k < keyframes.size(); ++k) {
    if (keyframes[k].time > keyframes[k - 1].time) continue;
    throw collision::FileDefect("has its pose " + std::to_string(k) + " at " +
                                std::to_string(keyframes[k].time) + " s, no later than the one before");
  }
}

}  // namespace

std::vector<Keyframe> read_keyframes(const MotionFile& motion, const FileReader& read_file) {
  return pbd::with_host_memory([&] {
    check::def(motion);
    try {
      std::vector<Keyframe> keyframes = read(motion, read_file);
      place(keyframes, motion);
      expect_finite(keyframes);
      expect_later_and_later(keyframes);
      return keyframes;
    } catch (const collision::FileDefect& defect) {
      throw Error(ErrorCode::parse, "motion file '" + motion.file + "' " + defect.what());
    }
  });
}

}  // namespace meniscus
