// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// RodSet: buffers, and the launches of a substep.
#pragma once

#include <algorithm>

#include "cloth/rods/rod_set.h"

namespace meniscus::cloth {

template <class D>
void RodSet<D>::set_model(const RodModel& model) {
  const uint32_t count = model.segment_count(), kept = std::min(segments_, count);
  const auto chains = static_cast<uint32_t>(model.chains.size());
  segments_ = kept;  // until all have their state: memory may run out before
  chain_.resize_discard(chains);
  chain_.write(model.chains);
  segment_.resize_discard(count);
  segment_.write(model.segments);
  for (pbd::Buffer<pbd::Vec4>* b : {&frame_, &spin_, &torque_}) b->resize_keep(count, kept);
  for (pbd::Buffer<pbd::Vec4>* b : {&previous_, &saved_frame_, &saved_spin_}) b->resize_discard(count);
  start_.resize_discard(count);
  multiplier_.resize_discard(count);
  pull_.resize_keep(count, kept);
  saved_pull_.resize_discard(count);
  link_.resize_discard(count);
  row_.resize_discard(2 * size_t{count});
  row_.fill(0);  // blocks beyond a rod's end stay 0

  std::vector<SegmentState> added;
  for (uint32_t k = kept; k < count; ++k) added.push_back({model.frames[k], {0, 0, 0}, false});
  set_states(kept, added);
  const std::vector<pbd::Vec4> none(added.size());
  torque_.write(none, kept);
  pull_.write(std::vector<float>(added.size()), kept);
  segments_ = count;
  chains_ = chains;
}

template <class D>
std::vector<SegmentState> RodSet<D>::states(uint32_t first, uint32_t count) const {
  std::vector<pbd::Vec4> frames(count), spins(count);
  frame_.read(std::span(frames), first);
  spin_.read(std::span(spins), first);
  std::vector<SegmentState> states;
  for (uint32_t k = 0; k < count; ++k)
    states.push_back({rod_kernels::quat(frames[k]), spins[k].xyz(), spins[k].w == 0});
  return states;
}

template <class D>
void RodSet<D>::set_states(uint32_t first, std::span<const SegmentState> states) {
  std::vector<pbd::Vec4> frames, spins;
  for (const SegmentState& s : states) {
    frames.push_back(rod_kernels::vec4(normalized(s.frame)));
    spins.push_back(pbd::with_w(s.spin, s.held ? 0 : 1));
  }
  frame_.write(frames, first);
  previous_.write(frames, first);
  spin_.write(spins, first);
}

template <class D>
void RodSet<D>::stop() {
  device_.parallel_for("rods/stop", segments_,
                       rod_kernels::Stop{frame_.view(), previous_.view(), spin_.view()});
}

template <class D>
std::vector<Vec3> RodSet<D>::torques(uint32_t first, uint32_t count) const {
  std::vector<pbd::Vec4> turned(count);
  torque_.read(std::span(turned), first);
  std::vector<Vec3> torques;
  for (const pbd::Vec4& t : turned) torques.push_back(dt_ > 0 ? t.xyz() / (dt_ * dt_) : Vec3{0, 0, 0});
  return torques;
}

template <class D>
void RodSet<D>::predict(float dt) {
  device_.parallel_for("rods/predict", segments_,
                       rod_kernels::Advance{frame_.view(), previous_.view(), spin_.view(), dt});
}

template <class D>
void RodSet<D>::begin(pbd::Substep<D>& substep) {
  dt_ = substep.dt;
  device_.parallel_for("rods/begin", segments_, rod_kernels::Begin{view(substep)});
}

template <class D>
void RodSet<D>::project(pbd::Substep<D>& substep, int iteration) {
  const rod_kernels::RodView rods = view(substep);
  device_.parallel_for("rods/linearize", segments_, rod_kernels::Linearize{rods});
  device_.parallel_for("rods/solve", chains_, rod_kernels::Solve{chain_.view(), row_.view(), iteration});
  device_.parallel_for("rods/apply", segments_, rod_kernels::Apply{rods});
}

template <class D>
void RodSet<D>::end(pbd::Substep<D>& substep) {
  device_.parallel_for(
      "rods/spin", segments_,
      rod_kernels::UpdateSpin{frame_.view(), previous_.view(), spin_.view(), 1 / substep.dt});
}

template <class D>
void RodSet<D>::save() {
  if (!segments_) return;
  device_.copy(saved_frame_.view().data, frame_.view().data, segments_ * sizeof(pbd::Vec4));
  device_.copy(saved_spin_.view().data, spin_.view().data, segments_ * sizeof(pbd::Vec4));
  device_.copy(saved_pull_.view().data, pull_.view().data, segments_ * sizeof(float));
}

template <class D>
void RodSet<D>::restore() {
  if (!segments_) return;
  device_.copy(frame_.view().data, saved_frame_.view().data, segments_ * sizeof(pbd::Vec4));
  device_.copy(spin_.view().data, saved_spin_.view().data, segments_ * sizeof(pbd::Vec4));
  device_.copy(pull_.view().data, saved_pull_.view().data, segments_ * sizeof(float));
  row_.fill(0);  // a step that failed has left values in them that are not finite
}

template <class D>
void RodSet<D>::visit_state(pbd::StateVisitor& v) {
  v.value("dt", dt_);
  v.array("frame", frame_.view(), segments_);
  v.array("spin", spin_.view(), segments_);
  v.array("pull", pull_.view(), segments_);
  v.array("torque", torque_.view(), segments_);
  if (v.restores()) row_.fill(0);  // as in restore()
}

template <class D>
rod_kernels::RodView RodSet<D>::view(const pbd::Substep<D>& substep) {
  return {substep.particles,  segment_.view(), frame_.view(), previous_.view(), spin_.view(), start_.view(),
          multiplier_.view(), link_.view(),    row_.view(),   torque_.view(),   pull_.view(), substep.dt};
}

}  // namespace meniscus::cloth
