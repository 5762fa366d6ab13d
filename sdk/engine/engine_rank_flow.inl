// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// DeviceEngine's sinks and emitters in a shared world. Rank 0 says what is to be done, and each rank does it
// for its own particles. Slots and numbers are those of a world alone.
#pragma once

#include <algorithm>

#include "sdk/engine/engine.inl"

namespace meniscus {

/// The particles that sinks take on this rank. `kept`: how many stay.
template <class D>
std::vector<typename DeviceEngine<D>::Taken> DeviceEngine<D>::take_own(std::span<uint32_t> taken,
                                                                       uint32_t& kept) {
  const uint32_t count = kept = particles_.sorted();
  if (count == 0) return {};
  removal_.reserve(particles_.capacity());
  kept = sinks_.mark(particles_, removal_, taken, {});
  if (kept == count) return {};
  std::vector<uint32_t> takers;
  sinks_.read_takers(count, takers);
  const std::vector<uint32_t> slots = particles_.slot.current.read(count);
  std::vector<uint32_t> keep(count);
  device_.copy_out(keep.data(), removal_.keep().data, count * sizeof(uint32_t));
  std::vector<Taken> gone;
  for (uint32_t i = 0; i < count; ++i) {
    if (!keep[i]) gone.push_back({slots[i], takers[i]});
  }
  return gone;
}

/// All ranks learn which slots are gone, since the others close up.
template <class D>
std::vector<bool> DeviceEngine<D>::take_sinks_among_ranks(std::span<uint32_t> taken,
                                                          std::vector<uint32_t>& takers) {
  uint32_t kept = 0;
  const std::vector<Taken> own = take_own(taken, kept);
  std::vector<Taken> all = pbd::lists_of_all(*ranks_, std::span(own));
  std::fill(taken.begin(), taken.end(), 0u);
  if (all.empty()) return {};
  std::sort(all.begin(), all.end(), [](const Taken& a, const Taken& b) { return a.slot < b.slot; });
  std::vector<uint32_t> gone;
  for (const Taken& t : all) {
    gone.push_back(t.slot);
    ++taken[t.sink];
  }
  std::vector<bool> removed;
  if (ranks_->rank() == 0) {
    removed.resize(all_particles_);
    takers.resize(all_particles_);
    for (const Taken& t : all) {
      removed[t.slot] = true;
      takers[t.slot] = t.sink;
    }
  }
  remove_among_ranks(gone, kept);
  return removed;
}

/// The slots that are gone on all ranks, ascending, and how many particles stay on this one, once
/// removal_.keep() says which.
template <class D>
void DeviceEngine<D>::remove_among_ranks(std::span<const uint32_t> gone, uint32_t kept) {
  device_.monitor().commit();
  fetched_contacts_.clear();
  contacts_fetched_ = true;
  removal_.apply_among_ranks(particles_, kept, gone, [&](pbd::View<const uint32_t> order, uint32_t count) {
    solver_.reorder(order, count);
  });
  all_particles_ -= static_cast<uint32_t>(gone.size());
  solver_.set_all_particles(all_particles_);
  solver_.particles_changed(kept, 0);
}

/// Removes the particles that rank 0 names.
template <class D>
void DeviceEngine<D>::keep_among_ranks(const std::vector<bool>& keep) {
  std::vector<uint32_t> gone;
  for (size_t slot = 0; slot < keep.size(); ++slot) {
    if (!keep[slot]) gone.push_back(static_cast<uint32_t>(slot));
  }
  gone = pbd::list_of_first(*ranks_, gone);
  const std::vector<uint32_t> slots = particles_.slot.current.read(particles_.sorted());
  std::vector<uint32_t> stays;
  for (const uint32_t slot : slots) stays.push_back(!std::binary_search(gone.begin(), gone.end(), slot));
  removal_.reserve(particles_.capacity());
  device_.copy_in(removal_.keep().data, stays.data(), stays.size() * sizeof(uint32_t));
  remove_among_ranks(gone, removal_.count_kept(particles_));
}

template <class D>
void DeviceEngine<D>::set_pistons(std::span<const Piston> pistons,
                                  std::span<const PistonParticle> particles) {
  if (!ranks_) return pistons_.set(particles_, pistons, particles);
  together({RankCall::set_pistons}, [&] {
    const auto all = pbd::list_of_first(*ranks_, std::vector(pistons.begin(), pistons.end()));
    const auto pushed = pbd::list_of_first(*ranks_, std::vector(particles.begin(), particles.end()));
    pistons_.set(particles_, all, pushed);
  });
}

template <class D>
void DeviceEngine<D>::find_room_among_ranks(std::span<const Arrival> arrivals,
                                            std::vector<uint8_t>& has_room) {
  free_room_.find(particles_, shape_set_, arrivals, has_room, [&](std::span<uint32_t> blocked) {
    std::vector<uint64_t> counts(blocked.begin(), blocked.end());
    ranks_->add_up(counts);
    for (size_t k = 0; k < blocked.size(); ++k) blocked[k] = counts[k] > 0;
  });
}

/// Rank 0 gets the spray, foam and bubbles of all ranks, in the order of a world alone.
template <class D>
std::vector<DiffuseParticle> DeviceEngine<D>::gather_diffuse() {
  using Own = typename fluid::Diffuse<D>::Own;
  const std::vector<Own> own = diffuse_->read_own();
  std::vector<Own> all = pbd::lists_on_first(*ranks_, std::span(own));
  std::sort(all.begin(), all.end(), [](const Own& a, const Own& b) { return a.key < b.key; });
  std::vector<DiffuseParticle> particles(all.size());
  std::transform(all.begin(), all.end(), particles.begin(), [](const Own& of) { return of.particle; });
  return particles;
}

/// Each particle belongs to the rank in whose region it is. All ranks give out the same slots and numbers.
template <class D>
void DeviceEngine<D>::append_among_ranks(const ParticleBatch& batch) {
  const auto count = static_cast<uint32_t>(batch.position.size());
  const std::vector<uint32_t> numbers = particles_.take_numbers(count);
  ParticleBatch own;
  std::vector<uint32_t> own_slots, own_numbers;
  for (uint32_t k = 0; k < count; ++k) {
    jets_.hold_for(pbd::held_steps(batch.phase[k]));
    if (!solver_.owns(batch.position[k].xyz())) continue;
    own.position.push_back(batch.position[k]);
    own.velocity.push_back(batch.velocity[k]);
    own.phase.push_back(batch.phase[k]);
    own_slots.push_back(all_particles_ + k);
    own_numbers.push_back(numbers[k]);
  }
  const uint32_t first = particles_.sorted(), added = static_cast<uint32_t>(own_slots.size());
  solver_.reserve_own(added);
  device_.monitor().commit();
  if (added) particles_.append(own.position, own.velocity, own.phase, own_slots, own_numbers);
  all_particles_ += count;
  solver_.set_all_particles(all_particles_);
  solver_.particles_changed(first, added);
}

}  // namespace meniscus
