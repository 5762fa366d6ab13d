// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Particles that wait on the host until ranks share the world, of which each takes its own.
#pragma once

#include <algorithm>

#include "sdk/engine/engine.inl"

namespace meniscus {

template <class D>
void DeviceEngine<D>::hold(const ParticleBatch& batch) {
  device_.monitor().commit();
  const auto add = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
  add(held_->position, batch.position);
  add(held_->velocity, batch.velocity);
  add(held_->phase, batch.phase);
  held_->by_hand |= batch.by_hand;
  held_->may_crowd |= batch.may_crowd;
}

template <class D>
void DeviceEngine<D>::keep_held(const std::vector<bool>& keep) {
  const auto filter = [&](auto& values) {
    std::size_t kept = 0;
    for (std::size_t k = 0; k < values.size(); ++k) {
      if (keep[k]) values[kept++] = values[k];
    }
    values.resize(kept);
  };
  filter(held_->position);
  filter(held_->velocity);
  filter(held_->phase);
}

template <class D>
void DeviceEngine<D>::copy_held(std::span<Vec3> out) const {
  std::transform(held_->position.begin(), held_->position.end(), out.begin(),
                 [](const pbd::Vec4& p) { return p.xyz(); });
}

template <class D>
void DeviceEngine<D>::release() {
  std::optional<ParticleBatch> held;
  held.swap(held_);
  if (!held) return;
  try {
    append(*held);
  } catch (...) {
    held_.swap(held);
    throw;
  }
}

/// Slots and numbers are those of a world alone.
template <class D>
void DeviceEngine<D>::share_held(pbd::Ranks& ranks, const pbd::CutPolicy& policy) {
  solver_.cut(ranks, policy, held_->position);
  const auto count = static_cast<uint32_t>(held_->position.size());
  const std::vector<uint32_t> numbers = particles_.take_numbers(count);
  ParticleBatch own;
  std::vector<uint32_t> own_slots, own_numbers;
  for (uint32_t k = 0; k < count; ++k) {
    jets_.hold_for(pbd::held_steps(held_->phase[k]));
    if (!solver_.may_need(held_->position[k].xyz())) continue;
    own.position.push_back(held_->position[k]);
    own.velocity.push_back(held_->velocity[k]);
    own.phase.push_back(held_->phase[k]);
    own_slots.push_back(k);
    own_numbers.push_back(numbers[k]);
  }
  any_overlapping_ |= held_->by_hand;
  held_.reset();
  const auto added = static_cast<uint32_t>(own_slots.size());
  reserve_more(added);
  if (added) particles_.append(own.position, own.velocity, own.phase, own_slots, own_numbers);
  solver_.particles_changed(0, added);
  solver_.keep_own();
}

}  // namespace meniscus
