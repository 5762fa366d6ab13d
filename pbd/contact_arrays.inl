// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Counts the contacts of each particle, sums the counts to offsets, and fills the array.
#pragma once

#include "pbd/contact_arrays.h"

namespace meniscus::pbd {

namespace contact_array_kernels {

/// Lists the particles with contacts where the last source does not count all particles.
struct ListTouching {
  ContactCounter counter;

  MENISCUS_HD void operator()(uint32_t i) const { counter.add(i, 0); }
};

}  // namespace contact_array_kernels

template <class D>
void ContactArrays<D>::reserve(uint32_t capacity) {
  counts_.resize_discard(capacity + 2);
  counts_.fill(0);
  start_.resize_discard(capacity + 1);
  start_.fill(0);
  for (ContactSource<D>* source : sources_) source->reserve(capacity);
  if (contacts_.size() < first_room(capacity)) resize(first_room(capacity));
}

template <class D>
void ContactArrays<D>::resize(uint32_t contacts) {
  particle_.resize_or_stay(contacts);
  try {
    touching_.resize_or_stay(contacts);
    contacts_.resize_or_stay(contacts);
  } catch (...) {
    particle_.resize_discard(contacts_.size());
    touching_.resize_discard(contacts_.size());
    throw;
  }
  particle_.fill(0);
  touching_.fill(0);
  contacts_.fill(0);  // kernels load a contact together with the count that says whether it is one
}

template <class D>
void ContactArrays<D>::find(const Substep<D>& substep, View<SumNote> note) {
  counted_ = substep.particles.owned;
  any_ = std::any_of(sources_.begin(), sources_.end(), [](const auto* source) { return source->any(); });
  device_.fill(counts_.view().data, 0, (counted_ + 2) * sizeof(uint32_t));
  ContactCounter counter{counts_.view(), touching()};
  for (ContactSource<D>* source : sources_) {
    counter.lists = source == sources_.back() && source->counts_all();
    source->count(substep, counter);
  }
  if (any_ && !counter.lists) {
    counter.lists = true;
    device_.parallel_for("contacts/touching", counted_, contact_array_kernels::ListTouching{counter});
  }
  device_.exclusive_scan("contacts/offsets", View<const uint32_t>{counts_.view().data, counted_},
                         start_.view(), capacity(), note);
  const ContactWriter writer{start_.view().first(counted_ + 1), counts_.view(), contacts_.view(),
                             particle_.view(), touching()};
  for (ContactSource<D>* source : sources_) source->fill(substep, writer);
}

template <class D>
void ContactArrays<D>::part_neighbours(const Substep<D>& substep) {
  if (!any_) return;
  for (ContactSource<D>* source : sources_) source->part_neighbours(substep);
}

}  // namespace meniscus::pbd
