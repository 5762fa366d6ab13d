// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// DeviceEngine's calls for batches of worlds.
#pragma once

#include "sdk/engine/engine.inl"

namespace meniscus {

namespace engine_kernels {

/// Counts by the criterion of pbd::solver_kernels::Summarize.
struct CountNonFinite {
  View<const pbd::Vec4> position, velocity;
  uint32_t each;  ///< of a world
  View<uint32_t> counts;

  MENISCUS_HD void operator()(uint32_t i) const {
    const Vec3 v = velocity[i].xyz();
    if (!is_finite(position[i].xyz()) || !(dot(v, v) <= pbd::most_finite))
      pbd::atomic_add(counts[i / each], 1);
  }
};

struct WriteVertices {
  View<const pbd::Vec4> from;  ///< by vertex
  View<Vec3> to;
  Vec3 shift;  ///< m

  MENISCUS_HD void operator()(uint32_t v) const { to[v] = from[v].xyz() + shift; }
};

struct HashVerticesByWorld {
  View<const pbd::Vec4> position, velocity;  ///< by vertex
  View<const uint64_t> numbers;              ///< of one world's
  View<int64_t> sums;

  MENISCUS_HD void operator()(uint32_t v) const {
    const uint64_t hash = pbd::element_hash(numbers[v % numbers.count], position[v].xyz(), velocity[v].xyz());
    pbd::atomic_add(sums[v / numbers.count], static_cast<int64_t>(hash));
  }
};

struct HashByWorld {
  HashParticle hash;
  uint32_t each;
  View<int64_t> sums;

