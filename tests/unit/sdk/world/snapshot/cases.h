// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Worlds in the midst of something, for tests of snapshots, and what of a world must be as it was.
#pragma once

#include <cstring>
#include <string>
#include <vector>

#include "pbd/math/hash.h"
#include "tests/cloth_worlds.h"

namespace meniscus::tests {

inline constexpr float snapshot_step = 0.016f;

/// Words that stand for all that a user can read of a world's state.
inline std::vector<uint64_t> state_of(const World& world) {
  std::vector<uint64_t> words{world.state_hash(), world.particle_count()};
  const auto add = [&](const auto& value) {
    uint64_t word = 0;
    std::memcpy(&word, &value, sizeof value);
    words.push_back(word);
  };
  add(world.time());
  for (const ParticleId id : world.ids()) add(id);
  for (const float pressure : world.pressures()) add(pressure);
  for (const DiffuseParticle& p : world.diffuse()) add(p.position.x), add(p.velocity.y), add(p.life);
  for (const EmitterId id : world.emitter_ids()) add(world.emitter_count(id).total);
  for (const SinkId id : world.sink_ids()) add(world.sink_count(id).total);
  for (const ProbeId id : world.probe_ids()) add(world.probe(id));
  for (const AttachmentId id : world.attachment_ids()) add(world.attachment_force(id).y);
  for (const ClothId id : world.cloth_ids()) {
    for (const float wetness : world.cloth_wetness(id)) add(wetness);
    add(world.cloth_bending_fraction(id));
  }
  for (const RopeId id : world.rope_ids()) {
    for (const Quat& frame : world.rope_frames(id)) add(frame.x), add(frame.w);
  }
  for (const BodyId id : world.body_ids()) {
    const BodyState body = world.body_state(id);
    add(body.awake), add(body.fluid_force.y), add(body.fluid_torque.x);
  }
  for (const ParticleContact& c : world.particle_contacts()) add(c.particle), add(c.impulse.y);
  for (const SolidContact& c : world.solid_contacts()) add(c.impulse), add(c.point.x);
  words.push_back(world.contact_events().size());
  words.push_back(world.tear_events().size());
  return words;
}

/// What a world does from now on, step by step.
inline std::vector<std::vector<uint64_t>> future_of(World& world, int steps) {
  std::vector<std::vector<uint64_t>> future;
  for (int k = 0; k < steps; ++k) {
    world.step(snapshot_step);
    future.push_back(state_of(world));
  }
  return future;
}

struct SnapshotCase {
  const char* name;
  World (*make)(const WorldDef& def);
  int before;  ///< steps before the snapshot
};

/// All kinds of things, at moments at which much is going on.
const std::vector<SnapshotCase>& snapshot_cases();

}  // namespace meniscus::tests
