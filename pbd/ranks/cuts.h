// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// How the columns of cells of a shared world are divided among ranks: into rectangles. Slabs are those that
// are cut along one axis alone, pencils those that are cut along both.
#pragma once

#include <meniscus/types.h>

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "pbd/device/base/view.h"
#include "pbd/ranks/region.h"

namespace meniscus::pbd {

/// `automatic`: those with which the busiest rank has less to do, as Cuts::load says.
enum class CutKind { automatic, slabs, pencils };

/// The axes along which a world is cut.
enum class CutAxes { y, z, both };

/// The particles of each column. Those of columns beyond count for the nearest ones.
struct ColumnCounts {
  int32_t first_y = 0, first_z = 0, layers_y = 1, layers_z = 1;
  std::vector<uint64_t> counts = std::vector<uint64_t>(1);  ///< y runs first

  Region columns() const { return {first_y, first_y + layers_y, first_z, first_z + layers_z}; }
  /// Of the columns of a region.
  uint64_t sum(const Region& region) const;
  /// By layer of one axis: the particles in a region.
  std::vector<uint64_t> layers(const Region& region, bool along_y) const;
  /// Has so many layers of an axis from now on, of which the last ones are empty.
  void extend(bool along_y, int32_t layers);
};

/// Divides consecutive ranks into those below a layer and those from it on.
struct Cut {
  int32_t at;
  uint32_t below;  ///< ranks
  bool along_y;    ///< it is a layer of y, or else of z
};

/// A tree. The first cut divides all ranks. The cuts of those below it follow, and then those of the others.
struct CutsView {
  View<const Cut> cuts;

  MENISCUS_HD uint32_t owner(int32_t y, int32_t z) const {
    uint32_t rank = 0, ranks = cuts.count + 1, next = 0;
    while (ranks > 1) {
      const Cut cut = cuts[next];
      const bool is_below = (cut.along_y ? y : z) < cut.at;
      next += is_below ? 1 : cut.below;
      rank += is_below ? 0 : cut.below;
      ranks = is_below ? cut.below : ranks - cut.below;
    }
    return rank;
  }
};

/// Each rank owns a region. The outer ones have no end there, so every particle has an owner. It is made by
/// recursive bisection (Berger and Bokhari 1987): half of the ranks get their part of the particles, up to
/// whole layers.
class Cuts {
 public:
  /// A region has at least this many layers on each axis.
  static constexpr int32_t least_layers = 3;

  Cuts() = default;
  /// Of the two axes, each cut takes the one with fewer particles on the wrong side of the cut and beside it.
  /// Throws Error(capacity) if there are too few layers.
  Cuts(const ColumnCounts& columns, int ranks, CutAxes axes);
  /// Whether there are enough layers.
  static bool fit(const ColumnCounts& columns, int ranks, CutAxes axes);

  int ranks() const { return static_cast<int>(regions_.size()); }
  const Region& region(int rank) const { return regions_[static_cast<size_t>(rank)]; }
  std::span<const Cut> tree() const { return cuts_; }
  CutsView view() const { return {{cuts_.data(), static_cast<uint32_t>(cuts_.size())}}; }
  bool any_along(bool y) const;
  /// Whether all cuts are along the same axis.
  bool are_slabs() const { return !any_along(true) || !any_along(false); }
  /// The other ranks that have a column within one layer of this rank's region, ascending.
  std::vector<int> neighbours(int rank) const;

  /// The greatest number of particles of a rank, over the mean.
  double imbalance(const ColumnCounts& columns) const;
  /// The time of a substep on the slowest rank, in quarters of what a particle takes. A ghost takes one for
  /// its work and four for its messages. See docs/scale.md for the model.
  uint64_t load(const ColumnCounts& columns) const;
  /// The same regions, all cuts moved by this many layers.
  Cuts moved(int32_t layers) const;

 private:
  void divide(const ColumnCounts& columns, const Region& box, int ranks, CutAxes axes);
  void find_regions();

  std::vector<Cut> cuts_;
  std::vector<Region> regions_ = std::vector<Region>(1);
};

/// The axis of a world's slabs follows from its definition: z, or y if gravity is along z.
inline bool has_layers_along_y(Vec3 gravity) {
  return std::fabs(gravity.z) > std::fabs(gravity.y);
}

}  // namespace meniscus::pbd
