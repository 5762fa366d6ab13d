// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// WorldBatch: many copies of one world, stepped in the same launches.
#pragma once

#include <meniscus/bodies.h>
#include <meniscus/device_arrays.h>
#include <meniscus/ids.h>
#include <meniscus/outputs.h>
#include <meniscus/snapshot.h>
#include <meniscus/types.h>
#include <meniscus/world_def.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace meniscus {

class World;

/// A batch of worlds.
struct BatchDef {
  uint32_t worlds = 1;  ///< 1 to 65,536
  /// Host threads that step rigid bodies, 0 to 1024; 0: one for each core, or the loop of
  /// WorldDef::parallel_for, if there is one.
  int rigid_threads = 0;
};

/// The state of one world of a batch.
struct WorldStatus {
  bool active = true;   ///< whether steps advance it; see WorldBatch::set_active
  bool failed = false;  ///< its last step was not finite: it has the state before, and waits for its reset
  double time = 0;      ///< s
};

/// The results of a step of a batch.
struct BatchReport {
  double ms = 0;                               ///< wall clock time
  int substeps = 0;                            ///< the largest number of any world
  int turns = 0;                               ///< in which the worlds have stepped; see WorldBatch::step
  std::array<double, stage_count> stage_ms{};  ///< on the device, by Stage
  double rigid_ms = 0;                         ///< time of Bullet on the host, contained in ms
  uint32_t stepped = 0;                        ///< worlds that have advanced
  uint32_t failed = 0;                         ///< worlds that failed in this step
  uint32_t contacts = 0;                       ///< of the last substep, in all worlds; the most of any turn
  uint32_t max_neighbours = 0;                 ///< of a particle
};

/// Arrays in the memory of the device, world after world; see World::device_arrays.
struct BatchArrays {
  DeviceArray positions;         ///< float32, worlds × particles × 3, m
  DeviceArray velocities;        ///< float32, worlds × particles × 3, m/s
  DeviceArray cloth_positions;   ///< float32, worlds × vertices × 3, m; empty without cloth
  DeviceArray cloth_velocities;  ///< float32, worlds × vertices × 3, m/s
};

/// The state of all worlds of a batch at one moment, made by WorldBatch::snapshot. Its arrays stay on the
/// batch's device. A copy shares them.
class BatchSnapshot {
 public:
  BatchSnapshot() = default;  ///< of no batch

  bool empty() const { return !data_; }  ///< holds no state
  std::size_t device_bytes() const;      ///< held on the device

  struct Data;  ///< for the library alone

 private:
  friend class WorldBatch;
  explicit BatchSnapshot(std::shared_ptr<Data> data) : data_(std::move(data)) {}

  std::shared_ptr<Data> data_;
};

/// Many copies of one world, the archetype, stepped in the same launches. Each has the bits of the archetype
/// alone, whatever its place in the batch and whatever happens in the others (docs/batch.md). Positions are
/// local to each world.
///
/// The archetype has WorldDef::sums `fixed`. It has fluids, granular materials, fixed shapes, bodies, joints
/// and cloth. Ropes, emitters, sinks, probes, force fields, hooks, viscosity, diffuse
/// particles and periodic axes are refused by name, as are cfl_number, step_budget_ms, density.tolerance, the
/// device's rigid solver, all density solvers but `jacobi` and `chebyshev`, and cloth that tears, absorbs, is
/// permeable or is driven.
///
/// Only one thread may use a batch at a time. Every call may throw Error and has then changed nothing, or the
/// batch is lost, as a world may be.
class WorldBatch {
 public:
  /// Copies of the archetype in its present state, on its device. The archetype does not change, and may go.
  /// Throws Error(invalid_argument) that names what a batch does not take, and Error(capacity) if all worlds
  /// together have more particles than a world may have.
  explicit WorldBatch(const World& archetype, const BatchDef& def = {});
  ~WorldBatch();
  WorldBatch(WorldBatch&&) noexcept;             ///< takes another batch, which is then of no use
  WorldBatch& operator=(WorldBatch&&) noexcept;  ///< likewise

  uint32_t worlds() const;             ///< number
  std::size_t particle_count() const;  ///< of each world
  std::size_t body_count() const;      ///< of each world
  std::size_t vertex_count() const;    ///< of the cloth of each world
  const WorldDef& def() const;         ///< of the archetype
  DeviceInfo device() const;           ///< see World::device

