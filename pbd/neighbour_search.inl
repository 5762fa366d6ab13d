// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>

#include "pbd/device/atomics.h"
#include "pbd/neighbour_search.h"

namespace meniscus::pbd {

namespace neighbour_kernels {

// The sort is a counting sort by cell. In each cell particles are first placed as they happen to arrive, then
// in the order of their present indices: so the result depends on nothing else.

/// Notes each particle's cell, and counts the cell's particles.
struct CountInCells {
  View<const Vec4> points;
  GridView grid;
  View<uint32_t> key, arrival, counts;

  MENISCUS_HD void operator()(uint32_t i) const {
    const Vec3 p = points[i].xyz();
    // What is not finite is near nothing; all in one cell it would take for ever.
    const uint32_t cell = is_finite(p) ? grid.key(grid.coordinates(p)) : i & (grid.cell_count() - 1);
    key[i] = cell;
    arrival[i] = atomic_add(counts[cell], 1);
  }
};

struct PlaceByArrival {
  View<const uint32_t> key, arrival, start;
  View<uint32_t> placed;

  MENISCUS_HD void operator()(uint32_t i) const { placed[start[key[i]] + arrival[i]] = i; }
};

/// Empties the counts on the way, for the next time.
struct PlaceInOrder {
  View<const uint32_t> key, start, placed;
  View<uint32_t> order, counts;
  uint32_t particles, cells;

  MENISCUS_HD void operator()(uint32_t i) const {
    const uint32_t begin = start[key[i]], end = start[key[i] + 1];
    uint32_t before = 0;
    for (uint32_t k = begin; k < end; ++k) before += placed[k] < i;
    order[begin + before] = i;
    for (uint32_t cell = i; cell < cells; cell += particles) counts[cell] = 0;
  }
};

struct ListNeighbours {
  static constexpr uint32_t resident_blocks = 8;  // see CudaDevice

  View<const Vec4> position;
  GridView grid;
  float reach2;
  View<uint32_t> index, counts, longest;
  uint32_t row_capacity, stride, sentinel;

  template <class D>
  MENISCUS_HD void run(uint32_t i) const {
    if constexpr (std::is_same_v<D, CudaTeam>) {
      TeamWriter writer(index.data, row_capacity, stride, i);
      if (is_finite(position[i].xyz())) list_by_team(i, writer);
      note(i, writer.finish(sentinel), D::leads());
    } else {
      ListWriter<D> writer(index.data, row_capacity, stride, i);
      if (is_finite(position[i].xyz())) list<D>(i, writer);
      note(i, writer.finish(sentinel), true);
    }
  }

 private:
  template <class D>
  MENISCUS_HD void list(uint32_t i, ListWriter<D>& writer) const {
    const Vec3 self = position[i].xyz();
    for_each_run(grid, self, [&](uint32_t begin, uint32_t end) {
      for (uint32_t j = begin; j < end; j += 32) writer.append(j, near_ones<D>(self, i, j, end));
    });
  }

  /// Each thread has runs of its own.
  MENISCUS_HD void list_by_team(uint32_t i, TeamWriter& writer) const {
    const Vec3 self = position[i].xyz();
    const Surroundings around(grid, self);
    for (uint32_t n = CudaTeam::rank(); any_in_team(n < around.runs()); n += CudaTeam::lane_count) {
      const Run run = n < around.runs() ? around.run(n) : Run{0, 0};
      for (uint32_t j = run.begin; any_in_team(j < run.end); j += 32) {
        writer.append(j, j < run.end ? near_ones<CudaTeam>(self, i, j, run.end) : 0);
      }
    }
  }

  MENISCUS_HD void note(uint32_t i, uint32_t found, bool leads) const {
    if (!leads) return;
    counts[i] = found < row_capacity ? found : row_capacity;
    atomic_max(longest[0], found);
  }

