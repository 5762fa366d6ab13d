// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Ghost particles as constraint sets see them: copies that neighbours read, and how to refresh them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "pbd/contacts.h"
#include "pbd/device/base/view.h"
#include "pbd/math/vec.h"

namespace meniscus::pbd {

struct GridView;
struct WordArray;

/// Ghost k is the particle first + k, behind all owned ones. It has a copy of what its source has, and stands
/// at an offset from it. No loop runs over ghosts. They appear in the neighbour lists of owned particles.
///
/// Whoever writes an array that neighbours read refreshes its ghosts before they are read.
///
/// The ghosts of a shared world are owned by other ranks, which send their values. They stand where their
/// owners have them.
class GhostExchange {
 public:
  /// Layers of cells, [first, end); none if they are not ascending.
  struct Layers {
    int32_t first, end;
  };

  virtual ~GhostExchange() = default;
  /// Fetches the values of all ghosts, of so many 32-bit words each.
  virtual void refresh(void* values, uint32_t words) = 0;
  /// Element by element, over all ranks, on the host. All ranks call it.
  virtual void add_up(std::span<uint64_t> values) = 0;

  // With slabs, for sets with values at the corners of cells, on the layers of cells that they begin.
  virtual int rank() const = 0;
  /// By rank: its layers of corners of cells that may have particles. Known if a set needs own cells.
  virtual std::span<const Layers> corner_layers() const = 0;
  /// In the device's memory: gives all ranks the words of each. Those of rank r are [starts[r], starts[r +
  /// 1]).
  virtual void share(uint32_t* words, std::span<const size_t> starts) = 0;
  /// In the device's memory: sends words to the rank above, and gets as many from the rank below.
  virtual void pass_up(const uint32_t* sent, uint32_t* received, size_t words) = 0;

  // For sets with elements of their own, each on the rank in whose region it is.
  /// Sends the elements in the regions of others, of so many in these arrays. The first array begins with a
  /// position. Returns how many arrive.
  virtual uint32_t hand_over(const GridView& grid, uint32_t count, const std::vector<WordArray>& arrays) = 0;
  /// Writes what has arrived into the arrays, from element `first` on. Call it once, next after hand_over().
  virtual void take_over(uint32_t first, const std::vector<WordArray>& arrays) = 0;
};

struct GhostView {
  View<const uint32_t> source;  ///< as many as there is room for; no_index where there is no ghost
  View<const Vec4> offset;      ///< m, from the source
  uint32_t first = 0;
  GhostExchange* exchange = nullptr;  ///< of a shared world, whose ghosts have no source here
};

namespace ghost_kernels {

template <class T>
struct Copy {
  GhostView ghosts;
  View<T> values;

  MENISCUS_HD void operator()(uint32_t k) const {
    const uint32_t source = ghosts.source[k];
    if (source != no_index) values[ghosts.first + k] = values[source];
  }
};

struct CopyPositions {
  GhostView ghosts;
  View<Vec4> positions;

  MENISCUS_HD void operator()(uint32_t k) const {
    const uint32_t source = ghosts.source[k];
    if (source == no_index) return;
    positions[ghosts.first + k] = shifted(positions[source], ghosts.offset[k].xyz());
  }
};

}  // namespace ghost_kernels

/// Copies the values of owned particles to their ghosts. Without ghosts nothing is launched.
template <class D, class T>
void refresh_ghosts(D& device, const GhostView& ghosts, View<T> values) {
  static_assert(sizeof(T) % sizeof(uint32_t) == 0);
  if (ghosts.exchange) return ghosts.exchange->refresh(values.data, sizeof(T) / sizeof(uint32_t));
  if (ghosts.source.count == 0) return;
  device.parallel_for("ghosts/values", ghosts.source.count, ghost_kernels::Copy<T>{ghosts, values});
}

/// The same for positions, m, with anything in w.
template <class D>
void refresh_ghost_positions(D& device, const GhostView& ghosts, View<Vec4> positions) {
  if (ghosts.exchange) return refresh_ghosts(device, ghosts, positions);
  if (ghosts.source.count == 0) return;
  device.parallel_for("ghosts/positions", ghosts.source.count,
                      ghost_kernels::CopyPositions{ghosts, positions});
}

}  // namespace meniscus::pbd
