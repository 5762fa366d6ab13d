// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// World's calls that make and attach cloth and ropes.
#include <meniscus/error.h>
#include <meniscus/world.h>

#include <algorithm>
#include <utility>

#include "sdk/world/check/check.h"
#include "sdk/world/check/periodic.h"
#include "sdk/world/world_calls.h"

namespace meniscus {

namespace {

std::vector<uint32_t> chosen_vertices(const AttachmentDef& def, const VertexRange& range) {
  std::vector<uint32_t> vertices = def.vertices;
  for (uint32_t v : vertices) {
    if (v >= range.count()) {
      check::refuse("a vertex of AttachmentDef::vertices", std::to_string(v),
                    "below " + std::to_string(range.count()) + ", the number of vertices");
    }
  }
  for (uint32_t v = 0; def.region && v < range.count(); ++v) {
    if (inside(*def.region, range.state.positions[v])) vertices.push_back(v);
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  if (vertices.empty()) {
    throw Error(ErrorCode::invalid_argument,
                "AttachmentDef::region of \"" + def.name + "\" holds no vertex of its cloth or rope");
  }
  return vertices;
}

/// Seams from each vertex to the nearest one of the other piece within reach, at their present distance.
std::vector<cloth::EdgeConstraint> sew(const AttachmentDef& def, const VertexRange& range,
                                       const VertexRange& other, std::span<const uint32_t> vertices) {
  std::vector<cloth::EdgeConstraint> seams;
  for (uint32_t v : vertices) {
    cloth::EdgeConstraint nearest{v, 0, def.reach, def.compliance};
    bool found = false;
    for (uint32_t u = 0; u < other.count(); ++u) {
      if (&other == &range && u == v) continue;
      const float gap = length(other.state.positions[u] - range.state.positions[v]);
      if (gap > nearest.rest_length) continue;
      found = true;
      nearest.b = u;
      nearest.rest_length = gap;
    }
    if (found) seams.push_back(nearest);
  }
  if (seams.empty()) {
    const std::string none =
        &other == &range ? "no other vertex of the same piece" : "no vertex of the other piece";
    throw Error(ErrorCode::invalid_argument, "AttachmentDef::reach of \"" + def.name + "\" is " +
                                                 std::to_string(def.reach) + " m; " + none + " is as near");
  }
  return seams;
}

}  // namespace

const VertexRange& World::Impl::range_of(const AttachmentDef& a) const {
  return a.cloth ? cloths.get(*a.cloth).range : ropes.get(*a.rope).range;
}

template <class Gone>
void World::Impl::drop_attachments(const Gone& gone) {
  std::vector<AttachmentId> dropped;
  dropped.reserve(attachments.size());
  attachments.for_each([&](uint32_t index, const AttachmentEntry& entry) {
    if (gone(entry.def)) dropped.push_back(attachments.id(index));
  });
  for (AttachmentId id : dropped) attachments.erase(id);
}

/// A vertex names its piece with as many bits as a particle names its fluid.
void World::Impl::check_pieces() const {
  if (cloths.size() + ropes.size() <= pbd::phase_group_mask) return;
  throw Error(ErrorCode::capacity, "a world has no room for more than 65536 pieces of cloth and ropes");
}

ClothId World::Calls::create_cloth(const ClothDef& def) {
  check::no_periodic_axes(impl_->def, "cloth");
  impl_->check_solver_allows("cloth");
  impl_->check_pieces();
  ClothEntry entry = make_cloth(def, impl_->def.read_file, impl_->time);
  if (entry.track) check_driven_room(impl_->cloths, entry.track->positions.size());
  impl_->cloths.prepare();
  impl_->cloth_changed();
  return impl_->cloths.insert(std::move(entry));
}

void World::Calls::destroy_cloth(ClothId id) {
  impl_->cloths.get(id);
  impl_->cloth_changed();
  impl_->drop_attachments([&](const AttachmentDef& a) { return a.cloth == id || a.other_cloth == id; });
  impl_->cloths.erase(id);
  std::erase_if(impl_->tears, [&](const TearEvent& t) { return t.cloth == id; });
}

RopeId World::Calls::create_rope(const RopeDef& def) {
  check::no_periodic_axes(impl_->def, "ropes");
  impl_->check_solver_allows("ropes");
  impl_->check_pieces();
  RopeEntry entry = make_rope(def);
  impl_->cloth_changed();
  return impl_->ropes.insert(std::move(entry));
}

void World::Calls::destroy_rope(RopeId id) {
  impl_->ropes.get(id);
  impl_->cloth_changed();
  impl_->drop_attachments([&](const AttachmentDef& a) { return a.rope == id || a.other_rope == id; });
  impl_->ropes.erase(id);
}

AttachmentId World::Calls::create_attachment(const AttachmentDef& def) {
  check::def(def);
  impl_->fetch_cloth();
  AttachmentEntry entry;
  entry.def = def;
  if (def.cloth && !def.other_cloth && !def.other_rope && impl_->cloths.get(*def.cloth).track)
    throw Error(ErrorCode::invalid_argument,
                "AttachmentDef::cloth of \"" + def.name +
                    "\" is a driven surface, which moves by its keyframes; other cloth can be sewn to it");
  const VertexRange& range = impl_->range_of(def);
  entry.vertices = chosen_vertices(def, range);
  if (def.other_cloth)
    entry.seams = sew(def, range, impl_->cloths.get(*def.other_cloth).range, entry.vertices);
  if (def.other_rope) entry.seams = sew(def, range, impl_->ropes.get(*def.other_rope).range, entry.vertices);
  if (def.body) {
    const BodyEntry& body = impl_->bodies.get(*def.body);
    const Pose pose = impl_->rigid.pose(def.body->index) * body.principal;
    for (uint32_t v : entry.vertices) entry.anchors.push_back(to_local(pose, range.state.positions[v]));
  }
  if (def.clamped) {
    if (!def.rope || !impl_->ropes.get(*def.rope).def.bends_and_twists)
      throw Error(ErrorCode::invalid_argument, "AttachmentDef::clamped is for rods alone");
    if (def.body || !entry.seams.empty())
      throw Error(ErrorCode::invalid_argument, "AttachmentDef::clamped holds a rod to the world alone");
    const auto& segments = impl_->ropes.get(*def.rope).model.segments;
    const auto chosen = [&](uint32_t v) {
      return std::binary_search(entry.vertices.begin(), entry.vertices.end(), v);
    };
    for (uint32_t s = 0; s < segments.size(); ++s) {
      if (chosen(segments[s].a) && chosen(segments[s].b)) entry.clamped.push_back(s);
    }
  }
  impl_->cloth_changed();
  return impl_->attachments.insert(std::move(entry));
}

void World::Calls::destroy_attachment(AttachmentId id) {
  impl_->attachments.get(id);
  impl_->cloth_changed();
  impl_->attachments.erase(id);
}

void World::Calls::set_wind(const WindDef& def) {
  check::def(def);
  impl_->engine->set_wind(
      cloth::make_wind(def.velocity, def.air_density, def.gust_speed, def.gust_size, def.seed));
  impl_->air_density = def.air_density;
}

void World::Impl::drop_attachments_of(BodyId body) {
  std::vector<AttachmentId> its;
  attachments.for_each([&](uint32_t index, const AttachmentEntry& entry) {
    if (entry.def.body == body) its.push_back(attachments.id(index));
  });
  if (its.empty()) return;
  cloth_changed();  // the next search for contacts uploads it before
  for (const AttachmentId id : its) attachments.erase(id);
}

namespace {

void mark_held(const AttachmentEntry& a, std::vector<bool>& held) {
  if (a.def.body || a.def.other_cloth || a.def.other_rope) return;
  for (uint32_t v : a.vertices) held[v] = true;
}

}  // namespace

std::vector<bool> World::Impl::held_vertices(ClothId cloth) const {
  const ClothEntry& entry = cloths.get(cloth);
  std::vector<bool> fast(entry.range.count(), entry.track != nullptr);
  attachments.for_each([&](uint32_t, const AttachmentEntry& a) {
    if (a.def.cloth == cloth) mark_held(a, fast);
  });
  return fast;
}

/// Looks at each attachment once.
World::Impl::HeldParts World::Impl::find_held() const {
  HeldParts parts;
  const auto at = [](auto& table, uint32_t index) -> auto& {
    if (table.size() <= index) table.resize(index + 1);
    return table[index];
  };
  cloths.for_each([&](uint32_t n, const ClothEntry& e) {
    at(parts.of_cloth, n).resize(e.range.count(), e.track != nullptr);
  });
  ropes.for_each([&](uint32_t n, const RopeEntry& e) {
    at(parts.of_rope, n).resize(e.range.count());
    at(parts.clamped, n).resize(e.segments.size());
  });
  attachments.for_each([&](uint32_t, const AttachmentEntry& a) {
    mark_held(a, a.def.cloth ? parts.of_cloth[a.def.cloth->index] : parts.of_rope[a.def.rope->index]);
    for (uint32_t s : a.clamped) parts.clamped[a.def.rope->index][s] = true;
  });
  return parts;
}

}  // namespace meniscus
