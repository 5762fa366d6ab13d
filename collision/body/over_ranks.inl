// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// How the ranks of a shared world add up what their contacts do to bodies.
#pragma once

#include <meniscus/error.h>

#include <string>
#include <vector>

#include "collision/body/body_set.h"

namespace meniscus::collision {

/// Replaces the numbers of this rank's contacts by those of all ranks.
template <class D>
void BodySet<D>::count_over_ranks(pbd::GhostExchange& ranks) {
  using body_kernels::GroupCounts;
  std::vector<uint64_t> all;
  for (const BodyProxy& body : proxies_.read(bodies_)) {
    const GroupCounts own = GroupCounts::of(body);
    all.insert(all.end(), {own.free, own.unyielding, own.attached});
  }
  ranks.add_up(all);
  std::vector<GroupCounts> counts(bodies_);
  for (uint32_t b = 0; b < bodies_; ++b) {
    const auto count = [&](uint32_t kind) { return static_cast<uint32_t>(all[3 * b + kind]); };
    counts[b] = {count(0), count(1), count(2)};
  }
  counts_.resize_discard(bodies_);
  counts_.write(counts);
}

/// Whether a rank's sum is so large that those of 1,024 ranks might overflow.
inline bool is_beyond_ranks(const body_kernels::IntegerSum& sum) {
  constexpr int64_t most = int64_t{1} << 53;
  bool is_beyond = false;
  for (int k = 0; k < 3; ++k) {
    for (const int64_t value : {sum.push[k], sum.twist[k]}) is_beyond |= value <= -most || value >= most;
  }
  return is_beyond;
}

/// Folds the lanes of all ranks. All ranks throw together, or none.
template <class D>
void BodySet<D>::add_over_ranks(pbd::GhostExchange& ranks) {
  using namespace body_kernels;
  constexpr uint32_t values = 7;
  totals_.resize_discard(bodies_);
  device_.parallel_for("bodies/add", bodies_, AddLanes{integer_sums_.view(), totals_.view(), lanes()});
  std::vector<IntegerSum> sums = totals_.read(bodies_);
  std::vector<uint64_t> all;
  for (const IntegerSum& s : sums) {
    for (int k = 0; k < 3; ++k)
      all.insert(all.end(), {static_cast<uint64_t>(s.push[k]), static_cast<uint64_t>(s.twist[k])});
    all.push_back(s.overflows + (is_beyond_ranks(s) ? 1 : 0));
  }
  ranks.add_up(all);
  for (uint32_t b = 0; b < bodies_; ++b) {
    const uint64_t* const of_body = &all[values * b];
    for (int k = 0; k < 3; ++k) {
      sums[b].push[k] = static_cast<int64_t>(of_body[2 * k]);
      sums[b].twist[k] = static_cast<int64_t>(of_body[2 * k + 1]);
    }
    if (of_body[values - 1] == 0) continue;
    throw Error(ErrorCode::capacity,
                "a particle pushes body " + std::to_string(b) +
                    " harder than sums over ranks have room for: by 128 m in a substep, or if nothing moves "
                    "the body, by 128 m of water of its size");
  }
  totals_.write(sums);
  device_.parallel_for(
      "bodies/fold", bodies_,
      FoldLanes{proxies_.view(), reaches_.view(), totals_.view(), partial_.view(), 1, lanes()});
}

}  // namespace meniscus::collision
