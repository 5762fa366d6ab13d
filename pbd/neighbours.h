// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Neighbour lists as constraints read them: only through for_each_neighbour, so that the form of the list can
// change. D is the reader: the CPU with eight lanes (CpuDevice), a thread of the GPU (CudaDevice), or a team
// of four, eight or 32 threads (CudaTeamOf).
#pragma once

#include <type_traits>

#include "pbd/device/base/view.h"
#include "pbd/device/cuda/team.h"
#include "pbd/device/scalar.h"

namespace meniscus::pbd {

/// One list for each particle, padded with a sentinel to a multiple of eight. On the CPU each particle has a
/// row of its own. On the GPU groups of sixteen bytes are interleaved over the particles, so that a warp's
/// loads coalesce. Wide lists have four indices in a group. A list may be narrow if all its indices are close
/// to the particle's: eight offsets in a group, 0 for the sentinel.
struct NeighbourView {
  View<uint32_t> index;
  View<uint32_t> count;       ///< the top bit: whether the list is narrow; see size()
  uint32_t row_capacity = 0;  ///< entries for each particle, a multiple of eight
  uint32_t stride = 0;        ///< particles in a row of groups; 0 where each particle has a row of its own
  uint32_t sentinel = 0;      ///< the particle that pads lists

  static constexpr uint32_t narrow_bit = 1u << 31, narrow_reach = 0x7fff;

  /// Entries of particle i's list.
  MENISCUS_HD uint32_t size(uint32_t i) const { return count[i] & ~narrow_bit; }
  MENISCUS_HD bool is_narrow(uint32_t i) const { return (count[i] & narrow_bit) != 0; }

  /// Entry k of particle i's list.
  MENISCUS_HD uint32_t at(uint32_t i, uint32_t k) const {
    return is_narrow(i) ? index_at(i, offset(i, k)) : entry(i, k);
  }
  /// Replaces entry k by the sentinel.
  MENISCUS_HD void drop(uint32_t i, uint32_t k) const {
    if (is_narrow(i)) {
      offset(i, k) = 0;
    } else {
      entry(i, k) = sentinel;
    }
  }

  // ---- the representation of a list ----

  /// The index that an offset from particle i represents.
  MENISCUS_HD uint32_t index_at(uint32_t i, int from_i) const {
    return from_i ? i + static_cast<uint32_t>(from_i) : sentinel;
  }
  /// Entry k of a narrow list.
  MENISCUS_HD int16_t& offset(uint32_t i, uint32_t k) const {
    return reinterpret_cast<int16_t*>(index.data)[(size_t{k / 8} * stride + i) * 8 + k % 8];
  }
  /// Entry k of a wide list.
  MENISCUS_HD uint32_t& entry(uint32_t i, uint32_t k) const {
    return index.data[stride ? (size_t{k / 4} * stride + i) * 4 + k % 4 : size_t{i} * row_capacity + k];
  }
};

struct alignas(16) IndexGroup {
  uint32_t a, b, c, d;
};

/// The hardware prefetcher does not predict where the next row is read, as rows have gaps between them.
/// Without explicit prefetches, half of a loop over neighbours is spent waiting for the list.
inline constexpr size_t rows_ahead = 8;

inline void prefetch_row(const uint32_t* row, uint32_t count) {
  constexpr uint32_t line = 16;
  for (uint32_t k = 0; k < count; k += line) __builtin_prefetch(row + k);
}

namespace neighbour_loops {

/// For one thread of a GPU. The next group is loaded while this group's neighbours are.
template <uint32_t in_group, class VisitGroup>
MENISCUS_HD void for_each_group(const NeighbourView& list, uint32_t i, uint32_t count,
                                const VisitGroup& visit_group) {
  const IndexGroup* group = reinterpret_cast<const IndexGroup*>(list.index.data) + i;
  IndexGroup g = count ? *group : IndexGroup{};
  for (uint32_t k = 0; k < count; k += in_group) {
    group += list.stride;
    const IndexGroup next = k + in_group < count ? *group : g;
    visit_group(g, count - k);
    g = next;
  }
}

template <class Visit>
MENISCUS_HD void by_thread(const NeighbourView& list, uint32_t i, const Visit& visit) {
  const uint32_t count = list.size(i);
  if (list.is_narrow(i)) {
    const auto both = [&](uint32_t offsets) {
      visit(list.index_at(i, static_cast<int16_t>(offsets)));
      visit(list.index_at(i, static_cast<int32_t>(offsets) >> 16));
    };
    for_each_group<8>(list, i, count, [&](const IndexGroup& g, uint32_t left) {
      both(g.a);
      both(g.b);
      if (left <= 4) return;
      both(g.c);
      both(g.d);
    });
  } else {
    for_each_group<4>(list, i, count, [&](const IndexGroup& g, uint32_t) {
      visit(g.a);
      visit(g.b);
      visit(g.c);
      visit(g.d);
    });
  }
}

/// For a team: of eight entries each thread takes as many consecutive ones as it must, and loads the next
/// ones early. In a warp each thread takes one, so a list is loaded in two rounds.
template <class D, class Entry, class Visit>
MENISCUS_HD void by_team(uint32_t count, const Entry& entry, const Visit& visit) {
  if constexpr (D::lane_count > 8) {
    for (uint32_t k = D::rank(); k < count; k += D::lane_count) visit(entry(k));
  } else {
    constexpr uint32_t each = 8 / D::lane_count;
    using Value = std::remove_cvref_t<decltype(entry(0))>;
    struct alignas(each * sizeof(Value)) Part {
      Value at[each];
    };
    const auto part = [&](uint32_t k) { return reinterpret_cast<const Part&>(entry(k + each * D::rank())); };
    Part j = count ? part(0) : Part{};
    for (uint32_t k = 0; k < count; k += 8) {
      const Part next = k + 8 < count ? part(k + 8) : j;
      MENISCUS_UNROLL
      for (uint32_t n = 0; n < each; ++n) visit(j.at[n]);
      j = next;
    }
  }
}

}  // namespace neighbour_loops

/// Calls visit(j) for each neighbour of i within the list's reach, in a reproducible order. j is one index,
/// or eight where D has eight lanes, for gather(). i itself is not included.
template <class D, class Visit>
MENISCUS_HD void for_each_neighbour(const NeighbourView& list, uint32_t i, const Visit& visit) {
  if constexpr (D::lane_count == 1) {
    neighbour_loops::by_thread(list, i, visit);
  } else if constexpr (is_cuda_team<D>) {
    const uint32_t count = list.size(i);
    if (list.is_narrow(i)) {
      neighbour_loops::by_team<D>(
          count, [&](uint32_t k) -> const int16_t& { return list.offset(i, k); },
          [&](int16_t from_i) { visit(typename D::Index{list.index_at(i, from_i)}); });
    } else {
      neighbour_loops::by_team<D>(
          count, [&](uint32_t k) -> const uint32_t& { return list.entry(i, k); },
          [&](uint32_t j) { visit(typename D::Index{j}); });
    }
  } else {
    const uint32_t count = list.size(i);
    const uint32_t* row = list.index.data + size_t{i} * list.row_capacity;
    prefetch_row(row + rows_ahead * size_t{list.row_capacity}, count);
    for (uint32_t k = 0; k < count; k += D::lane_count) visit(typename D::LaneIndex{row + k});
  }
}

}  // namespace meniscus::pbd
