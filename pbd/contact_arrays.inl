// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "pbd/contact_arrays.h"

namespace meniscus::pbd {

namespace contact_kernels {

struct MarkTouched {
  View<const uint32_t> counts;
  View<uint32_t> touched;

  MENISCUS_HD void operator()(uint32_t i) const { touched[i] = counts[i] > 0; }
};

struct ListTouched {
  View<const uint32_t> start, place;
  View<uint32_t> particles;

  MENISCUS_HD void operator()(uint32_t i) const {
    if (start[i + 1] > start[i]) particles[place[i]] = i;
  }
};

}  // namespace contact_kernels

template <class D>
void ContactArrays<D>::reserve(uint32_t capacity) {
  counts_.resize_discard(capacity);
  start_.resize_discard(capacity + 1);
  start_.fill(0);
  touched_.resize_discard(capacity);
  particles_.resize_discard(capacity);
  place_.resize_discard(capacity + 1);
  if (contacts_.size() == 0) contacts_.resize_discard(std::max(1024u, capacity / 4));
}

template <class D>
void ContactArrays<D>::find_counts(const Substep<D>& substep) {
  counted_ = substep.particles.owned;
  device_.fill(counts_.view().data, 0, counted_ * sizeof(uint32_t));
  for (ContactSource<D>* source : sources_) source->count(substep, counts_.view());
  device_.exclusive_scan("contacts/offsets", counts_.view().first(counted_),
                         start_.view().first(counted_ + 1));
  device_.parallel_for("contacts/touched", counted_,
                       contact_kernels::MarkTouched{counts_.view(), touched_.view()});
  device_.exclusive_scan("contacts/places", touched_.view().first(counted_),
                         place_.view().first(counted_ + 1));
}

template <class D>
void ContactArrays<D>::fill(const Substep<D>& substep, uint32_t total, uint32_t total_particles) {
  if (total > contacts_.size()) contacts_.resize_discard(total + total / 4);
  count_ = total;
  particle_count_ = total_particles;
  device_.parallel_for("contacts/list", counted_,
                       contact_kernels::ListTouched{start_.view(), place_.view(), particles_.view()});
  device_.copy(counts_.view().data, start_.view().data, counted_ * sizeof(uint32_t));
  for (ContactSource<D>* source : sources_) source->fill(substep, counts_.view(), contacts_.view());
}

}  // namespace meniscus::pbd
