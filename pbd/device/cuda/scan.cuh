// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A prefix sum in one launch: each tile looks back over the sums of the tiles before it (Merrill & Garland
// 2016, "Single-pass parallel prefix scan with decoupled look-back"). CUB's needs one more launch, to reset
// the sums of the last run, and neither overlaps its neighbours. Here each sum carries the number of its run.
#pragma once

#include <cub/block/block_load.cuh>
#include <cub/block/block_scan.cuh>
#include <cub/block/block_store.cuh>

#include "pbd/device/cuda/launch.cuh"
#include "pbd/device/scalar.h"

namespace meniscus::pbd::cuda_kernels {

constexpr uint32_t scan_block = 256, scan_items = 16, scan_tile = scan_block * scan_items;

/// The state of a tile, in one word, so that it is read atomically. The low half is the sum. The high half is
/// the run's number, and whether the sum includes all tiles before.
struct TileSums {
  static constexpr uint32_t most_runs = 0x7fffffff;  ///< until all words must be 0 again

  uint64_t* word;
  uint32_t run;  ///< from 1 on

  __device__ void publish(uint32_t tile, uint32_t sum, bool takes_in_all) const {
    const uint64_t high = 2 * run + (takes_in_all ? 1 : 0);
    *const_cast<volatile uint64_t*>(word + tile) = high << 32 | sum;
  }
  __device__ uint64_t read(int32_t tile) const {
    return tile < 0 ? uint64_t{2 * run + 1} << 32 : *const_cast<volatile uint64_t*>(word + tile);
  }
  __device__ bool is_ready(uint64_t w) const { return static_cast<uint32_t>(w >> 33) == run; }
  __device__ static bool takes_in_all(uint64_t w) { return (w >> 32 & 1) != 0; }

  /// The sum of all tiles before this one; a warp computes it together.
  __device__ uint32_t look_back(uint32_t tile, SumUpTo sum) const {
    constexpr unsigned warp = 0xffffffff;
    const int32_t lane = static_cast<int32_t>(threadIdx.x & 31);
    uint32_t before = 0;
    for (int32_t end = static_cast<int32_t>(tile);; end -= 32) {
      uint64_t w;
      do {
        w = read(end - 1 - lane);
      } while (!__all_sync(warp, is_ready(w)));
      const unsigned whole = __ballot_sync(warp, takes_in_all(w));
      const int32_t last = whole ? __ffs(static_cast<int>(whole)) - 1 : 31;
      uint32_t part = lane <= last ? static_cast<uint32_t>(w) : 0;
      for (int step = 16; step > 0; step /= 2) part = sum(part, __shfl_xor_sync(warp, part, step));
      before = sum(before, part);
      if (whole) return before;
    }
  }
};

/// `runs`: the number of completed runs. All tiles have read it when the last one has their sums.
static __global__ void __launch_bounds__(scan_block)
    scan_tiles(TimeMark mark, View<const uint32_t> in, uint32_t* out, View<SumNote> note, SumUpTo sum,
               uint64_t* runs, uint64_t* tile_words) {
  wait_for_previous(mark);
  using Load = cub::BlockLoad<uint32_t, scan_block, scan_items, cub::BLOCK_LOAD_WARP_TRANSPOSE>;
  using Store = cub::BlockStore<uint32_t, scan_block, scan_items, cub::BLOCK_STORE_WARP_TRANSPOSE>;
  using Scan = cub::BlockScan<uint32_t, scan_block>;
  __shared__ union {
    typename Load::TempStorage load;
    typename Store::TempStorage store;
    typename Scan::TempStorage scan;
  } storage;
  __shared__ uint32_t shared_before;

  const TileSums tiles{tile_words, static_cast<uint32_t>(*const_cast<const volatile uint64_t*>(runs)) + 1};
  const uint32_t tile = blockIdx.x, first = tile * scan_tile;
  const int valid = static_cast<int>(min(scan_tile, in.count - first));
  uint32_t items[scan_items], total;
  Load(storage.load).Load(in.data + first, items, valid, 0u);
  __syncthreads();
  Scan(storage.scan).ExclusiveScan(items, items, 0u, sum, total);
  if (threadIdx.x < 32) {
    if (threadIdx.x == 0) tiles.publish(tile, total, tile == 0);
    const uint32_t before = tiles.look_back(tile, sum);
    if (threadIdx.x == 0) {
      tiles.publish(tile, sum(before, total), true);
      shared_before = before;
      if (tile + 1 == gridDim.x) {
        const uint32_t all = sum(before, total);
        out[in.count] = all;
        *runs = tiles.run;
        if (note.count) note[0].take(all);
      }
    }
  }
  __syncthreads();
  for (uint32_t& item : items) item = sum(shared_before, item);
  Store(storage.store).Store(out + first, items, valid);
}

}  // namespace meniscus::pbd::cuda_kernels
