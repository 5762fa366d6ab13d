// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What WorldBatch holds.
#pragma once

#include <meniscus/batch.h>
#include <meniscus/world.h>

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "pbd/state/saved_state.h"
#include "sdk/engine/engine_types.h"
#include "sdk/world/state/body_calls.h"
#include "sdk/world/world_boundary.h"

namespace meniscus {

struct BatchSnapshot::Data {
  pbd::SavedState state;
};

struct WorldBatch::Impl {
  Impl(const World& archetype_world, const BatchDef& def);
  ~Impl();

  /// What the batch runs on: a world whose engine has all particles.
  World::Impl& host() const { return *running.impl_; }
  Engine& engine() const { return *host().engine; }
  template <class Call>
  auto run(const Call& call, const char* name) const {
    return host().run([&](auto) { return call(); }, name);
  }

  void check_archetype() const;
  void check_cloth() const;
  void make_worlds(const BatchDef& def);
  void check_mask(const char* call, std::span<const uint8_t> mask) const;
  void check_world(const char* call, uint32_t world) const;
  BatchReport step(float dt);
  bool choose_worlds_alike();
  void step_chosen(BatchReport& report, bool is_only_turn);
  void step_in_turns(BatchReport& report);
  void place_bodies();
  void note_failures(BatchReport& report);
  void reset(std::span<const uint8_t> mask);
  void set_gravities(std::span<const Vec3> values);
  World extract(uint32_t world) const;
  void check_insert(World::Impl& state) const;
  void insert(uint32_t world, const World& state);
  BatchArrays device_arrays();
  const BodyEntry& body(BodyId id) const;
  // The user's ids of the archetype's solids, by their numbers.
  BodyId body_id(uint32_t number) const;
  ShapeId shape_id(uint32_t number) const;
  /// Runs call(its calls) for a body of one world.
  template <class Call>
  void for_body(const char* name, uint32_t world, BodyId id, const Call& call);
  std::span<const BodyState> read_bodies();
  void visit_state(pbd::StateVisitor& v);
  void restore(const pbd::SavedState& saved);
  /// Whatever fails half way is a pbd::StateLost.
  void restore_or_lose(const pbd::SavedState& saved);
  void note(const std::shared_ptr<BatchSnapshot::Data>& data);
  bool has(const std::shared_ptr<BatchSnapshot::Data>& data) const;
  void hash_worlds(std::span<uint64_t> out) const;
  void changed();
  /// Reads vertices once for all, if they were not read since the last change.
  void read_vertices();

  World archetype, running;
  std::vector<BodyId> ids;         // of the bodies, in the user's archetype: a copy of it has others
  std::vector<ShapeId> shape_ids;  // likewise, of fixed shapes
  uint32_t worlds, each;
  uint32_t bodies_each = 0;  // with numbers that are not in use
  uint32_t vertices_each = 0;
  float dt = 0;  // s, of the last step; 0: none yet
  std::vector<WorldStatus> status;
  std::vector<Vec3> gravities;
  std::vector<uint32_t> chosen, bad, placed;  // by world
  std::vector<uint8_t> waiting, stepping;     // by world: to be stepped in this call; stepping now
  std::vector<LastSubsteps> last;             // by world: what its next step starts from
  LastSubsteps kept_last;                     // what a reset world starts from
  std::vector<int> substeps;                  // by world, of this step
  CachedReadout<Vec3> positions, velocities;
  CachedReadout<uint64_t> hashes;
  CachedReadout<BodyState> bodies;
  CachedReadout<Vec3> vertex_positions, vertex_velocities;
  BatchArrays arrays;
  pbd::SavedState before_turns;                               // the state before a step in turns
  std::vector<std::weak_ptr<BatchSnapshot::Data>> snapshots;  // that may still exist
};

}  // namespace meniscus
