// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Where RankExchange places the cuts between ranks, from the particles of each column.
#pragma once

#include <algorithm>
#include <utility>

#include "pbd/rank_exchange.h"
#include "pbd/rank_exchange_kernels.h"

namespace meniscus::pbd {

template <class D>
CutAxes RankExchange<D>::axes() const {
  if (policy_.kind != CutKind::slabs) return CutAxes::both;
  return layers_along_y_ ? CutAxes::y : CutAxes::z;
}

/// Columns for all particles in the extent: of both axes, or of the slabs' axis alone. There are not too many
/// for a message. Stray particles beyond them count for the ends.
template <class D>
ColumnCounts RankExchange<D>::no_counts(const GridView& grid, const Aabb& extent) const {
  constexpr int32_t most_columns = 1 << 22, most_of_slabs = 1 << 16, most_of_both = 1 << 11;
  const CellCoordinates first = grid.coordinates(extent.lower), last = grid.coordinates(extent.upper);
  ColumnCounts columns{first.y, first.z, std::max(last.y - first.y + 1, 1),
                       std::max(last.z - first.z + 1, 1)};
  if (axes() == CutAxes::y) columns.layers_z = 1;
  if (axes() == CutAxes::z) columns.layers_y = 1;
  const auto most = [&](int32_t across) {
    return std::min(most_of_slabs, std::max(most_of_both, most_columns / across));
  };
  const int32_t most_y = most(columns.layers_z), most_z = most(columns.layers_y);
  columns.layers_y = std::min(columns.layers_y, most_y);
  columns.layers_z = std::min(columns.layers_z, most_z);
  columns.counts.assign(static_cast<size_t>(columns.layers_y) * static_cast<size_t>(columns.layers_z), 0);
  return columns;
}

template <class D>
ColumnCounts RankExchange<D>::count_columns(const ParticleView& particles, const GridView& grid,
                                            const Aabb& extent) {
  ColumnCounts columns = no_counts(grid, extent);
  const auto size = static_cast<uint32_t>(columns.counts.size());
  rank_kernels::make_room(histogram_, size);
  histogram_.fill(0);
  device_.parallel_for(
      "ranks/columns", particles.sorted,
      rank_kernels::CountColumns{particles.position, grid, columns.first_y, columns.first_z, columns.layers_y,
                                 columns.layers_z, histogram_.view().first(size)});
  const std::vector<uint32_t> own = histogram_.read(size);
  columns.counts.assign(own.begin(), own.end());
  return columns;
}

template <class D>
void RankExchange<D>::cut_all(const ParticleView& particles, const GridView& grid, const Aabb& extent) {
  const bool is_empty = !(extent.lower.z <= extent.upper.z);
  if (is_empty) return cut({});
  cut(count_columns(particles, grid, extent));
  histogram_.resize_discard(0);  // that of slabs is small
}

template <class D>
void RankExchange<D>::cut_all(std::span<const Vec4> positions, const GridView& grid) {
  if (positions.empty()) return cut({});
  Aabb extent{positions.front().xyz(), positions.front().xyz()};
  for (const Vec4& p : positions) extent = {min(extent.lower, p.xyz()), max(extent.upper, p.xyz())};
  ColumnCounts columns = no_counts(grid, extent);
  const rank_kernels::CountColumns place{
      {}, grid, columns.first_y, columns.first_z, columns.layers_y, columns.layers_z, {}};
  for (const Vec4& p : positions) ++columns.counts[place.column(grid.coordinates(p.xyz()))];
  cut(std::move(columns));
}

/// The first cuts. An automatic choice is made here, and stays.
template <class D>
void RankExchange<D>::cut(ColumnCounts columns) {
  const int ranks = ranks_.count();
  const CutAxes along = layers_along_y_ ? CutAxes::y : CutAxes::z;
  if (policy_.expects_more && !Cuts::fit(columns, ranks, axes()))
    columns.extend(layers_along_y_, Cuts::least_layers * ranks);
  if (policy_.kind == CutKind::automatic) {
    const bool may_be_pencils = Cuts::fit(columns, ranks, CutAxes::both),
               may_be_slabs = Cuts::fit(columns, ranks, along) || !may_be_pencils;
    const bool are_pencils =
        !may_be_slabs || (may_be_pencils && Cuts(columns, ranks, CutAxes::both).load(columns) <
                                                Cuts(columns, ranks, along).load(columns));
    policy_.kind = are_pencils ? CutKind::pencils : CutKind::slabs;
  }
  even_cuts_ = Cuts(columns, ranks, axes());
  set_cuts(even_cuts_);
}

template <class D>
void RankExchange<D>::balance(const ParticleView& particles, const GridView& grid, const Aabb& extent) {
  if (steps_++ % policy_.every != 0 || !(extent.lower.z <= extent.upper.z)) return;
  ColumnCounts columns = count_columns(particles, grid, extent);
  ranks_.add_up(columns.counts);
  const bool has_room = Cuts::fit(columns, ranks_.count(), axes());
  if (has_room && even_cuts_.imbalance(columns) > policy_.most_imbalance)
    even_cuts_ = Cuts(columns, ranks_.count(), axes());
  set_cuts(even_cuts_.moved(++looks_ % 2 ? policy_.shift : 0));
}

template <class D>
void RankExchange<D>::set_cuts(Cuts cuts) {
  cuts_ = std::move(cuts);
  const Region& own = region();
  std::vector<NeighbourRank> neighbours;
  for (const int rank : cuts_.neighbours(ranks_.rank())) {
    const Region& other = cuts_.region(rank);
    const bool are_beside = own.first_z < other.end_z && other.first_z < own.end_z;
    neighbours.push_back({other, are_beside ? 0u : 1u});
  }
  rank_kernels::make_room(tree_, cuts_.tree().size());
  tree_.write(cuts_.tree());
  rank_kernels::make_room(neighbours_, neighbours.size());
  neighbours_.write(neighbours);
}

template <class D>
CutsView RankExchange<D>::cuts_on_device() const {
  return {{tree_.view().data, static_cast<uint32_t>(cuts_.tree().size())}};
}

// ---- layers ----

template <class D>
PartLayers RankExchange<D>::layers_within(const GridView& grid, const Aabb& extent) const {
  const CellCoordinates lower = grid.coordinates(extent.lower), upper = grid.coordinates(extent.upper);
  const auto with_ghosts = [](int32_t first, int32_t last, int32_t own_first, int32_t own_end) {
    return std::max(std::min(last, own_end - 1) - std::max(first, own_first) + 1, 1) + 2;
  };
  const Region& own = region();
  return {with_ghosts(lower.y, upper.y, own.first_y, own.end_y),
          with_ghosts(lower.z, upper.z, own.first_z, own.end_z)};
}

/// The layers of a rank.
template <class D>
GhostExchange::Layers RankExchange<D>::slab(int rank) const {
  const Region& r = cuts_.region(rank);
  return layers_along_y_ ? Layers{r.first_y, r.end_y} : Layers{r.first_z, r.end_z};
}

/// A layer with particles has corners on both of its sides. The corners below have edges that reach into it.
template <class D>
template <class Points>
typename RankExchange<D>::OccupiedLayers RankExchange<D>::find_layers(const Points& points,
                                                                      const GridView& grid, uint32_t count) {
  using namespace rank_kernels;
  occupied_.resize_discard(1);
  device_.reduce("ranks/occupied", count, no_layers, LayersOf<Points>{points, grid}, MergeLayers{},
                 occupied_.view());
  Layers all = no_layers;
  for (const Layers& of_rank : values_of_all(ranks_, occupied_.read(1)[0])) all = MergeLayers{}(all, of_rank);
  corner_layers_.clear();
  for (int r = 0; r < ranks_.count(); ++r)
    corner_layers_.push_back({std::max(slab(r).first, all.first - 1), std::min(slab(r).end, all.end + 1)});
  if (all.first >= all.end) return {0, 1};
  const Layers own = slab(ranks_.rank());
  const int32_t first = std::max(own.first - 1, all.first), last = std::min(own.end + 1, all.end);
  return {static_cast<uint32_t>(all.end - all.first), std::max(last - first, 1)};
}

}  // namespace meniscus::pbd
