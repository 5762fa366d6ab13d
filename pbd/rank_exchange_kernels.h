// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The kernels of RankExchange: which particles go where, and how their values are packed.
#pragma once

#include <cstring>

#include "pbd/device/base/atomics.h"
#include "pbd/rank_exchange.h"

namespace meniscus::pbd::rank_kernels {

/// Makes room, and a quarter more, since the next message may be longer.
template <class T>
void make_room(Buffer<T>& buffer, size_t size) {
  if (size > buffer.size()) buffer.resize_discard(size + size / 4 + 64);
}

/// The ranks that need particle i, other than the one that has it: its owner, and those with a column beside
/// its own. Particles that are not finite stay where they are.
template <class Points>
struct Destinations {
  Points points;
  GridView grid;
  CutsView cuts;
  Region own;
  uint32_t self;
  int32_t reach_y, reach_z;  ///< layers to the columns beside one: 1, or 0 on an axis without cuts

  /// Calls visit(rank) for each.
  template <class Visit>
  MENISCUS_HD void for_each(uint32_t i, const Visit& visit) const {
    const Vec3 p = points(i).xyz();
    if (!is_finite(p)) return;
    const CellCoordinates c = grid.coordinates(p);
    if (own.is_inside(c.y, c.z)) return;
    uint32_t found[9], count = 0;
    for (int32_t z = c.z - reach_z; z <= c.z + reach_z; ++z) {
      for (int32_t y = c.y - reach_y; y <= c.y + reach_y; ++y) {
        const uint32_t rank = cuts.owner(y, z);
        bool is_new = rank != self;
        for (uint32_t k = 0; k < count; ++k) is_new = is_new && found[k] != rank;
        if (!is_new) continue;
        visit(rank);
        found[count++] = rank;
      }
    }
  }
};

/// The rank in whose region element i is, if that is another one.
struct Owners {
  WordArray elements;  ///< each begins with a position
  GridView grid;
  CutsView cuts;
  uint32_t self;

  template <class Visit>
  MENISCUS_HD void for_each(uint32_t i, const Visit& visit) const {
    Vec3 p;
    memcpy(&p, elements.data + static_cast<size_t>(i) * elements.words, sizeof p);
    if (!is_finite(p)) return;
    const CellCoordinates c = grid.coordinates(p);
    const uint32_t rank = cuts.owner(c.y, c.z);
    if (rank != self) visit(rank);
  }
};

/// The least range of layers that contains all particles; that of none.
inline constexpr GhostExchange::Layers no_layers{Region::unbounded, -Region::unbounded};

template <class Points>
struct LayersOf {
  Points points;
  GridView grid;

  MENISCUS_HD GhostExchange::Layers operator()(uint32_t i) const {
    const Vec3 p = points(i).xyz();
    if (!is_finite(p)) return {Region::unbounded, -Region::unbounded};
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

/// The neighbours that need particle i, or for a ghost its owner. The tag of neighbour k has the kind 2 k for
/// particles that it needs, and 2 k + 1 for its ghosts. Below the kind it has the row. Layers whose tags are
/// equal are so far apart that floats do not tell cells there.
struct Boundaries {
  View<const Vec4> position;
  GridView grid;
  uint32_t owned;
  View<const NeighbourRank> neighbours;
  uint32_t row_bits;

  template <class Visit>
  MENISCUS_HD void for_each(uint32_t i, const Visit& visit) const {
    const Vec3 p = position[i].xyz();
    if (!is_finite(p)) return;
    const CellCoordinates c = grid.coordinates(p);
    const bool is_ghost = i >= owned;
    if (grid.part.is_inside(c.y, c.z)) return;
    for (uint32_t k = 0; k < neighbours.count; ++k) {
      const NeighbourRank n = neighbours[k];
      if (is_ghost ? n.region.contains(c.y, c.z) : n.region.is_near(c.y, c.z))
        visit(tag(2 * k + is_ghost, n.rows_along_y ? c.y : c.z));
    }
  }

 private:
  MENISCUS_HD uint32_t tag(uint32_t kind, int32_t layer) const {
    const uint32_t rows = 1u << row_bits;  // half of them below 0
    return kind << row_bits | ((static_cast<uint32_t>(layer) + rows / 2) & (rows - 1));
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

/// How many of the sorted tags have at most kind t.
struct EndsOfTags {
  View<const uint32_t> sorted;
  uint32_t row_bits;
  View<uint32_t> ends;

  MENISCUS_HD void operator()(uint32_t t) const {
    uint32_t first = 0, last = sorted.count;
    while (first < last) {
      const uint32_t middle = first + (last - first) / 2;
      if (sorted[middle] >> row_bits <= t)
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

/// Particles by column. Those beyond the histogram count for its ends.
struct CountColumns {
  View<const Vec4> position;
  GridView grid;
  int32_t first_y, first_z, layers_y, layers_z;
  View<uint32_t> counts;

  MENISCUS_HD void operator()(uint32_t i) const {
    const Vec3 p = position[i].xyz();
    if (!is_finite(p)) return;
    atomic_add(counts[column(grid.coordinates(p))], 1);
  }
  MENISCUS_HD uint32_t column(CellCoordinates c) const {
    const auto place = [](int32_t layer, int32_t layers) {
      return static_cast<uint32_t>(layer < 0 ? 0 : layer < layers ? layer : layers - 1);
    };
    return place(c.z - first_z, layers_z) * static_cast<uint32_t>(layers_y) + place(c.y - first_y, layers_y);
  }
};

}  // namespace meniscus::pbd::rank_kernels
