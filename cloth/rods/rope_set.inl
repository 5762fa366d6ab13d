// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// RopeSet: buffers, and the launches of a substep.
#pragma once

#include <algorithm>

#include "cloth/rods/rope_set.h"

namespace meniscus::cloth {

template <class D>
void RopeSet<D>::set_model(const RodModel& model) {
  const uint32_t count = model.segment_count(), kept = std::min(segments_, count);
  const auto chains = static_cast<uint32_t>(model.chains.size());
  segments_ = kept;  // until all have their state: memory may run out before
  chain_.resize_discard(chains);
  chain_.write(model.chains);
  segment_.resize_discard(count);
  segment_.write(model.segments);
  start_.resize_discard(count);
  multiplier_.resize_discard(count);
  pull_.resize_keep(count, kept);
  pull_.write(std::vector<float>(count - kept), kept);
  saved_pull_.resize_discard(count);
  row_.resize_discard(count);
  segments_ = count;
  chains_ = chains;
}

template <class D>
std::vector<float> RopeSet<D>::tensions(uint32_t first, uint32_t count) const {
  std::vector<float> tensions(count);
  pull_.read(std::span(tensions), first);
  for (float& t : tensions) t = dt_ > 0 ? t / (dt_ * dt_) : 0;
  return tensions;
}

template <class D>
void RopeSet<D>::begin(pbd::Substep<D>& substep) {
  dt_ = substep.dt;
  device_.parallel_for("ropes/begin", segments_, rope_kernels::Begin{view(substep)});
}

template <class D>
void RopeSet<D>::project(pbd::Substep<D>& substep, int iteration) {
  const rope_kernels::RopeView ropes = view(substep);
  device_.parallel_for("ropes/linearize", segments_, rope_kernels::Linearize{ropes});
  device_.parallel_for("ropes/solve", chains_, rope_kernels::Solve{chain_.view(), row_.view(), iteration});
  device_.parallel_for("ropes/apply", segments_, rope_kernels::Apply{ropes});
}

template <class D>
void RopeSet<D>::save() {
  if (segments_) device_.copy(saved_pull_.view().data, pull_.view().data, segments_ * sizeof(float));
}

template <class D>
void RopeSet<D>::restore() {
  if (segments_) device_.copy(pull_.view().data, saved_pull_.view().data, segments_ * sizeof(float));
}

template <class D>
rope_kernels::RopeView RopeSet<D>::view(const pbd::Substep<D>& substep) {
  return {substep.particles, segment_.view(), start_.view(), multiplier_.view(),
          pull_.view(),      row_.view(),     substep.dt};
}

}  // namespace meniscus::cloth
