// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Cuts a world into slabs of whole layers.
#include "pbd/ranks/slabs.h"

#include <meniscus/error.h>

#include <algorithm>
#include <numeric>
#include <string>

namespace meniscus::pbd {

Slabs::Slabs(int32_t first, std::span<const uint64_t> counts, int ranks) {
  const auto layers = static_cast<int32_t>(counts.size());
  if (layers < least_layers * ranks)
    throw Error(ErrorCode::capacity, "the fluid has " + std::to_string(layers) +
                                         " layers of cells along the axis of its slabs; " +
                                         std::to_string(ranks) + " ranks need 3 each");
  const uint64_t total = std::accumulate(counts.begin(), counts.end(), uint64_t{0});
  uint64_t below = 0;
  int32_t layer = 0;
  for (int r = 1; r < ranks; ++r) {
    const uint64_t wanted = total * static_cast<uint64_t>(r) / static_cast<uint64_t>(ranks);
    // The cut goes to that side of its layer which is nearer to the wanted count.
    while (layer < layers && below + counts[static_cast<size_t>(layer)] / 2 < wanted)
      below += counts[static_cast<size_t>(layer++)];
    cuts_.push_back(first + layer);
  }
  int32_t least = first;
  for (int32_t& cut : cuts_) least = cut = std::max(cut, least + least_layers);
  int32_t most = first + layers;
  for (auto cut = cuts_.rbegin(); cut != cuts_.rend(); ++cut)
    most = *cut = std::min(*cut, most - least_layers);
}

int Slabs::owner(int32_t layer) const {
  return static_cast<int>(std::upper_bound(cuts_.begin(), cuts_.end(), layer) - cuts_.begin());
}

double Slabs::imbalance(int32_t first, std::span<const uint64_t> counts) const {
  std::vector<uint64_t> of_rank(static_cast<size_t>(ranks()));
  for (size_t k = 0; k < counts.size(); ++k)
    of_rank[static_cast<size_t>(owner(first + static_cast<int32_t>(k)))] += counts[k];
  const uint64_t total = std::accumulate(of_rank.begin(), of_rank.end(), uint64_t{0});
  if (total == 0) return 1;
  const uint64_t most = *std::max_element(of_rank.begin(), of_rank.end());
  return static_cast<double>(most) * ranks() / static_cast<double>(total);
}

Slabs Slabs::moved(int32_t layers) const {
  Slabs moved = *this;
  for (int32_t& cut : moved.cuts_) cut += layers;
  return moved;
}

}  // namespace meniscus::pbd