  /// Bit k is set where particle first + k, one of at most 32 before `end`, is in reach and is not i. Whole
  /// masks keep the threads of a warp together: the rare hits are written out afterwards.
  template <class D>
  MENISCUS_HD uint32_t near_ones(Vec3 self, uint32_t i, uint32_t first, uint32_t end) const {
    const uint32_t near = D::Lister::near(position, self, reach2, first, end - first < 32 ? end - first : 32);
    return i - first < 32 ? near & ~(1u << (i - first)) : near;
  }
};

inline uint32_t bits_for(float cells, uint32_t least) {
  uint32_t bits = least;
  while (bits < 30 && static_cast<float>(1u << bits) < cells) ++bits;
  return bits;
}

}  // namespace neighbour_kernels

template <class D>
NeighbourSearch<D>::NeighbourSearch(D& device, float support_radius)
    : device_(device), support_radius_(support_radius) {
  grid_.inverse_reach = 1.0f / support_radius;
  longest_.resize_discard(1);
  longest_.fill(0);
}

template <class D>
void NeighbourSearch<D>::reserve(uint32_t capacity) {
  capacity_ = capacity;
  if (row_capacity_ == 0) row_capacity_ = 48;  // at h = 2 s about 32 are usual, and more than 44 rare
  const uint32_t size = capacity + Particles::padding;
  for (Buffer<uint32_t>* b : {&order_, &counts_}) b->resize_discard(size);
  index_.resize_discard(size_t{size} * row_capacity_);
  uint32_t cells = 4096;
  while (cells < GridView::slices * capacity) cells *= 2;
  cell_counts_.resize_discard(cells);
  cell_counts_.fill(0);
  cell_start_.resize_discard(cells + 1);
}

template <class D>
void NeighbourSearch<D>::fit(const Aabb& extent) {
  using neighbour_kernels::bits_for;
  const Vec3 reaches = grid_.inverse_reach * (extent.upper - extent.lower) + Vec3{2, 2, 2};
  uint32_t bits[3] = {bits_for(GridView::slices * reaches.x, GridView::least_bits_x),
                      bits_for(reaches.y, GridView::least_bits), bits_for(reaches.z, GridView::least_bits)};
  const uint32_t most_bits = static_cast<uint32_t>(std::bit_width(cell_counts_.size())) - 1;
  while (bits[0] + bits[1] + bits[2] > most_bits) --*std::max_element(bits, bits + 3);
  grid_.bits_x = bits[0];
  grid_.bits_y = bits[1];
  grid_.bits_z = bits[2];
  grid_.start = cell_start_.view().first(grid_.cell_count() + 1);
}

template <class D>
void NeighbourSearch<D>::sort(View<const Vec4> points, uint32_t count) {
  using namespace neighbour_kernels;
  const uint32_t cells = grid_.cell_count();
  const View<uint32_t> counts = cell_counts_.view().first(cells);
  uint32_t* const room = index_.view().data;
  const View<uint32_t> keys{room, count}, arrival{room + count, count}, placed{arrival.data + count, count};
  device_.parallel_for("neighbours/cells", count, CountInCells{points, grid_, keys, arrival, counts});
  try {
    device_.exclusive_scan("neighbours/starts", View<const uint32_t>(counts), cell_start_.view());
  } catch (...) {
    cell_counts_.fill(0);
    throw;
  }
  device_.parallel_for("neighbours/place", count, PlaceByArrival{keys, arrival, grid_.start, placed});
  device_.parallel_for("neighbours/order", count,
                       PlaceInOrder{keys, grid_.start, placed, order_.view(), counts, count, cells});
}

template <class D>
void NeighbourSearch<D>::list(const ParticleView& particles, uint32_t sentinel) {
  using namespace neighbour_kernels;
  device_.parallel_for_long(
      "neighbours/list", particles.sorted,
      ListNeighbours{particles.position, grid_, support_radius_ * support_radius_, index_.view(),
                     counts_.view(), longest_.view(), row_capacity_, stride(), sentinel});
}

template <class D>
void NeighbourSearch<D>::grow_rows(uint32_t needed) {
  const uint32_t row_capacity = (needed + needed / 8 + 15) / 16 * 16;
  index_.resize_or_stay(size_t{capacity_ + Particles::padding} * row_capacity);
  row_capacity_ = row_capacity;
}

template <class D>
NeighbourView NeighbourSearch<D>::view() {
  return {index_.view(), counts_.view(), row_capacity_, stride()};
}

}  // namespace meniscus::pbd
