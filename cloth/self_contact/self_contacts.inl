// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// SelfContacts: the launches of a substep, the room for lists, and the saved state.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "cloth/self_contact/candidate_lifetime.h"
#include "cloth/self_contact/ccd_failsafe.h"
#include "cloth/self_contact/find.h"
#include "cloth/self_contact/groups.h"
#include "cloth/self_contact/lessons.h"
#include "cloth/self_contact/narrow.h"
#include "cloth/self_contact/self_contacts.h"
#include "cloth/self_contact/solve.h"
#include "cloth/self_contact/tuning.h"
#include "pbd/device/launch_size.h"
#include "pbd/surface_tree/surface_tree.inl"

namespace meniscus::cloth {

namespace self_contact_kernels {

/// The range of the vertices in an array over all particles.
template <class T>
View<T> vertices_of(View<T> all, uint32_t sorted, uint32_t count) {
  return {all.data + sorted, count};
}

}  // namespace self_contact_kernels

/// Lists the pairs again where the present lists no longer hold.
template <class D>
void SelfContacts<D>::list_pairs(pbd::Substep<D>& substep) {
  using namespace self_contact_kernels;
  const pbd::ParticleView& p = substep.particles;
  const View<const Vec4> previous = vertices_of(p.previous, p.sorted, vertices_);
  const Listing listing{counters_.view()};
  device_.parallel_for("self contacts/frames", static_cast<uint32_t>(pieces_.size()),
                       ChooseFrames{counters_.view(), surroundings(), pieces_.view(), frame_of_.view(),
                                    cell_of_.view(), of_world_, one_frame_.view()});
  device_.parallel_for(
      "self contacts/keep", vertices_,
      CandidateLifetime{listing, previous, foreseen_.view(), vertex_piece_.view(), frame_of_.view(),
                        pieces_.view(), strayed_.view(), surroundings(), frames_.view(), kept_.view(),
                        wide_.view(), counters_.view(), of_world_});
  tree_.refit(KeptBoxes{listing, {kept_.view()}});
  if (of_world_.frames > 1) tree_.refit_before(KeptBoxesBefore{listing, {kept_.view()}, frames()});
  const pbd::SurfaceTreeView tree = tree_.view();
  device_.parallel_for_groups("self contacts/cones", blocks_of<ConeScratch>(),
                              FitCones{listing, tree, pieces_.view(), previous, foreseen_.view(),
                                       cones_.view(), rough_.view(), of_world_.groups});
  device_.parallel_for_groups("self contacts/groups", tree.groups_of(1),
                              FindGroups{listing, tree, pieces_.view(), cell_of_.view(), sheets(), pairs()});
  constexpr uint32_t each = CandidateScratch::pairs;
  const uint32_t blocks = std::max(1u, (launched(group_pairs, group_pairs_.size()) + each - 1) / each);
  device_.parallel_for_groups(
      "self contacts/candidates", worlds_ * blocks,
      FindCandidates{listing, cloth(substep), pairs(), candidates_.view(), worlds_, blocks});
}

template <class D>
void SelfContacts<D>::sum_surroundings(pbd::Substep<D>& substep) {
  using namespace self_contact_kernels;
  const pbd::ParticleView& p = substep.particles;
  device_.parallel_for_groups("self contacts/motion", blocks_of<MotionScratch>(),
                              SumMotion{cloth(substep), surroundings()});
  device_.parallel_for("self contacts/surroundings", substep.contacts.contacts.count,
                       FindSurroundings{substep.contacts, p.previous, p.position, p.phase,
                                        vertex_piece_.view(), p.sorted, surroundings()});
}

template <class D>
void SelfContacts<D>::find_pairs(pbd::Substep<D>& substep) {
  using namespace self_contact_kernels;
  using self_contact_tuning::separation_time;
  const pbd::ParticleView& p = substep.particles;
  sum_surroundings(substep);
  device_.parallel_for("self contacts/foresee", vertices_,
                       Foresee{vertices_of(p.previous, p.sorted, vertices_),
                               vertices_of(p.position, p.sorted, vertices_),
                               vertex_piece_.view(),
                               pieces_.view(),
                               strayed_.view(),
                               frames(),
                               surroundings(),
                               kept_.view(),
                               wide_.view(),
                               foreseen_.view(),
                               impact_zones(),
                               piece_sums(),
                               folds(),
                               entries_.view(),
                               counters_.view(),
                               of_world_,
                               {room_of_world(group_pairs_.size()), room_of_world(candidates_.size()),
                                room_of_world(corners_.size())},
                               std::exchange(anew_, false),
                               lasts_one_substep_.view()});
  list_pairs(substep);
  const uint32_t blocks = launched(candidates, candidates_.size()) / threads_together + 1;
  device_.parallel_for_groups("self contacts/contacts", worlds_ * blocks,
                              MakeContacts{cloth(substep), candidates_.view(), rest_, list(), entries_.view(),
                                           substep.dt / separation_time, worlds_, blocks});
}

template <class D>
void SelfContacts<D>::project(pbd::Substep<D>& substep, int iteration) {
  using namespace self_contact_kernels;
  if (idle()) return;
  if (iteration == 0) find_pairs(substep);
  const pbd::ParticleView& p = substep.particles;
  const View<Vec4> position = vertices_of(p.position, p.sorted, vertices_);
  const PushSums sums{push_sums_.view(), unit_};
  const uint32_t threads = std::max(1u, launched(contacts, corners_.size()));
  const PushApart push{list(),  position, vertices_of(p.previous, p.sorted, vertices_), entries_.view(), sums,
                       worlds_, threads};
  const MoveVertices move{entries_.view(), position, vertices_of(p.accumulated_delta, p.sorted, vertices_),
                          sums};
  for (int sweep = 0; sweep < self_contact_tuning::sweeps; ++sweep) {
    device_.parallel_for("self contacts/push", worlds_ * threads, push);
    device_.parallel_for("self contacts/move", vertices_, move);
  }
}

template <class D>
void SelfContacts<D>::join_crossings(pbd::Substep<D>& substep) {
  using namespace self_contact_kernels;
  if (idle()) return;
  const pbd::ParticleView& p = substep.particles;
  const View<const Vec4> previous = vertices_of(p.previous, p.sorted, vertices_);
  const View<Vec4> position = vertices_of(p.position, p.sorted, vertices_);
  const View<Vec4> accumulated_delta = vertices_of(p.accumulated_delta, p.sorted, vertices_);
  device_.parallel_for("self contacts/contain", vertices_,
                       Contain{previous,
                               vertex_piece_.view(),
                               {kept_.view()},
                               frames(),
                               surroundings(),
                               foreseen_.view(),
                               position,
                               accumulated_delta,
                               strayed_.view(),
                               own_motion(),
                               counters_.view(),
                               of_world_.vertices});
  const uint32_t most = std::max(launched(candidates, candidates_.size()), of_world_.vertices);
  const uint32_t blocks = std::min(most, most_threads / worlds_) / threads_together + 1;
  for (uint32_t round = 0; round < rounds_; ++round) {
    device_.parallel_for_groups("self contacts/folds", blocks_of<FoldScratch>(),
                                FindFolds{cloth(substep), sheets(), impact_zones(), folds(), round});
    device_.parallel_for_groups(
        "self contacts/crossings", worlds_ * blocks,
        FindCrossings{cloth(substep), candidates_.view(), sheets(), impact_zones(), own_motion(), folds(),
                      worlds_, round, blocks, least_distance_});
    device_.parallel_for(
        "self contacts/zones", vertices_,
        GatherImpactZones{previous, position, impact_zones(), counters_.view(), of_world_.vertices, round});
    device_.parallel_for(
        "self contacts/move zones", vertices_,
        MoveImpactZones{cloth(substep), substep.contacts, p.sorted, position, accumulated_delta,
                        impact_zones(), own_motion(), foreseen_.view(), counters_.view(), round});
  }
  device_.parallel_for_groups("self contacts/lost", blocks_of<LostScratch>(),
                              SumLost{cloth(substep), foreseen_.view(), piece_sums(), counters_.view()});
  const auto all_counters = static_cast<uint32_t>(counters_.size());
  device_.parallel_for("self contacts/transfer", std::max(vertices_, all_counters),
                       TransferPush{vertex_piece_.view(), position, accumulated_delta, piece_sums(),
                                    counters_.view(), found_by_world_.view(), of_world_.vertices});
  // A GPU reads the host's memory slowly, so only one counter of each kind is compared there.
  const bool is_batch = worlds_ > 1;
  if (is_batch)
    device_.parallel_for("self contacts/most", all_counters,
                         NoteFound{found_by_world_.view(), most_found_.view()});
  device_.parallel_for("self contacts/found", counter_count,
                       NoteFound{is_batch ? most_found_.view() : found_by_world_.view(), found_.view()});
}

// ---- room ----

/// The number of rounds that found something.
template <class D>
uint32_t SelfContacts<D>::used_rounds() const {
  uint32_t used = 0;
  for (uint32_t k = 0; k < rounds_; ++k) used = found(self_contact_kernels::crossings + k) > 0 ? k + 1 : used;
  return used;
}

template <class D>
void SelfContacts<D>::start_step() {
  forget_found();
  found_by_world_.fill(0);
  most_found_.fill(0);
  learned_ = false;
}

template <class D>
void SelfContacts<D>::forget_found() {
  std::fill(found_.host().begin(), found_.host().end(), 0u);
  anew_ = true;
}

/// Takes over what the last step has shown. An attempt that is repeated shows nothing: which pairs had room
/// in its lists depends on the order of threads.
template <class D>
void SelfContacts<D>::learn() {
  using namespace self_contact_kernels;
  if (std::exchange(learned_, true) || idle()) return;
  // Rounds that the last step did not use are dropped one by one. A superfluous round costs little. A
  // repeated step costs as much as the step itself.
  rounds_ = std::min(most_rounds, std::max({self_contact_tuning::first_rounds,
                                            used_rounds() + self_contact_tuning::spare_rounds, rounds_ - 1}));
  device_.parallel_for("self contacts/learn", worlds_,
                       Learn{found_by_world_.view(), lasts_one_substep_.view(), one_frame_.view()});
}

template <class D>
bool SelfContacts<D>::lists_had_room() const {
  using namespace self_contact_kernels;
  return found(group_pairs) <= room_of_world(group_pairs_.size()) &&
         found(candidates) <= room_of_world(candidates_.size()) &&
         found(contacts) <= room_of_world(corners_.size());
}

template <class D>
bool SelfContacts<D>::had_room() const {
  using namespace self_contact_kernels;
  return idle() || ((!ran_short() || rounds_ == most_rounds) && found(frames_meet) == 0 && lists_had_room());
}

template <class D>
void SelfContacts<D>::make_room() {
  using namespace self_contact_kernels;
  const bool is_complete = lists_had_room();
  // Folding cloth needs more in each step. A repeated step costs as much as the step itself.
  const auto more = [&](uint32_t found) { return worlds_ * size_t{found + found / 2}; };
  const auto lacks = [&](uint32_t found, size_t room) { return found > room_of_world(room); };
  if (lacks(found(group_pairs), group_pairs_.size())) group_pairs_.resize_or_stay(more(found(group_pairs)));
  if (lacks(found(candidates), candidates_.size())) candidates_.resize_or_stay(more(found(candidates)));
  if (lacks(found(contacts), corners_.size())) reserve_contacts(static_cast<uint32_t>(more(found(contacts))));
  if (!is_complete) return;  // what the pairs showed depends on which of them had room
  if (ran_short()) rounds_ = more_rounds();
  if (found(frames_meet) > 0)
    device_.parallel_for("self contacts/unite frames", worlds_,
                         UniteFrames{found_by_world_.view(), one_frame_.view()});
}

template <class D>
void SelfContacts<D>::reserve_contacts(uint32_t capacity) {
  corners_.resize_discard(0);
  plane_.resize_discard(capacity);
  multiplier_.resize_discard(capacity);
  weights_.resize_discard(capacity);
  corners_.resize_discard(capacity);  // last: its size is the one that is checked
}

// ---- state ----

template <class D>
void SelfContacts<D>::save() {
  learn();
  if (!idle()) device_.copy(saved_strayed_.view().data, strayed_.view().data, vertices_ * sizeof(float));
}

template <class D>
void SelfContacts<D>::restore() {
  learned_ = true;
  if (idle()) return;
  device_.copy(strayed_.view().data, saved_strayed_.view().data, vertices_ * sizeof(float));
  push_sums_.fill(0);  // a step that was cancelled has left pushes that nobody took
}

template <class D>
self_contact_kernels::ClothState SelfContacts<D>::cloth(const pbd::Substep<D>& substep) {
  using namespace self_contact_kernels;
  const pbd::ParticleView& p = substep.particles;
  return {vertices_of(p.previous, p.sorted, vertices_),
          vertices_of(p.position, p.sorted, vertices_),
          {kept_.view()},
          tree_.view(),
          features_.view(),
          pieces_.view(),
          rough_.view(),
          frames(),
          of_world_};
}

template <class D>
self_contact_kernels::Frames SelfContacts<D>::frames() {
  return {frames_.view(), frame_of_.view(), vertex_piece_.view()};
}

template <class D>
self_contact_kernels::Surroundings SelfContacts<D>::surroundings() {
  return {{displacement_sums_.view()}, {immovable_.view()}, {movable_.view()}};
}

template <class D>
self_contact_kernels::GroupPairs SelfContacts<D>::pairs() {
  return {group_pairs_.view(), counters_.view()};
}

template <class D>
self_contact_kernels::SheetViews SelfContacts<D>::sheets() {
  return {cones_.view(), neighbour_start_.view(), neighbours_.view(), smooth_.view()};
}

/// Contacts do not push while impact zones are solved, so both share the sums.
template <class D>
self_contact_kernels::ImpactZones SelfContacts<D>::impact_zones() {
  constexpr float coarser = 1 << 9;  // so many vertices can be summed
  return {impact_zone_label_.view(),
          impact_zone_mark_.view(),
          impact_zone_anchor_.view(),
          impact_zone_mass_.view(),
          {push_sums_.view(), coarser * unit_},
          coarser * unit_};
}

template <class D>
self_contact_kernels::OwnMotion SelfContacts<D>::own_motion() {
  return {solved_.view(), safe_fraction_.view()};
}

template <class D>
self_contact_kernels::PieceSums SelfContacts<D>::piece_sums() {
  constexpr float coarser = 1 << 9, coarse = 1 << 29;  // a piece may have a million vertices, under water
  return {piece_sums_.view(), coarser * unit_, coarse * unit_};
}

template <class D>
self_contact_kernels::Folds SelfContacts<D>::folds() {
  return {fold_state_.view(), fold_noted_.view(), fold_list_.view(), counters_.view(), of_world_.groups};
}

template <class D>
self_contact_kernels::ContactList SelfContacts<D>::list() {
  return {corners_.view(), plane_.view(), multiplier_.view(), weights_.view(), counters_.view()};
}

/// For each world.
template <class D>
uint32_t SelfContacts<D>::launched(uint32_t counter, size_t capacity) {
  uint32_t most = 0;
  if constexpr (!D::runs_at_once) {
    for (uint32_t w = 0; w < worlds_; ++w)
      most = std::max(most, counters_.view()[w * self_contact_kernels::counter_count + counter]);
  }
  return pbd::launch_size<D>(most, room_of_world(capacity), std::max(1u, most_threads / worlds_));
}

}  // namespace meniscus::cloth

#include "cloth/self_contact/self_contact_surface.inl"
#include "cloth/self_contact/self_contact_worlds.inl"