  /// Advances the active worlds by dt seconds. A world with a result that is not finite keeps the state
  /// before, and fails; the others do not notice. Worlds that need other numbers of substeps, or whose last
  /// substeps had other lengths, take turns. Each turn costs as much as a step of all worlds.
  BatchReport step(float dt);
  /// Gives the archetype's state to the worlds with mask ≠ 0, with its time and pressures. Their gravity and
  /// whether they are active stay. Empty: all worlds.
  void reset(std::span<const uint8_t> mask = {});
  /// Worlds with mask = 0 stay as they are until a mask names them again.
  void set_active(std::span<const uint8_t> mask);
  /// m/s², of one world, from the next step on.
  void set_gravity(uint32_t world, Vec3 gravity);
  /// m/s², by world.
  void set_gravities(std::span<const Vec3> gravities);

  /// As World's calls of these names, for a body of one world. The ids are those of the archetype. What a
  /// pose is set to holds from the next step on, with what it then overlaps.
  void set_body_pose(uint32_t world, BodyId body, const Pose& pose);
  void set_body_velocity(uint32_t world, BodyId body, Vec3 velocity,
                         Vec3 angular_velocity);                              ///< m/s and rad/s
  void apply_force(uint32_t world, BodyId body, Vec3 force);                  ///< N, at the centre of mass
  void apply_force(uint32_t world, BodyId body, Vec3 force, Vec3 point);      ///< N, at a point in m
  void apply_torque(uint32_t world, BodyId body, Vec3 torque);                ///< N·m
  void apply_impulse(uint32_t world, BodyId body, Vec3 impulse, Vec3 point);  ///< N·s, at a point in m
  void move_body(uint32_t world, BodyId body, const Pose& target, float duration);  ///< duration: s

  /// Replaces one world by another that was built as the archetype was, with as many particles, bodies and
  /// vertices in other places or with other velocities, or with another gravity. The world then has the bits
  /// of that one alone. A reset gives it the archetype's state. Throws Error(invalid_argument) that names
  /// what differs.
  void insert(uint32_t world, const World& state);

  std::span<const WorldStatus> status() const;  ///< by world
  std::span<const Vec3> positions() const;      ///< m, worlds × particles, in the order of World::positions
  std::span<const Vec3> velocities() const;     ///< m/s, likewise
  /// Worlds × bodies; those of a world by the index of their ids. Valid until the next call.
  std::span<const BodyState> body_states() const;
  /// Of one world, as World's calls of these names; with the ids of the archetype. A world that failed, was
  /// reset or was replaced has no events until its next step.
  std::vector<SolidContact> solid_contacts(uint32_t world) const;
  std::vector<ContactEvent> contact_events(uint32_t world) const;  ///< of its last step
  std::vector<SleepEvent> sleep_events(uint32_t world) const;      ///< likewise
  /// m, worlds × vertices; those of a world in the order of World::cloth_ids.
  std::span<const Vec3> cloth_positions() const;
  std::span<const Vec3> cloth_velocities() const;  ///< m/s, likewise
  std::span<const uint64_t> state_hashes() const;  ///< by world: World::state_hash of it alone
  /// Positions and velocities on the device, also those of cloth. Does not wait for the device.
  BatchArrays device_arrays() const;
  /// A world of its own that continues with the same bits. It has the gravity of the world.
  World extract(uint32_t world) const;

  /// The state of all worlds: particles, bodies, pressures, times, gravities, activity and failures.
  BatchSnapshot snapshot() const;
  /// Goes back to a snapshot of this batch. What follows is bit for bit what followed the snapshot. Throws
  /// Error(invalid_argument) if the snapshot is empty or of another batch.
  void restore(const BatchSnapshot& snapshot);
  /// Writes the archetype and the state to a file (docs/snapshots.md), which appears complete or not at all.
  /// Throws Error(io) if the file cannot be written.
  void save(const std::string& path) const;
  /// A new batch with the state of a file, which continues as World::load says. The ids of bodies have the
  /// same indices, but are those that body_ids() lists. Throws what World::load throws.
  static WorldBatch load(const std::string& path, const LoadDef& def = {});
  std::vector<BodyId> body_ids() const;  ///< those that the calls above take, ascending

  /// Bytes and allocations of the batch's device; see World::memory_stats.
  MemoryStats memory_stats() const;

 private:
  struct Impl;
  explicit WorldBatch(std::unique_ptr<Impl> impl);

  std::unique_ptr<Impl> impl_;
};

}  // namespace meniscus
