// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Culls a long list with a cheap test, and shares the remaining elements among a group of threads.
#pragma once

#include <cstdint>

#include "pbd/device/base/atomics.h"

namespace meniscus::cloth::self_contact_kernels {

/// Working memory of a group of threads: the elements of a part of the list that passed the test.
struct CullScratch {
  static constexpr uint32_t most = 1024;

  uint16_t left[most];
  uint32_t count;
};

/// Visits the elements of a long list that pass a quick test. Few do, and all threads of a group share those
/// of a part of the list. Otherwise the threads of a warp would wait for one.
class Cull {
 public:
  /// The parts of a list of `count` elements that group n of `groups` takes: every `groups`-th one.
  MENISCUS_HD Cull(uint32_t count, uint32_t n, uint32_t groups)
      : count_(count), part_(part_of(count)), first_(n * part_), stride_(groups * part_) {}

  /// Calls visit(k) for each k for which deserves(k) is true.
  template <class Group, class Deserves, class Visit>
  MENISCUS_HD void run(const Group& group, CullScratch& scratch, const Deserves& deserves,
                       const Visit& visit) const {
    for (uint32_t first = first_; first < count_; first += stride_) {
      const uint32_t left = count_ - first;
      group.for_each(1, [&](uint32_t) { scratch.count = 0; });
      group.for_each(left < part_ ? left : part_, [&](uint32_t k) {
        if (deserves(first + k)) scratch.left[pbd::append(scratch.count, 1)] = static_cast<uint16_t>(k);
      });
      group.for_each(scratch.count, [&](uint32_t k) { visit(first + scratch.left[k]); });
    }
  }

 private:
  static constexpr uint32_t fewest = 128, parts = 1024;  // enough to fill a GPU

  MENISCUS_HD static uint32_t part_of(uint32_t count) {
    const uint32_t part = count / parts / fewest * fewest;
    return part < fewest ? fewest : part < CullScratch::most ? part : CullScratch::most;
  }

  uint32_t count_, part_, first_, stride_;
};

}  // namespace meniscus::cloth::self_contact_kernels
