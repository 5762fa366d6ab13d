// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Uploads the cloth and ropes of a world to the device, and fetches their state.
#include <meniscus/error.h>

#include <algorithm>
#include <utility>

#include "cloth/build/merge.h"
#include "cloth/build/tearing.h"
#include "pbd/filter.h"
#include "sdk/world/tuning.h"
#include "sdk/world/world_impl.h"

namespace meniscus {

namespace {

constexpr float metre_of_water = 9806.65f;  // Pa

std::vector<uint32_t> numbers_of(const std::vector<bool>& chosen) {
  std::vector<uint32_t> numbers;
  for (uint32_t v = 0; v < chosen.size(); ++v) {
    if (chosen[v]) numbers.push_back(v);
  }
  return numbers;
}

/// Assembles all pieces of a world.
class Assembly {
 public:
  EngineCloth cloth;
  std::vector<ClothId> pieces;

  uint32_t vertices() const { return static_cast<uint32_t>(cloth.position.size()); }

  /// `fluids`: the collision filter of each fluid.
  Assembly(const WorldDef& def, std::vector<CollisionFilter> fluids)
      : spacing_(def.particle_spacing), radius_(def.contact_radius), fluids_(std::move(fluids)) {}

  void add(ClothId id, ClothEntry& entry, const std::vector<bool>& held) {
    const uint32_t first = add_range(entry.range, held, entry.track != nullptr);
    const FabricDef& fabric = entry.def.fabric;
    pieces.push_back(id);
    const float distance = std::max(radius_ * spacing_, 0.5f * entry.thickness);
    cloth.sheets.push_back({.filter = entry.def.filter,
                            .radius = distance,
                            .friction = fabric.fluid_friction,
                            .adhesion = fabric.fluid_adhesion * spacing_ * spacing_,
                            .spread = spread_on(entry),
                            .flow = fabric.permittivity / (metre_of_water * spacing_ * spacing_ * spacing_),
                            .absorbs = fabric.absorbency > 0,
                            .slip_length = fabric.slip_length});
    cloth::ClothModel& model = cloth.model;
    const auto part = static_cast<uint32_t>(model.pieces.size());
    constraints_.push_back(entry.constraints);
    for (const auto& t : entry.mesh.triangles)
      model.triangles.push_back({first + t[0], first + t[1], first + t[2], part});
    model.rest.insert(model.rest.end(), entry.mesh.vertices.begin(), entry.mesh.vertices.end());
    model.pieces.push_back(piece_of(entry));
    cloth.contact_pieces.push_back({entry.thickness, entry.def.fabric.friction, entry.def.filter,
                                    entry.def.self_collision && !entry.track});
    if (entry.def.tethers && !entry.track) {
      attach_to_held(entry, numbers_of(held));
      for (const cloth::Tether& t : entry.tethers)
        model.tethers.push_back(
            {first + t.vertex, first + t.anchor, t.length, t.compliance, entry.range.masses[t.vertex]});
    }
  }

  void add(RopeEntry& entry, const std::vector<bool>& held, const std::vector<bool>& clamped) {
    const uint32_t first = add_range(entry.range, held);
    pieces.emplace_back();
    cloth.sheets.emplace_back();
    const bool rod = entry.def.bends_and_twists;
    cloth::append(rod ? cloth.rods : cloth.ropes, entry.model, first);
    rope_masses_.insert(rope_masses_.end(), entry.range.masses.begin(), entry.range.masses.end());
    cloth.model.rest.insert(cloth.model.rest.end(), entry.range.state.positions.begin(),
                            entry.range.state.positions.end());
    cloth.model.pieces.push_back(
        {.first_vertex = first, .end_vertex = vertices(), .stretch_damping = -1, .bending_damping = -1});
    cloth.contact_pieces.push_back({.filter = {0, 0}, .self = false});
    for (size_t s = 0; s < entry.segments.size(); ++s) {
      entry.segments[s].held = clamped[s];
      cloth.segments.push_back(entry.segments[s]);
    }
  }

  void finish(std::span<const cloth::EdgeConstraint> seams) {
    cloth::ClothConstraints& all = cloth.model.constraints;
    all = cloth::merge(constraints_);
    all.masses.insert(all.masses.end(), rope_masses_.begin(), rope_masses_.end());
    cloth::add_seams(all, seams);
    std::stable_sort(cloth.model.tethers.begin(), cloth.model.tethers.end(),
                     [](const cloth::Tether& a, const cloth::Tether& b) { return a.anchor < b.anchor; });
  }

