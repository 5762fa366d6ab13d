// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// World's read-outs of cloth and ropes.
#include <meniscus/world.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "sdk/world/cloth/cloth_texture.h"
#include "sdk/world/world_calls.h"

namespace meniscus {

namespace {

/// The mean of the normals of a vertex's triangles, with the weights of Max (1999), which are exact on a
/// sphere. With weights by area, normals would lean towards the diagonals, and folds would look rippled.
std::vector<Vec3> vertex_normals(const cloth::ClothMesh& mesh, std::span<const Vec3> x) {
  std::vector<Vec3> normals(x.size(), {0, 0, 0});
  for (const auto& t : mesh.triangles) {
    for (size_t k = 0; k < 3; ++k) {
      const Vec3 a = x[t[(k + 1) % 3]] - x[t[k]], b = x[t[(k + 2) % 3]] - x[t[k]];
      const float weight = dot(a, a) * dot(b, b);
      if (weight > 0) normals[t[k]] += cross(a, b) / weight;
    }
  }
  for (Vec3& n : normals) n = normalized_or(n, {0, 1, 0});
  return normals;
}

/// The largest principal stretch of a triangle less 1, from the map of its rest plane to its present place.
float principal_strain(const Vec3 rest[3], const Vec3 now[3]) {
  const Vec3 a = rest[1] - rest[0], b = rest[2] - rest[0];
  const float ax = length(a), bx = dot(a, b) / ax, by = length(cross(a, b)) / ax;
  const Vec3 u = (now[1] - now[0]) / ax;
  const Vec3 v = (now[2] - now[0] - bx * u) / by;
  const double uu = dot(u, u), vv = dot(v, v), uv = dot(u, v);
  const double largest = 0.5 * (uu + vv) + std::sqrt(0.25 * (uu - vv) * (uu - vv) + uv * uv);
  return static_cast<float>(std::sqrt(largest) - 1);
}

}  // namespace

std::span<const Vec3> World::Calls::cloth_positions(ClothId id) const {
  impl_->fetch_cloth();
  return impl_->cloths.get(id).range.state.positions;
}

std::span<const Vec3> World::Calls::outward_positions(ClothId id) const {
  return meniscus::outward(impl_->origin, cloth_positions(id), impl_->cloths.edit(id).outward);
}

std::span<const Vec3> World::Calls::outward_positions(RopeId id) const {
  return meniscus::outward(impl_->origin, rope_positions(id), impl_->ropes.edit(id).outward);
}

std::span<const Vec3> World::Calls::cloth_velocities(ClothId id) const {
  impl_->fetch_cloth();
  return impl_->cloths.get(id).range.state.velocities;
}

std::span<const Vec3> World::Calls::cloth_normals(ClothId id) const {
  impl_->fetch_cloth();
  ClothEntry& entry = impl_->cloths.edit(id);
  if (entry.normals.empty()) entry.normals = vertex_normals(entry.mesh, entry.range.state.positions);
  return entry.normals;
}

std::span<const uint32_t> World::Calls::cloth_triangles(ClothId id) const {
  const auto& triangles = impl_->cloths.get(id).mesh.triangles;
  return {triangles.front().data(), 3 * triangles.size()};
}

std::span<const TexturePoint> World::Calls::cloth_texture(ClothId id) const {
  ClothEntry& entry = impl_->cloths.edit(id);
  if (!entry.texture) entry.texture = texture_of(entry, impl_->def.read_file);
  return *entry.texture;
}

uint32_t World::Calls::cloth_welded_vertices(ClothId id) const {
  return impl_->cloths.get(id).welded;
}

float World::Calls::cloth_bending_fraction(ClothId id) const {
  impl_->cloths.get(id);
  const std::vector<float>& fractions = impl_->engine->bending_fractions();
  const auto piece = std::find(impl_->pieces.begin(), impl_->pieces.end(), id) - impl_->pieces.begin();
  return static_cast<size_t>(piece) < fractions.size() ? fractions[static_cast<size_t>(piece)] : 1;
}

std::span<const float> World::Calls::cloth_strains(ClothId id) const {
  impl_->fetch_cloth();
  ClothEntry& entry = impl_->cloths.edit(id);
  if (!entry.strains.empty()) return entry.strains;
  const std::vector<Vec3>&rest = entry.mesh.vertices, &now = entry.range.state.positions;
  for (const auto& t : entry.mesh.triangles) {
    const Vec3 before[] = {rest[t[0]], rest[t[1]], rest[t[2]]}, after[] = {now[t[0]], now[t[1]], now[t[2]]};
    entry.strains.push_back(principal_strain(before, after));
  }
  return entry.strains;
}

std::span<const float> World::Calls::cloth_wetness(ClothId id) const {
  ClothEntry& entry = impl_->cloths.edit(id);
  if (!entry.wetness.empty()) return entry.wetness;
  const FabricDef& f = entry.def.fabric;
  entry.wetness.resize(entry.range.count());
  for (size_t v = 0; v < entry.water.size(); ++v) {
    const double capacity = double{entry.constraints.masses[v]} / double{f.density} * double{f.absorbency};
    entry.wetness[v] = static_cast<float>(entry.water[v] / capacity);
  }
  return entry.wetness;
}

ClothState World::Calls::cloth_state(ClothId id) const {
  impl_->fetch_cloth();
  const ClothEntry& entry = impl_->cloths.get(id);
  const std::vector<Vec3>&x = entry.range.state.positions, &v = entry.range.state.velocities;
  ClothState state;
  state.closed = entry.closed;
  double mass = 0, kinetic = 0, sums[6] = {};
  for (uint32_t i = 0; i < entry.range.count(); ++i) {
    const double m = entry.range.masses[i];
    mass += m;
    kinetic += 0.5 * m * double{dot(v[i], v[i])};
    const double parts[6] = {x[i].x, x[i].y, x[i].z, v[i].x, v[i].y, v[i].z};
    for (int k = 0; k < 6; ++k) sums[k] += m * parts[k];
  }
  const auto vector = [](const double* from, double scale) {
    return Vec3{static_cast<float>(scale * from[0]), static_cast<float>(scale * from[1]),
                static_cast<float>(scale * from[2])};
  };
  state.mass = static_cast<float>(mass);
  state.fluid_mass = static_cast<float>(std::accumulate(entry.water.begin(), entry.water.end(), 0.0));
  state.centre = vector(sums, 1 / mass);
  state.momentum = vector(sums + 3, 1);
  state.kinetic_energy = static_cast<float>(kinetic);
  double area = 0, strain = 0, most = 0;
  for (const auto& t : entry.mesh.triangles) {
    const std::vector<Vec3>& rest = entry.mesh.vertices;
    area += 0.5 * double{length(cross(rest[t[1]] - rest[t[0]], rest[t[2]] - rest[t[0]]))};
    for (int k = 0; k < 3; ++k) {
      const uint32_t a = t[k], b = t[(k + 1) % 3];
      const double stretch = double{length(x[b] - x[a])} / length(rest[b] - rest[a]);
      strain += std::fabs(stretch - 1);
      most = std::max(most, stretch);
    }
  }
  state.area = static_cast<float>(area);
  state.mean_stretch = static_cast<float>(strain / (3.0 * static_cast<double>(entry.mesh.triangles.size())));
  state.max_stretch = static_cast<float>(most);
  if (entry.closed) state.volume = enclosed_volume(entry.mesh, x);
  if (entry.closed && entry.def.inflation) {
    const InflationDef& gas = *entry.def.inflation;
    const float fills = entry.rest_volume * (1 + gas.pressure / gas.air_pressure);
    state.pressure = gas.air_pressure * (fills - state.volume) / entry.rest_volume;
  }
  return state;
}

const std::vector<TearEvent>& World::Calls::tear_events() const {
  return impl_->tears;
}

std::span<const Vec3> World::Calls::rope_positions(RopeId id) const {
  impl_->fetch_cloth();
  return impl_->ropes.get(id).range.state.positions;
}

std::span<const Vec3> World::Calls::rope_velocities(RopeId id) const {
  impl_->fetch_cloth();
  return impl_->ropes.get(id).range.state.velocities;
}

std::span<const Quat> World::Calls::rope_frames(RopeId id) const {
  impl_->fetch_cloth();
  RopeEntry& entry = impl_->ropes.edit(id);
  entry.frames.clear();
  for (const cloth::SegmentState& s : entry.segments) entry.frames.push_back(s.frame);
  return entry.frames;
}

std::vector<uint32_t> World::Calls::attachment_vertices(AttachmentId id) const {
  return impl_->attachments.get(id).vertices;
}

Vec3 World::Calls::attachment_force(AttachmentId id) const {
  impl_->attachments.get(id);
  impl_->read_reactions();
  return impl_->attachments.get(id).force;
}

void World::Impl::read_reactions() {
  if (reactions_known) return;
  const std::vector<Vec3> on_held = engine->read_reactions(),
                          on_attachments = engine->read_attachment_impulses();
  attachments.for_each([&](uint32_t, AttachmentEntry& entry) {
    entry.force = {0, 0, 0};
    if (!entry.seams.empty() || entry.first_attachment == pbd::no_index) return;
    const VertexRange& range = range_of(entry.def);
    for (size_t k = 0; k < entry.anchors.size(); ++k)
      entry.force -= on_attachments[entry.first_attachment + k] / last_step;
    for (uint32_t v : entry.vertices) {
      const auto at = std::lower_bound(held.begin(), held.end(), range.first + v);
      if (at == held.end() || *at != range.first + v) continue;
      // A held vertex carries its own fraction of the cloth as well.
      entry.force +=
          on_held[static_cast<size_t>(at - held.begin())] / last_step + range.masses[v] * def.gravity;
    }
  });
  reactions_known = true;
}

void World::Impl::forget_reactions() {
  attachments.for_each([](uint32_t, AttachmentEntry& entry) { entry.force = {0, 0, 0}; });
  reactions_known = true;
}

std::string World::Impl::name_particle(uint32_t slot) const {
  if (!pbd::is_vertex_slot(slot)) return "number " + std::to_string(ids[slot]);
  const uint32_t vertex = slot - pbd::vertex_slot;
  std::string name;
  const auto look = [&](const char* what, const auto& entry) {
    const VertexRange& s = entry.range;
    if (vertex >= s.first && vertex < s.first + s.count())
      name = "vertex " + std::to_string(vertex - s.first) + " of the " + what + " \"" + entry.def.name + "\"";
  };
  cloths.for_each([&](uint32_t, const ClothEntry& entry) { look("cloth", entry); });
  ropes.for_each([&](uint32_t, const RopeEntry& entry) { look("rope", entry); });
  return name;
}

}  // namespace meniscus
