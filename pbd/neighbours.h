// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Neighbour lists as constraints read them: through for_each_neighbour alone, so that the form of the list
// can change.
#pragma once

#include "pbd/device/view.h"

namespace meniscus::pbd {

/// One list a particle, padded with a sentinel to whole groups. With one lane (GPU) groups of four lie
/// interleaved over the particles, so that a warp's loads of sixteen bytes coalesce; with eight (CPU) each
/// particle has a row of its own.
struct NeighbourView {
  View<const uint32_t> index;
  View<const uint32_t> count;
  uint32_t row_capacity = 0;  ///< entries a particle, a multiple of the group
  uint32_t stride = 0;        ///< particles a group row, on the GPU
};

struct alignas(16) IndexGroup {
  uint32_t a, b, c, d;
};

/// Calls visit(j) for each neighbour of i within the list's reach, in an order that is the same every time. j
/// is one index, or eight on a device with eight lanes; it goes to gather(). i itself is not among them.
template <class D, class Visit>
MENISCUS_HD void for_each_neighbour(const NeighbourView& list, uint32_t i, const Visit& visit) {
  const uint32_t count = list.count[i];
  if constexpr (D::lane_count == 1) {
    const IndexGroup* group = reinterpret_cast<const IndexGroup*>(list.index.data) + i;
    for (uint32_t k = 0; k < count; k += 4, group += list.stride) {
      const IndexGroup j = *group;
      visit(j.a);
      visit(j.b);
      visit(j.c);
      visit(j.d);
    }
  } else {
    const uint32_t* row = list.index.data + size_t{i} * list.row_capacity;
    for (uint32_t k = 0; k < count; k += D::lane_count) visit(typename D::LaneIndex{row + k});
  }
}

/// Appends to the list of one particle while it is built.
template <class D>
class NeighbourWriter {
 public:
  MENISCUS_HD NeighbourWriter(uint32_t* index, uint32_t row_capacity, uint32_t stride, uint32_t i)
      : at_(D::lane_count == 1 ? index + size_t{i} * 4 : index + size_t{i} * row_capacity),
        row_capacity_(row_capacity),
        stride_(stride) {}

  /// Counts every neighbour, and stores those that fit.
  MENISCUS_HD void append(uint32_t j) {
    if constexpr (D::lane_count == 1) {
      group_ = {group_.b, group_.c, group_.d, j};
      if (++count_ % 4 == 0) flush();
    } else {
      if (count_ < row_capacity_) at_[count_] = j;
      ++count_;
    }
  }

  /// Fills the last group up with `sentinel`; returns the number found, which may be more than fitted.
  MENISCUS_HD uint32_t finish(uint32_t sentinel) {
    const uint32_t found = count_;
    while (count_ % (D::lane_count == 1 ? 4 : D::lane_count)) append(sentinel);
    return found;
  }

 private:
  MENISCUS_HD void flush() {
    if (count_ > row_capacity_) return;
    *reinterpret_cast<IndexGroup*>(at_) = group_;
    at_ += size_t{stride_} * 4;
  }

  uint32_t* at_;
  uint32_t row_capacity_, stride_;
  uint32_t count_ = 0;
  IndexGroup group_{};
};

}  // namespace meniscus::pbd