 private:
  uint32_t add_range(VertexRange& range, const std::vector<bool>& held, bool driven = false) {
    const uint32_t first = vertices();
    const auto piece = static_cast<uint32_t>(cloth.touches.size());
    for (uint32_t v = 0; v < range.count(); ++v) {
      const bool fast = held[v];
      cloth.position.push_back(pbd::with_w(range.state.positions[v], fast ? 0 : 1 / range.masses[v]));
      cloth.velocity.push_back(pbd::with_w(fast && !driven ? Vec3{0, 0, 0} : range.state.velocities[v], 0));
      cloth.phase.push_back(pbd::phase_vertex | (range.placed ? pbd::phase_overlapping : 0) | piece);
      if (fast) cloth.model.held.push_back(first + v);
    }
    cloth.touches.push_back({range.filter, range.contact_radius});
    range.first = first;
    return first;
  }

  bool carries_fluid(const CollisionFilter& filter) const {
    return std::any_of(fluids_.begin(), fluids_.end(),
                       [&](const CollisionFilter& fluid) { return pbd::meet(filter, fluid); });
  }

  /// Large enough that every vertex between neighbouring particles gets its part, and small enough that no
  /// contact has too many vertices.
  float spread_on(const ClothEntry& entry) const {
    const float edge = mean_edge(entry.mesh);
    return edge < world_tuning::fine_mesh * spacing_
               ? std::min(std::max(world_tuning::least_spread * edge, spacing_),
                          world_tuning::most_spread * edge)
               : 0.0f;
  }

  cloth::Piece piece_of(const ClothEntry& entry) const {
    const FabricDef& f = entry.def.fabric;
    cloth::Piece piece{.first_vertex = entry.range.first,
                       .end_vertex = vertices(),
                       .stretch_damping = f.stretch_damping,
                       .bending_damping = f.bending_damping,
                       .drag = f.drag,
                       .lift = f.lift,
                       .tear_strain = f.tear_strain,
                       .carries_fluid = carries_fluid(entry.def.filter)};
    // Without constraints it has no part in the damping that all pieces have in common.
    if (entry.track) piece.stretch_damping = piece.bending_damping = -1;
    if (entry.def.inflation && entry.closed) {
      // p V is constant: at the outside pressure the gas would fill V₀ (1 + p/p_air).
      const InflationDef& gas = *entry.def.inflation;
      piece.inside = entry.rest_volume * (1 + gas.pressure / gas.air_pressure);
      piece.inside_compliance = entry.rest_volume / gas.air_pressure;
    }
    return piece;
  }

