// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Spray, foam and bubbles of a world that ranks share.
#pragma once

#include <algorithm>
#include <cstddef>

#include "fluid/diffuse/diffuse.h"
#include "fluid/diffuse/diffuse_kernels.h"

namespace meniscus::fluid {

template <class D>
void Diffuse<D>::share(const std::function<bool(Vec3)>& owns) {
  all_count_ = next_all_count_ = count_;
  std::vector<DiffuseParticle> own;
  std::vector<DiffuseKey> keys;
  const std::vector<DiffuseParticle> all = present_.read(count_);
  for (uint32_t k = 0; k < count_; ++k) {
    if (!owns(all[k].position)) continue;
    own.push_back(all[k]);
    keys.push_back({0, k, 0});
  }
  keys_.resize_discard(parameters_.def.capacity);
  next_keys_.resize_discard(parameters_.def.capacity);
  present_.write(own);
  keys_.write(keys);
  count_ = static_cast<uint32_t>(own.size());
  is_shared_ = true;
}

template <class D>
std::vector<typename Diffuse<D>::Own> Diffuse<D>::read_own() const {
  const std::vector<DiffuseParticle> particles = present_.read(count_);
  const std::vector<DiffuseKey> keys = keys_.read(count_);
  std::vector<Own> own(count_);
  for (uint32_t k = 0; k < count_; ++k) own[k] = {keys[k], particles[k]};
  return own;
}

template <class D>
void Diffuse<D>::set_gathered(std::span<const DiffuseParticle> particles) {
  gathered_.resize_discard(particles.size());
  gathered_.write(particles);
}

template <class D>
std::vector<pbd::WordArray> Diffuse<D>::carried() {
  static_assert(offsetof(DiffuseParticle, position) == 0);
  return {{reinterpret_cast<uint32_t*>(present_.view().data), sizeof(DiffuseParticle) / sizeof(uint32_t)},
          {reinterpret_cast<uint32_t*>(keys_.view().data), sizeof(DiffuseKey) / sizeof(uint32_t)}};
}

/// Particles go to the rank in whose region they are. Those that arrive stand behind the present ones, which
/// stay as they are until the step is accepted. Returns their number.
template <class D>
uint32_t Diffuse<D>::exchange_particles(const pbd::Substep<D>& s) {
  if (!is_shared()) return 0;
  pbd::refresh_ghosts(device_, s.ghosts, s.particles.velocity);
  const uint32_t arriving = s.ghosts.exchange->hand_over(s.grid, count_, carried());
  const uint32_t needed = count_ + arriving;
  if (needed > present_.size()) present_.resize_keep(needed, count_);
  if (needed > keys_.size()) keys_.resize_keep(needed, count_);
  if (needed > moved_.size()) {
    moved_.resize_discard(needed);
    alive_.resize_discard(needed);
    place_.resize_discard(size_t{needed} + 1);
  }
  s.ghosts.exchange->take_over(count_, carried());
  return arriving;
}

/// The capacity is that of all ranks.
template <class D>
void Diffuse<D>::agree_on_births(const pbd::Substep<D>& s) {
  uint32_t kept = 0, born = 0;
  device_.copy_out(&kept, place_.view().data + candidates_, sizeof kept);
  device_.copy_out(&born, birth_place_.view().data + s.particles.sorted, sizeof born);
  uint64_t all[2] = {kept, born};
  s.ghosts.exchange->add_up(all);
  const uint64_t room = parameters_.def.capacity - all[0], accepted = std::min(all[1], room);
  next_all_count_ = static_cast<uint32_t>(all[0] + accepted);
  next_refused_ = static_cast<uint32_t>(all[1] - accepted);
  if (accepted < all[1]) limit_births(s, room);
}

/// Leaves the first births by slot, as many as have room on all ranks together.
template <class D>
void Diffuse<D>::limit_births(const pbd::Substep<D>& s, uint64_t room) {
  std::vector<uint32_t> born = born_.read(s.particles.sorted), slots(born.size()), parents;
  device_.copy_out(slots.data(), s.particles.slot.data, slots.size() * sizeof(uint32_t));
  for (uint32_t k = 0; k < born.size(); ++k) {
    if (born[k] > 0) parents.push_back(k);
  }
  const auto born_below = [&](uint32_t end) {
    uint64_t count = 0;
    for (const uint32_t k : parents) count += slots[k] < end ? born[k] : 0;
    s.ghosts.exchange->add_up({&count, 1});
    return count;
  };
  uint32_t end = 0;  // the greatest such that all births below have room
  for (uint32_t bit = 1u << 31; bit > 0; bit /= 2) {
    if (born_below(end + bit) <= room) end += bit;
  }
  const auto left = static_cast<uint32_t>(room - born_below(end));
  for (const uint32_t k : parents) {
    if (slots[k] >= end) born[k] = slots[k] == end ? std::min(born[k], left) : 0;
  }
  born_.write(born);
  device_.exclusive_scan("diffuse/births", pbd::View<const uint32_t>(born_.view()).first(s.particles.sorted),
                         birth_place_.view());
}

}  // namespace meniscus::fluid
