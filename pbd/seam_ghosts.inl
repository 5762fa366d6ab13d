// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The kernels that make and list the ghosts of periodic axes, and their launches.
#pragma once

#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "pbd/list_writers.h"
#include "pbd/neighbour_search.inl"
#include "pbd/seam_ghosts.h"
#include "pbd/tuning.h"

namespace meniscus::pbd {

namespace seam_kernels {

/// Points at their places between the ends of the axes.
template <class Points>
struct Wrapped {
  Points points;
  PeriodicAxes axes;

  MENISCUS_HD Vec4 operator()(uint32_t i) const {
    const Vec4 p = points(i);
    return shifted(p, axes.wrap(p.xyz()));
  }
};

/// Moves a particle and its previous position alike, so that their difference stays.
struct Wrap {
  PeriodicAxes axes;
  View<Vec4> position, previous;
  CoarsePositions coarse;  ///< to be kept up to date, if there are any
  GridView grid;

  MENISCUS_HD void operator()(uint32_t i) const {
    const Vec3 shift = axes.wrap(position[i].xyz());
    if (shift == Vec3{0, 0, 0}) return;
    position[i] = shifted(position[i], shift);
    previous[i] = shifted(previous[i], shift);
    if (coarse.blocks.count) coarse.put(i, grid, position[i].xyz());
  }
};

struct CountImages {
  PeriodicAxes axes;
  float reach;
  View<const Vec4> position;
  View<uint32_t> counts;

  MENISCUS_HD void operator()(uint32_t i) const {
    counts[i] = SeamImages{axes.across_seams(position[i].xyz(), reach)}.count();
  }
};

/// Writes the source and the offset of each image for which there is room, in the order of the sources.
struct PlaceImages {
  PeriodicAxes axes;
  float reach;
  View<const Vec4> position;
  View<const uint32_t> start;
  View<uint32_t> source;
  View<Vec4> offset;

  MENISCUS_HD void operator()(uint32_t i) const {
    const SeamImages images{axes.across_seams(position[i].xyz(), reach)};
    for (uint32_t n = 0; n < images.count(); ++n) {
      const uint32_t k = start[i] + n;
      if (k >= source.count) return;
      source[k] = i;
      offset[k] = with_w(images.offset(n), 0);
    }
  }
};

/// Images in the order in which they were placed. Room that is not used is not finite, which the sort spreads
/// over its cells.
struct Images {
  View<const uint32_t> source;
  View<const Vec4> offset;
  View<const Vec4> position;
  View<const uint32_t> total;
  float nowhere;  ///< NaN

  MENISCUS_HD bool has(uint32_t k) const { return k < total[0]; }
  MENISCUS_HD Vec4 operator()(uint32_t k) const {
    if (!has(k)) return {nowhere, nowhere, nowhere, 0};
    return shifted(load(position, load(source, k)), load(offset, k).xyz());
  }
};

/// Sorts the images by cell, and writes them behind the particles.
struct MakeGhosts {
  CellOrder order;
  Images images;
  View<uint32_t> source;
  View<Vec4> offset;
  uint32_t first;
  View<Vec4> position, previous, velocity;
  View<Phase> phase;
  View<uint32_t> number;

  MENISCUS_HD void operator()(uint32_t k) const {
    const uint32_t from = order.find(k), to = first + k;
    if (!images.has(from)) {
      constexpr float away = Particles::far_away;
      source[k] = no_index;
      position[to] = previous[to] = {away, away, away, 0};
      return;
    }
    const uint32_t i = images.source[from];
    const Vec4 shift = images.offset[from];
    source[k] = i;
    offset[k] = shift;
    position[to] = shifted(position[i], shift.xyz());
    previous[to] = shifted(previous[i], shift.xyz());
    velocity[to] = velocity[i];
    phase[to] = phase[i];
    number[to] = number[i];
  }
};

struct ListGhosts {
  PeriodicAxes axes;
  float seam_reach, reach2;
  View<const Vec4> position;
  uint32_t first;
  GridView grid;  ///< of the ghosts
  NeighbourView lists;
  View<uint32_t> longest;

