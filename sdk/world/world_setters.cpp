// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// World's calls that set positions and velocities of particles, cloth and ropes.
#include <meniscus/error.h>
#include <meniscus/world.h>

#include <algorithm>
#include <numeric>
#include <string>

#include "sdk/world/check/check.h"
#include "sdk/world/check/periodic.h"
#include "sdk/world/crowding.h"
#include "sdk/world/world_calls.h"

namespace meniscus {

namespace {

/// What a call sets.
struct Setter {
  const char* call;
  const char* value;   ///< of one thing, for errors
  const char* values;  ///< of several
  const char* unit;
};

constexpr Setter particle_positions{"set_positions", "a position of set_positions", "positions", "m"};
constexpr Setter particle_velocities{"set_velocities", "a velocity of set_velocities", "velocities", "m/s"};
constexpr Setter cloth_positions_of{"set_cloth_positions", "a position of set_cloth_positions", "positions",
                                    "m"};
constexpr Setter cloth_velocities_of{"set_cloth_velocities", "a velocity of set_cloth_velocities",
                                     "velocities", "m/s"};
constexpr Setter rope_positions_of{"set_rope_positions", "a position of set_rope_positions", "positions",
                                   "m"};
constexpr Setter rope_velocities_of{"set_rope_velocities", "a velocity of set_rope_velocities", "velocities",
                                    "m/s"};

/// The squares of larger values, and what steps make of them, would not be finite.
constexpr double most = 1e9;

void check_values(const Setter& setter, std::span<const Vec3> values, std::size_t count, const char* of) {
  if (values.size() != count) {
    throw Error(ErrorCode::invalid_argument,
                std::string(setter.call) + " got " + std::to_string(values.size()) + " " + setter.values +
                    " for " + std::to_string(count) + " " + of + "; it takes one for each");
  }
  for (const Vec3 v : values) check::value(setter.value, v, between(-most, most), setter.unit);
}

std::vector<uint32_t> all_slots(std::size_t count) {
  std::vector<uint32_t> slots(count);
  std::iota(slots.begin(), slots.end(), 0u);
  return slots;
}

/// Values by slot, in the order of the slots.
struct BySlot {
  std::vector<uint32_t> slots;
  std::vector<Vec3> values;
};

BySlot by_slot(const Setter& setter, std::span<const ParticleId> present, std::span<const ParticleId> ids,
               std::span<const Vec3> values) {
  std::vector<uint32_t> order = all_slots(ids.size());
  std::ranges::sort(order, {}, [&](uint32_t k) { return ids[k]; });
  BySlot sorted;
  for (std::size_t k = 0; k < order.size(); ++k) {
    const ParticleId id = ids[order[k]];
    if (k > 0 && ids[order[k - 1]] == id)
      throw Error(ErrorCode::invalid_argument,
                  std::string(setter.call) + " got the particle " + std::to_string(id) + " twice");
    const auto at = std::ranges::lower_bound(present, id);
    if (at == present.end() || *at != id)
      throw Error(ErrorCode::not_found, "no particle has the id " + std::to_string(id));
    sorted.slots.push_back(static_cast<uint32_t>(at - present.begin()));
    sorted.values.push_back(values[order[k]]);
  }
  return sorted;
}

/// Positions of the particles in no slot of `slots`, which ascend.
std::vector<Vec3> others(std::span<const Vec3> positions, std::span<const uint32_t> slots) {
  std::vector<Vec3> rest;
  auto next = slots.begin();
  for (uint32_t slot = 0; slot < positions.size(); ++slot) {
    if (next != slots.end() && *next == slot)
      ++next;
    else
      rest.push_back(positions[slot]);
  }
  return rest;
}

/// Its keyframes alone move a driven surface.
void check_free(const ClothEntry& entry, const Setter& setter) {
  if (!entry.track) return;
  throw Error(ErrorCode::invalid_argument, std::string(setter.call) + " got \"" + entry.def.name +
                                               "\", a driven surface, which moves by its keyframes");
}

}  // namespace

// ---- particles ----

std::vector<uint32_t> World::Calls::slots_of(FluidId fluid) const {
  impl_->fluids.get(fluid);
  const std::span<const uint32_t> groups = fluids();
  std::vector<uint32_t> slots;
  for (uint32_t slot = 0; slot < groups.size(); ++slot) {
    if (groups[slot] == fluid.index) slots.push_back(slot);
  }
  return slots;
}

void World::Impl::place(std::span<const uint32_t> slots, std::span<const Vec3> places,
                        const std::function<std::vector<Vec3>()>& others) {
  if (slots.empty()) return;
  check::between_seams(periodic_axes(def.periodic), places, particle_positions.value);
  uint64_t bound = slots.size() == ids.size() ? 0 : crowding_bound;
  std::vector<Vec3> rest;
  check_crowding(
      bound, places, [&]() -> std::span<const Vec3> { return rest = others(); }, kernel.h,
      particle_positions.call);
  upload_materials();
  engine->place_particles(slots, places);
  crowding_bound = bound;
  state_changed();
}

void World::Calls::set_positions(std::span<const Vec3> positions) {
  check_values(particle_positions, positions, impl_->ids.size(), "particles");
  impl_->place(all_slots(positions.size()), positions, [] { return std::vector<Vec3>(); });
}

void World::Calls::set_positions(FluidId fluid, std::span<const Vec3> positions) {
  const std::vector<uint32_t> slots = slots_of(fluid);
  check_values(particle_positions, positions, slots.size(), "particles of the fluid");
  impl_->place(slots, positions, [&] { return others(this->positions(), slots); });
}

void World::Calls::set_positions(std::span<const ParticleId> ids, std::span<const Vec3> positions) {
  check_values(particle_positions, positions, ids.size(), "ids");
  const BySlot sorted = by_slot(particle_positions, impl_->ids, ids, positions);
  impl_->place(sorted.slots, sorted.values, [&] { return others(this->positions(), sorted.slots); });
}

void World::Impl::set_particle_velocities(std::span<const uint32_t> slots, std::span<const Vec3> values) {
  if (slots.empty()) return;
  engine->set_particle_velocities(slots, values);
  velocities.valid = false;
}

void World::Calls::set_velocities(std::span<const Vec3> velocities) {
  check_values(particle_velocities, velocities, impl_->ids.size(), "particles");
  impl_->set_particle_velocities(all_slots(velocities.size()), velocities);
}

void World::Calls::set_velocities(FluidId fluid, std::span<const Vec3> velocities) {
  const std::vector<uint32_t> slots = slots_of(fluid);
  check_values(particle_velocities, velocities, slots.size(), "particles of the fluid");
  impl_->set_particle_velocities(slots, velocities);
}

void World::Calls::set_velocities(std::span<const ParticleId> ids, std::span<const Vec3> velocities) {
  check_values(particle_velocities, velocities, ids.size(), "ids");
  const BySlot sorted = by_slot(particle_velocities, impl_->ids, ids, velocities);
  impl_->set_particle_velocities(sorted.slots, sorted.values);
}

// ---- cloth and ropes ----

/// The next use uploads all cloth, which then starts afresh.
void World::Impl::place_vertices(VertexRange& range, std::span<const Vec3> places) {
  cloth_changed();
  std::ranges::copy(places, range.state.positions.begin());
  range.placed = true;
}

/// The device keeps held vertices at rest.
void World::Impl::set_vertex_velocities(VertexRange& range, std::span<const Vec3> changed) {
  with_all();
  fetch_cloth();
  cloth_is_on_host = false;
  std::ranges::copy(changed, range.state.velocities.begin());
  weigh(range);
}

void World::Calls::set_cloth_positions(ClothId id, std::span<const Vec3> positions) {
  ClothEntry& entry = impl_->cloths.edit(id);
  check_free(entry, cloth_positions_of);
  check_values(cloth_positions_of, positions, entry.range.count(), "vertices of the cloth");
  impl_->place_vertices(entry.range, positions);
  entry.normals.clear();
  entry.strains.clear();
}

void World::Calls::set_cloth_velocities(ClothId id, std::span<const Vec3> velocities) {
  ClothEntry& entry = impl_->cloths.edit(id);
  check_free(entry, cloth_velocities_of);
  check_values(cloth_velocities_of, velocities, entry.range.count(), "vertices of the cloth");
  impl_->set_vertex_velocities(entry.range, velocities);
}

void World::Calls::set_rope_positions(RopeId id, std::span<const Vec3> positions) {
  RopeEntry& entry = impl_->ropes.edit(id);
  check_values(rope_positions_of, positions, entry.range.count(), "vertices of the rope");
  impl_->place_vertices(entry.range, positions);
  for (std::size_t s = 0; s < entry.segments.size(); ++s) {
    const cloth::RodSegment& segment = entry.model.segments[s];
    const std::vector<Vec3>& x = entry.range.state.positions;
    entry.segments[s].frame = cloth::turned_frame(entry.segments[s].frame, x[segment.b] - x[segment.a]);
  }
}

void World::Calls::set_rope_velocities(RopeId id, std::span<const Vec3> velocities) {
  RopeEntry& entry = impl_->ropes.edit(id);
  check_values(rope_velocities_of, velocities, entry.range.count(), "vertices of the rope");
  impl_->set_vertex_velocities(entry.range, velocities);
}

}  // namespace meniscus
