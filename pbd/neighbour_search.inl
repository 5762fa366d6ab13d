// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include "pbd/device/atomics.h"
#include "pbd/neighbour_search.h"

namespace meniscus::pbd {

namespace neighbour_kernels {

struct ComputeKeys {
  ParticleView particles;
  GridView grid;
  Vec3 gravity;
  float dt;
  View<uint32_t> keys, identity;

  MENISCUS_HD void operator()(uint32_t i) const {
    const Vec4 x = particles.position[i];
    Vec3 v = particles.velocity[i].xyz();
    if (x.w > 0) v += dt * gravity;
    keys[i] = grid.key(grid.coordinates(x.xyz() + dt * v));
    identity[i] = i;
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
  View<uint32_t> index, counts, overflow;
  uint32_t row_capacity, stride, sentinel;

  MENISCUS_HD void operator()(uint32_t i) const {
    using Real = typename D::Real;
    const Vec3 self = position[i].xyz();
    NeighbourWriter<D> writer(index.data, row_capacity, stride, i);
    for_each_run(grid, grid.coordinates(self), [&](uint32_t begin, uint32_t end) {
      for (uint32_t j = begin; j < end; j += D::lane_count) {
        const Vec3Of<Real> d = self - load_run(position, j, static_cast<Real*>(nullptr)).xyz();
        uint32_t near = less_mask(dot(d, d), Real(reach2));
        if (end - j < D::lane_count) near &= (1u << (end - j)) - 1;
        for (; near; near &= near - 1) {
          const uint32_t k = j + lowest_bit(near);
          if (k != i) writer.append(k);
        }
      }
    });
    const uint32_t found = writer.finish(sentinel);
    counts[i] = found < row_capacity ? found : row_capacity;
    if (found > row_capacity) atomic_max(overflow[0], found);
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
  overflow_.resize_discard(1);
  overflow_.fill(0);
}

template <class D>
void NeighbourSearch<D>::reserve(uint32_t capacity) {
  if (capacity <= capacity_) return;
  capacity_ = capacity;
  if (row_capacity_ == 0) row_capacity_ = 64;  // about 32 are usual at h = 2 s
  const uint32_t size = capacity + Particles::padding;
  for (Buffer<uint32_t>* b : {&keys_, &sorted_keys_, &identity_, &order_, &counts_}) b->resize_discard(size);
  index_.resize_discard(size * row_capacity_);
  uint32_t cells = 4096;
  while (cells < 2 * capacity) cells *= 2;
  cells_.resize_discard(cells);
}

template <class D>
void NeighbourSearch<D>::fit(const Aabb& extent) {
  using neighbour_kernels::bits_for;
  const Vec3 cells = grid_.inverse_cell * (extent.upper - extent.lower) + Vec3{2, 2, 2};
  uint32_t bits[3] = {bits_for(cells.x), bits_for(cells.y), bits_for(cells.z)};
  while ((uint64_t{1} << (bits[0] + bits[1] + bits[2])) > cells_.size()) --*std::max_element(bits, bits + 3);
  grid_.bits_x = bits[0];
  grid_.bits_y = bits[1];
  grid_.bits_z = bits[2];
  grid_.cells = cells_.view().first(1u << grid_.key_bits());
}

template <class D>
void NeighbourSearch<D>::sort(const ParticleView& particles, Vec3 gravity, float dt) {
  using namespace neighbour_kernels;
  count_ = particles.owned + particles.ghosts;
  device_.parallel_for("neighbours/keys", count_,
                       ComputeKeys{particles, grid_, gravity, dt, keys_.view(), identity_.view()});
  device_.sort_pairs("neighbours/sort", keys_.view().first(count_), sorted_keys_.view().first(count_),
                     identity_.view().first(count_), order_.view().first(count_), grid_.key_bits());
  device_.fill(grid_.cells.data, 0, grid_.cells.count * sizeof(CellRange));
  device_.parallel_for("neighbours/cells", count_, FindCells{sorted_keys_.view(), grid_.cells, count_});
}

template <class D>
void NeighbourSearch<D>::list(const ParticleView& particles, uint32_t sentinel) {
  using namespace neighbour_kernels;
  device_.parallel_for(
      "neighbours/list", particles.owned,
      ListNeighbours<D>{particles.position, grid_, support_radius_ * support_radius_, index_.view(),
                        counts_.view(), overflow_.view(), row_capacity_, capacity_, sentinel});
}

template <class D>
void NeighbourSearch<D>::grow_rows(uint32_t needed) {
  row_capacity_ = (needed + needed / 8 + 15) / 16 * 16;
  index_.resize_discard((capacity_ + Particles::padding) * row_capacity_);
  overflow_.fill(0);
}

template <class D>
NeighbourView NeighbourSearch<D>::view() const {
  return {index_.view(), counts_.view(), row_capacity_, capacity_};
}

}  // namespace meniscus::pbd
