// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The kernels of RankExchange: which particles go where, and how their values are packed.
#pragma once

#include <cstring>

#include "pbd/device/base/atomics.h"
#include "pbd/rank_exchange.h"

namespace meniscus::pbd::rank_kernels {

/// The ranks that need particle i, other than the one that has it: its owner, and the ranks beside its layer.
/// Particles that are not finite stay where they are.
template <class Points>
struct Destinations {
  Points points;
  GridView grid;
  View<const int32_t> cuts;
  uint32_t self;

  /// Calls visit(rank) for each.
  template <class Visit>
  MENISCUS_HD void for_each(uint32_t i, const Visit& visit) const {
    const Vec3 p = points(i).xyz();
    if (!is_finite(p)) return;
    const int32_t layer = grid.layer(grid.coordinates(p));
    uint32_t last = self;
    for (int32_t offset = -1; offset <= 1; ++offset) {
      uint32_t rank = 0;
      while (rank < cuts.count && layer + offset >= cuts[rank]) ++rank;
      if (rank == self || rank == last) continue;
      visit(rank);
      last = rank;
    }
  }
};

/// The rank in whose slab element i is, if that is another one.
struct Owners {
  WordArray elements;  ///< each begins with a position
  GridView grid;
  View<const int32_t> cuts;
  uint32_t self;

  template <class Visit>
  MENISCUS_HD void for_each(uint32_t i, const Visit& visit) const {
    Vec3 p;
    memcpy(&p, elements.data + static_cast<size_t>(i) * elements.words, sizeof p);
    if (!is_finite(p)) return;
    const int32_t layer = grid.layer(grid.coordinates(p));
    uint32_t rank = 0;
    while (rank < cuts.count && layer >= cuts[rank]) ++rank;
    if (rank != self) visit(rank);
  }
};

/// The least range of layers that contains all particles; that of none.
inline constexpr GhostExchange::Layers no_layers{Slabs::unbounded, -Slabs::unbounded};

template <class Points>
struct LayersOf {
  Points points;
  GridView grid;

  MENISCUS_HD GhostExchange::Layers operator()(uint32_t i) const {
    const Vec3 p = points(i).xyz();
    if (!is_finite(p)) return {Slabs::unbounded, -Slabs::unbounded};
    const int32_t layer = grid.layer(grid.coordinates(p));
    return {layer, layer + 1};
  }
};

struct MergeLayers {
  MENISCUS_HD GhostExchange::Layers operator()(GhostExchange::Layers a,
                                               const GhostExchange::Layers& b) const {
    return {a.first < b.first ? a.first : b.first, a.end > b.end ? a.end : b.end};
  }
};

/// What the owner and the ghosts of the layers beside a cut have to do with the rank beyond it.
enum Boundary : uint32_t { needed_below, needed_above, ghost_below, ghost_above, boundary_kinds };

struct Boundaries {
  View<const Vec4> position;
  GridView grid;
  uint32_t owned;
  int32_t first, end;
  bool has_below, has_above;

  template <class Visit>
  MENISCUS_HD void for_each(uint32_t i, const Visit& visit) const {
    const Vec3 p = position[i].xyz();
    if (!is_finite(p)) return;
    const int32_t layer = grid.layer(grid.coordinates(p));
    if (i >= owned) return visit(layer < first ? ghost_below : ghost_above);
    if (has_below && layer == first) visit(needed_below);
    if (has_above && layer == end - 1) visit(needed_above);
  }
};

template <class Tags>
struct CountTags {
  Tags tags;
  View<uint32_t> counts;

  MENISCUS_HD void operator()(uint32_t i) const {
    uint32_t count = 0;
    tags.for_each(i, [&](uint32_t) { ++count; });
    counts[i] = count;
  }
};

template <class Tags>
struct PlaceTags {
  Tags tags;
  View<const uint32_t> start;
  View<uint32_t> tag, index;

  MENISCUS_HD void operator()(uint32_t i) const {
    uint32_t place = start[i];
    tags.for_each(i, [&](uint32_t t) {
      tag[place] = t;
      index[place++] = i;
    });
  }
};

/// How many of the sorted tags are at most t.
struct EndsOfTags {
  View<const uint32_t> sorted;
  View<uint32_t> ends;

  MENISCUS_HD void operator()(uint32_t t) const {
    uint32_t first = 0, last = sorted.count;
    while (first < last) {
      const uint32_t middle = first + (last - first) / 2;
      if (sorted[middle] <= t)
        first = middle + 1;
      else
        last = middle;
    }
    ends[t] = first;
  }
};

struct Pack {
  WordArray from;
  View<const uint32_t> list;
  uint32_t* to;

  MENISCUS_HD void operator()(uint32_t k) const {
    const uint32_t* source = from.data + static_cast<size_t>(list[k]) * from.words;
    for (uint32_t w = 0; w < from.words; ++w) to[static_cast<size_t>(k) * from.words + w] = source[w];
  }
};

struct Unpack {
  const uint32_t* from;
  View<const uint32_t> list;
  WordArray to;

  MENISCUS_HD void operator()(uint32_t k) const {
    uint32_t* target = to.data + static_cast<size_t>(list[k]) * to.words;
    for (uint32_t w = 0; w < to.words; ++w) target[w] = from[static_cast<size_t>(k) * to.words + w];
  }
};

/// Of a histogram. Stray particles beyond them count for its ends.
inline constexpr int32_t most_layers = 1 << 16;

/// Layers beyond those of the histogram count for its ends.
struct CountLayers {
  View<const Vec4> position;
  GridView grid;
  int32_t first;
  View<uint32_t> counts;

  MENISCUS_HD void operator()(uint32_t i) const {
    const Vec3 p = position[i].xyz();
    if (!is_finite(p)) return;
    const int32_t k = grid.layer(grid.coordinates(p)) - first;
    const int32_t last = static_cast<int32_t>(counts.count) - 1;
    atomic_add(counts[static_cast<uint32_t>(k < 0 ? 0 : k > last ? last : k)], 1);
  }
};

}  // namespace meniscus::pbd::rank_kernels
