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

/// Empties the table's entries on the way.
struct ComputeKeys {
  View<const Vec4> points;
  GridView grid;
  View<CellRange> cells;
  View<uint32_t> keys, identity;
  uint32_t count;

  MENISCUS_HD void operator()(uint32_t i) const {
    keys[i] = grid.key(grid.coordinates(points[i].xyz()));
    identity[i] = i;
    for (uint32_t cell = i; cell < cells.count; cell += count) cells[cell] = {0, 0};
  }
};

/// Notes where each cell that holds particles begins and ends.
struct FindCells {
  View<const uint32_t> keys;
  View<CellRange> cells;
  uint32_t count;

  MENISCUS_HD void operator()(uint32_t i) const {
    const uint32_t key = keys[i];
    if (i == 0 || keys[i - 1] != key) cells[key].begin = i;
    if (i + 1 == count || keys[i + 1] != key) cells[key].end = i + 1;
  }
};

template <class D>
struct ListNeighbours {
  View<const Vec4> position;
  GridView grid;
  float reach2;
  View<uint32_t> index, counts, longest;
  uint32_t row_capacity, stride, sentinel;

  MENISCUS_HD void operator()(uint32_t i) const {
    const Vec3 self = position[i].xyz();
    ListWriter<D> writer(index.data, row_capacity, stride, i);
    for_each_run(grid, grid.coordinates(self), [&](uint32_t begin, uint32_t end) {
      for (uint32_t j = begin; j < end; j += 32) writer.append(j, near_ones(self, i, j, end));
    });
    const uint32_t found = writer.finish(sentinel);
    counts[i] = found < row_capacity ? found : row_capacity;
    if (found > longest[0]) atomic_max(longest[0], found);
  }

  /// Bit k is set where particle first + k, one of at most 32 before `end`, is in reach and is not i. Whole
  /// masks keep the threads of a warp together: the rare hits are written out afterwards.
  MENISCUS_HD uint32_t near_ones(Vec3 self, uint32_t i, uint32_t first, uint32_t end) const {
    using Real = typename D::Lister::Real;
    const uint32_t count = end - first < 32 ? end - first : 32;
    uint32_t near = 0;
    for (uint32_t k = 0; k < count; k += D::Lister::lane_count) {
      const Vec3Of<Real> d = self - load_run(position, first + k, static_cast<Real*>(nullptr)).xyz();
      near |= less_mask(dot(d, d), Real(reach2)) << k;
    }
    if (count < 32) near &= (1u << count) - 1;
    if (i - first < 32) near &= ~(1u << (i - first));
    return near;
  }
};

inline uint32_t bits_for(float cells) {
  uint32_t bits = 2;
  while (bits < 30 && static_cast<float>(1u << bits) < cells) ++bits;
  return bits;
}

}  // namespace neighbour_kernels

template <class D>
NeighbourSearch<D>::NeighbourSearch(D& device, float support_radius)
    : device_(device), support_radius_(support_radius) {
  grid_.inverse_cell = 1.0f / support_radius;
  longest_.resize_discard(1);
  longest_.fill(0);
}

template <class D>
void NeighbourSearch<D>::reserve(uint32_t capacity) {
  if (capacity <= capacity_) return;
  capacity_ = capacity;
  if (row_capacity_ == 0) row_capacity_ = 64;  // about 32 are usual at h = 2 s
  const uint32_t size = capacity + Particles::padding;
  for (Buffer<uint32_t>* b : {&keys_, &sorted_keys_, &identity_, &order_, &counts_}) b->resize_discard(size);
  index_.resize_discard(size_t{size} * row_capacity_);
  uint32_t cells = 4096;
  while (cells < 2 * capacity) cells *= 2;
  cells_.resize_discard(cells);
}

template <class D>
void NeighbourSearch<D>::fit(const Aabb& extent) {
  using neighbour_kernels::bits_for;
  const Vec3 cells = grid_.inverse_cell * (extent.upper - extent.lower) + Vec3{2, 2, 2};
  uint32_t bits[3] = {bits_for(cells.x), bits_for(cells.y), bits_for(cells.z)};
  const uint32_t most_bits = static_cast<uint32_t>(std::bit_width(cells_.size())) - 1;
  while (bits[0] + bits[1] + bits[2] > most_bits) --*std::max_element(bits, bits + 3);
  grid_.bits_x = bits[0];
  grid_.bits_y = bits[1];
  grid_.bits_z = bits[2];
  grid_.cells = cells_.view().first(1u << grid_.key_bits());
}

template <class D>
void NeighbourSearch<D>::sort(View<const Vec4> points, uint32_t count) {
  using namespace neighbour_kernels;
  const View<CellRange> cells = cells_.view().first(grid_.cells.count);
  device_.parallel_for("neighbours/keys", count,
                       ComputeKeys{points, grid_, cells, keys_.view(), identity_.view(), count});
  device_.sort_pairs("neighbours/sort", keys_.view().first(count), sorted_keys_.view().first(count),
                     identity_.view().first(count), order_.view().first(count), grid_.key_bits());
  device_.parallel_for("neighbours/cells", count, FindCells{sorted_keys_.view(), cells, count});
}

template <class D>
void NeighbourSearch<D>::list(const ParticleView& particles, uint32_t sentinel) {
  using namespace neighbour_kernels;
  device_.parallel_for(
      "neighbours/list", particles.owned,
      ListNeighbours<D>{particles.position, grid_, support_radius_ * support_radius_, index_.view(),
                        counts_.view(), longest_.view(), row_capacity_, stride(), sentinel});
}

template <class D>
void NeighbourSearch<D>::grow_rows(uint32_t needed) {
  row_capacity_ = (needed + needed / 8 + 15) / 16 * 16;
  index_.resize_discard(size_t{capacity_ + Particles::padding} * row_capacity_);
}

template <class D>
NeighbourView NeighbourSearch<D>::view() const {
  return {index_.view(), counts_.view(), row_capacity_, stride()};
}

}  // namespace meniscus::pbd
