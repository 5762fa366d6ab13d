// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// World's read-outs of particles.
#include <meniscus/world.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "sdk/fields/probes.h"
#include "sdk/world/check/check.h"
#include "sdk/world/state/hashed_elements.h"
#include "sdk/world/world_calls.h"

namespace meniscus {

size_t World::Calls::particle_count() const {
  return impl_->ids.size();
}

std::span<const ParticleId> World::Calls::ids() const {
  return impl_->ids;
}

std::span<const Vec3> World::Calls::positions() const {
  return impl_->positions.get(particle_count(), [&](auto out) { impl_->engine->read_positions(out); });
}

namespace {

/// A read-out in the user's frame, kept in `kept`: the read-out itself where the origin is zero.
template <class T, class Place>
std::span<const T> in_users_frame(const Origin& origin, std::span<const T> values, CachedReadout<T>& kept,
                                  const Place& place) {
  if (origin.is_zero()) return values;
  return kept.get(values.size(), [&](std::span<T> out) {
    std::ranges::copy(values, out.begin());
    for (T& value : out) place(value) = origin.outward(place(value));
  });
}

}  // namespace

std::span<const Vec3> World::Calls::outward_positions() const {
  return in_users_frame(impl_->origin, positions(), impl_->outward_positions,
                        [](Vec3& p) -> Vec3& { return p; });
}

std::span<const Ellipsoid> World::Calls::outward_ellipsoids() const {
  return in_users_frame(impl_->origin, ellipsoids(), impl_->outward_ellipsoids,
                        [](Ellipsoid& e) -> Vec3& { return e.centre; });
}

std::span<const DiffuseParticle> World::Calls::outward_diffuse() const {
  return in_users_frame(impl_->origin, diffuse(), impl_->outward_diffuse,
                        [](DiffuseParticle& d) -> Vec3& { return d.position; });
}

std::span<const Vec3> World::Calls::velocities() const {
  return impl_->velocities.get(particle_count(), [&](auto out) { impl_->engine->read_velocities(out); });
}

std::span<const uint32_t> World::Calls::fluids() const {
  return impl_->fluid_indices.get(particle_count(), [&](auto out) { impl_->engine->read_fluids(out); });
}

std::span<const float> World::Calls::density_errors() const {
  return impl_->density_errors.get(particle_count(), [&](auto error) {
    impl_->full_support.valid = false;
    impl_->full_support.get(particle_count(), [&](auto full) {
      impl_->measured = impl_->with_all().read_density_errors(error, full);
    });
  });
}

std::span<const float> World::Calls::pressures() const {
  return impl_->pressures.get(particle_count(),
                              [&](auto out) { impl_->engine->read_pressures(out, impl_->last_substep); });
}

std::span<const Ellipsoid> World::Calls::ellipsoids() const {
  return impl_->ellipsoids.get(particle_count(), [&](auto out) { impl_->with_all().read_ellipsoids(out); });
}

std::span<const DiffuseParticle> World::Calls::diffuse() const {
  return impl_->diffuse.get(impl_->engine->diffuse_count(),
                            [&](auto out) { impl_->engine->read_diffuse(out); });
}

std::shared_ptr<const void> World::Calls::hold(const void* first) const {
  std::shared_ptr<const void> owner;
  const auto try_each = [&](const auto&... readouts) {
    const auto try_one = [&](const auto& readout) {
      const auto& values = readout.array->values;
      if (readout.valid && !values.empty() && values.data() == first) owner = readout.hold();
    };
    (try_one(readouts), ...);
  };
  try_each(impl_->positions, impl_->velocities, impl_->fluid_indices, impl_->density_errors, impl_->pressures,
           impl_->ellipsoids, impl_->diffuse, impl_->outward_positions, impl_->outward_ellipsoids,
           impl_->outward_diffuse);
  if (!owner) throw Error(ErrorCode::not_found, "no read-out of particles begins at the address of hold");
  return owner;
}

SurfaceMesh World::Calls::surface_mesh(const SurfaceMeshDef& def) const {
  check::def(def);
  std::optional<uint32_t> group;
  if (def.fluid) {
    impl_->fluids.get(*def.fluid);
    group = def.fluid->index;
  }
  if (particle_count() == 0) return {};
  if (!impl_->surface)
    impl_->surface = fluid::calibrate_surface(impl_->def.particle_spacing, impl_->kernel.h);
  fluid::SurfaceField field = *impl_->surface;
  field.cell = def.cell_size * impl_->def.particle_spacing;
  field.iso *= def.level;
  return impl_->with_all().read_surface(field, group);
}

Diagnostics World::Calls::diagnostics() const {
  Diagnostics d = impl_->with_all().measure(impl_->def.gravity);
  const std::span<const float> error = density_errors();
  const std::vector<float>& full = impl_->full_support.array->values;
  double over = 0, interior = 0, interior_count = 0;
  for (size_t i = 0; i < error.size(); ++i) {
    over += std::max(error[i], 0.0f);
    d.density_error_max = std::max<double>(d.density_error_max, error[i]);
    interior += full[i] > 0 ? std::fabs(error[i]) : 0;
    interior_count += full[i];
  }
  if (!error.empty()) {
    d.density_error_mean = over / static_cast<double>(error.size());
    d.neighbours_mean = impl_->measured.neighbours_mean;
    d.contacts = impl_->measured.contacts;
    d.wall_overflows = impl_->measured.wall_overflows;
  }
  if (interior_count > 0) d.density_error_interior = interior / interior_count;
  return d;
}

namespace {

/// The vector of a probe in the user's frame, 0 without particles.
std::array<double, 3> exact_vector(const fluid::ProbeSum& value, ProbeKind kind, Vec3 origin) {
  const bool is_place = kind == ProbeKind::fluid_centre && (value.x != 0 || value.y != 0 || value.z != 0);
  if (!is_place) origin = {0, 0, 0};
  return {value.x + origin.x, value.y + origin.y, value.z + origin.z};
}

}  // namespace

Vec3 World::Calls::probe_vector(ProbeId id) const {
  const ProbeKind kind = impl_->probes.get(id).kind;
  if (!is_vector(kind)) return {0, 0, 0};
  const std::array<double, 3> v = exact_vector(impl_->probe_values[id.index], kind, impl_->origin.at());
  return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
}

double World::Calls::probe(ProbeId id) const {
  const ProbeDef& def = impl_->probes.get(id);
  const fluid::ProbeSum& value = impl_->probe_values[id.index];
  const std::array<double, 3> v = exact_vector(value, def.kind, impl_->origin.at());
  const double size = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  if (def.kind == ProbeKind::wall_pressure) return size / def.area;
  return is_vector(def.kind) ? size : value.value;
}

uint64_t World::Calls::state_hash() const {
  uint64_t sum = impl_->engine->hash_particles();
  impl_->fetch_cloth();
  const auto add_vertices = [&](HashedKind kind) {
    return [&sum, kind](uint32_t owner, const auto& entry) {
      const auto& state = entry.range.state;
      for (size_t v = 0; v < state.positions.size(); ++v)
        sum += element_hash(kind, owner, v, state.positions[v], state.velocities[v]);
    };
  };
  impl_->cloths.for_each(add_vertices(HashedKind::cloth));
  impl_->ropes.for_each(add_vertices(HashedKind::rope));
  return sum + hash_bodies(impl_->bodies, impl_->rigid);
}

size_t World::Calls::device_bytes() const {
  return impl_->engine->device().memory().bytes;
}

std::vector<MemoryShare> World::Calls::memory_shares() const {
  std::vector<MemoryShare> shares;
  for (const auto& [what, bytes] : impl_->with_all().device().held()) {
    if (bytes > 0) shares.push_back({what, bytes});
  }
  std::stable_sort(shares.begin(), shares.end(),
                   [](const MemoryShare& a, const MemoryShare& b) { return a.bytes > b.bytes; });
  return shares;
}

MemoryStats World::Calls::memory_stats() const {
  const pbd::Device& device = impl_->engine->device();
  return {device.memory(), device.shared_memory()};
}

}  // namespace meniscus
