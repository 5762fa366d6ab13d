// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Builds the sparse grid of blocks: marks, sorts and numbers them, and links neighbours.
#pragma once

#include <meniscus/error.h>

#include <utility>

#include "fluid/surface/block_grid.h"

namespace meniscus::fluid {

namespace block_kernels {

using pbd::View;

struct NumberInOrder {
  View<uint32_t> order;

  MENISCUS_HD void operator()(uint32_t i) const { order[i] = i; }
};

/// Half of each block's key, in the present order.
struct SortKey {
  BlockTable table;
  View<const uint32_t> order;
  View<uint32_t> out;
  uint32_t shift;

  MENISCUS_HD void operator()(uint32_t i) const {
    out[i] = static_cast<uint32_t>(table.keys[table.slots[order[i]]] >> shift);
  }
};

struct NumberBlocks {
  BlockTable table;
  View<const uint32_t> order;
  View<GridPlace> places;

  MENISCUS_HD void operator()(uint32_t i) const {
    const uint32_t slot = table.slots[order[i]];
    table.numbers[slot] = i;
    places[i] = BlockTable::place_of(table.keys[slot]);
  }
};

struct FindAround {
  BlockTable table;
  View<const GridPlace> places;
  View<uint32_t> around;

  MENISCUS_HD void operator()(uint32_t i) const {
    const GridPlace p = places[i / 27];
    const int32_t n = static_cast<int32_t>(i % 27);
    around[i] = table.find({p.x + n % 3 - 1, p.y + n / 3 % 3 - 1, p.z + n / 9 - 1});
  }
};

}  // namespace block_kernels

template <class D>
template <class Mark>
void BlockGrid<D>::build(const Mark& mark) {
  if (slots_.size() == 0) reserve(1024);
  for (;;) {
    keys_.fill(0xff);
    size_.fill(0);
    table_ = {keys_.view(), numbers_.view(), slots_.view(), size_.view()};
    mark(table_);
    uint32_t found = 0;
    size_.read(std::span(&found, 1));
    if (found < slots_.size()) return number_blocks(found);
    reserve(static_cast<uint32_t>(4 * slots_.size()));
  }
}

template <class D>
void BlockGrid<D>::reserve(uint32_t blocks) {
  if (blocks > 1u << 25) {
    throw Error(ErrorCode::capacity,
                "a surface mesh takes more than 2^25 blocks of 64 nodes; a larger cell_size needs fewer");
  }
  keys_.resize_or_stay(4 * blocks);
  numbers_.resize_or_stay(4 * blocks);
  for (pbd::Buffer<uint32_t>* b : {&sort_keys_, &sorted_keys_, &order_, &sorted_}) b->resize_or_stay(blocks);
  places_.resize_or_stay(blocks);
  around_.resize_or_stay(27 * blocks);
  size_.resize_or_stay(1);
  slots_.resize_or_stay(blocks);  // last, as its length is the capacity
}

/// Sorts by the keys, which are too long for one sort.
template <class D>
void BlockGrid<D>::number_blocks(uint32_t count) {
  using namespace block_kernels;
  view_ = {};
  if (count == 0) return;
  pbd::View<uint32_t> order = order_.view().first(count), sorted = sorted_.view().first(count);
  const pbd::View<uint32_t> keys = sort_keys_.view().first(count),
                            sorted_keys = sorted_keys_.view().first(count);
  device_.parallel_for("blocks/number", count, NumberInOrder{order});
  for (const uint32_t shift : {0u, 32u}) {
    device_.parallel_for("blocks/keys", count, SortKey{table_, order, keys, shift});
    device_.sort_pairs("blocks/sort", keys, sorted_keys, order, sorted, 32);
    std::swap(order, sorted);
  }
  const pbd::View<GridPlace> places = places_.view().first(count);
  const pbd::View<uint32_t> around = around_.view().first(27 * count);
  device_.parallel_for("blocks/places", count, NumberBlocks{table_, order, places});
  device_.parallel_for("blocks/around", 27 * count, FindAround{table_, places, around});
  view_ = {places, around};
}

}  // namespace meniscus::fluid
