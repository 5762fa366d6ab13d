// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The items of a world's tables, besides the definitions.
#include "sdk/world/state/visit_tables.h"

#include <meniscus/error.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

namespace meniscus {

namespace {

using pbd::StateVisitor;

/// Visits ids with generations that count from 0.
class IdVisit {
 public:
  IdVisit(StateVisitor& v, uint32_t first_generation) : v_(v), first_(first_generation) {}

  /// A list of structs, whose ids `each(shift, item)` hands to shift(id).
  template <class T, class Each>
  void list(const char* name, std::vector<T>& values, const Each& each) const {
    std::vector<T> counted = values;
    if (!v_.restores()) shift_all(counted, each, 0u - first_);
    v_.list(name, counted);
    if (!v_.restores()) return;
    shift_all(counted, each, first_);
    values = std::move(counted);
  }
  template <class Id>
  void list(const char* name, std::vector<Id>& ids) const {
    list(name, ids, [](const auto& shift, Id& id) { shift(id); });
  }
  template <class Id>
  void optional(const char* name, std::optional<Id>& id) const {
    std::vector<Id> all;
    if (id) all.push_back(*id);
    list(name, all);
    if (v_.restores()) id = all.empty() ? std::nullopt : std::optional(all.front());
  }

 private:
  template <class T, class Each>
  static void shift_all(std::vector<T>& values, const Each& each, uint32_t by) {
    for (T& value : values) each([by](auto& id) { id.generation += by; }, value);
  }

