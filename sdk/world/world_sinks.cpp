// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// World's sinks.
#include <meniscus/world.h>

#include <algorithm>

#include "sdk/world/check/check.h"
#include "sdk/world/world_calls.h"

namespace meniscus {

namespace {

struct FillRegion {
  Sink& sink;

  void operator()(const BoxRegion& r) const {
    sink.kind = Sink::Kind::box;
    sink.box = {r.lower, r.upper};
  }
  void operator()(const BallRegion& r) const {
    sink.kind = Sink::Kind::ball;
    sink.size = r.radius;
  }
  void operator()(const HalfSpaceRegion& r) const {
    sink.kind = Sink::Kind::half_space;
    sink.normal = r.normal / length(r.normal);
    sink.size = r.offset / length(r.normal);
  }
};

}  // namespace

SinkId World::Calls::create_sink(const SinkDef& def) {
  check::def(def);
  if (def.body) impl_->bodies.get(*def.body);
  impl_->sinks_changed();
  return impl_->sinks.insert({def, {}});
}

void World::Calls::destroy_sink(SinkId id) {
  impl_->sinks.erase(id);
  impl_->sinks_changed();
}

FlowCount World::Calls::sink_count(SinkId id) const {
  return impl_->sinks.get(id).count;
}

void World::Impl::upload_sinks() {
  if (sinks_are_on_device) return;
  std::vector<Sink> all;
  sinks_are_carried = false;
  sinks.for_each([&](uint32_t, const SinkEntry& entry) {
    const SinkDef& s = entry.def;
    Sink sink;
    sink.outside = s.outside;
    sink.pose = s.body ? rigid.pose(s.body->index) * s.pose : s.pose;
    sinks_are_carried |= s.body.has_value();
    std::visit(FillRegion{sink}, s.region);
    all.push_back(sink);
  });
  engine->set_sinks(all);
  taken.resize(all.size());
  sinks_are_on_device = true;
}

/// Notes which sink takes each of these particles, by slot.
void World::Impl::note_removals(const std::vector<bool>& removed) {
  std::vector<SinkId> all = sinks.ids();
  for (size_t slot = 0; slot < removed.size(); ++slot) {
    if (removed[slot]) flows.push_back({{}, all[takers[slot]], ids[slot]});
  }
}

/// Removes the particles that the sinks take at the end of a step. Returns their number.
uint32_t World::Impl::take_sinks() {
  if (sinks_are_carried) {
    sinks_changed();
    upload_sinks();
  }
  std::fill(taken.begin(), taken.end(), 0u);
  const std::vector<bool> removed = engine->take_sinks(taken, takers);
  if (!removed.empty()) {
    note_removals(removed);
    remove(removed);
  }
  size_t place = 0;
  uint32_t sum = 0;
  sinks.for_each([&](uint32_t, SinkEntry& entry) {
    entry.count.last_step = taken[place++];
    entry.count.total += entry.count.last_step;
    sum += entry.count.last_step;
  });
  return sum;
}

/// Destroys the emitters and sinks that a body carries.
void World::Impl::drop_flow_of(BodyId body) {
  std::vector<EmitterId> gone_emitters;
  emitters.for_each([&](uint32_t number, const EmitterEntry& e) {
    if (e.def.body == body) gone_emitters.push_back(emitters.id(number));
  });
  for (EmitterId id : gone_emitters) emitters.erase(id);
  std::vector<SinkId> gone_sinks;
  sinks.for_each([&](uint32_t number, const SinkEntry& s) {
    if (s.def.body == body) gone_sinks.push_back(sinks.id(number));
  });
  for (SinkId id : gone_sinks) sinks.erase(id);
  if (!gone_sinks.empty()) sinks_changed();
}

}  // namespace meniscus
