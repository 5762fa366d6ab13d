// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// DeviceEngine's calls that add, remove and change particles.
#pragma once

#include <numeric>

#include "sdk/engine/engine.inl"

namespace meniscus {

template <class D>
void DeviceEngine<D>::reserve(uint32_t fluid, uint32_t vertices) {
  const uint32_t capacity = fluid + vertices;
  fetch_contacts();
  solver_.reserve(fluid, vertices);
  reserve_readouts(fluid);
  state_sum_.resize_or_stay(1);
  count_out_.resize_or_stay(2);
  removal_.reserve(capacity);
  fluid_capacity_ = fluid;  // last: if memory ran out, the old capacity still holds
  vertex_capacity_ = vertices;
}

template <class D>
void DeviceEngine<D>::reserve_readouts(uint32_t fluid) {
  vector_out_.resize_or_stay(fluid);
  scalar_out_.resize_or_stay(fluid);
  full_out_.resize_or_stay(fluid);
  index_out_.resize_or_stay(fluid);
}

template <class D>
void DeviceEngine<D>::set_solvers(const EngineDef& def) {
  def_ = def;
  solver_.set_parameters(def.solver);
  density_.set_parameters(def.density);
  cloth_.set_parameters(def.cloth);
  if (diffuse_) diffuse_->set_gravity(def.solver.gravity);
}

template <class D>
void DeviceEngine<D>::set_materials(std::span<const ParticleMaterial> materials) {
  std::vector<fluid::Material> fluids;
  std::vector<collision::GrainMaterial> grains;
  std::vector<CollisionFilter> filters;
  bool any_fluid = false, any_grains = false;
  for (const ParticleMaterial& m : materials) {
    fluids.push_back(m.fluid);
    grains.push_back(m.grain);
    filters.push_back(m.filter);
    (m.grain.is_grain ? any_grains : any_fluid) = true;
  }
  std::vector<float> densities;
  for (const fluid::Material& m : fluids) densities.push_back(m.rest_density);
  contacts_.set_filters(filters);
  forces_.set_densities(densities);
  density_.set_kinds(any_fluid, any_grains);
  grains_.set_materials(grains);
  tension_.set_materials(fluids);
  viscosity_.set_materials(fluids);
  smoothing_.set_materials(fluids);
}

/// The first fill gets what it asks for, unless that is little. Later ones reserve more than needed, so that
/// an emitter rarely reallocates.
template <class D>
void DeviceEngine<D>::reserve_more(uint32_t more) {
  const uint32_t present = particles_.sorted(), needed = present + more;
  constexpr uint32_t least = 1024;
  if (needed > fluid_capacity_)
    reserve(std::max(least, present == 0 ? needed : needed + needed / 4), vertex_capacity_);
}

template <class D>
void DeviceEngine<D>::make_room(uint32_t more) {
  if (!ranks_) reserve_more(more);  // others do not know how many of these come to them
  free_room_.reserve(more);
}

template <class D>
void DeviceEngine<D>::find_room(std::span<const Arrival> arrivals, std::vector<uint8_t>& has_room) {
  if (ranks_) {
    std::vector<Arrival> all(arrivals.begin(), arrivals.end());
    together({RankCall::find_room, static_cast<int32_t>(all.size())}, [&] {
      pbd::copy_from_first(*ranks_, std::span(all));
      find_room_among_ranks(all, has_room);
      note_waiting(all);
    });
    return;
  }
  free_room_.find(particles_, shape_set_, arrivals, has_room, [](std::span<uint32_t>) {});
  note_waiting(arrivals);
}

/// Arrivals that have waited may have driven particles away.
template <class D>
void DeviceEngine<D>::note_waiting(std::span<const Arrival> arrivals) {
  if (std::none_of(arrivals.begin(), arrivals.end(), [](const Arrival& a) { return a.waits; })) return;
  jets_.hold_for(1);
  solver_.particles_changed(0, 0);
}

template <class D>
void DeviceEngine<D>::append(const ParticleBatch& batch) {
  const uint32_t first = particles_.sorted();
  const auto added = static_cast<uint32_t>(batch.position.size());
  if (added == 0) return;
  if (held_) return hold(batch);
  if (ranks_) {
    ParticleBatch all = batch;
    return together({RankCall::append, static_cast<int32_t>(added)}, [&] {
      pbd::copy_from_first(*ranks_, std::span(all.position));
      pbd::copy_from_first(*ranks_, std::span(all.velocity));
      pbd::copy_from_first(*ranks_, std::span(all.phase));
      append_among_ranks(all);
    });
  }
  reserve_more(added);
  std::vector<uint32_t> slot(added);
  std::iota(slot.begin(), slot.end(), first);
  device_.monitor().commit();
  particles_.append(batch.position, batch.velocity, batch.phase, slot);
  for (pbd::Phase phase : batch.phase) jets_.hold_for(pbd::held_steps(phase));
  any_overlapping_ |= batch.by_hand;
  solver_.particles_changed(first, added);
  if (batch.may_crowd) density_.note_placed(first, added);
}

template <class D>
void DeviceEngine<D>::keep(const std::vector<bool>& keep) {
  if (held_) return keep_held(keep);
  if (ranks_) return together({RankCall::keep}, [&] { keep_among_ranks(keep); });
  const std::vector<uint32_t> by_slot(keep.begin(), keep.end());
  removal_.keep_by_slot(particles_, by_slot);
  remove_marked(removal_.count_kept(particles_));
}

template <class D>
std::vector<uint32_t> DeviceEngine<D>::remove_marked(uint32_t kept) {
  fetch_contacts();  // while they match the particles
  std::vector<uint32_t> by_slot(particles_.sorted()), place(particles_.sorted());
  device_.monitor().commit();
  removal_.apply(particles_, kept, by_slot,
                 [&](pbd::View<const uint32_t> order, uint32_t count) { solver_.reorder(order, count); });
  solver_.particles_changed(kept, 0);
  keep_contacts(by_slot, place);
  return by_slot;
}

/// Contacts of remaining particles move with them to their new slots, which this writes to `place`.
template <class D>
void DeviceEngine<D>::keep_contacts(std::span<const uint32_t> stays, std::span<uint32_t> place) {
  std::exclusive_scan(stays.begin(), stays.end(), place.begin(), 0u);
  std::erase_if(fetched_contacts_, [&](const ContactReadout& c) { return stays[c.slot] == 0; });
  for (ContactReadout& c : fetched_contacts_) c.slot = place[c.slot];
}

template <class D>
void DeviceEngine<D>::push_particles(std::span<const uint32_t> slots, std::span<const Vec3> impulses) {
  push<engine_kernels::PushParticles>(particles_.sorted(), slots, impulses);
}

template <class D>
void DeviceEngine<D>::push_vertices(std::span<const uint32_t> vertices, std::span<const Vec3> impulses) {
  push<engine_kernels::PushVertices>(static_cast<uint32_t>(vertices.size()), vertices, impulses);
}

template <class D>
template <class Kernel>
void DeviceEngine<D>::push(uint32_t count, std::span<const uint32_t> who, std::span<const Vec3> impulses) {
  pbd::Buffer<uint32_t> numbers(device_, "pushed particles");
  pbd::Buffer<Vec3> pushes(device_, "impulses");
  replace(numbers, who);
  replace(pushes, impulses);
  device_.parallel_for(
      "particles/push", count,
      Kernel{particles_.position.current.view(), particles_.velocity.current.view(),
             particles_.slot.current.view(), numbers.view(), pushes.view(), particles_.sorted()});
  solver_.particles_changed(0, 0);
}

template <class D>
void DeviceEngine<D>::set_sinks(std::span<const Sink> sinks) {
  if (!ranks_) return sinks_.set(sinks);
  std::vector<Sink> all(sinks.begin(), sinks.end());
  together({RankCall::set_sinks, static_cast<int32_t>(all.size())}, [&] {
    pbd::copy_from_first(*ranks_, std::span(all));
    sinks_.set(all);
  });
}

template <class D>
std::vector<bool> DeviceEngine<D>::take_sinks(std::span<uint32_t> taken, std::vector<uint32_t>& takers) {
  if (sinks_.empty()) return {};
  if (ranks_) return together({RankCall::take_sinks}, [&] { return take_sinks_among_ranks(taken, takers); });
  if (particles_.sorted() == 0) return {};
  const uint32_t kept = sinks_.mark(particles_, removal_, taken, particles_.slot.current.view());
  if (kept == particles_.sorted()) return {};
  sinks_.read_takers(particles_.sorted(), takers);
  const std::vector<uint32_t> by_slot = remove_marked(kept);
  std::vector<bool> removed(by_slot.size());
  std::transform(by_slot.begin(), by_slot.end(), removed.begin(), [](uint32_t stays) { return stays == 0; });
  return removed;
}

template <class D>
Overflows DeviceEngine<D>::overflows() const {
  using namespace collision::fluid_cloth_kernels;
  return {.cloth_layers = fluid_cloth_contacts_.found(crowded),
          .cloth_vertices = fluid_cloth_contacts_.found(cut),
          .fluid_failsafe = fluid_cloth_contacts_.found(unstopped),
          .cloth_failsafe = self_contacts_.given_up()};
}

template <class D>
void DeviceEngine<D>::begin_step(float dt, int iterations) {
  fetched_contacts_.clear();  // after a failed step there are none
  forgotten_.clear();
  contacts_fetched_ = true;
  note_overlapping();
  begun_step_ = dt;
  begun_iterations_ = iterations;
  together({RankCall::step, iterations, dt}, [&] { solver_.begin_step(dt, iterations); });
}

template <class D>
EngineStep DeviceEngine<D>::end_step() {
  EngineStep done;
  done.result = guarded(ranks_, [&] { return solver_.end_step(); });
  if (done.result.summary.non_finite && solver_.worlds() == 1) return done;
  last_substep_ = begun_step_ / static_cast<float>(done.result.substeps);
  contacts_fetched_ = false;
  sorted_in_step_ = particles_.sorted();
  jets_.age(particles_);
  if (diffuse_) diffuse_->accept();
  done.stage_ms = solver_.timer().read_ms();
  done.rigid_ms = bodies_.step_ms();
  done.any_world_failed = bodies_.worlds().any_failed();
  done.overflows = overflows();
  done.pistons = guarded(ranks_, [&] { return pistons_.read(ranks_); });
  done.density_iterations =
      density_.iterations_done(static_cast<uint32_t>(done.result.substeps * begun_iterations_));
  return done;
}

}  // namespace meniscus