  StateVisitor& v_;
  uint32_t first_;
};

template <class Constraint>
void visit_coloured(StateVisitor& v, const char* name, cloth::Coloured<Constraint>& c) {
  v.group(name, [&] {
    v.list("item", c.items);
    v.list("colour_start", c.colour_starts);
  });
}

void visit_rods(StateVisitor& v, const char* name, cloth::RodModel& rods) {
  v.group(name, [&] {
    v.list("chain", rods.chains);
    v.list("segment", rods.segments);
    v.list("frame", rods.frames);
    v.list("mass", rods.masses);
  });
}

void visit_range(StateVisitor& v, VertexRange& range) {
  v.list("position", range.state.positions);
  v.list("velocity", range.state.velocities);
  v.list("mass", range.masses);
  v.value("first", range.first);
  v.value("uploaded", range.uploaded);
  v.value("placed", range.placed);
  v.value("filter", range.filter);
  v.value("contact_radius", range.contact_radius);
}

/// What files may have, and the calls that make tracks refuse.
void check_track(const VertexTrack& track, size_t vertices) {
  const auto refuse = [](const std::string& why) {
    throw Error(ErrorCode::io, "the snapshot is not usable: the track of a driven surface " + why);
  };
  const auto is_no_time = [](double time) { return !std::isfinite(time); };
  if (track.times.empty()) refuse("has no times");
  if (std::ranges::any_of(track.times, is_no_time)) refuse("has a time that is not finite");
  if (!std::ranges::is_sorted(track.times, std::ranges::less_equal()))
    refuse("has times that do not increase");
  if (vertices == 0 || track.positions.size() % vertices != 0 ||
      track.positions.size() / vertices != track.times.size())
    refuse("has " + std::to_string(track.positions.size()) + " positions for " +
           std::to_string(track.times.size()) + " times and " + std::to_string(vertices) + " vertices");
}

/// Where a driven surface is over time. Its files need not be there when a snapshot is loaded.
void visit_track(StateVisitor& v, VertexTrackPtr& track) {
  VertexTrack visited;
  if (track) visited = *track;
  v.list("track_time", visited.times);
  v.list("track_position", visited.positions);
  v.value("track_loops", visited.loop);
  if (v.restores()) track = std::make_shared<const VertexTrack>(std::move(visited));
}

/// That of a file, which need not be there when a snapshot is loaded.
void visit_texture(StateVisitor& v, std::optional<std::vector<TexturePoint>>& texture) {
  if (v.restores() ? v.lacks("texture") : !texture) return;  // a file of 0.2: it is read when it is asked for
  if (v.restores()) texture.emplace();
  v.list("texture", *texture);
}

void visit_cloth(StateVisitor& v, const IdVisit& ids, ClothEntry& cloth) {
  if (is_driven(cloth.def.geometry)) visit_track(v, cloth.track);
  v.list("rest_position", cloth.mesh.vertices);
  v.list("triangle", cloth.mesh.triangles);
  v.list("material", cloth.mesh.material);
  if (std::holds_alternative<ClothFile>(cloth.def.geometry)) visit_texture(v, cloth.texture);
  v.value("thickness", cloth.thickness);
  v.value("rest_volume", cloth.rest_volume);
  v.value("welded", cloth.welded);
  if (v.restores()) build_constraints(cloth);  // its masses are dry, unlike those that follow
  visit_range(v, cloth.range);
  if (v.restores() && cloth.track) check_track(*cloth.track, cloth.range.count());
  v.list("water", cloth.water);
  ids.optional("soaked_with", cloth.soaked_with);
}

void visit_attachment(StateVisitor& v, AttachmentEntry& a) {
  v.list("vertex", a.vertices);
  v.list("anchor", a.anchors);
  v.value("first_attachment", a.first_attachment);
  v.list("seam", a.seams);
  v.list("clamped", a.clamped);
  v.value("force", a.force);
}

void visit_emitter(StateVisitor& v, EmitterEntry& e) {
  v.list("site", e.sites.places);
  v.value("area", e.sites.area);
  v.value("layer", e.sites.layer);
  v.part("clock", e.clock);
  v.value("emitted", e.count);
  v.value("body_before", e.body_before);
  if (e.def.mode == EmitterMode::imposed) v.part("duct", e.duct);
}

/// Visits each entry, with its index before the names of its items.
template <class Table, class Visit>
void visit_each(StateVisitor& v, const char* name, Table& table, const Visit& visit) {
  table.for_each([&](uint32_t index, auto& entry) {
    v.group(std::string(name).append("/").append(std::to_string(index)), [&] { visit(entry); });
  });
}

}  // namespace

void visit_engine_cloth(StateVisitor& v, EngineCloth& c) {
  v.list("position", c.position);
  v.list("velocity", c.velocity);
  v.list("phase", c.phase);
  v.list("touch", c.touches);
  v.list("contact_piece", c.contact_pieces);
  v.list("sheet", c.sheets);
  v.list("attachment", c.attachments);
  v.list("mass", c.model.constraints.masses);
  visit_coloured(v, "edges", c.model.constraints.edges);
  visit_coloured(v, "strains", c.model.constraints.strains);
  visit_coloured(v, "hinges", c.model.constraints.hinges);
  v.list("isometric", c.model.constraints.isometric);
  v.list("tether", c.model.tethers);
  v.list("triangle", c.model.triangles);
  v.list("rest_position", c.model.rest);
  v.list("piece", c.model.pieces);
  v.list("held", c.model.held);
  visit_rods(v, "rods", c.rods);
  visit_rods(v, "ropes", c.ropes);
  v.list("segment", c.segments);
}

void visit_tables(StateVisitor& v, WorldTables& t) {
  const IdVisit ids(v, t.first_generation);
  v.value("air_density", t.air_density);
  v.value("time", t.time);
  v.value("last_substep", t.last_substep);
  v.value("last_step", t.last_step);
  v.value("next_id", t.next_id);
  v.list("id", t.ids);
  v.value("crowding_bound", t.crowding_bound);
  v.list("touch", t.touches);
  ids.list("event", t.events, [](const auto& shift, ContactEvent& e) {
    shift(e.a);
    shift(e.b);
    shift(e.shape);
  });
  if (v.lacks("awake")) {  // a file of 0.2
    t.awake.clear();
    t.sleeps.clear();
    t.flows.clear();
  } else {
    v.list("awake", t.awake);
    ids.list("sleep", t.sleeps, [](const auto& shift, SleepEvent& e) { shift(e.body); });
    ids.list("flow", t.flows, [](const auto& shift, FlowEvent& e) {
      shift(e.emitter);
      shift(e.sink);
    });
  }
  ids.list("tear", t.tears, [](const auto& shift, TearEvent& e) { shift(e.cloth); });
  ids.list("piece", t.pieces);
  ids.list("touched_piece", t.touched_pieces);
  v.list("probe_value", t.probe_values);
  visit_each(v, "emitter", t.emitters, [&](EmitterEntry& e) { visit_emitter(v, e); });
  visit_each(v, "sink", t.sinks, [&](SinkEntry& s) { v.value("taken", s.count); });
  visit_each(v, "cloth", t.cloths, [&](ClothEntry& c) { visit_cloth(v, ids, c); });
  if (v.restores()) check_driven_room(t.cloths);
  visit_each(v, "rope", t.ropes, [&](RopeEntry& r) {
    visit_range(v, r.range);
    v.list("segment", r.segments);
  });
  visit_each(v, "attachment", t.attachments, [&](AttachmentEntry& a) { visit_attachment(v, a); });
}

}  // namespace meniscus
