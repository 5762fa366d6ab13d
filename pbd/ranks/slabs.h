// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// How the cells of a shared world are divided among ranks: into slabs of whole layers of cells.
#pragma once

#include <meniscus/types.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace meniscus::pbd {

/// Rank r owns the layers [first(r), end(r)). The first and the last slab have no outer bound, so every
/// particle has an owner. A particle in a rank's first or last layer is a ghost of the rank beside it.
class Slabs {
 public:
  /// A slab has at least this many layers. So only the ranks beside a rank have ghosts of it, and no particle
  /// is a ghost of both.
  static constexpr int32_t least_layers = 3;
  /// Outside of all layers that a grid has.
  static constexpr int32_t unbounded = int32_t{1} << 30;

  Slabs() = default;
  /// Slabs with as even counts as whole layers allow. `counts`: the particles of the layers from `first` on.
  /// Throws Error(capacity) if there are fewer than 3 layers a rank.
  Slabs(int32_t first, std::span<const uint64_t> counts, int ranks);

  int ranks() const { return static_cast<int>(cuts_.size()) + 1; }
  int32_t first(int rank) const { return rank == 0 ? -unbounded : cuts_[static_cast<size_t>(rank) - 1]; }
  int32_t end(int rank) const { return rank + 1 == ranks() ? unbounded : cuts_[static_cast<size_t>(rank)]; }
  /// The cuts between the ranks, ascending.
  std::span<const int32_t> cuts() const { return cuts_; }
  int owner(int32_t layer) const;

  /// The greatest number of particles of a rank, over the mean.
  double imbalance(int32_t first, std::span<const uint64_t> counts) const;
  /// The same slabs, all cuts moved by this many layers.
  Slabs moved(int32_t layers) const;

 private:
  std::vector<int32_t> cuts_;
};

/// The axis of a world's slabs follows from its definition: z, or y if gravity is along z.
inline bool has_layers_along_y(Vec3 gravity) {
  return std::fabs(gravity.z) > std::fabs(gravity.y);
}

}  // namespace meniscus::pbd
