// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <numeric>

#include "sdk/engine/engine.inl"

namespace meniscus {

template <class D>
void DeviceEngine<D>::reserve(uint32_t fluid, uint32_t vertices) {
  const uint32_t capacity = fluid + vertices;
  fetch_contacts();
  solver_.reserve(fluid, vertices);
  fluid_capacity_ = fluid;
  vertex_capacity_ = vertices;
  removal_.reserve(capacity);
  vector_out_.resize_discard(capacity);
  scalar_out_.resize_discard(capacity);
  full_out_.resize_discard(capacity);
  index_out_.resize_discard(capacity);
  state_sum_.resize_discard(1);
  count_out_.resize_discard(1);
}

template <class D>
void DeviceEngine<D>::append(const ParticleBatch& batch) {
  const uint32_t first = particles_.sorted();
  const auto added = static_cast<uint32_t>(batch.position.size());
  if (added == 0) return;
  const uint32_t needed = first + added;
  // A first fill gets what it asks for; later ones leave room for more, so that an emitter does not
  // reallocate often.
  if (needed > fluid_capacity_) reserve(first == 0 ? needed : needed + needed / 4, vertex_capacity_);
  std::vector<uint32_t> slot(added);
  std::iota(slot.begin(), slot.end(), first);
  particles_.append(batch.position, batch.velocity, batch.phase, slot);
  solver_.particles_changed(first, added);
}

template <class D>
void DeviceEngine<D>::keep(const std::vector<bool>& keep) {
  const std::vector<uint32_t> by_slot(keep.begin(), keep.end());
  removal_.keep_by_slot(particles_, by_slot);
  remove_marked(removal_.count_kept(particles_));
}

template <class D>
std::vector<uint32_t> DeviceEngine<D>::remove_marked(uint32_t kept) {
  fetch_contacts();  // while they fit the particles
  std::vector<uint32_t> by_slot = removal_.apply(
      particles_, kept,
      [&](pbd::View<const uint32_t> order, uint32_t count) { density_.reorder(order, count); });
  solver_.particles_changed(kept, 0);
  keep_contacts(by_slot);
  return by_slot;
}

/// Contacts of particles that stay go with them to their new slots.
template <class D>
void DeviceEngine<D>::keep_contacts(std::span<const uint32_t> stays) {
  std::vector<uint32_t> place(stays.size());
  std::exclusive_scan(stays.begin(), stays.end(), place.begin(), 0u);
  std::erase_if(fetched_contacts_, [&](const ContactReadout& c) { return stays[c.slot] == 0; });
  for (ContactReadout& c : fetched_contacts_) c.slot = place[c.slot];
}

template <class D>
std::vector<bool> DeviceEngine<D>::take_sinks() {
  if (sinks_.size() == 0 || particles_.sorted() == 0) return {};
  device_.parallel_for("sinks/mark", particles_.count(),
                       engine_kernels::MarkSinks{particles_.position.current.view(), sinks_.view(),
                                                 removal_.keep(), particles_.sorted()});
  const uint32_t kept = removal_.count_kept(particles_);
  if (kept == particles_.sorted()) return {};
  const std::vector<uint32_t> by_slot = remove_marked(kept);
  std::vector<bool> removed(by_slot.size());
  std::transform(by_slot.begin(), by_slot.end(), removed.begin(), [](uint32_t stays) { return stays == 0; });
  return removed;
}

template <class D>
EngineStep DeviceEngine<D>::step(float dt) {
  EngineStep done;
  fetched_contacts_.clear();  // after a step that fails there are none
  contacts_fetched_ = true;
  done.result = solver_.step(dt);
  if (done.result.summary.non_finite) return done;
  last_substep_ = dt / static_cast<float>(done.result.substeps);
  contacts_fetched_ = false;
  done.removed = take_sinks();
  done.stage_ms = solver_.timer().read_ms();
  done.rigid_ms = bodies_.step_ms();
  return done;
}

}  // namespace meniscus
