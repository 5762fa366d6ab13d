// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Emitters, sinks and probes for worlds of several ranks, and what they say.
#pragma once

#include <iomanip>
#include <sstream>
#include <string>

#include "pbd/math/hash.h"
#include "tests/worlds.h"

namespace meniscus::tests {

/// Where some ranks have nothing at first.
inline World jet_into_an_empty_tank(const WorldDef& def) {
  World world(def);
  world.create_shape(tank({0, 0, 0}, {0.4f, 1, 2}));
  EmitterDef jet;
  jet.fluid = world.create_fluid({});
  jet.opening = DiscOpening{0.1f};
  jet.pose = {{0.2f, 0.4f, 0.3f}, {0.70710678f, 0, 0, 0.70710678f}};  // out along z
  jet.speed = 4;
  world.create_emitter(jet);
  return world;
}

/// Adds to a dam of this width and length (m): a jet along the axis of the slabs, one under water, sinks in
/// the dam and where it breaks to, and a probe of each kind.
inline void add_flow(World& world, float width, float length) {
  const float middle = width / 2, half = 0.70710678f;
  const FluidId fluid = world.fluid_ids()[0];
  EmitterDef jet;
  jet.fluid = fluid;
  jet.opening = DiscOpening{0.06f};
  jet.pose = {{middle, 0.9f, 0.2f}, {half, 0, 0, half}};  // out along z
  jet.speed = 4;
  world.create_emitter(jet);
  EmitterDef below = jet;
  below.pose = {{middle, 0.2f, length / 2}, {0, 0, 0, 1}};
  below.rate = 0.3f * 0.0113f * below.speed;
  world.create_emitter(below);

  SinkDef sink;
  sink.region = BallRegion{0.1f};
  sink.pose.position = {middle, 0.3f, 0.8f * length};
  world.create_sink(sink);
  sink.region = BoxRegion{{0, 0.3f, length}, {width, 0.5f, length + 0.2f}};
  sink.pose = {};
  world.create_sink(sink);

  for (int kind = 0; kind <= static_cast<int>(ProbeKind::fluid_centre); ++kind) {
    ProbeDef probe;
    probe.kind = static_cast<ProbeKind>(kind);
    probe.point = {middle, 0.2f, length / 2};
    probe.normal = {0, 1, 0};
    probe.radius = 0.1f;
    probe.shape = world.shape_ids()[0];
    if (probe.kind == ProbeKind::wall_pressure) {
      probe.patch = Aabb{{-1, -0.01f, 0}, {1, 0.01f, length}};
      probe.area = width * length;
    }
    world.create_probe(probe);
  }
}

/// All that flow and probes say, with all digits, and a hash of the particles by slot.
inline std::string told_by_flow(const World& world) {
  std::ostringstream text;
  for (const ProbeId probe : world.probe_ids()) {
    const Vec3 v = world.probe_vector(probe);
    text << std::setprecision(17) << world.probe(probe) << ' ' << std::setprecision(9) << v.x << ' ' << v.y
         << ' ' << v.z << ' ';
  }
  for (const EmitterId id : world.emitter_ids()) text << "emitted " << world.emitter_count(id).total << ' ';
  for (const SinkId id : world.sink_ids()) text << "taken " << world.sink_count(id).total << ' ';
  uint64_t hash = 0;
  for (const FlowEvent& event : world.flow_events()) hash = pbd::mixed(hash ^ event.particle);
  const std::span<const Vec3> positions = world.positions(), velocities = world.velocities();
  for (size_t k = 0; k < positions.size(); ++k)
    hash = pbd::mixed(hash ^ world.ids()[k]) + pbd::element_hash(k, positions[k], velocities[k]);
  text << "by slot " << std::hex << hash;
  return text.str();
}

}  // namespace meniscus::tests
