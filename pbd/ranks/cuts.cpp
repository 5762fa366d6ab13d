// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Divides a world into regions by recursive bisection.
#include "pbd/ranks/cuts.h"

#include <meniscus/error.h>

#include <algorithm>
#include <bit>
#include <numeric>
#include <optional>
#include <string>

namespace meniscus::pbd {

namespace {

/// The columns that both have.
Region common(const Region& a, const Region& b) {
  return {std::max(a.first_y, b.first_y), std::min(a.end_y, b.end_y), std::max(a.first_z, b.first_z),
          std::min(a.end_z, b.end_z)};
}

bool is_empty(const Region& r) {
  return r.first_y >= r.end_y || r.first_z >= r.end_z;
}

/// Both sides of a cut.
std::pair<Region, Region> sides(const Region& region, int32_t at, bool along_y) {
  std::pair<Region, Region> parts{region, region};
  (along_y ? parts.first.end_y : parts.first.end_z) = at;
  (along_y ? parts.second.first_y : parts.second.first_z) = at;
  return parts;
}

/// How many regions have room beside each other on an axis.
int32_t places(const Region& box, bool along_y, CutAxes axes) {
  if (axes != CutAxes::both && (axes == CutAxes::y) != along_y) return 1;
  const int32_t layers = along_y ? box.end_y - box.first_y : box.end_z - box.first_z;
  return std::max(layers / Cuts::least_layers, 1);
}

/// So many places along an axis are enough for ranks with these `across`. Either each gets one of its own, or
/// each bisection halves the places of an axis until there is one.
int32_t places_for(int ranks, int32_t across) {
  const auto halvings = static_cast<int>(std::bit_width(static_cast<uint32_t>(ranks) - 1));
  const int of_them_across =
      std::min(halvings, static_cast<int>(std::bit_width(static_cast<uint32_t>(across))) - 1);
  return std::min(int32_t{ranks}, int32_t{1} << (halvings - of_them_across));
}

struct Choice {
  int32_t at;
  uint64_t cost;  // particles on the wrong side and beside the cut
};

/// The layer that cuts an axis of a box into parts for so many ranks below and above it.
std::optional<Choice> choose(const ColumnCounts& columns, const Region& box, bool along_y, CutAxes axes,
                             int below, int above) {
  const int32_t across = places(box, !along_y, axes), least_below = places_for(below, across),
                least_above = places_for(above, across);
  if (axes != CutAxes::both && (axes == CutAxes::y) != along_y) return std::nullopt;
  if (least_below + least_above > places(box, along_y, axes)) return std::nullopt;
  const std::vector<uint64_t> counts = columns.layers(box, along_y);
  const uint64_t total = std::accumulate(counts.begin(), counts.end(), uint64_t{0}),
                 wanted = total * static_cast<uint64_t>(below) / static_cast<uint64_t>(below + above);
  // The cut goes to that side of its layer which is nearer to the wanted count.
  size_t layer = 0;
  for (uint64_t sum = 0; layer < counts.size() && sum + counts[layer] / 2 < wanted;) sum += counts[layer++];
  layer = std::clamp(layer, static_cast<size_t>(Cuts::least_layers * least_below),
                     counts.size() - static_cast<size_t>(Cuts::least_layers * least_above));
  const uint64_t found =
      std::accumulate(counts.begin(), counts.begin() + static_cast<ptrdiff_t>(layer), uint64_t{0});
  const int32_t first = along_y ? box.first_y : box.first_z;
  return Choice{first + static_cast<int32_t>(layer),
                (found > wanted ? found - wanted : wanted - found) + counts[layer - 1] + counts[layer]};
}

[[noreturn]] void refuse(const ColumnCounts& columns, int ranks, CutAxes axes) {
  const std::string y = std::to_string(columns.layers_y), z = std::to_string(columns.layers_z),
                    needed = "; " + std::to_string(ranks) + " ranks need " +
                             std::to_string(Cuts::least_layers) + " each";
  if (axes == CutAxes::both)
    throw Error(ErrorCode::capacity, "the fluid has " + y + " by " + z +
                                         " layers of cells along the axes of its pencils" + needed);
  throw Error(ErrorCode::capacity, "the fluid has " + (axes == CutAxes::y ? y : z) +
                                       " layers of cells along the axis of its slabs" + needed);
}

}  // namespace

uint64_t ColumnCounts::sum(const Region& region) const {
  const std::vector<uint64_t> by_layer = layers(region, true);
  return std::accumulate(by_layer.begin(), by_layer.end(), uint64_t{0});
}

std::vector<uint64_t> ColumnCounts::layers(const Region& region, bool along_y) const {
  const Region part = common(region, columns());
  if (is_empty(part)) return {};
  const int32_t first = along_y ? part.first_y : part.first_z, end = along_y ? part.end_y : part.end_z;
  std::vector<uint64_t> sums(static_cast<size_t>(end - first));
  for (int32_t z = part.first_z; z < part.end_z; ++z) {
    const uint64_t* row =
        counts.data() + size_t{1} * static_cast<size_t>(z - first_z) * static_cast<size_t>(layers_y);
    for (int32_t y = part.first_y; y < part.end_y; ++y)
      sums[static_cast<size_t>((along_y ? y : z) - first)] += row[y - first_y];
  }
  return sums;
}

void ColumnCounts::extend(bool along_y, int32_t layers) {
  ColumnCounts longer = *this;
  (along_y ? longer.layers_y : longer.layers_z) = layers;
  longer.counts.assign(static_cast<size_t>(longer.layers_y) * static_cast<size_t>(longer.layers_z), 0);
  for (size_t k = 0; k < counts.size(); ++k) {
    const size_t width = static_cast<size_t>(layers_y);
    longer.counts[k / width * static_cast<size_t>(longer.layers_y) + k % width] = counts[k];
  }
  *this = std::move(longer);
}

bool Cuts::fit(const ColumnCounts& columns, int ranks, CutAxes axes) {
  const int32_t y = places(columns.columns(), true, axes), z = places(columns.columns(), false, axes);
  return ranks == 1 || places_for(ranks, y) <= z || places_for(ranks, z) <= y;
}

Cuts::Cuts(const ColumnCounts& columns, int ranks, CutAxes axes) {
  if (!fit(columns, ranks, axes)) refuse(columns, ranks, axes);
  divide(columns, columns.columns(), ranks, axes);
  find_regions();
}

void Cuts::divide(const ColumnCounts& columns, const Region& box, int ranks, CutAxes axes) {
  if (ranks == 1) return;
  const int below = ranks / 2;
  const auto y = choose(columns, box, true, axes, below, ranks - below),
             z = choose(columns, box, false, axes, below, ranks - below);
  const bool along_y = y && (!z || y->cost < z->cost);
  const int32_t at = (along_y ? y : z)->at;
  cuts_.push_back({at, static_cast<uint32_t>(below), along_y});
  const auto [low, high] = sides(box, at, along_y);
  divide(columns, low, below, axes);
  divide(columns, high, ranks - below, axes);
}

/// The regions follow from the cuts: each cut divides the region of its ranks.
void Cuts::find_regions() {
  regions_.clear();
  std::vector<std::pair<Region, uint32_t>> open{{Region{}, static_cast<uint32_t>(cuts_.size()) + 1}};
  auto next = cuts_.begin();
  while (!open.empty()) {
    const auto [region, ranks] = open.back();
    open.pop_back();
    if (ranks == 1) {
      regions_.push_back(region);
      continue;
    }
    const Cut& cut = *next++;
    const auto [low, high] = sides(region, cut.at, cut.along_y);
    open.push_back({high, ranks - cut.below});
    open.push_back({low, cut.below});
  }
}

bool Cuts::any_along(bool y) const {
  return std::any_of(cuts_.begin(), cuts_.end(), [&](const Cut& cut) { return cut.along_y == y; });
}

std::vector<int> Cuts::neighbours(int rank) const {
  std::vector<int> found;
  for (int r = 0; r < ranks(); ++r) {
    if (r != rank && !is_empty(common(region(r), region(rank).grown(1)))) found.push_back(r);
  }
  return found;
}

double Cuts::imbalance(const ColumnCounts& columns) const {
  uint64_t total = 0, most = 0;
  for (const Region& region : regions_) {
    const uint64_t count = columns.sum(region);
    total += count;
    most = std::max(most, count);
  }
  return total == 0 ? 1 : static_cast<double>(most) * ranks() / static_cast<double>(total);
}

uint64_t Cuts::load(const ColumnCounts& columns) const {
  uint64_t most = 0;
  for (const Region& region : regions_) {
    const uint64_t own = columns.sum(region), ghosts = columns.sum(region.grown(1)) - own;
    most = std::max(most, 4 * own + 5 * ghosts);
  }
  return most;
}

Cuts Cuts::moved(int32_t layers) const {
  Cuts moved = *this;
  for (Cut& cut : moved.cuts_) cut.at += layers;
  moved.find_regions();
  return moved;
}

}  // namespace meniscus::pbd
