// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "cloth/self_contacts.h"
#include "cloth/self_contacts_find.h"
#include "cloth/self_contacts_guard.h"
#include "cloth/self_contacts_narrow.h"
#include "cloth/self_contacts_solve.h"
#include "pbd/filter.h"
#include "pbd/surface_tree.inl"

namespace meniscus::cloth {

namespace self_contact_kernels {

/// Vertices of an array over all particles.
template <class T>
View<T> vertices_of(View<T> all, uint32_t sorted, uint32_t count) {
  return {all.data + sorted, count};
}

}  // namespace self_contact_kernels

template <class D>
void SelfContacts<D>::begin(pbd::Substep<D>& substep) {
  if (idle()) return;
  find_pairs(substep);
  make_contacts(substep);
}

template <class D>
void SelfContacts<D>::find_pairs(pbd::Substep<D>& substep) {
  using namespace self_contact_kernels;
  const pbd::ParticleView& p = substep.particles;
  const View<const Vec4> previous = vertices_of(p.previous, p.sorted, vertices_);
  device_.parallel_for(
      "self contacts/foresee", vertices_,
      Foresee{previous, vertices_of(p.position, p.sorted, vertices_), vertex_part_.view(), parts_.view(),
              strayed_.view(), foreseen_.view(), limit_.view(), entry_count_.view(), counters_.view()});
  tree_.refit(p, Reach{foreseen_.view()});
  device_.parallel_for("self contacts/cones", groups_,
                       FitCones{tree_.view(), parts_.view(), previous, foreseen_.view(), cones_.view(),
                                rough_.view(), squeezed_.view()});
  device_.parallel_for(
      "self contacts/groups", groups_,
      FindGroups{tree_.view(), parts_.view(), cones_.view(), neighbour_start_.view(), neighbours_.view(),
                 rows_.view(), row_count_.view(), counters_.view(), row_capacity_});
  device_.parallel_for("self contacts/candidates", tree_.places(),
                       FindCandidates{{cloth(substep), false}, candidates_.view(), counters_.view()});
}

template <class D>
void SelfContacts<D>::make_contacts(pbd::Substep<D>& substep) {
  using namespace self_contact_kernels;
  constexpr float separation_time = 0.02f;  // s, in which an overlap is opened by a thickness
  device_.parallel_for("self contacts/contacts", launched(candidates, candidates_.size()),
                       MakeContacts{cloth(substep), candidates_.view(), rest_, list(), entry_count_.view(),
                                    squeezed_.view(), substep.dt / separation_time});
  device_.exclusive_scan("self contacts/offsets", entry_count_.view(), entry_start_.view());
  device_.parallel_for("self contacts/entries", launched(contacts, corners_.size()),
                       EnterContacts{list(), entry_start_.view(), entry_count_.view(), entries_.view()});
}

template <class D>
void SelfContacts<D>::project(pbd::Substep<D>& substep, int) {
  using namespace self_contact_kernels;
  if (idle()) return;
  const pbd::ParticleView& p = substep.particles;
  const View<Vec4> position = vertices_of(p.position, p.sorted, vertices_);
  device_.parallel_for(
      "self contacts/push", launched(contacts, corners_.size()),
      PushApart{list(), position, vertices_of(p.previous, p.sorted, vertices_), entry_start_.view()});
  device_.parallel_for("self contacts/move", vertices_,
                       MoveVertices{list(), entry_start_.view(), entries_.view(), position,
                                    vertices_of(p.moved, p.sorted, vertices_), unit_});
}

template <class D>
void SelfContacts<D>::settle(pbd::Substep<D>& substep) {
  using namespace self_contact_kernels;
  if (idle()) return;
  const pbd::ParticleView& p = substep.particles;
  const View<const Vec4> previous = vertices_of(p.previous, p.sorted, vertices_);
  const View<Vec4> position = vertices_of(p.position, p.sorted, vertices_);
  const View<Vec4> moved = vertices_of(p.moved, p.sorted, vertices_);
  device_.parallel_for("self contacts/contain", vertices_,
                       Contain{previous, foreseen_.view(), position, moved, strayed_.view()});
  const uint32_t count = launched(contacts, corners_.size());
  for (uint32_t round = 0; round < rounds_; ++round) {
    device_.parallel_for("self contacts/flags", groups_,
                         FlagGroups{tree_.view(), parts_.view(), foreseen_.view(), position, cones_.view(),
                                    squeezed_.view(), counters_.view(), flags_.view(), round});
    device_.parallel_for("self contacts/crossings", count + tree_.places(),
                         FindCrossings{{cloth(substep), true},
                                       list(),
                                       position,
                                       flags_.view(),
                                       limit_.view(),
                                       count,
                                       round,
                                       least_distance_});
    device_.parallel_for("self contacts/hold back", vertices_,
                         HoldBack{previous, position, moved, limit_.view(), counters_.view(), round});
  }
  device_.parallel_for("self contacts/found", counter_count, NoteCounters{counters_.view(), found_.view()});
}

// ---- room ----

/// How many rounds found something to hold back.
template <class D>
uint32_t SelfContacts<D>::used_rounds() const {
  uint32_t used = 0;
  for (uint32_t k = 0; k < rounds_; ++k) used = found(self_contact_kernels::crossings + k) > 0 ? k + 1 : used;
  return used;
}

template <class D>
void SelfContacts<D>::start_step() {
  using namespace self_contact_kernels;
  // Where the last step's rounds did not suffice it gets more; those that it had no use for go.
  if (!idle()) rounds_ = ran_short() ? more_rounds() : std::max(first_rounds, used_rounds() + 1);
  std::fill(found_.host().begin(), found_.host().end(), 0u);
}

template <class D>
bool SelfContacts<D>::had_room() {
  using namespace self_contact_kernels;
  return idle() || ((!ran_short() || rounds_ == most_rounds) && found(longest_row) <= row_capacity_ &&
                    found(candidates) <= candidates_.size() && found(contacts) <= corners_.size());
}

template <class D>
void SelfContacts<D>::make_room() {
  using namespace self_contact_kernels;
  const auto more = [](uint32_t found) { return found + found / 4; };
  if (found(longest_row) > row_capacity_) reserve_rows(more(found(longest_row)));
  if (found(candidates) > candidates_.size()) candidates_.resize_or_stay(more(found(candidates)));
  if (found(contacts) > corners_.size()) reserve_contacts(more(found(contacts)));
  // start_step() makes more rounds.
}

template <class D>
void SelfContacts<D>::reserve_rows(uint32_t capacity) {
  rows_.resize_or_stay(size_t{groups_} * capacity);
  row_capacity_ = capacity;
}

template <class D>
void SelfContacts<D>::reserve_contacts(uint32_t capacity) {
  plane_.resize_discard(capacity);
  multiplier_.resize_discard(capacity);
  push_.resize_discard(capacity);
  weights_.resize_discard(capacity);
  entries_.resize_discard(4 * size_t{capacity});
  corners_.resize_discard(capacity);  // last: its length is what counts
}

// ---- state ----

template <class D>
void SelfContacts<D>::set_surface(std::span<const pbd::SurfaceTriangle> triangles, std::span<const Vec3> rest,
                                  pbd::View<const Vec3> device_rest, std::span<const ContactPart> parts,
                                  float heaviest) {
  if (!any_meet(parts)) triangles = {};
  tree_.set_surface(triangles, rest);
  const SelfContactTables tables = build_tables(tree_.triangles(), rest, parts.size());
  const auto upload = [](auto& buffer, const auto& values) {
    buffer.resize_discard(values.size());
    buffer.write(values);
  };
  upload(features_, tables.features);
  upload(vertex_part_, tables.vertex_part);
  upload(neighbour_start_, tables.neighbour_start);
  upload(neighbours_, tables.neighbours);
  set_parts(parts, tables.fineness);
  rest_ = device_rest;
  vertices_ = static_cast<uint32_t>(rest.size());
  groups_ = tree_.places() / 8;
  // A vertex can take some 2¹³ m times the greatest mass, in steps far below a float's.
  unit_ = std::ldexp(1.0f, std::ilogb(heaviest) - 49);

  cones_.resize_discard(groups_);
  flags_.resize_discard(groups_);
  rough_.resize_discard(groups_);
  squeezed_.resize_discard(groups_);
  row_count_.resize_discard(groups_);
  foreseen_.resize_discard(vertices_);
  limit_.resize_discard(vertices_);
  strayed_.resize_discard(vertices_);
  saved_strayed_.resize_discard(vertices_);
  entry_count_.resize_discard(vertices_);
  entry_start_.resize_discard(vertices_ + 1);
  counters_.resize_discard(self_contact_kernels::counter_count);
  found_.resize_discard(self_contact_kernels::counter_count);
  start_step();
  strayed_.fill(0);
  reserve_rows(std::max(row_capacity_, 8u));
  const uint32_t least = std::max(256u, vertices_ / 4);
  if (candidates_.size() < least) candidates_.resize_discard(least);
  if (corners_.size() < least) reserve_contacts(least);
}

/// Whether any part collides with itself or with another.
template <class D>
bool SelfContacts<D>::any_meet(std::span<const ContactPart> parts) {
  for (size_t k = 0; k < parts.size(); ++k) {
    if (parts[k].self) return true;
    for (size_t n = 0; n < k; ++n) {
      if (pbd::meet(parts[k].filter, parts[n].filter)) return true;
    }
  }
  return false;
}

template <class D>
void SelfContacts<D>::set_parts(std::span<const ContactPart> parts, std::span<const float> fineness) {
  std::vector<self_contact_kernels::Part> rows;
  least_distance_ = 1e30f;
  for (size_t k = 0; k < parts.size(); ++k) {
    const ContactPart& p = parts[k];
    // MakeContacts leaves out only what is foreseen further apart than twice this, all the way.
    const float tolerance = 0.2f * std::min(p.thickness, fineness[k]);
    least_distance_ = std::min(least_distance_, 0.1f * tolerance);
    rows.push_back({p.thickness, p.friction, p.filter.groups, p.filter.mask, p.self, tolerance});
  }
  parts_.resize_discard(rows.size());
  parts_.write(rows);
}

template <class D>
void SelfContacts<D>::save() {
  if (!idle()) device_.copy(saved_strayed_.view().data, strayed_.view().data, vertices_ * sizeof(float));
}

template <class D>
void SelfContacts<D>::restore() {
  if (!idle()) device_.copy(strayed_.view().data, saved_strayed_.view().data, vertices_ * sizeof(float));
}

template <class D>
self_contact_kernels::ClothState SelfContacts<D>::cloth(const pbd::Substep<D>& substep) {
  using namespace self_contact_kernels;
  return {vertices_of(substep.particles.previous, substep.particles.sorted, vertices_),
          foreseen_.view(),
          tree_.view(),
          features_.view(),
          parts_.view(),
          rough_.view(),
          rows_.view(),
          row_count_.view(),
          row_capacity_};
}

template <class D>
self_contact_kernels::ContactList SelfContacts<D>::list() {
  return {corners_.view(), plane_.view(),   multiplier_.view(),
          push_.view(),    weights_.view(), counters_.view()};
}

/// How many of a list kernels are to look at: all that there is room for, or, where the host is in step with
/// the device, all that there are.
template <class D>
uint32_t SelfContacts<D>::launched(uint32_t counter, size_t capacity) {
  const auto most = static_cast<uint32_t>(capacity);
  return device_.kind() == pbd::DeviceKind::cpu ? std::min(counters_.view()[counter], most) : most;
}

}  // namespace meniscus::cloth