  MENISCUS_HD void operator()(uint32_t i) const {
    pbd::atomic_add(sums[i / each], static_cast<int64_t>(hash(i)));
  }
};

}  // namespace engine_kernels

/// Overlaps with solids are noted first, as the first step of a world notes them.
template <class D>
void DeviceEngine<D>::make_worlds(const SolidShapes& solids, const EngineCloth& cloth,
                                  const VertexNumbers& numbers) {
  const uint32_t each = particles_.sorted(), worlds = solids.worlds;
  fetch_contacts();
  note_overlapping();
  for (pbd::Buffer<uint32_t>* b : {&chosen_worlds_, &bad_worlds_}) b->resize_discard(worlds);
  world_hashes_.resize_discard(worlds);
  world_gravities_.resize_discard(worlds);
  device_.monitor().commit();
  solver_.keep_world(static_cast<uint32_t>(cloth.touches.size()));
  solver_.make_worlds(worlds);
  fluid_capacity_ = worlds * each;
  vertex_capacity_ = worlds * static_cast<uint32_t>(numbers.size());
  pieces_of_world_ = static_cast<uint32_t>(cloth.touches.size());
  replace<uint64_t>(vertex_numbers_, numbers);
  if (!numbers.empty()) set_cloth(cloth, worlds);
  solver_.reset_worlds({});
  vector_out_.resize_or_stay(fluid_capacity_);  // the only read-out of a batch
  set_shapes(solids);
  any_overlapping_ = false;
}

template <class D>
LastSubsteps DeviceEngine<D>::last_substeps() const {
  return {last_substep_, density_.last_substep(), cloth_.last_substep(), grains_.last_substep()};
}

template <class D>
void DeviceEngine<D>::continue_from(const LastSubsteps& last) {
  last_substep_ = last.of_all;
  density_.set_last_substep(last.density);
  cloth_.set_last_substep(last.cloth);
  grains_.set_last_substep(last.grains);
}

template <class D>
void DeviceEngine<D>::find_substeps(float dt, std::span<int> out) {
  std::ranges::fill(out, def_.solver.substeps);
  if (!body_zones_.may_need_substeps()) return;
  bodies_.motions_changed();
  bodies_.speed(dt);
  const std::span<const uint32_t> needed = body_zones_.least_substeps_by_world(dt, particles_.source());
  for (size_t w = 0; w < out.size(); ++w) out[w] = body_zones_.in_range(needed[w], out[w]);
}

template <class D>
void DeviceEngine<D>::place_worlds(std::span<const uint32_t> chosen) {
  bodies_.place();
  chosen_worlds_.write(chosen);
  note_overlapping(chosen_worlds_.view());
}

template <class D>
void DeviceEngine<D>::set_gravities(std::span<const Vec3> gravities) {
  std::vector<pbd::Vec4> padded;
  for (const Vec3 g : gravities) padded.push_back(pbd::with_w(g, 0));
  world_gravities_.write(padded);
  solver_.set_gravities(world_gravities_.view());
  fluid_cloth_.set_gravities({world_gravities_.view(), particles_.sorted() / solver_.worlds()});
  films_.set_gravities(padded);
}

template <class D>
void DeviceEngine<D>::reset_worlds(std::span<const uint32_t> chosen) {
  chosen_worlds_.write(chosen);
  solver_.reset_worlds(chosen_worlds_.view());
  bodies_.reset_bodies(chosen);
}

template <class D>
void DeviceEngine<D>::undo_worlds(std::span<const uint32_t> chosen) {
  chosen_worlds_.write(chosen);
  solver_.undo_worlds(chosen_worlds_.view());
  bodies_.undo_bodies(chosen);
}

template <class D>
void DeviceEngine<D>::count_non_finite(std::span<uint32_t> counts) {
  const pbd::ParticleView p = particles_.view();
  bad_worlds_.fill(0);
  const auto count = [&](uint32_t first, uint32_t particles) {
    device_.parallel_for("worlds/finite", particles,
                         engine_kernels::CountNonFinite{p.position.from(first), p.velocity.from(first),
                                                        particles / solver_.worlds(), bad_worlds_.view()});
  };
  count(0, p.sorted);
  count(p.sorted, particles_.vertices());
  bad_worlds_.read(counts);
  const std::span<const uint8_t> failed = bodies_.worlds().failed();
  for (size_t w = 0; w < failed.size(); ++w) counts[w] += failed[w];
}

template <class D>
void DeviceEngine<D>::hash_worlds(std::span<uint64_t> hashes) {
  const pbd::ParticleView p = particles_.view();
  world_hashes_.fill(0);
  device_.parallel_for(
      "worlds/hash", p.sorted,
      engine_kernels::HashByWorld{
          {p.position, p.velocity, p.number}, p.sorted / solver_.worlds(), world_hashes_.view()});
  device_.parallel_for(
      "worlds/hash vertices", particles_.vertices(),
      engine_kernels::HashVerticesByWorld{p.position.from(p.sorted), p.velocity.from(p.sorted),
                                          vertex_numbers_.view(), world_hashes_.view()});
  device_.copy_out(hashes.data(), world_hashes_.view().data, hashes.size_bytes());
}

template <class D>
void DeviceEngine<D>::visit_worlds(pbd::StateVisitor& v) {
  const uint32_t count = particles_.count();
  const auto array = [&]<class T>(const char* name, pbd::View<T> all) {
    v.array(name, all.first(count), count);
  };
  array("position", particles_.position.current.view());
  array("velocity", particles_.velocity.current.view());
  array("phase", particles_.phase.current.view());
  array("slot", particles_.slot.current.view());
  array("number", particles_.number.current.view());
  density_.visit_multipliers(v, particles_.sorted());
  v.value("last_substep", last_substep_);
  v.part("bodies", bodies_);
  v.part("grains", grains_);
  if (vertex_numbers_.size() > 0) {
    v.part("stick_anchors", stick_anchors_);
    v.part("cloth", cloth_);
    v.part("self_contacts", self_contacts_);
    v.part("fluid_cloth", fluid_cloth_);
  }
  if (v.restores()) solver_.particles_changed(0, 0);
}

template <class D>
EngineWorld DeviceEngine<D>::read_world(uint32_t world) {
  note_overlapping();
  const uint32_t each = particles_.sorted() / solver_.worlds(), first = world * each;
  EngineWorld state;
  const auto read = [&]<class T>(std::vector<T>& to, pbd::View<const T> from) {
    to.resize(each);
    device_.copy_out(to.data(), from.data + first, each * sizeof(T));
  };
  const pbd::ParticleView p = particles_.view();
  read(state.position, pbd::View<const pbd::Vec4>(p.position));
  read(state.velocity, pbd::View<const pbd::Vec4>(p.velocity));
  read(state.phase, p.phase);
  read(state.slot, p.slot);
  read(state.number, p.number);
  read(state.multiplier, density_.multipliers());
  for (uint32_t& slot : state.slot) slot -= first;
  const uint32_t bodies = bodies_.worlds().each();
  const auto forces = bodies_.mean_forces().subspan(size_t{world} * bodies, bodies);
  state.body_forces.assign(forces.begin(), forces.end());
  state.last = last_substeps();
  read_vertices_of(world, state);
  state.parts = std::make_shared<pbd::SavedState>();
  pbd::StateSaver v(device_, *state.parts, pbd::SavedTo::host);
  visit_parts_of(world, v);
  return state;
}

template <class D>
void DeviceEngine<D>::read_vertices_of(uint32_t world, EngineWorld& state) {
  const uint32_t each = solver_.vertices_of_world();
  if (each == 0) return;
  const uint32_t first = particles_.sorted() + world * each;
  const auto read = [&]<class T>(std::vector<T>& to, const pbd::Buffer<T>& from) {
    to.resize(each);
    from.read(std::span(to), first);
  };
  read(state.vertex_position, particles_.position.current);
  read(state.vertex_velocity, particles_.velocity.current);
  read(state.vertex_phase, particles_.phase.current);
  for (pbd::Phase& phase : state.vertex_phase) phase -= world * pieces_of_world_;
}

template <class D>
void DeviceEngine<D>::write_world(uint32_t world, const EngineWorld& state) {
  const auto each = static_cast<uint32_t>(state.position.size()), first = world * each;
  const auto write = [&]<class T>(pbd::Buffer<T>& to, std::span<const T> from) { to.write(from, first); };
  std::vector<uint32_t> slot = state.slot;
  for (uint32_t& s : slot) s += first;
  write(particles_.position.current, std::span(state.position));
  write(particles_.velocity.current, std::span(state.velocity));
  write(particles_.phase.current, std::span(state.phase));
  write(particles_.slot.current, std::span<const uint32_t>(slot));
  write(particles_.number.current, std::span(state.number));
  solver_.particles_changed(0, 0);
  density_.set_multipliers(first, state.multiplier);
  bodies_.set_mean_forces(world, state.body_forces);
  write_vertices_of(world, state);
  pbd::StateRestorer v(device_, *state.parts);
  visit_parts_of(world, v);
  continue_from(state.last);
  any_overlapping_ = false;
}

template <class D>
void DeviceEngine<D>::write_vertices_of(uint32_t world, const EngineWorld& state) {
  const auto each = static_cast<uint32_t>(state.vertex_position.size());
  const uint32_t first = particles_.sorted() + world * each;
  std::vector<pbd::Phase> phase = state.vertex_phase;
  for (pbd::Phase& p : phase) p += world * pieces_of_world_;
  particles_.position.current.write(state.vertex_position, first);
  particles_.velocity.current.write(state.vertex_velocity, first);
  particles_.phase.current.write(phase, first);
}

/// In a batch of one world, otherwise of all.
template <class D>
void DeviceEngine<D>::visit_parts_of(uint32_t world, pbd::StateVisitor& v) {
  v.group("grains", [&] { grains_.visit_world(v, world, particles_.sorted() / solver_.worlds()); });
  if (particles_.vertices() == 0) return;
  const auto visit = [&](const char* name, auto& part) {
    if (vertex_numbers_.size() == 0) return v.part(name, part);
    v.group(name, [&] { part.visit_world(v, world); });
  };
  visit("stick_anchors", stick_anchors_);
  visit("cloth", cloth_);
  visit("self_contacts", self_contacts_);
}

template <class D>
void DeviceEngine<D>::write_vectors(Vec3* positions, Vec3* velocities) {
  const uint32_t count = particles_.sorted();
  const pbd::ParticleView p = particles_.view();
  device_.parallel_for("arrays/positions", count,
                       engine_kernels::ReadVector{p.position, p.slot, {positions, count}});
  device_.parallel_for("arrays/velocities", count,
                       engine_kernels::ReadVector{p.velocity, p.slot, {velocities, count}});
  if (def_.origin != Vec3{0, 0, 0})
    device_.parallel_for("arrays/origin", count,
                         engine_kernels::ShiftVectors{{positions, count}, def_.origin});
  device_.send_off();
}

template <class D>
void DeviceEngine<D>::write_vertices(Vec3* positions, Vec3* velocities) {
  const uint32_t count = particles_.vertices();
  const auto write = [&](const char* name, const pbd::Buffer<pbd::Vec4>& from, Vec3* to, Vec3 shift) {
    device_.parallel_for(
        name, count,
        engine_kernels::WriteVertices{from.view().from(particles_.sorted()), {to, count}, shift});
  };
  write("arrays/vertices", particles_.position.current, positions, def_.origin);
  write("arrays/vertex velocities", particles_.velocity.current, velocities, {0, 0, 0});
  device_.send_off();
}

}  // namespace meniscus