  std::vector<cloth::ClothConstraints> constraints_;
  std::vector<float> rope_masses_;
  float spacing_;  // m, of particles
  float radius_;   // contact radius, in spacings
  std::vector<CollisionFilter> fluids_;
};

}  // namespace

void World::Impl::cloth_changed() {
  fetch_cloth();
  cloth_is_on_device = false;
  state_changed();
}

void World::Impl::fetch_cloth() {
  if (cloth_is_on_host) return;
  VertexStates all{std::vector<Vec3>(vertex_count), std::vector<Vec3>(vertex_count)};
  engine->read_vertices(all.positions, all.velocities);
  const std::vector<cloth::SegmentState> segments = engine->read_segments();
  const auto take = [&](VertexRange& range) {
    const auto slice = [&](const std::vector<Vec3>& from, std::vector<Vec3>& to) {
      to.assign(from.begin() + range.first, from.begin() + range.first + range.count());
    };
    if (!range.uploaded) return;
    slice(all.positions, range.state.positions);
    slice(all.velocities, range.state.velocities);
  };
  cloths.for_each([&](uint32_t, ClothEntry& entry) {
    take(entry.range);
    entry.normals.clear();
    entry.strains.clear();
    entry.wetness.clear();
  });
  auto next = segments.begin();
  ropes.for_each([&](uint32_t, RopeEntry& entry) {
    take(entry.range);
    if (!entry.range.uploaded) return;
    std::copy_n(next, entry.segments.size(), entry.segments.begin());
    next += static_cast<std::ptrdiff_t>(entry.segments.size());
  });
  cloth_is_on_host = true;
}

void World::Impl::upload_cloth() {
  if (cloth_is_on_device) return;
  read_reactions();
  fetch_cloth();
  std::vector<CollisionFilter> filters;
  fluids.for_each([&](uint32_t, const ParticleMaterial& m) { filters.push_back(m.filter); });
  Assembly all(def, filters);
  HeldParts held_parts = find_held();
  cloths.for_each([&](uint32_t index, ClothEntry& entry) {
    all.add(cloths.id(index), entry, held_parts.of_cloth[index]);
  });
  ropes.for_each([&](uint32_t index, RopeEntry& entry) {
    all.add(entry, held_parts.of_rope[index], held_parts.clamped[index]);
  });
  std::vector<cloth::EdgeConstraint> seams;
  attachments.for_each([&](uint32_t, AttachmentEntry& a) {
    const uint32_t here = range_of(a.def).first;
    a.first_attachment = static_cast<uint32_t>(all.cloth.attachments.size());
    for (size_t k = 0; k < a.anchors.size(); ++k)
      all.cloth.attachments.push_back({here + a.vertices[k], a.def.body->index, a.anchors[k]});
    for (const cloth::EdgeConstraint& s : a.seams) {
      const uint32_t there = a.def.other_cloth ? cloths.get(*a.def.other_cloth).range.first
                                               : ropes.get(*a.def.other_rope).range.first;
      seams.push_back({here + s.a, there + s.b, s.rest_length, s.compliance});
    }
  });
  all.finish(seams);
  all.cloth.driven = driven_pieces(cloths);
  uploaded_cloth = std::make_shared<const EngineCloth>(std::move(all.cloth));
  set_engine_cloth();
  pieces = all.pieces;
  vertex_count = static_cast<uint32_t>(uploaded_cloth->position.size());
  held = uploaded_cloth->model.held;
  const auto note = [](uint32_t, auto& entry) { entry.range.uploaded = true; };
  cloths.for_each(note);
  ropes.for_each(note);
  cloth_is_on_device = true;
}

void World::Impl::set_engine_cloth() {
  static const EngineCloth none;
  const EngineCloth& cloth = uploaded_cloth ? *uploaded_cloth : none;
  engine->set_cloth(cloth);
  forces_are_on_device &= force_fields.size() == 0;
  rigid.keep_awake(attached_bodies(cloth));
}

void World::Impl::note_cloth_step(float dt) {
  tears.clear();
  if (vertex_count == 0) return;
  last_step = dt;
  cloth_is_on_host = false;
  reactions_known = false;
  const auto note = [](uint32_t, auto& entry) { entry.range.placed = false; };
  cloths.for_each(note);
  ropes.for_each(note);
}

void World::Impl::tear_cloth() {
  if (vertex_count == 0 || !engine->found_tears()) return;
  read_reactions();
  fetch_cloth();
  cloths.for_each([&](uint32_t index, ClothEntry& entry) {
    const float limit = entry.def.fabric.tear_strain;
    if (limit == 0) return;
    std::vector<cloth::OverstretchedEdge> edges;
    VertexRange& range = entry.range;
    for (const auto& t : entry.mesh.triangles) {
      for (int k = 0; k < 3; ++k) {
        const uint32_t a = t[k], b = t[(k + 1) % 3];
        const float stretch = length(range.state.positions[b] - range.state.positions[a]) /
                              length(entry.mesh.vertices[b] - entry.mesh.vertices[a]);
        if (stretch > 1 + limit) edges.push_back({std::min(a, b), std::max(a, b), stretch});
      }
    }
    const auto torn = cloth::tear_along(entry.mesh, range.state.positions, edges, world_tuning::most_splits);
    if (torn.empty()) return;
    cloth_is_on_device = false;
    for (const cloth::TornVertex& t : torn) {
      range.state.positions.push_back(range.state.positions[t.original]);
      range.state.velocities.push_back(range.state.velocities[t.original]);
      tears.push_back({cloths.id(index), t.copy, t.original});
      if (entry.water.empty()) continue;
      entry.water[t.original] *= 0.5;
      entry.water.push_back(entry.water[t.original]);
    }
    build_constraints(entry);
    for (size_t v = 0; v < entry.water.size(); ++v) range.masses[v] += static_cast<float>(entry.water[v]);
  });
}

}  // namespace meniscus
