// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Counts of particles that passed through cloth, from one frame to the next.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "sdk/cli/record/frame_sample.h"
#include "sdk/cli/record/path_columns.h"

namespace meniscus::cli {

/// Counts passages of particles through cloth from frame to frame. Between two frames both are assumed to
/// move along straight lines, which they do not. Passages in opposite directions cancel. The net count of a
/// piece is that of any other paths between the two frames, unless they lead around a border. The two sides
/// of a fresh tear start from the place that they had as one.
class ClothCrossings {
 public:
  void start(const FrameSample& sample);
  /// Adds the state of a later frame. Particles may have been added and removed.
  void add(const FrameSample& sample);

  /// Passages through a piece so far; 0 for one that has never occurred.
  uint64_t through(std::size_t piece) const { return piece < counts_.size() ? counts_[piece] : 0; }
  uint64_t through_all() const;

 private:
  struct Corners {
    std::array<Vec3, 3> at;
  };

  std::vector<Path> paths_to(const io::ParticleFrame& now) const;
  void count(const PathColumns& paths, const std::vector<Aabb>& boxes, const io::ClothFrame& cloth);
  void keep(const FrameSample& sample);

  std::vector<Corners> corners_;  // of the triangles in the last frame
  std::vector<Vec3> positions_;   // of the particles in the last frame
  std::vector<ParticleId> ids_;
  std::vector<uint64_t> counts_;
};

/// +1 if a point passes through a triangle along its normal, −1 if against it, 0 if it does not pass or comes
/// back. Corners and point move along straight lines.
int passage(const std::array<Vec3, 3>& from, const std::array<Vec3, 3>& to, Vec3 point_from, Vec3 point_to);

}  // namespace meniscus::cli
