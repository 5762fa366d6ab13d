// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// ClothSet: uploads a model, and launches the kernels of a substep in order.
#pragma once

#include <algorithm>
#include <utility>

#include "cloth/build/tethers.h"
#include "cloth/solve/chain_kernel.h"
#include "cloth/solve/cloth_set.h"
#include "cloth/solve/colour_kernel.h"
#include "cloth/solve/load_kernels.h"
#include "cloth/solve/of_worlds.h"
#include "cloth/solve/sweep_kernel.h"
#include "cloth/solve/tear_kernels.h"
#include "cloth/solve/tether_kernels.h"
#include "cloth/solve/tuning.h"
#include "cloth/solve/wind_kernels.h"

namespace meniscus::cloth {

template <class D>
void ClothSet<D>::set_model(const ClothModel& one, uint32_t worlds) {
  device_.wait();
  worlds_ = worlds;
  clocks_.resize_discard(in_batch_ ? worlds : 0);
  saved_clocks_.resize_discard(clocks_.size());
  vertex_count_ = worlds * static_cast<uint32_t>(one.rest.size());
  const ClothModel model = upload_constraints(one);
  const auto any = [&](auto has) { return std::any_of(model.pieces.begin(), model.pieces.end(), has); };
  any_air_ = any([](const Piece& p) { return p.drag > 0 || p.lift > 0; });
  any_gas_ = any([](const Piece& p) { return p.inside > 0; });
  any_tears_ = any([](const Piece& p) { return p.tear_strain > 0; });
  damping_ = common_damping(model.pieces);
  last_dt_ = 0;

  tether_pull_.resize_discard(model.tethers.size());
  upload(held_, model.held);
  std::vector<uint32_t> tether_start{0};
  for (uint32_t v : model.held) {
    uint32_t end = tether_start.back();
    while (end < model.tethers.size() && model.tethers[end].anchor == v) ++end;
    tether_start.push_back(end);
  }
  upload(tether_start_, tether_start);
  reaction_.resize_discard(model.held.size());
  reaction_.fill(0);

  upload(pieces_, model.pieces);
  loaded_.resize_discard(model.pieces.size());
  upload(triangles_, model.triangles);
  upload(rest_, model.rest);
  volume_gradient_.resize_discard(any_gas_ ? vertex_count_ : 0);
  gas_partial_.resize_discard(any_gas_ ? volume_kernels::lanes * model.pieces.size() : 0);
  gas_.resize_discard(any_gas_ ? model.pieces.size() : 0);
  gas_.fill(0);
  gas_step_.resize_discard(any_gas_ ? model.pieces.size() : 0);
  wind_force_.resize_discard(any_air_ ? model.triangles.size() : 0);
  tears_.resize_discard(1);
  tears_.host()[0] = 0;
}

/// Returns the model of all worlds.
template <class D>
ClothModel ClothSet<D>::upload_constraints(const ClothModel& model) {
  ClothConstraints constraints = model.constraints;
  ClothModel one = model;
  const Chains chains = draw_chains(constraints, model.rest, model.pieces);
  one.tethers = tethers_beside(chains, model);
  ClothModel all = of_worlds(one, worlds_);
  upload(tethers_, all.tethers);
  bending_.set_model(model, all);
  const auto vertices = static_cast<uint32_t>(model.rest.size());
  const Clusters clusters = build_clusters(constraints, model.rest);
  Clusters c = of_worlds(clusters, vertices, worlds_);
  upload(edge_places_, places_by_world(clusters.colour_starts, in_batch_ ? worlds_ : 0));
  upload_edges(all, c, of_worlds(chains, vertices, worlds_));
  upload(strains_, c.strains);
  upload(hinges_, c.hinges);
  upload(batches_, c.batches);
  upload(clusters_, c.clusters);
  upload(cluster_vertices_, c.vertices);
  pass_starts_ = c.pass_starts;
  bending_passes_ = c.bending_passes;
  colour_starts_ = c.colour_starts;
  strain_multiplier_.resize_discard(c.strains.size());
  return all;
}

/// Multipliers of bending last for one substep. With a single iteration none are stored.
template <class D>
void ClothSet<D>::reserve_bending_multipliers(int iterations) {
  hinge_multiplier_.resize_discard(iterations > 1 ? hinges_.size() : 0);
}

/// Uploads the edges of clusters, with vertices numbered within their cluster, then the edges of chains.
template <class D>
void ClothSet<D>::upload_edges(const ClothModel& model, Clusters& clusters, const Chains& chains) {
  upload_adjacency(model, clusters.edges);
  number_locally(clusters);
  std::vector<EdgeConstraint> edges = clusters.edges;
  edges.insert(edges.end(), chains.edges.begin(), chains.edges.end());
  upload(edges_, edges);
  first_chain_edge_ = static_cast<uint32_t>(clusters.edges.size());
  upload(chains_, chains.chains);
  layer_starts_ = chains.layer_starts;
  edge_multiplier_.resize_discard(edges.size());
  saved_edge_multiplier_.resize_discard(clusters.edges.size());
  saved_chain_multiplier_.resize_discard(chains.edges.size());
  edge_multiplier_.fill(0);
}

template <class D>
void ClothSet<D>::upload_adjacency(const ClothModel& model, const std::vector<EdgeConstraint>& edges) {
  const Adjacency triangles = corners_by_vertex(model.triangles, model.rest.size());
  upload(corner_start_, triangles.start);
  upload(corners_, triangles.items);
  const bool warm_starts = parameters_.warm_start > 0;
  pending_.resize_discard(warm_starts && !edges.empty() ? vertex_count_ : 0);
  const Adjacency by_edge = warm_starts ? edge_ends_by_vertex(edges, model.rest.size()) : Adjacency{};
  upload(edge_end_start_, by_edge.start);
  upload(edge_ends_, by_edge.items);
}

template <class D>
void ClothSet<D>::begin(pbd::Substep<D>& substep) {
  if (vertex_count_ == 0) return;
  reserve_bending_multipliers(substep.iterations);
  // A multiplier is proportional to the square of the substep.
  const float ratio = last_dt_ > 0 ? substep.dt / last_dt_ : 0;
  warm_start_fraction_ = parameters_.warm_start > 0 ? std::min(1.0f, ratio * ratio) : 0;
  last_dt_ = substep.dt;
  time_ += substep.dt;
}

template <class D>
bool ClothSet<D>::prepares() const {
  return vertex_count_ > 0 && any_air_ && wind_.density > 0;
}

template <class D>
void ClothSet<D>::prepare(pbd::Substep<D>& substep) {
  if (!prepares()) return;
  const double time = wind_.gusty ? time_ : 0;  // a constant keeps launches alike without gusts
  const View<load_kernels::WorldClock> no_clocks{};
  device_.parallel_for_lanes(
      "cloth/wind", static_cast<uint32_t>(triangles_.size()),
      wind_kernels::BlowOnTriangles{triangles_.view(), vertices(substep), wind_, static_cast<float>(time),
                                    wind_.gusty ? clocks_.view() : no_clocks, wind_force_.view()});
  feels_wind_ = true;
}

/// Chains absorb the pushes that the other edges start with, before cloth moves. Chains hold by far the
/// greater part of these pushes.
template <class D>
void ClothSet<D>::start_from_last(pbd::Substep<D>& substep) {
  using namespace stretch_kernels;
  note_loads(substep);
  forget_pulls(substep);
  device_.parallel_for("cloth/start", vertex_count_,
                       StartPushes{edge_end_start_.view(), edge_ends_.view(), edge_multiplier_.view(),
                                   warm_start_fraction_, pending_.view()});
  solve_chains(substep, ChainStage::absorbs_pending, Direction::forwards);
  device_.parallel_for("cloth/give pending", vertex_count_, GivePending{pending_.view(), vertices(substep)});
}

template <class D>
void ClothSet<D>::note_loads(pbd::Substep<D>& substep) {
  using namespace load_kernels;
  if (!may_be_loaded(substep)) return;
  loaded_.fill(0);
  if (substep.effective_mass.count > 0) {
    device_.parallel_for("cloth/loads of bodies", substep.contacts.contacts.count,
                         NoteBodyLoads{substep.contacts, vertices(substep), vertex_count_, loaded_.view()});
  }
  if (substep.fluid_near.count > 0) {
    device_.parallel_for("cloth/loads of fluid", vertex_count_,
                         NoteFluidLoads{substep.fluid_near, vertices(substep), loaded_.view()});
  }
  if (may_be_fresh()) {
    device_.parallel_for(
        "cloth/fresh", static_cast<uint32_t>(loaded_.size()),
        MarkFresh{clocks_.view(), static_cast<uint32_t>(loaded_.size()) / worlds_, loaded_.view()});
  }
}

/// Clears the multipliers of loaded pieces, at the end of a substep as well: they will not fit the next one
/// either.
template <class D>
void ClothSet<D>::forget_pulls(pbd::Substep<D>& substep) {
  if (!may_be_loaded(substep)) return;
  device_.parallel_for("cloth/forget", vertex_count_,
                       load_kernels::Forget{edge_end_start_.view(), edge_ends_.view(), loaded_.view(),
                                            vertices(substep), edge_multiplier_.view()});
}

template <class D>
void ClothSet<D>::project(pbd::Substep<D>& substep, int iteration) {
  if (vertex_count_ == 0) return;
  if (iteration == 0) bending_.solve(substep, vertices(substep));
  if (feels_wind_) {
    device_.parallel_for(
        "cloth/blow", vertex_count_,
        wind_kernels::Blow{corner_start_.view(), corners_.view(), wind_force_.view(), vertices(substep),
                           substep.dt, 1 / static_cast<float>(substep.iterations)});
    if (iteration + 1 == substep.iterations) feels_wind_ = false;
  }
  if (iteration == 0 && starts_from_last()) start_from_last(substep);
  // The constraint that is solved last holds best: lengths or, where there is gas, its volume.
  const int turns = any_gas_ ? iteration : substep.iterations - 1 - iteration;
  const SweepOrder order{.follows = iteration == 0 ? Follows::last_substep : Follows::last_iteration,
                         .direction = turns % 2 != 0 ? Direction::backwards : Direction::forwards,
                         .ends = iteration + 1 == substep.iterations};
  const bool backwards = order.is_backwards();
  if (any_gas_ && !backwards) apply_gas(substep, order.starts());
  // Rounds improve the final state. Iterations that others follow do without them.
  const int rounds = order.ends ? parameters_.stretch_rounds : 1;
  if (!backwards) bend(substep, order);
  stretch(substep, rounds, order);
  if (backwards) bend(substep, order);
  if (any_gas_ && backwards) apply_gas(substep, order.starts());
  device_.parallel_for_lanes("cloth/tethers", static_cast<uint32_t>(tethers_.size()),
                             tether_kernels::ProjectTethers{tethers_.view(), tether_pull_.view(),
                                                            vertices(substep), order.starts()});
}

template <class D>
void ClothSet<D>::bend(pbd::Substep<D>& substep, const SweepOrder& order) {
  sweep(substep, 0, bending_passes_, {.follows = order.follows, .direction = order.direction});
}

/// Every other round runs through colours and layers in the other direction. The error that remains between
/// rounds is what sweeps and chains undo of one another.
template <class D>
void ClothSet<D>::stretch(pbd::Substep<D>& substep, int rounds, const SweepOrder& order) {
  const size_t stretch_end = pass_starts_.size() - 1;
  for (int round = 0; round < rounds; ++round) {
    const int left = rounds - 1 - round;
    const bool backwards = (order.is_backwards() ? round + 1 : left) % 2 != 0;
    const SweepOrder edges{.follows = round == 0 ? order.follows : Follows::last_round,
                           .direction = backwards ? Direction::backwards : Direction::forwards,
                           .ends = order.ends && left == 0};
    const ChainStage chains = !edges.starts()      ? ChainStage::continues
                              : starts_from_last() ? ChainStage::follows_absorbing
                                                   : ChainStage::starts;
    if (order.is_backwards()) solve_chains(substep, chains, edges.direction);
    colour_starts_.empty() ? sweep(substep, bending_passes_, stretch_end, edges)
                           : sweep_colours(substep, edges);
    if (!order.is_backwards()) solve_chains(substep, chains, edges.direction);
  }
}

template <class D>
stretch_kernels::SolveEdge ClothSet<D>::edge_solver(const pbd::Substep<D>& substep, const SweepOrder& order) {
  return {.edges = edges_.view(),
          .multiplier = edge_multiplier_.view(),
          .relaxation = parameters_.over_relaxation,
          .fraction = order.starts() ? warm_start_fraction_ : 1,
          .momentum = order.follows == Follows::last_round ? cloth_tuning::round_momentum : 0,
          .shears = starts_from_last(),
          .loaded = substep.fluid_near.count > 0 || may_be_fresh() ? loaded_.view() : View<uint32_t>{},
          .ends = order.ends,
          .next_fraction = parameters_.warm_start};
}

template <class D>
void ClothSet<D>::sweep_colours(pbd::Substep<D>& substep, const SweepOrder& order) {
  const SolveColour solve{edge_solver(substep, order), vertices(substep)};
  const size_t colours = colour_starts_.size() - 1;
  for (size_t k = 0; k < colours; ++k) {
    const size_t colour = order.is_backwards() ? colours - 1 - k : k;
    const uint32_t first = colour_starts_[colour];
    SolveColour one = solve;
    one.edge.edges = solve.edge.edges.from(first);
    one.edge.multiplier = solve.edge.multiplier.from(first);
    device_.parallel_for_lanes("cloth/diagonals", colour_starts_[colour + 1] - first, one);
  }
}

template <class D>
void ClothSet<D>::sweep(pbd::Substep<D>& substep, size_t first_pass, size_t end_pass,
                        const SweepOrder& order) {
  SolveClusters solve{
      .clusters = clusters_.view(),
      .batches = batches_.view(),
      .numbers = cluster_vertices_.view(),
      .all = vertices(substep),
      .hinge = {hinges_.view(), hinge_multiplier_.view(), order.starts()},
      .strain = {strains_.view(), strain_multiplier_.view(), parameters_.over_relaxation, order.starts()},
      .edge = edge_solver(substep, order),
      .first = 0,
      .backwards = order.is_backwards()};
  for (size_t k = first_pass; k < end_pass; ++k) {
    const size_t pass = order.is_backwards() ? first_pass + end_pass - 1 - k : k;
    solve.first = pass_starts_[pass];
    device_.parallel_for_groups("cloth/sweep", pass_starts_[pass + 1] - solve.first, solve);
  }
}

template <class D>
void ClothSet<D>::solve_chains(pbd::Substep<D>& substep, ChainStage stage, Direction direction) {
  SolveChains solve{
      .chains = chains_.view(),
      .edges = edges_.view().from(first_chain_edge_),
      .multiplier = chain_multiplier(),
      .all = vertices(substep),
      .pending = pending_.view(),
      .effective_mass = substep.effective_mass,
      .loaded = starts_from_last() && may_be_loaded(substep) ? loaded_.view() : View<uint32_t>{},
      .stage = stage,
      .first = 0,
      .end = 0};
  const size_t layers = layer_starts_.size() - 1;
  for (size_t k = 0; k < layers; ++k) {
    const size_t layer = direction == Direction::backwards ? layers - 1 - k : k;
    solve.first = layer_starts_[layer];
    solve.end = layer_starts_[layer + 1];
    device_.parallel_for_lane_groups("cloth/chains", solve.end - solve.first, solve);
  }
}

template <class D>
void ClothSet<D>::apply_gas(pbd::Substep<D>& substep, bool starts) {
  using namespace volume_kernels;
  const auto pieces = static_cast<uint32_t>(pieces_.size());
  const VertexState state = vertices(substep);
  device_.parallel_for(
      "cloth/volume gradients", vertex_count_,
      Gradients{triangles_.view(), corner_start_.view(), corners_.view(), state, volume_gradient_.view()});
  device_.parallel_for("cloth/volume sums", pieces * lanes,
                       SumLanes{volume_gradient_.view(), state, gas_partial_.view()});
  device_.parallel_for(
      "cloth/gas", pieces,
      Solve{gas_partial_.view(), pieces_.view(), gas_.view(), gas_step_.view(), state.inverse_dt, starts});
  device_.parallel_for("cloth/pressure", vertex_count_,
                       Push{volume_gradient_.view(), gas_step_.view(), state});
}

template <class D>
void ClothSet<D>::settle(pbd::Substep<D>& substep) {
  if (starts_from_last()) forget_pulls(substep);
  device_.parallel_for("cloth/clocks", static_cast<uint32_t>(clocks_.size()),
                       load_kernels::AdvanceClocks{clocks_.view(), substep.dt});
}

template <class D>
void ClothSet<D>::end(pbd::Substep<D>& substep) {
  if (!any_tears_) return;
  device_.parallel_for("cloth/tears", static_cast<uint32_t>(triangles_.size()),
                       tear_kernels::FindTears{surface(), vertices(substep), tears_.view()});
}

/// Late, because contacts push on held vertices until the substep's end.
template <class D>
void ClothSet<D>::observe(const pbd::Substep<D>& substep) {
  device_.parallel_for("cloth/reactions", static_cast<uint32_t>(held_.size()),
                       tether_kernels::NoteReactions{held_.view(), tether_start_.view(), tether_pull_.view(),
                                                     vertices(substep), reaction_.view()});
}

template <class D>
void ClothSet<D>::start_step() {
  feels_wind_ = false;  // a step may have failed before its wind acted
  start_time_ = time_;
  reaction_.fill(0);
  if (!tears_.host().empty()) tears_.host()[0] = 0;
}

template <class D>
void ClothSet<D>::visit_state(pbd::StateVisitor& v) {
  v.value("wind", wind_);
  v.value("time", time_);
  v.value("last_dt", last_dt_);
  v.array("edge_multiplier", edge_multiplier_.view(), edge_multiplier_.size());
  v.part("bending", bending_);
  if (in_batch_) v.array("clock", clocks_.view(), clocks_.size());
}

/// Chains start without a push. Only the sizes of their last multipliers matter.
template <class D>
void ClothSet<D>::save() {
  saved_last_dt_ = last_dt_;
  copy_clocks(clocks_, saved_clocks_);
  device_.copy(saved_edge_multiplier_.view().data, edge_multiplier_.view().data,
               first_chain_edge_ * sizeof(Vec4));
  device_.parallel_for("cloth/save chains", static_cast<uint32_t>(saved_chain_multiplier_.size()),
                       KeepMultipliers{chain_multiplier(), saved_chain_multiplier_.view()});
}

template <class D>
void ClothSet<D>::restore() {
  last_dt_ = saved_last_dt_;
  copy_clocks(saved_clocks_, clocks_);
  device_.copy(edge_multiplier_.view().data, saved_edge_multiplier_.view().data,
               first_chain_edge_ * sizeof(Vec4));
  device_.parallel_for("cloth/restore chains", static_cast<uint32_t>(saved_chain_multiplier_.size()),
                       RestoreMultipliers{saved_chain_multiplier_.view(), chain_multiplier()});
}

template <class D>
std::vector<Vec3> ClothSet<D>::read_reactions() const {
  std::vector<Vec3> out;
  for (const Vec4& r : reaction_.read(reaction_.size())) out.push_back(r.xyz());
  return out;
}

}  // namespace meniscus::cloth

#include "cloth/solve/cloth_worlds.inl"
