// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// DeviceEngine's calls that read results and measure.
#pragma once

#include "sdk/engine/engine.inl"

namespace meniscus {

template <class D>
void DeviceEngine<D>::read_vector(pbd::View<const pbd::Vec4> from, std::span<Vec3> out) {
  device_.parallel_for("read-out/vectors", particles_.sorted(),
                       engine_kernels::ReadVector{from, readout_places(), vector_out_.view()});
  deliver(vector_out_, slots_by_place(), out);
}

template <class D>
void DeviceEngine<D>::read_fluids(std::span<uint32_t> out) {
  together({RankCall::fluids}, [&] {
    device_.parallel_for(
        "read-out/fluids", particles_.sorted(),
        engine_kernels::ReadGroup{particles_.phase.current.view(), readout_places(), index_out_.view()});
    deliver(index_out_, slots_by_place(), out);
  });
}

template <class D>
uint64_t DeviceEngine<D>::hash_particles() {
  if (particles_.sorted() == 0 && !ranks_) return 0;
  return together({RankCall::hash}, [&] {
    const pbd::ParticleView p = particles_.view();
    device_.reduce("read-out/hash", p.sorted, uint64_t{0},
                   engine_kernels::HashParticle{p.position, p.velocity, p.number},
                   engine_kernels::AddCounts{}, count_out_.view().first(1));
    uint64_t sum = 0;
    count_out_.read(std::span(&sum, 1));
    if (ranks_) ranks_->add_up(std::span(&sum, 1));
    return sum;
  });
}

template <class D>
void DeviceEngine<D>::read_pressures(std::span<float> out, float dt) {
  const float scale = dt > 0 ? 1 / (def_.kernel.particle_volume * dt * dt) : 0;
  together({RankCall::pressures, 0, dt}, [&] {
    device_.parallel_for(
        "read-out/pressures", particles_.sorted(),
        engine_kernels::ReadMultipliers{density_.multipliers(), readout_places(), scalar_out_.view(), scale});
    deliver(scalar_out_, slots_by_place(), out);
  });
}

template <class D>
void DeviceEngine<D>::set_probes(std::span<const fluid::Probe> probes) {
  std::vector<collision::film_kernels::LoadProbe> loads;
  for (const fluid::Probe& p : probes) {
    const bool on_shape = p.measure == fluid::ProbeMeasure::force || p.measure == fluid::ProbeMeasure::torque;
    loads.push_back({on_shape ? p.shape : pbd::no_index, p.patch, p.point});
  }
  films_.set_probes(loads);
  probes_.set_probes(probes);
}

template <class D>
void DeviceEngine<D>::read_probes(std::span<fluid::ProbeSum> means) {
  if (means.empty()) return;
  together({RankCall::probes}, [&] { probes_.read(means); });
  const std::span<const collision::RigidImpulse> loads = films_.read_probes();
  for (size_t k = 0; k < means.size(); ++k) {
    const bool torque = probes_.probes()[k].measure == fluid::ProbeMeasure::torque;
    const Vec3 load = torque ? loads[k].angular : loads[k].linear;
    means[k].x += double{load.x};
    means[k].y += double{load.y};
    means[k].z += double{load.z};
  }
}

template <class D>
EngineMeasure DeviceEngine<D>::read_density_errors(std::span<float> error, std::span<float> full) {
  return together({RankCall::density_errors}, [&] { return measure_density(error, full); });
}

template <class D>
EngineMeasure DeviceEngine<D>::measure_density(std::span<float> error, std::span<float> full) {
  using namespace engine_kernels;
  fetch_contacts();
  std::array<uint64_t, 4> counts{};  // neighbours, walls, contacts, particles
  std::vector<uint32_t> slots;
  solver_.measure([&](pbd::Substep<D>& substep, const pbd::Found& found) {
    counts[2] = found.contacts.last;
    counts[3] = particles_.sorted();
    slots = slots_by_place();
    pistons_.open_walls(substep);
    pbd::Substep<D> read = substep;
    read.particles.slot = readout_places();
    density_.measure(read, scalar_out_.view(), full_out_.view());
    device_.reduce("measure/neighbours", particles_.sorted(), uint64_t{0},
                   CountNeighbours{substep.neighbours}, AddCounts{}, count_out_.view().first(1));
    device_.reduce("measure/walls", particles_.sorted(), uint64_t{0},
                   CountCrowdedAtWalls{substep.contacts, substep.particles.position, substep.particles.phase,
                                       def_.kernel.h},
                   AddCounts{}, count_out_.view().from(1));
  });
  deliver(scalar_out_, slots, error);
  deliver(full_out_, slots, full);
  count_out_.read(std::span(counts).first(2));
  if (ranks_) ranks_->add_up(counts);
  return {static_cast<double>(counts[0]) / static_cast<double>(std::max(uint64_t{1}, counts[3])),
          static_cast<uint32_t>(counts[2]), counts[1]};
}

template <class D>
OwnParticles DeviceEngine<D>::read_own_particles() {
  using namespace engine_kernels;
  return guarded(ranks_, [&] {
    OwnParticles own;
    const float scale =
        last_substep_ > 0 ? 1 / (def_.kernel.particle_volume * last_substep_ * last_substep_) : 0;
    fetch_contacts();
    solver_.measure([&](pbd::Substep<D>& substep, const pbd::Found&) {
      const uint32_t count = particles_.sorted();
      own.slots = slots_by_place();
      pbd::Substep<D> read = substep;
      const pbd::View<const uint32_t> places = read.particles.slot = readout_places();
      const auto vectors = [&](pbd::View<const pbd::Vec4> from) {
        device_.parallel_for("read-out/vectors", count, ReadVector{from, places, vector_out_.view()});
        return vector_out_.read(count);
      };
      own.positions = vectors(substep.particles.position);
      own.velocities = vectors(substep.particles.velocity);
      device_.parallel_for("read-out/fluids", count,
                           ReadGroup{substep.particles.phase, places, index_out_.view()});
      own.fluids = index_out_.read(count);
      device_.parallel_for("read-out/pressures", count,
                           ReadMultipliers{density_.multipliers(), places, scalar_out_.view(), scale});
      own.pressures = scalar_out_.read(count);
      density_.measure(read, scalar_out_.view(), full_out_.view());
      own.density_errors = scalar_out_.read(count);
    });
    release_readouts();
    if (!diffuse_) return own;
    for (const auto& of : diffuse_->read_own()) own.diffuse.push_back(of.particle);
    return own;
  });
}

template <class D>
void DeviceEngine<D>::read_diffuse(std::span<DiffuseParticle> out) {
  together({RankCall::diffuse}, [&] {
    if (!ranks_) return diffuse_->read(out);
    const std::vector<DiffuseParticle> all = gather_diffuse();
    std::copy(all.begin(), all.end(), out.begin());
  });
}

template <class D>
void DeviceEngine<D>::read_ellipsoids(std::span<Ellipsoid> out) {
  together({RankCall::ellipsoids}, [&] {
    fetch_contacts();
    const fluid::Anisotropy<D> anisotropy(
        device_, fluid::calibrate_anisotropy(def_.particle_spacing, def_.solver.support_radius));
    std::vector<uint32_t> slots;
    solver_.measure([&](pbd::Substep<D>& substep, const pbd::Found&) {
      slots = slots_by_place();
      ellipsoid_out_.resize_discard(
          particles_.sorted());  // a shared world may give this rank other particles
      ranks_ ? anisotropy.measure_sorted(substep, ellipsoid_out_.view())
             : anisotropy.measure(substep, ellipsoid_out_.view());
    });
    deliver(ellipsoid_out_, slots, out);
  });
}

template <class D>
void DeviceEngine<D>::write_particles(const ParticleArrays& arrays) {
  const uint32_t count = particles_.sorted();
  const fluid::Anisotropy<D> anisotropy(
      device_, fluid::calibrate_anisotropy(def_.particle_spacing, def_.solver.support_radius));
  const auto write = [&](pbd::Substep<D>& substep) {
    anisotropy.measure(substep, {arrays.ellipsoids, count});
    if (def_.origin != Vec3{0, 0, 0})
      device_.parallel_for("read-out/origin", count,
                           engine_kernels::ShiftEllipsoids{{arrays.ellipsoids, count}, def_.origin});
    device_.parallel_for(
        "read-out/fluids", count,
        engine_kernels::ReadGroup{substep.particles.phase, substep.particles.slot, {arrays.fluids, count}});
    if (!arrays.velocities) return;
    device_.parallel_for("read-out/velocities", count,
                         engine_kernels::ReadVector{
                             substep.particles.velocity, substep.particles.slot, {arrays.velocities, count}});
  };
  if (solver_.read_last_substep(write)) return;
  fetch_contacts();
  solver_.measure([&](pbd::Substep<D>& substep, const pbd::Found&) { write(substep); });
}

template <class D>
SurfaceMesh DeviceEngine<D>::read_surface(const fluid::SurfaceField& field, std::optional<uint32_t> group) {
  fetch_contacts();
  ellipsoid_out_.resize_discard(particles_.sorted());
  const fluid::Anisotropy<D> anisotropy(
      device_, fluid::calibrate_anisotropy(def_.particle_spacing, def_.solver.support_radius));
  solver_.measure([&](pbd::Substep<D>& substep, const pbd::Found&) {
    anisotropy.measure_sorted(substep, ellipsoid_out_.view());
    mesher_.build(ellipsoid_out_.view(), substep.particles.velocity,
                  {substep.particles.phase, group.value_or(fluid::all_fluids)}, field);
  });
  return mesher_.read();
}

/// Fetches the effects of the last substep's contacts to the host, by slot. It runs once a step, and before
/// particles change their places.
template <class D>
void DeviceEngine<D>::fetch_contacts() {
  if (contacts_fetched_) return;
  fetched_contacts_.clear();
  const pbd::ContactView view = solver_.contacts();
  uint32_t total = 0;
  device_.copy_out(&total, view.start.data + view.start.count - 1, sizeof total);
  std::vector<pbd::Contact> contacts(total);
  std::vector<uint32_t> particle(total), slot(particles_.count());
  if (total == 0) {
    contacts_fetched_ = true;
    return;
  }
  device_.copy_out(contacts.data(), view.contacts.data, total * sizeof(pbd::Contact));
  device_.copy_out(particle.data(), view.particle.data, total * sizeof(uint32_t));
  particles_.slot.current.read(std::span(slot));
  for (uint32_t n = 0; n < total; ++n) {
    const pbd::Contact& c = contacts[n];
    const Vec3 impulse = multiplier_sum(c) / last_substep_;
    if (c.solid == pbd::no_index || impulse == Vec3{0, 0, 0}) continue;
    if (particle[n] >= sorted_in_step_) continue;  // skips vertices and points of faces
    const TouchedKind kind = c.body == pbd::no_index   ? TouchedKind::shape
                             : c.body == pbd::on_cloth ? TouchedKind::cloth
                                                       : TouchedKind::body;
    fetched_contacts_.push_back({slot[particle[n]], c.solid, kind, c.point, c.normal, impulse});
  }
  std::stable_sort(fetched_contacts_.begin(), fetched_contacts_.end(),
                   [](const ContactReadout& a, const ContactReadout& b) { return a.slot < b.slot; });
  contacts_fetched_ = true;
}

template <class D>
std::vector<ContactReadout> DeviceEngine<D>::read_contacts() {
  fetch_contacts();
  std::ranges::sort(forgotten_);
  std::erase_if(fetched_contacts_, [&](const ContactReadout& c) {
    return std::ranges::binary_search(forgotten_, std::pair(c.solid, c.kind));
  });
  forgotten_.clear();
  return fetched_contacts_;
}

template <class D>
void DeviceEngine<D>::forget_contacts(uint32_t solid, TouchedKind kind) {
  forgotten_.emplace_back(solid, kind);
  if (kind == TouchedKind::body) bodies_.forget_forces(solid);
}

template <class D>
Diagnostics DeviceEngine<D>::measure(Vec3 gravity) {
  using namespace engine_kernels;
  const StateSum sum = together({RankCall::diagnostics}, [&] { return sum_states(gravity); });
  Diagnostics d;
  d.particles = ranks_ ? all_particles_ : particles_.sorted();
  d.kinetic_energy = sum.kinetic;
  d.potential_energy = sum.potential;
  d.max_speed = std::sqrt(sum.max_speed2);
  d.non_finite = sum.non_finite;
  d.outside = sum.outside;
  return d;
}

/// Of all ranks; their sums are added in the order of the ranks.
template <class D>
engine_kernels::StateSum DeviceEngine<D>::sum_states(Vec3 gravity) {
  using namespace engine_kernels;
  device_.reduce("measure/state", particles_.count(), StateSum{},
                 SumState{particles_.position.current.view(), particles_.velocity.current.view(), shape_set_,
                          contacts_.find_near(particles_.position.current.view(), particles_.count(), 0),
                          contacts_.touches(particles_.phase.current.view(), particles_.sorted()), gravity,
                          def_.solver.support_radius},
                 AddStates{}, state_sum_.view());
  StateSum sum{};
  state_sum_.read(std::span(&sum, 1));
  if (!ranks_) return sum;
  StateSum all{};
  for (const StateSum& of_rank : pbd::values_of_all(*ranks_, sum)) all = AddStates{}(all, of_rank);
  return all;
}

}  // namespace meniscus
