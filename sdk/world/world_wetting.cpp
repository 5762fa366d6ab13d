// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Absorbent cloth takes up particles that touch it after a step, and drips.
#include <meniscus/world.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "sdk/world/cloth/cloth_water.h"
#include "sdk/world/tuning.h"
#include "sdk/world/world_impl.h"

namespace meniscus {

namespace {

double held_by(const ClothEntry& entry) {
  return std::accumulate(entry.water.begin(), entry.water.end(), 0.0);
}

}  // namespace

/// A piece that absorbs or holds water in this step.
struct World::Impl::WetPiece {
  ClothId id;
  FluidId fluid;
  ClothWater water;
  std::vector<uint32_t> dripping;
};

/// Reserves room for the drops, while the step may still fail.
void World::Impl::plan_dripping() {
  planned_drips = 0;
  double most = 0;
  cloths.for_each([&](uint32_t, const ClothEntry& entry) {
    if (entry.soaked_with) most += std::floor(held_by(entry) / particle_mass(*entry.soaked_with));
  });
  if (most == 0) return;
  check_room(ids.size(), most);
  planned_drips = static_cast<uint32_t>(most);
  engine->make_room(planned_drips);
}

double World::Impl::particle_mass(FluidId fluid) const {
  const float s = def.particle_spacing;
  return double{fluids.get(fluid).fluid.rest_density * s * s * s};
}

void World::Impl::wet_cloth(float dt, StepReport& report) {
  bool any = false, wet = false;
  cloths.for_each([&](uint32_t, const ClothEntry& entry) {
    any |= !entry.water.empty();
    wet |= entry.soaked_with.has_value();
  });
  if (!any) return;
  const std::vector<collision::WettingTouch> wetting = engine->read_wetting();
  if (wetting.empty() && !wet) return;
  read_reactions();  // while the cloth still has the masses of the step
  fetch_cloth();
  std::vector<WetPiece> wet_pieces;
  report.absorbed = take_up(wetting, wet_pieces);
  if (const float g = length(def.gravity); g > 0) {
    const Vec3 down = def.gravity / g;
    for (WetPiece& piece : wet_pieces) {
      piece.water.run_down(down, double{dt});
      piece.dripping = piece.water.dripping(down);
    }
    report.dripped = drip(down, wet_pieces);
  }
  for (WetPiece& piece : wet_pieces) {
    if (piece.water.finish() && cloth_is_on_device) weigh(cloths.get(piece.id).range);
  }
}

/// Moves particles into the pieces that they touch, in the order of their ids. Returns their number.
uint32_t World::Impl::take_up(std::span<const collision::WettingTouch> wetting, std::vector<WetPiece>& wet) {
  const auto at = velocities.get(ids.size(), [&](auto out) { engine->read_velocities(out); });
  const auto group = fluid_indices.get(ids.size(), [&](auto out) { engine->read_fluids(out); });
  std::vector<bool> removed(ids.size());
  uint32_t count = 0;
  cloths.for_each([&](uint32_t index, ClothEntry& entry) {
    const VertexRange& range = entry.range;
    if (entry.water.empty() || !range.uploaded) return;
    std::vector<collision::WettingTouch> own;
    for (const collision::WettingTouch& t : wetting) {
      if (t.vertex - range.first < range.count() && !removed[t.slot] &&
          !fluids.get(fluids.id(group[t.slot])).grain.is_grain)
        own.push_back(t);
    }
    if (!entry.soaked_with && own.empty()) return;
    const FluidId fluid = entry.soaked_with ? *entry.soaked_with : fluids.id(group[own.front().slot]);
    wet.push_back({cloths.id(index),
                   fluid,
                   ClothWater(entry, particle_mass(fluid), held_vertices(cloths.id(index))),
                   {}});
    for (const collision::WettingTouch& t : own) {
      if (group[t.slot] != fluid.index || !wet.back().water.take(t.vertex - range.first, at[t.slot]))
        continue;
      entry.soaked_with = fluid;
      removed[t.slot] = true;
      ++count;
    }
  });
  if (count == 0) return 0;
  std::vector<bool> keep = removed;
  keep.flip();
  engine->keep(keep);
  remove(removed);
  return count;
}

/// Releases drops from the lowest places with room beneath them. Returns their number.
uint32_t World::Impl::drip(Vec3 down, std::vector<WetPiece>& wet) {
  std::vector<Arrival> places;
  std::vector<Vec3> free;
  for (WetPiece& piece : wet) {
    const ClothEntry& entry = cloths.get(piece.id);
    // Below the cloth's contact distance; otherwise it would absorb the drop again.
    const float below = world_tuning::drop_distance *
                        std::max(def.contact_radius * def.particle_spacing, 0.5f * entry.thickness);
    piece.dripping.resize(std::min(piece.dripping.size(), planned_drips - places.size()));
    for (const uint32_t v : piece.dripping) {
      const Vec3 to = entry.range.state.positions[v] + below * down;
      places.push_back({to, to, {0, 0, 0}, fluids.get(piece.fluid).filter, 0});
      free.push_back(to);
    }
  }
  if (places.empty()) return 0;
  keep_off_cloth(free, CollisionFilter{});
  std::vector<uint8_t> has_room;
  engine->find_room(places, has_room);
  ParticleBatch drops;
  size_t next = 0, next_free = 0;
  for (WetPiece& piece : wet) {
    for (const uint32_t v : piece.dripping) {
      const size_t at = next++;
      if (next_free == free.size() || !(free[next_free] == places[at].to)) continue;
      ++next_free;
      if (!has_room[at]) continue;
      if (const auto velocity = piece.water.drip(v)) add_to(drops, piece.fluid, places[at].to, *velocity);
    }
  }
  append(drops);
  return static_cast<uint32_t>(drops.position.size());
}

void World::Impl::weigh(const VertexRange& range) {
  std::vector<float> weights;
  for (const float mass : range.masses) weights.push_back(1 / mass);
  engine->weigh_vertices(range.first, weights, range.state.velocities);
}

}  // namespace meniscus
