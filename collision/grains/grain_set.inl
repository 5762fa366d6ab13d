// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Functions and tuned constants of GrainSet; its kernels are in grain_kernels.h.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "collision/grains/grain_kernels.h"
#include "collision/grains/grain_set.h"
#include "collision/grains/tuning.h"
#include "pbd/gather.h"

namespace meniscus::collision {

template <class D>
GrainSet<D>::GrainSet(D& device, float diameter, ContactSet<D>& contacts)
    : device_(device), diameter_(diameter), contacts_(contacts), chebyshev_(grain_tuning::spectral_bound) {}

template <class D>
void GrainSet<D>::set_materials(std::span<const GrainMaterial> materials) {
  std::vector<float> roughness;
  for (const GrainMaterial& m : materials) roughness.push_back(std::sqrt(m.friction));
  roughness_.resize_discard(roughness.size());
  roughness_.write(roughness);
  if (any_ || std::none_of(materials.begin(), materials.end(), [](auto& m) { return m.is_grain; })) return;
  reserve_arrays(0);
  any_ = true;
}

template <class D>
void GrainSet<D>::begin(pbd::Substep<D>& substep) {
  using namespace grain_tuning;
  if (!any_) return;
  const float ratio = last_dt_ > 0 ? substep.dt / last_dt_ : 0;
  last_dt_ = substep.dt;
  const pbd::ParticleView& p = substep.particles;
  device_.parallel_for("grains/find", p.sorted,
                       grain_kernels::FindTouching{
                           .position = p.position,
                           .previous = p.previous,
                           .phase = p.phase,
                           .neighbours = substep.neighbours,
                           .roughness = roughness_.view(),
                           .diameter = diameter_,
                           .reach = reach * diameter_,
                           .recovery = std::fmin(most_recovery, recovery_rate * substep.dt),
                           .last = current_rows(),
                           .origin = origin_.current(),
                           .fraction = warm_start * std::fmin(1.0f, ratio * ratio),
                           .rows = next_rows(),
                           .change = change_.view(),
                           .next_origin = origin_.next(),
                           .pressing = pressing_.view(),
                           .longest = longest_.view(),
                       });
  partner_.flip();
  impulse_.flip();
  count_.flip();
  origin_.flip();
  device_.parallel_for("grains/found", 1, grain_kernels::NoteLongest{longest_.view(), found_.view()});
}

template <class D>
void GrainSet<D>::project(pbd::Substep<D>& substep, int iteration) {
  using namespace grain_kernels;
  if (!any_) return;
  const pbd::ParticleView& p = substep.particles;
  if (iteration == 0) {
    device_.parallel_for("grains/start", p.sorted, Start{current_rows(), p.position, p.accumulated_delta});
    // Solids react to the impulses that grains start with. Otherwise the lowest layer would have no support
    // and sink.
    pbd::Substep<D> grains = substep;  // vertices and points of faces are projected elsewhere
    grains.contacts = substep.contacts.of_first(p.sorted);
    contacts_.project(grains, iteration);
  }
  device_.parallel_for("grains/stage", p.sorted,
                       Stage{current_rows(), change_.view(), p.position, pressing_.view(), staged_.view()});
  const pbd::IterationWeights weights = chebyshev_.next(iteration, substep.iterations);
  device_.parallel_for("grains/project", p.sorted,
                       Project{.rows = current_rows(),
                               .change = change_.view(),
                               .staged = staged_.view(),
                               .previous = p.previous,
                               .position = p.position,
                               .accumulated_delta = p.accumulated_delta,
                               .momentum = weights.momentum,
                               .step = weights.step});
}

// ---- arrays that follow the particles ----

template <class D>
GrainRows GrainSet<D>::current_rows() {
  return {partner_.current(), impulse_.current(), count_.current(), row_capacity_, block};
}

template <class D>
GrainRows GrainSet<D>::next_rows() {
  return {partner_.next(), impulse_.next(), count_.next(), row_capacity_, block};
}

template <class D>
void GrainSet<D>::reserve(uint32_t capacity, uint32_t) {
  // Rows are indexed by the particles' order in the last substep. A particle that stays may have had an index
  // at or beyond the present count, so all rows up to the capacity are kept.
  const uint32_t rows = std::min(capacity_, capacity);
  capacity_ = capacity;
  if (any_) reserve_arrays(rows);
}

/// Allocates only if there may be grains. The first `kept` rows stay.
template <class D>
void GrainSet<D>::reserve_arrays(uint32_t kept) {
  reserve_rows(kept);
  count_.reserve(capacity_, kept);
  origin_.reserve(capacity_, kept);
  staged_.resize_discard(capacity_);
  pressing_.resize_discard(capacity_);
  if (longest_.size() == 0) {
    longest_.resize_discard(1);
    longest_.fill(0);
    found_.resize_discard(1);
    found_.host()[0] = 0;
  }
  const uint32_t more = capacity_ - kept;
  if (more == 0) return;
  device_.fill(count_.current().data + kept, 0, more * sizeof(uint32_t));
  device_.fill(origin_.current().data + kept, 0xff, more * sizeof(uint32_t));
}

template <class D>
void GrainSet<D>::reserve_rows(uint32_t kept) {
  const size_t elements = row_elements(capacity_, row_capacity_, block);
  const size_t kept_elements = row_elements(kept, row_capacity_, block);
  partner_.reserve(elements, kept_elements);
  impulse_.reserve(elements, kept_elements);
  change_.resize_discard(elements);
}

/// New particles have touched nothing and have no rows. The rows at their indices may belong to other
/// particles.
template <class D>
void GrainSet<D>::clear(uint32_t first, uint32_t count) {
  if (any_ && count > 0) device_.fill(origin_.current().data + first, 0xff, count * sizeof(uint32_t));
}

template <class D>
void GrainSet<D>::reorder(pbd::View<const uint32_t> order, uint32_t count) {
  if (!any_) return;
  device_.parallel_for("grains/reorder", count,
                       pbd::GatherInOrder<uint32_t>{origin_.current(), order, origin_.next()});
  origin_.flip();
}

template <class D>
void GrainSet<D>::make_room() {
  lengthen_rows((longest_row() + 3) / 4 * 4);
}

/// The impulses stay. So a world of a batch does not notice that another has longer rows.
template <class D>
void GrainSet<D>::lengthen_rows(uint32_t capacity) {
  pbd::Buffer<uint32_t> partner(device_, "grain contacts");
  pbd::Buffer<pbd::Vec4> impulse(device_, "grain contact impulses");
  const auto set_aside = [&]<class T>(pbd::Buffer<T>& aside, pbd::View<T> from) {
    aside.resize_discard(from.count);
    device_.copy(aside.view().data, from.data, size_t{from.count} * sizeof(T));
  };
  set_aside(partner, partner_.current());
  set_aside(impulse, impulse_.current());
  const uint32_t before = std::exchange(row_capacity_, capacity);
  const auto take_up = [&] {
    const GrainRows aside{partner.view(), impulse.view(), count_.current(), before, block};
    device_.parallel_for("grains/lengthen", capacity_, grain_kernels::CopyRows{aside, current_rows()});
    device_.wait();
  };
  try {
    reserve_rows(0);
  } catch (...) {
    row_capacity_ = before;
    reserve_rows(0);
    take_up();
    throw;
  }
  take_up();
}

/// Rows that another kind of device has stored in another order are not used, and the next solve starts
/// without impulses.
template <class D>
void GrainSet<D>::visit_state(pbd::StateVisitor& v) {
  uint32_t rows = any_ ? capacity_ : 0, row_capacity = row_capacity_, in_blocks_of = block;
  v.value("last_dt", last_dt_);
  v.value("rows", rows);
  v.value("row_capacity", row_capacity);
  v.value("block", in_blocks_of);
  if (v.restores() && any_) {
    row_capacity_ = row_capacity;
    reserve_arrays(0);
  }
  if (rows == 0) return;
  if (in_blocks_of != block) {
    std::vector<uint32_t> unused;
    std::vector<pbd::Vec4> unused_impulse;
    v.list("impulse", unused_impulse);
    for (const char* name : {"partner", "contacts", "origin"}) v.list(name, unused);
    return;
  }
  const size_t elements = row_elements(rows, row_capacity_, block);
  v.array("partner", partner_.current(), elements);
  v.array("impulse", impulse_.current(), elements);
  v.array("contacts", count_.current(), rows);
  v.array("origin", origin_.current(), rows);
}

template <class D>
void GrainSet<D>::save() {
  saved_dt_ = last_dt_;
  partner_.save();
  impulse_.save();
  count_.save();
  origin_.save();
}

template <class D>
void GrainSet<D>::restore() {
  last_dt_ = saved_dt_;
  partner_.restore();
  impulse_.restore();
  count_.restore();
  origin_.restore();
}

}  // namespace meniscus::collision

#include "collision/grains/grain_worlds.inl"
