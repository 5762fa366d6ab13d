// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A sparse grid of nodes without bounds: blocks of 4³ nodes, found through a hash table. Blocks are numbered
// in the order of their places, independent of the order of insertion.
#pragma once

#include "pbd/device/base/atomics.h"
#include "pbd/device/buffer.h"
#include "pbd/math/vec.h"

namespace meniscus::fluid {

inline constexpr int32_t block_width = 4;
inline constexpr uint32_t block_nodes = 64;
inline constexpr uint32_t no_block = ~0u;
inline constexpr uint64_t no_key = ~uint64_t{0};
/// Blocks are less than this far from the origin, on each axis.
inline constexpr int32_t most_blocks_out = 1 << 20;

/// Coordinates of a node, or of a block.
struct GridPlace {
  int32_t x, y, z;
};

MENISCUS_HD constexpr GridPlace block_of(GridPlace node) {
  return {node.x >> 2, node.y >> 2, node.z >> 2};
}
/// The number of a node within its block.
MENISCUS_HD constexpr uint32_t node_in_block(GridPlace node) {
  return static_cast<uint32_t>((node.x & 3) | (node.y & 3) << 2 | (node.z & 3) << 4);
}

/// The table of blocks. During insertion, a full table accepts no more.
struct BlockTable {
  pbd::View<uint64_t> keys;     ///< by hash; the number of slots is a power of two
  pbd::View<uint32_t> numbers;  ///< the same, once all blocks are inserted
  pbd::View<uint32_t> slots;    ///< of blocks, in any order
  pbd::View<uint32_t>
      size;  ///< one element: the number of blocks; at or above the capacity the table was full

  MENISCUS_HD static uint64_t key_of(GridPlace block) {
    const auto part = [](int32_t v) { return static_cast<uint64_t>(int64_t{v} + most_blocks_out); };
    return part(block.x) | part(block.y) << 21 | part(block.z) << 42;
  }
  MENISCUS_HD static GridPlace place_of(uint64_t key) {
    const auto part = [&](int shift) {
      return static_cast<int32_t>(key >> shift & 0x1fffff) - most_blocks_out;
    };
    return {part(0), part(21), part(42)};
  }

  MENISCUS_HD void insert(GridPlace block) const {
    const uint64_t key = key_of(block);
    uint32_t slot = first_slot(key);
    for (uint32_t n = 0; n < keys.count; ++n, slot = next(slot)) {
      uint64_t seen = pbd::atomic_load(keys[slot]);
      if (seen == no_key) {
        if (pbd::atomic_load(size[0]) >= slots.count) return;
        seen = pbd::atomic_exchange_if(keys[slot], no_key, key);
        if (seen == no_key) return note(slot);
      }
      if (seen == key) return;
    }
  }

  /// The number of a block, or no_block.
  MENISCUS_HD uint32_t find(GridPlace block) const {
    const uint64_t key = key_of(block);
    for (uint32_t slot = first_slot(key);; slot = next(slot)) {
      if (keys[slot] == key) return numbers[slot];
      if (keys[slot] == no_key) return no_block;
    }
  }

 private:
  MENISCUS_HD uint32_t first_slot(uint64_t key) const {
    return static_cast<uint32_t>((key ^ key >> 29) * 0x9e3779b97f4a7c15ull >> 32) & (keys.count - 1);
  }
  MENISCUS_HD uint32_t next(uint32_t slot) const { return (slot + 1) & (keys.count - 1); }
  MENISCUS_HD void note(uint32_t slot) const {
    const uint32_t at = pbd::append(size[0], 1);
    if (at < slots.count) slots[at] = slot;
  }
};

/// All blocks, by number.
struct BlockView {
  pbd::View<const GridPlace> places;
  pbd::View<const uint32_t>
      around;  ///< 27 for each block, x fastest: the numbers of the adjacent blocks, or no_block

  MENISCUS_HD uint32_t count() const { return places.count; }
  MENISCUS_HD GridPlace place_of_node(uint32_t i) const {
    const GridPlace b = places[i / block_nodes];
    const auto within = [&](int shift) { return static_cast<int32_t>(i >> shift & 3); };
    return {4 * b.x + within(0), 4 * b.y + within(2), 4 * b.z + within(4)};
  }
  /// The node at this offset from node i, at most four on each axis; no_block where there is none.
  MENISCUS_HD uint32_t neighbour(uint32_t i, GridPlace away) const {
    const auto at = [&](int shift, int32_t step) { return static_cast<int32_t>(i >> shift & 3) + step; };
    const GridPlace node{at(0, away.x), at(2, away.y), at(4, away.z)};
    const GridPlace block = block_of(node);
    const uint32_t towards = static_cast<uint32_t>(block.x + 3 * block.y + 9 * block.z + 13);
    const uint32_t number = towards == 13 ? i / block_nodes : around[27 * (i / block_nodes) + towards];
    return number == no_block ? no_block : number * block_nodes + node_in_block(node);
  }
};

template <class D>
class BlockGrid {
 public:
  explicit BlockGrid(D& device) : device_(device) {}

  /// Rebuilds the blocks. mark(table) launches kernels that insert them, and may be called again, until there
  /// is room for all. Throws Error(out_of_memory), and Error(capacity) beyond 2²⁵ blocks.
  template <class Mark>
  void build(const Mark& mark);

  const BlockTable& table() const { return table_; }
  BlockView view() const { return view_; }

 private:
  void reserve(uint32_t blocks);
  void number_blocks(uint32_t count);

  D& device_;
  BlockTable table_{};
  BlockView view_{};
  pbd::Buffer<uint64_t> keys_{device_, "block keys"};
  pbd::Buffer<uint32_t> numbers_{device_, "block numbers"};
  pbd::Buffer<uint32_t> slots_{device_, "blocks"};
  pbd::Buffer<uint32_t> size_{device_, "block count"};
  pbd::Buffer<uint32_t> sort_keys_{device_, "block sort keys"};
  pbd::Buffer<uint32_t> sorted_keys_{device_, "block sort keys"};
  pbd::Buffer<uint32_t> order_{device_, "block order"};
  pbd::Buffer<uint32_t> sorted_{device_, "block order"};
  pbd::Buffer<GridPlace> places_{device_, "block places"};
  pbd::Buffer<uint32_t> around_{device_, "blocks around"};
};

}  // namespace meniscus::fluid