  MENISCUS_HD void operator()(uint32_t i) const {
    const Vec3 self = position[i].xyz();
    if (!is_finite(self) || axes.across_seams(self, seam_reach) == Vec3{0, 0, 0}) return;
    ListExtension list(lists, i);
    RunsAround(grid, self).for_each([&](uint32_t begin, uint32_t end) {
      for (uint32_t k = begin; k < end; ++k) {
        const Vec3 d = self - position[first + k].xyz();
        if (dot(d, d) < reach2) list.add(first + k);
      }
    });
    atomic_max(longest[0], list.finish());
  }
};

}  // namespace seam_kernels

/// The search needs no room for lists; its sort takes four words a ghost.
template <class D>
SeamGhosts<D>::SeamGhosts(D& device, const PeriodicAxes& axes, float support_radius)
    : device_(device), axes_(axes), support_radius_(support_radius), search_(device, support_radius, 4) {}

/// m. Particles are between the ends within rounding, so ghosts are made from a little further than the
/// support radius.
template <class D>
float SeamGhosts<D>::reach() const {
  return search_tuning::seam_reach * support_radius_;
}

template <class D>
uint32_t SeamGhosts<D>::expected(uint32_t particles) const {
  double with_images = particles;
  for (const float extent : {axes_.extent.x, axes_.extent.y, axes_.extent.z}) {
    if (extent > 0) with_images *= 1 + 2 * double{reach()} / extent;
  }
  return static_cast<uint32_t>(std::ceil(with_images)) - particles;
}

template <class D>
void SeamGhosts<D>::reserve(uint32_t particles, uint32_t ghosts) {
  room_ = ghosts;
  counts_.resize_discard(particles);
  start_.resize_discard(particles + 1);
  for (Buffer<uint32_t>* b : {&unsorted_source_, &order_of_making_, &source_}) b->resize_discard(ghosts);
  for (Buffer<Vec4>* b : {&unsorted_offset_, &offset_}) b->resize_discard(ghosts);
  std::vector<uint32_t> numbers(ghosts);
  std::iota(numbers.begin(), numbers.end(), 0u);
  order_of_making_.write(numbers);
  search_.reserve(ghosts);
}

template <class D>
void SeamGhosts<D>::wrap(Particles& particles, const CoarsePositions& coarse, const GridView& grid) {
  const ParticleView p = particles.view();
  device_.parallel_for("ghosts/wrap", p.sorted,
                       seam_kernels::Wrap{axes_, p.position, particles.previous.view(), coarse, grid});
}

template <class D>
void SeamGhosts<D>::make(Particles& particles, const Aabb& extent, View<SumNote> note) {
  using namespace seam_kernels;
  const ParticleView p = particles.view();
  first_ = p.owned;
  device_.parallel_for("ghosts/count", p.sorted, CountImages{axes_, reach(), p.position, counts_.view()});
  device_.exclusive_scan("ghosts/offsets", View<const uint32_t>{counts_.view().data, p.sorted}, start_.view(),
                         ~0u, note);
  device_.parallel_for("ghosts/place", p.sorted,
                       PlaceImages{axes_, reach(), p.position, start_.view(), unsorted_source_.view(),
                                   unsorted_offset_.view()});
  const Vec3 around{reach(), reach(), reach()};
  search_.fit({extent.lower - around, extent.upper + around}, room_);
  const Images images{unsorted_source_.view(), unsorted_offset_.view(), p.position,
                      View<const uint32_t>(start_.view().from(p.sorted)),
                      std::numeric_limits<float>::quiet_NaN()};
  const CellOrder order = search_.sort(images, order_of_making_.view());
  device_.parallel_for(
      "ghosts/make", room_,
      MakeGhosts{order, images, source_.view(), offset_.view(), first_, p.position, particles.previous.view(),
                 p.velocity, particles.phase.current.view(), particles.number.current.view()});
}

template <class D>
void SeamGhosts<D>::list(const ParticleView& particles, const NeighbourView& lists, View<uint32_t> longest) {
  device_.parallel_for("ghosts/list", particles.sorted,
                       seam_kernels::ListGhosts{axes_, reach(), support_radius_ * support_radius_,
                                                particles.position, first_, search_.grid(), lists, longest});
}

}  // namespace meniscus::pbd
