// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// GrainSet in a batch: what worlds are reset to, and one world alone.
#pragma once

#include "collision/grains/grain_set.h"
#include "pbd/worlds.h"

namespace meniscus::collision {

namespace grain_kernels {

/// The rows of contacts, and by grain the row that it had in the last substep. Both are numbered world after
/// world.
struct GrainState {
  GrainRows rows;
  View<uint32_t> origin;

  /// Takes over row n and grain n of `from` as row and grain i. Numbers of rows change by i − n.
  MENISCUS_HD void take(uint32_t i, const GrainState& from, uint32_t n) const {
    const uint32_t row = from.origin[n], count = from.rows.count[n];
    origin[i] = row == pbd::no_index ? row : row + (i - n);
    rows.count[i] = pbd::min(count, rows.capacity);
    for (uint32_t k = 0; k < rows.count[i]; ++k) {
      const size_t at = rows.place(i, k), there = from.rows.place(n, k);
      rows.partner.data[at] = from.rows.partner.data[there] + (i - n);
      rows.impulse.data[at] = from.rows.impulse.data[there];
    }
  }
};

/// Replaces the grains of the chosen worlds by those of one world, or of as many.
struct WriteGrains {
  pbd::ChosenWorlds worlds;
  GrainState from, to;
  pbd::WorldsFrom kind;

  MENISCUS_HD void operator()(uint32_t i) const {
    if (worlds.has(i)) to.take(i, from, kind == pbd::WorldsFrom::one ? i % worlds.each : i);
  }
};

/// Notes by row which grain of a world has it. The world begins with grain `first`.
struct NotePlaces {
  View<const uint32_t> origin;
  View<uint32_t> place;
  uint32_t first;

  MENISCUS_HD void operator()(uint32_t i) const {
    const uint32_t row = origin[first + i];
    if (row != pbd::no_index) place[row] = i;
  }
};

/// Writes the rows of a world in the present order of its grains, with its partners by their present places.
/// Contacts with grains that are gone are left out.
struct PackGrains {
  GrainState from, to;
  View<const uint32_t> place;  ///< see NotePlaces; no_index: no grain has the row
  uint32_t first;

  MENISCUS_HD void operator()(uint32_t i) const {
    const uint32_t row = from.origin[first + i];
    const uint32_t all = row == pbd::no_index ? 0 : pbd::min(from.rows.count[row], from.rows.capacity);
    uint32_t count = 0;
    for (uint32_t k = 0; k < all; ++k) {
      const size_t there = from.rows.place(row, k);
      const uint32_t partner = place[from.rows.partner.data[there]];
      if (partner == pbd::no_index) continue;
      const size_t at = to.rows.place(i, count++);
      to.rows.partner.data[at] = partner;
      to.rows.impulse.data[at] = from.rows.impulse.data[there];
    }
    to.rows.count[i] = count;
    to.origin[i] = i;
  }
};

/// Replaces grains from one on by others.
struct CopyGrains {
  GrainState from, to;
  uint32_t from_first, to_first;

  MENISCUS_HD void operator()(uint32_t i) const { to.take(to_first + i, from, from_first + i); }
};

}  // namespace grain_kernels

template <class D>
grain_kernels::GrainState GrainSet<D>::current_state() {
  return {current_rows(), origin_.current()};
}

template <class D>
grain_kernels::GrainState GrainSet<D>::kept_state() {
  return {{kept_partner_.view(), kept_impulse_.view(), kept_count_.view(), kept_row_capacity_, block},
          kept_origin_.view()};
}

/// Rows are numbered as in the last substep. Particles may have been added or removed since.
template <class D>
void GrainSet<D>::pack_world(uint32_t first, uint32_t each, const grain_kernels::GrainState& to) {
  pbd::Buffer<uint32_t> place(device_, "grain places");
  place.resize_discard(capacity_);
  place.fill(0xff);
  const grain_kernels::GrainState from = current_state();
  device_.parallel_for("grains/places", each, grain_kernels::NotePlaces{from.origin, place.view(), first});
  device_.parallel_for("grains/pack", each, grain_kernels::PackGrains{from, to, place.view(), first});
  device_.wait();
}

/// Called while there is one world.
template <class D>
void GrainSet<D>::keep_world(uint32_t each) {
  if (!any_) return;
  kept_row_capacity_ = row_capacity_;
  const size_t elements = row_elements(each, row_capacity_, block);
  kept_partner_.resize_discard(elements);
  kept_impulse_.resize_discard(elements);
  kept_count_.resize_discard(each);
  kept_origin_.resize_discard(each);
  pack_world(0, each, kept_state());
}

template <class D>
void GrainSet<D>::reset_worlds(const pbd::ChosenWorlds& worlds) {
  if (!any_) return;
  device_.parallel_for(
      "grains/reset", worlds.count,
      grain_kernels::WriteGrains{worlds, kept_state(), current_state(), pbd::WorldsFrom::one});
}

template <class D>
void GrainSet<D>::undo_worlds(const pbd::ChosenWorlds& worlds) {
  if (!any_) return;
  const grain_kernels::GrainState saved{
      {partner_.saved(), impulse_.saved(), count_.saved(), row_capacity_, block}, origin_.saved()};
  device_.parallel_for("grains/undo", worlds.count,
                       grain_kernels::WriteGrains{worlds, saved, current_state(), pbd::WorldsFrom::all});
}

/// The rows follow one another in the order of the grains, as long as they are here.
template <class D>
void GrainSet<D>::visit_world(pbd::StateVisitor& v, uint32_t world, uint32_t each) {
  uint32_t capacity = any_ ? row_capacity_ : 0;
  v.value("row_capacity", capacity);
  if (capacity == 0) return;
  if (capacity > row_capacity_) lengthen_rows(capacity);
  pbd::Buffer<uint32_t> partner(device_, "grain contacts"), count(device_, "grain contact counts"),
      origin(device_, "grain origins");
  pbd::Buffer<pbd::Vec4> impulse(device_, "grain contact impulses");
  partner.resize_discard(size_t{each} * capacity);
  impulse.resize_discard(size_t{each} * capacity);
  count.resize_discard(each);
  origin.resize_discard(each);
  const grain_kernels::GrainState one{{partner.view(), impulse.view(), count.view(), capacity, 1},
                                      origin.view()};
  if (!v.restores()) {
    partner.fill(0);
    impulse.fill(0);
    pack_world(world * each, each, one);
  }
  v.array("partner", partner.view(), partner.size());
  v.array("impulse", impulse.view(), impulse.size());
  v.array("contacts", count.view(), each);
  v.array("origin", origin.view(), each);
  if (v.restores())
    device_.parallel_for("grains/put in", each,
                         grain_kernels::CopyGrains{one, current_state(), 0, world * each});
}

}  // namespace meniscus::collision
