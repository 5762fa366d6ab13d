// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include "pbd/contact_arrays.h"

namespace meniscus::pbd {

template <class D>
void ContactArrays<D>::reserve(uint32_t capacity) {
  counts_.resize_discard(capacity + 2);
  counts_.fill(0);
  start_.resize_discard(capacity + 1);
  start_.fill(0);
  for (ContactSource<D>* source : sources_) source->reserve(capacity);
  if (contacts_.size() == 0) resize(std::max(1024u, capacity / 8));
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
}

template <class D>
void ContactArrays<D>::find(const Substep<D>& substep, View<SumNote> note) {
  counted_ = substep.particles.owned;
  any_ = std::any_of(sources_.begin(), sources_.end(), [](const auto* source) { return source->any(); });
  device_.fill(counts_.view().data, 0, (counted_ + 2) * sizeof(uint32_t));
  for (ContactSource<D>* source : sources_) source->count(substep, counts_.view());
  device_.exclusive_scan("contacts/offsets", View<const uint32_t>{counts_.view().data, counted_},
                         start_.view(), capacity(), note);
  const ContactWriter writer{start_.view(),    counts_.view(),   contacts_.view(),
                             particle_.view(), touching_.view(), touching_counts()};
  for (ContactSource<D>* source : sources_) source->fill(substep, writer);
}

template <class D>
void ContactArrays<D>::part_neighbours(const Substep<D>& substep) {
  if (!any_) return;
  for (ContactSource<D>* source : sources_) source->part_neighbours(substep);
}

}  // namespace meniscus::pbd
