// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Paths of particles, sorted into columns so that those near a box are found fast.
#pragma once

#include <meniscus/types.h>

#include <cstddef>
#include <vector>

#include "pbd/surface_tree/boxes.h"

namespace meniscus::cli {

/// The straight path of a particle from one frame to the next.
struct Path {
  Vec3 from, to;
};

/// The box around a path.
inline Aabb around(const Path& path) {
  return {min(path.from, path.to), max(path.from, path.to)};
}

inline Aabb united(const Aabb& a, const Aabb& b) {
  return {min(a.lower, b.lower), max(a.upper, b.upper)};
}

/// The paths whose boxes meet a region, sorted by column along y. A path is in the column of its box's lower
/// corner.
class PathColumns {
 public:
  PathColumns(const std::vector<Path>& paths, const Aabb& region);

  std::size_t count() const { return paths_.size(); }

  /// Calls visit(number below count(), path) for all whose boxes meet this one.
  template <class Visit>
  void for_each_near(const Aabb& box, const Visit& visit) const {
    const Place first = place_of(box.lower - longest_), last = place_of(box.upper);
    for (std::size_t z = first.z; z <= last.z; ++z) {
      // The columns of a row are contiguous.
      for (std::size_t n = start_[each * z + first.x]; n < start_[each * z + last.x + 1]; ++n)
        if (pbd::overlap(around(paths_[n]), box)) visit(n, paths_[n]);
    }
  }

 private:
  static constexpr std::size_t each = 64;  // columns on each of the two axes

  struct Place {
    std::size_t x, z;
  };

  Place place_of(Vec3 point) const;

  std::vector<Path> paths_;
  std::vector<std::size_t> start_;  // by column, and the end
  Vec3 lower_, longest_{};          // lower corner of the columns; largest extent of a path's box
  float per_x_ = 0, per_z_ = 0;     // columns per metre
};

}  // namespace meniscus::cli
