// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// ClothSet in a batch: what worlds are reset to, and one world alone.
#pragma once

#include "cloth/solve/cloth_set.h"
#include "pbd/worlds.h"

namespace meniscus::cloth {

namespace world_kernels {

using pbd::ChosenWorlds;
using pbd::WorldsFrom;

/// The place of an edge, from its number in the order of worlds.
struct EdgePlaces {
  View<const uint32_t> places;

  MENISCUS_HD uint32_t operator[](uint32_t k) const { return places.count ? places[k] : k; }
};

/// Writes the multipliers of edges outside chains.
struct WriteEdges {
  ChosenWorlds worlds;
  EdgePlaces places;
  View<const Vec4> from;
  View<Vec4> to;
  WorldsFrom kind;

  MENISCUS_HD void operator()(uint32_t k) const {
    if (!worlds.has(k)) return;
    const uint32_t at = places[k];
    to[at] = from[kind == WorldsFrom::one ? k % worlds.each : at];
  }
};

/// The same for chains: see RestoreMultipliers.
struct WriteChains {
  ChosenWorlds worlds;
  View<const float> from;
  View<Vec4> to;
  WorldsFrom kind;

  MENISCUS_HD void operator()(uint32_t k) const {
    if (worlds.has(k)) to[k] = {0, 0, 0, from[kind == WorldsFrom::one ? k % worlds.each : k]};
  }
};

/// Copies the multipliers of one world to `one`, or from it: those of edges outside chains, then those of
/// chains.
struct CopyWorld {
  EdgePlaces places;
  View<Vec4> multiplier;
  uint32_t world, edges, all_edges, chain_edges;  ///< all_edges: outside chains, of all worlds
  View<Vec4> one;
  bool restores;

  MENISCUS_HD void operator()(uint32_t k) const {
    Vec4& here =
        multiplier[k < edges ? places[world * edges + k] : all_edges + world * chain_edges + (k - edges)];
    if (restores)
      here = one[k];
    else
      one[k] = here;
  }
};

}  // namespace world_kernels

/// Called while there is one world.
template <class D>
void ClothSet<D>::keep_world(uint32_t) {
  in_batch_ = true;
  kept_clock_ = {time_, last_dt_ > 0};
  kept_clocks_.resize_discard(1);
  kept_clocks_.write(std::span<const load_kernels::WorldClock>(&kept_clock_, 1));
  kept_edge_multiplier_.resize_discard(saved_edge_multiplier_.size());
  kept_chain_multiplier_.resize_discard(saved_chain_multiplier_.size());
  device_.copy(kept_edge_multiplier_.view().data, edge_multiplier_.view().data,
               first_chain_edge_ * sizeof(Vec4));
  device_.parallel_for("cloth/keep chains", static_cast<uint32_t>(kept_chain_multiplier_.size()),
                       KeepMultipliers{chain_multiplier(), kept_chain_multiplier_.view()});
}

template <class D>
void ClothSet<D>::reset_worlds(const pbd::ChosenWorlds& worlds) {
  if (vertex_count_ == 0) return;
  write_multipliers(worlds.chosen, kept_edge_multiplier_.view(), kept_chain_multiplier_.view(),
                    pbd::WorldsFrom::one);
  pbd::write_worlds(device_, "cloth/reset clocks", {worlds.chosen, 1, static_cast<uint32_t>(clocks_.size())},
                    View<const load_kernels::WorldClock>(kept_clocks_.view()), clocks_.view(),
                    pbd::WorldsFrom::one);
}

template <class D>
void ClothSet<D>::undo_worlds(const pbd::ChosenWorlds& worlds) {
  if (vertex_count_ == 0) return;
  write_multipliers(worlds.chosen, saved_edge_multiplier_.view(), saved_chain_multiplier_.view(),
                    pbd::WorldsFrom::all);
  pbd::write_worlds(device_, "cloth/undo clocks", {worlds.chosen, 1, static_cast<uint32_t>(clocks_.size())},
                    View<const load_kernels::WorldClock>(saved_clocks_.view()), clocks_.view(),
                    pbd::WorldsFrom::all);
}

template <class D>
void ClothSet<D>::write_multipliers(View<const uint32_t> chosen, View<const Vec4> edges,
                                    View<const float> chains, pbd::WorldsFrom kind) {
  using namespace world_kernels;
  const uint32_t chain_edges = chain_multiplier().count;
  device_.parallel_for("cloth/write edges", first_chain_edge_,
                       WriteEdges{{chosen, first_chain_edge_ / worlds_, first_chain_edge_},
                                  {edge_places_.view()},
                                  edges,
                                  edge_multiplier_.view(),
                                  kind});
  device_.parallel_for(
      "cloth/write chains", chain_edges,
      WriteChains{{chosen, chain_edges / worlds_, chain_edges}, chains, chain_multiplier(), kind});
}

/// Wind, and what bending has resolved, are of all worlds. So is the last substep, until
/// DeviceEngine::continue_from() overwrites it.
template <class D>
void ClothSet<D>::visit_world(pbd::StateVisitor& v, uint32_t world) {
  load_kernels::WorldClock clock{};
  clocks_.read(std::span(&clock, 1), world);
  float last = clock.has_last ? last_dt_ : 0;
  Wind wind = wind_;
  const uint32_t edges = first_chain_edge_ / worlds_, chain_edges = chain_multiplier().count / worlds_;
  pbd::Buffer<Vec4> one(device_, "edge multipliers");
  one.resize_discard(edges + chain_edges);
  const auto copy = [&] {
    device_.parallel_for("cloth/copy world", edges + chain_edges,
                         world_kernels::CopyWorld{{edge_places_.view()},
                                                  edge_multiplier_.view(),
                                                  world,
                                                  edges,
                                                  first_chain_edge_,
                                                  chain_edges,
                                                  one.view(),
                                                  v.restores()});
  };
  if (!v.restores()) copy();
  v.value("wind", wind);
  v.value("time", clock.time);
  v.value("last_dt", last);
  v.array("edge_multiplier", one.view(), one.size());
  if (!v.restores()) return v.part("bending", bending_);
  copy();
  if (last > 0) last_dt_ = last;
  clock.has_last = last > 0;
  clocks_.write(std::span<const load_kernels::WorldClock>(&clock, 1), world);
}

}  // namespace meniscus::cloth
