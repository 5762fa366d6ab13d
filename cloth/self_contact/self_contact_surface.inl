// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// SelfContacts: takes a surface, with the tables and the room that follow from it.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "cloth/self_contact/self_contacts.h"
#include "cloth/self_contact/tables.h"
#include "cloth/self_contact/tuning.h"
#include "pbd/filter.h"
#include "pbd/repeated.h"

namespace meniscus::cloth {

template <class D>
void SelfContacts<D>::set_surface(std::span<const pbd::SurfaceTriangle> triangles, std::span<const Vec3> rest,
                                  pbd::View<const Vec3> device_rest, std::span<const ContactPiece> pieces,
                                  float heaviest, uint32_t worlds) {
  learn();
  if (!any_meet(pieces)) triangles = {};
  const bool forgets = idle() || worlds != worlds_;
  worlds_ = worlds;
  of_world_.vertices = static_cast<uint32_t>(rest.size());
  of_world_.pieces = static_cast<uint32_t>(pieces.size());
  tree_.set_surface(triangles, rest, {worlds, of_world_.vertices, of_world_.pieces});
  of_world_.groups = tree_.places() / 8;
  const SelfContactTables tables =
      of_worlds(build_tables(tree_.triangles(), rest, pieces.size()), of_world_.pieces, worlds);
  const auto upload = [](auto& buffer, const auto& values) {
    buffer.resize_discard(values.size());
    buffer.write(values);
  };
  upload(features_, tables.features);
  upload(vertex_piece_, tables.vertex_piece);
  upload(neighbour_start_, tables.neighbour_start);
  upload(neighbours_, tables.neighbours);
  set_pieces(pieces, tables.fineness);
  rest_ = device_rest;
  vertices_ = worlds * of_world_.vertices;
  groups_ = worlds * of_world_.groups;
  // The integer sums hold displacements up to about 2¹³ m of the heaviest vertex, in units far below a
  // float's precision.
  unit_ = std::ldexp(1.0f, std::ilogb(heaviest > 0 ? heaviest : 1.0f) - 49);

  cones_.resize_discard(groups_);
  for (pbd::Buffer<uint32_t>* buffer : {&rough_, &smooth_, &fold_state_, &fold_noted_, &fold_list_})
    buffer->resize_discard(groups_);
  kept_.resize_discard(vertices_);
  wide_.resize_discard(vertices_);
  foreseen_.resize_discard(vertices_);
  for (pbd::Buffer<uint32_t>* buffer : {&impact_zone_label_, &impact_zone_mark_, &impact_zone_anchor_})
    buffer->resize_discard(vertices_);
  solved_.resize_discard(vertices_);
  safe_fraction_.resize_discard(vertices_);
  impact_zone_mark_.fill(0);
  impact_zone_mass_.resize_discard(vertices_);
  impact_zone_mass_.fill(0);
  strayed_.resize_discard(vertices_);
  saved_strayed_.resize_discard(vertices_);
  entries_.resize_discard(vertices_);
  push_sums_.resize_discard(3 * size_t{vertices_});
  push_sums_.fill(0);
  counters_.resize_discard(worlds * self_contact_kernels::counter_count);
  counters_.fill(0);
  found_by_world_.resize_discard(counters_.size());
  most_found_.resize_discard(worlds > 1 ? counters_.size() / worlds : 0);
  for (pbd::Buffer<uint32_t>* found : {&found_by_world_, &most_found_}) found->fill(0);
  for (pbd::Buffer<uint8_t>* flags : {&lasts_one_substep_, &one_frame_}) {
    flags->resize_discard(worlds);
    if (forgets) flags->fill(0);
  }
  if (found_.host().empty()) {
    found_.resize_discard(self_contact_kernels::counter_count);
    std::fill(found_.host().begin(), found_.host().end(),
              0u);  // a step starts by reading those of the last step
  }
  forget_found();
  strayed_.fill(0);
  if (group_pairs_.size() < 2 * size_t{groups_}) group_pairs_.resize_discard(2 * size_t{groups_});
  const uint32_t least_candidates = worlds * std::max(256u, of_world_.vertices / 4);
  if (candidates_.size() < least_candidates) candidates_.resize_discard(least_candidates);
  const uint32_t least_contacts = worlds * std::max(256u, of_world_.vertices / 16);
  if (corners_.size() < least_contacts) reserve_contacts(least_contacts);
}

/// Whether any piece collides with itself or with another.
template <class D>
bool SelfContacts<D>::any_meet(std::span<const ContactPiece> pieces) {
  for (size_t k = 0; k < pieces.size(); ++k) {
    if (pieces[k].self) return true;
    for (size_t n = 0; n < k; ++n) {
      if (pbd::meet(pieces[k].filter, pieces[n].filter)) return true;
    }
  }
  return false;
}

template <class D>
void SelfContacts<D>::set_pieces(std::span<const ContactPiece> pieces, std::span<const float> fineness) {
  std::vector<self_contact_kernels::PieceProperties> rows;
  least_distance_ = 1e30f;
  for (size_t k = 0; k < pieces.size(); ++k) {
    const ContactPiece& p = pieces[k];
    const float least = std::min(p.thickness, fineness[k]);
    least_distance_ = std::min(least_distance_, self_contact_tuning::least_distance * least);
    rows.push_back({p.thickness, p.friction, p.filter.groups, p.filter.mask, p.self,
                    self_contact_tuning::nearness * least});
  }
  pbd::write_repeated(pieces_, std::span<const self_contact_kernels::PieceProperties>(rows), worlds_);
  set_frames(rows.size());
  piece_sums_.resize_discard(4 * pieces_.size());
}

template <class D>
void SelfContacts<D>::set_frames(size_t pieces) {
  of_world_.frames = static_cast<uint32_t>(std::min<size_t>(pieces, self_contact_tuning::most_frames));
  frames_.resize_discard(worlds_ * of_world_.frames);
  frame_of_.resize_discard(worlds_ * pieces);
  cell_of_.resize_discard(worlds_ * pieces);
  const size_t rows = frame_of_.size() + frames_.size();
  displacement_sums_.resize_discard(4 * rows);
  immovable_.resize_discard(6 * rows);
  movable_.resize_discard(6 * rows);
  for (pbd::Buffer<uint32_t>* buffer : {&frame_of_, &cell_of_, &immovable_, &movable_}) buffer->fill(0);
  frames_.fill(0);
  displacement_sums_.fill(0);
  tree_.reserve_before(of_world_.frames > 1);
}

}  // namespace meniscus::cloth
