// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "sdk/cli/record/frame_sample.h"
#include "sdk/cli/record/way_columns.h"

namespace meniscus::cli {

/// Counts passages of particles through cloth from frame to frame. Between two frames both are taken to move
/// along straight lines, which they do not: so passages to and fro cancel, and what is left of a piece is
/// what any other way between the two frames would leave, too, if it leads around no border. A tear's two
/// lips are where they were as one.
class ClothCrossings {
 public:
  void start(const FrameSample& sample);
  /// The state of a later frame. Particles may have come and gone.
  void add(const FrameSample& sample);

  /// So far, through each piece; 0 for one that has never been seen.
  uint64_t through(std::size_t piece) const { return piece < counts_.size() ? counts_[piece] : 0; }
  uint64_t through_all() const;

 private:
  struct Corners {
    std::array<Vec3, 3> at;
  };

  std::vector<Way> ways_to(const io::ParticleFrame& now) const;
  void count(const WayColumns& ways, const std::vector<Aabb>& boxes, const io::ClothFrame& cloth);
  void keep(const FrameSample& sample);

  std::vector<Corners> corners_;  // of the last frame's triangles
  std::vector<Vec3> positions_;   // of the last frame's particles
  std::vector<ParticleId> ids_;
  std::vector<uint64_t> counts_;
};

/// +1 where a point passes through a triangle along its normal, −1 against it, 0 where it does not, or comes
/// back: corners and point go along straight lines.
int passage(const std::array<Vec3, 3>& from, const std::array<Vec3, 3>& to, Vec3 point_from, Vec3 point_to);

}  // namespace meniscus::cli
