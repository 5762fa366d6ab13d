// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The ghosts of particles near the seams of periodic axes.
#pragma once

#include "pbd/ghosts.h"
#include "pbd/math/periodic_axes.h"
#include "pbd/neighbour_search.h"

namespace meniscus::pbd {

/// Makes the images of particles near a seam as ghosts, and lists them as neighbours. Without periodic axes
/// it holds no memory, and the solver leaves it alone.
///
/// Ghosts are sorted by the cells of a grid of their own. So list() needs to know nothing of seams but which
/// particles are near one, and ghosts from elsewhere could stand beside these.
template <class D>
class SeamGhosts {
 public:
  SeamGhosts(D& device, const PeriodicAxes& axes, float support_radius);

  bool any() const { return axes_.any(); }
  const PeriodicAxes& axes() const { return axes_; }

  /// The number of ghosts that so many particles have where they fill the axes evenly.
  uint32_t expected(uint32_t particles) const;
  /// Makes room for this many ghosts of this many particles.
  void reserve(uint32_t particles, uint32_t ghosts);

  /// Takes particles that have left across a seam to the other end, with their previous positions.
  void wrap(Particles& particles, const CoarsePositions& coarse, const GridView& grid);
  /// Makes the ghosts behind the particles, which are inside `extent`. Ghosts for which there is no room are
  /// left out; note[0], on the device, records how many there are.
  void make(Particles& particles, const Aabb& extent, View<SumNote> note);
  /// Appends the ghosts in reach to the neighbour lists. `longest`: see NeighbourSearch::list.
  void list(const ParticleView& particles, const NeighbourView& lists, View<uint32_t> longest);

  /// Of the last make().
  GhostView view() const { return {source_.view(), offset_.view(), first_}; }

 private:
  float reach() const;

  D& device_;
  PeriodicAxes axes_;
  float support_radius_;
  uint32_t first_ = 0, room_ = 0;
  NeighbourSearch<D> search_;  // sorts, and lists nothing

  Buffer<uint32_t> counts_{device_, "ghost counts"};
  Buffer<uint32_t> start_{device_, "ghost offsets"};
  Buffer<uint32_t> unsorted_source_{device_, "ghost sources"};
  Buffer<uint32_t> order_of_making_{device_, "ghost numbers"};
  Buffer<Vec4> unsorted_offset_{device_, "ghost offsets"};
  Buffer<uint32_t> source_{device_, "ghost sources"};
  Buffer<Vec4> offset_{device_, "ghost offsets"};
};

}  // namespace meniscus::pbd
