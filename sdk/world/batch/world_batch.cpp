// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// WorldBatch: a world whose engine has made many of it, and what is known of each.
#include <meniscus/batch.h>
#include <meniscus/error.h>
#include <meniscus/world.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <utility>
#include <vector>

#include "sdk/world/check/check.h"
#include "sdk/world/world_boundary.h"

namespace meniscus {

namespace {

constexpr uint32_t most_worlds = 1u << 16;
constexpr size_t most_particles = size_t{1} << 27;

[[noreturn]] void refuse(const std::string& why) {
  throw Error(ErrorCode::invalid_argument, "WorldBatch: " + why);
}

void check_def(const WorldDef& def) {
  if (def.sums != Sums::fixed) refuse("the archetype's WorldDef::sums must be fixed");
  if (def.cfl_number > 0) refuse("cfl_number must be 0, as all worlds have the same substeps");
  if (def.step_budget_ms > 0) refuse("step_budget_ms must be 0");
  if (def.density.tolerance > 0) refuse("density.tolerance must be 0");
  if (def.density.solver != DensitySolver::jacobi && def.density.solver != DensitySolver::chebyshev)
    refuse("density.solver must be jacobi or chebyshev");
  if (def.diffuse) refuse("diffuse particles are not supported");
  if (def.periodic != PeriodicDef{}) refuse("periodic axes are not supported");
}

}  // namespace

struct WorldBatch::Impl {
  Impl(const World& archetype_world, const BatchDef& def);

  /// What the batch runs on: a world whose engine has all particles.
  World::Impl& host() const { return *running.impl_; }
  Engine& engine() const { return *host().engine; }
  template <class Call>
  auto run(const Call& call, const char* name) const {
    return host().run([&](auto) { return call(); }, name);
  }

  void check_archetype() const;
  void check_mask(const char* call, std::span<const uint8_t> mask) const;
  void check_world(const char* call, uint32_t world) const;
  BatchReport step(float dt);
  void check_step(float dt) const;
  void note_failures(BatchReport& report);
  void reset(std::span<const uint8_t> mask);
  void set_gravities(std::span<const Vec3> values);
  World extract(uint32_t world) const;
  BatchArrays device_arrays();
  void changed() { positions.valid = velocities.valid = hashes.valid = false; }

  World archetype, running;
  uint32_t worlds, each;
  float dt = 0;  // s, of all steps; 0: none yet
  std::vector<WorldStatus> status;
  std::vector<Vec3> gravities;
  std::vector<uint32_t> chosen, bad;  // by world
  CachedReadout<Vec3> positions, velocities;
  CachedReadout<uint64_t> hashes;
  BatchArrays arrays;
};

WorldBatch::Impl::Impl(const World& archetype_world, const BatchDef& def)
    : archetype(archetype_world.clone()),
      running(archetype_world.clone()),
      worlds(def.worlds),
      each(static_cast<uint32_t>(running.particle_count())) {
  if (worlds < 1 || worlds > most_worlds)
    check::refuse("BatchDef::worlds", std::to_string(worlds), "1 to " + std::to_string(most_worlds));
  if (!archetype_world.impl_->hooks.empty()) refuse("hooks are not supported");
  check_archetype();
  if (size_t{worlds} * each > most_particles)
    throw Error(ErrorCode::capacity, "WorldBatch: " + std::to_string(worlds) + " worlds of " +
                                         std::to_string(each) + " particles are more than " +
                                         std::to_string(most_particles));
  status.assign(worlds, {true, false, running.time()});
  gravities.assign(worlds, host().given.gravity);
  chosen.resize(worlds);
  bad.resize(worlds);
  run([&] { host().with_all().make_worlds(worlds); }, "WorldBatch");
  set_gravities(gravities);
}

void WorldBatch::Impl::check_archetype() const {
  World::Impl& w = host();
  check_def(w.def);
  const std::pair<const char*, size_t> refused[] = {
      {"bodies", w.bodies.size()},     {"joints", w.joints.size()},
      {"cloth", w.cloths.size()},      {"ropes", w.ropes.size()},
      {"emitters", w.emitters.size()}, {"sinks", w.sinks.size()},
      {"probes", w.probes.size()},     {"force fields", w.force_fields.size()}};
  for (const auto& [what, count] : refused) {
    if (count > 0) refuse(std::string(what) + " are not supported");
  }
  w.fluids.for_each([](uint32_t, const ParticleMaterial& m) {
    if (m.grain.is_grain) refuse("granular materials are not supported");
    if (m.fluid.dynamic_viscosity > 0) refuse("FluidDef::dynamic_viscosity must be 0");
  });
  if (each == 0) refuse("the archetype has no particles");
  if (w.engine->any_crowd())
    refuse("the archetype's add_particles() may have crowded particles; step it until they have parted");
}

void WorldBatch::Impl::check_mask(const char* call, std::span<const uint8_t> mask) const {
  if (mask.size() == worlds) return;
  throw Error(ErrorCode::invalid_argument, std::string(call) + " got a mask of " +
                                               std::to_string(mask.size()) + " worlds; the batch has " +
                                               std::to_string(worlds));
}

void WorldBatch::Impl::check_world(const char* call, uint32_t world) const {
  if (world >= worlds)
    check::refuse(std::string(call) + "'s world", std::to_string(world), "below " + std::to_string(worlds));
}

// ---- steps ----

/// Multipliers start from those of the last substep, which must have the same length in all worlds, at any
/// time, also after a reset.
void WorldBatch::Impl::check_step(float length) const {
  check::value("WorldBatch::step's dt", length, at_least(1e-12), "s");
  const World::Impl& w = host();
  if (dt > 0 && length != dt)
    check::refuse("WorldBatch::step's dt", std::to_string(length), std::to_string(dt) + ", as before");
  const float substep = length / static_cast<float>(w.def.substeps);
  if (w.last_substep > 0 && substep != w.last_substep)
    check::refuse(
        "WorldBatch::step's dt", std::to_string(length),
        "that of the archetype's last step, whose substeps had " + std::to_string(w.last_substep) + " s");
}

BatchReport WorldBatch::Impl::step(float length) {
  const auto start = std::chrono::steady_clock::now();
  BatchReport report;
  const auto may_step = [](const WorldStatus& s) { return s.active && !s.failed; };
  if (std::none_of(status.begin(), status.end(), may_step)) return report;
  engine().begin_step(length, host().def.iterations);
  const EngineStep done = engine().end_step();
  host().monitor().commit();
  dt = length;
  changed();
  report.substeps = done.result.substeps;
  report.contacts = done.result.contacts;
  report.max_neighbours = done.result.max_neighbours;
  if (done.result.summary.non_finite) {
    engine().count_non_finite(bad);
  } else {
    std::fill(bad.begin(), bad.end(), 0);
  }
  note_failures(report);
  report.ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  return report;
}

/// Notes which worlds have advanced. The others go back, those that did not take part as well.
void WorldBatch::Impl::note_failures(BatchReport& report) {
  bool any_back = false;
  for (uint32_t w = 0; w < worlds; ++w) {
    WorldStatus& s = status[w];
    const bool takes_part = s.active && !s.failed, fails = takes_part && bad[w] > 0;
    chosen[w] = !takes_part || fails;
    any_back |= chosen[w] != 0;
    s.failed |= fails;
    report.failed += fails;
    if (chosen[w]) continue;
    s.time += double{dt};
    ++report.stepped;
  }
  if (any_back) engine().undo_worlds(chosen);
}

void WorldBatch::Impl::reset(std::span<const uint8_t> mask) {
  for (uint32_t w = 0; w < worlds; ++w) {
    chosen[w] = mask.empty() || mask[w] != 0;
    if (!chosen[w]) continue;
    status[w].failed = false;
    status[w].time = archetype.time();
  }
  engine().reset_worlds(chosen);
  changed();
}

/// Artificial pressure scales with gravity, and is one for all worlds.
void WorldBatch::Impl::set_gravities(std::span<const Vec3> values) {
  const Vec3 common = archetype.def().gravity;
  const bool scales = archetype.def().density.artificial_pressure.strength > 0;
  if (scales && std::any_of(values.begin(), values.end(), [&](Vec3 g) { return g != common; }))
    refuse("worlds with density.artificial_pressure have the archetype's gravity");
  run([&] { engine().set_gravities(values); }, "set_gravities");
  gravities.assign(values.begin(), values.end());
}

// ---- read-outs ----

World WorldBatch::Impl::extract(uint32_t world) const {
  World made = archetype.clone();
  WorldDef def = made.def();
  def.gravity = gravities[world];
  if (def.gravity != made.def().gravity) made.set_def(def);
  const EngineWorld state = run([&] { return engine().read_world(world); }, "extract");
  World::Impl& to = *made.impl_;
  to.run([&](auto) {
    to.with_all().write_world(state);
    to.state_changed();
    to.time = status[world].time;
    if (to.time > archetype.time()) to.last_substep = state.last_substep;
  });
  return made;
}

namespace {

/// Makes room for vectors, unless the memory of the last ones serves and nobody else holds it.
void make_room(DeviceArray& array, Engine& engine, int64_t worlds, int64_t each) {
  if (array.memory.use_count() != 1)
    array.memory = engine.allocate_lasting(static_cast<size_t>(worlds * each) * sizeof(Vec3));
  array.data = array.memory.get();
  array.dimensions = 3;
  array.shape = {worlds, each, 3};
  array.strides = {3 * each, 3, 1};
  array.on_cuda = engine.device().kind() == pbd::DeviceKind::cuda;
  array.device = engine.ordinal();
  array.stream = engine.stream();
}

}  // namespace

BatchArrays WorldBatch::Impl::device_arrays() {
  for (DeviceArray* array : {&arrays.positions, &arrays.velocities})
    make_room(*array, engine(), worlds, each);
  engine().write_vectors(static_cast<Vec3*>(arrays.positions.data),
                         static_cast<Vec3*>(arrays.velocities.data));
  return arrays;
}

// ---- the public calls ----

WorldBatch::WorldBatch(const World& archetype, const BatchDef& def)
    : impl_(std::make_unique<Impl>(archetype, def)) {}
WorldBatch::~WorldBatch() = default;
WorldBatch::WorldBatch(WorldBatch&&) noexcept = default;
WorldBatch& WorldBatch::operator=(WorldBatch&&) noexcept = default;

uint32_t WorldBatch::worlds() const {
  return impl_->worlds;
}
std::size_t WorldBatch::particle_count() const {
  return impl_->each;
}
const WorldDef& WorldBatch::def() const {
  return impl_->archetype.def();
}
DeviceInfo WorldBatch::device() const {
  return impl_->running.device();
}

BatchReport WorldBatch::step(float dt) {
  impl_->check_step(dt);
  return impl_->run([&] { return impl_->step(dt); }, "step");
}

void WorldBatch::reset(std::span<const uint8_t> mask) {
  if (!mask.empty()) impl_->check_mask("reset", mask);
  impl_->run([&] { impl_->reset(mask); }, "reset");
}

void WorldBatch::set_active(std::span<const uint8_t> mask) {
  impl_->check_mask("set_active", mask);
  for (uint32_t w = 0; w < impl_->worlds; ++w) impl_->status[w].active = mask[w] != 0;
}

void WorldBatch::set_gravity(uint32_t world, Vec3 gravity) {
  impl_->check_world("set_gravity", world);
  check::value("set_gravity's gravity", gravity);
  std::vector<Vec3> all = impl_->gravities;
  all[world] = gravity;
  impl_->set_gravities(all);
}

void WorldBatch::set_gravities(std::span<const Vec3> gravities) {
  if (gravities.size() != impl_->worlds)
    check::refuse("set_gravities", std::to_string(gravities.size()) + " vectors",
                  "one for each of " + std::to_string(impl_->worlds) + " worlds");
  for (const Vec3 g : gravities) check::value("a gravity of set_gravities", g);
  impl_->set_gravities(gravities);
}

std::span<const WorldStatus> WorldBatch::status() const {
  return impl_->status;
}

namespace {

template <class Read>
std::span<const Vec3> in_users_frame(const Origin& origin, CachedReadout<Vec3>& kept, size_t count,
                                     const Read& read) {
  return kept.get(count, [&](std::span<Vec3> out) {
    read(out);
    if (origin.is_zero()) return;
    for (Vec3& p : out) p = origin.outward(p);
  });
}

}  // namespace

std::span<const Vec3> WorldBatch::positions() const {
  return impl_->run(
      [&] {
        return in_users_frame(impl_->host().origin, impl_->positions, size_t{impl_->worlds} * impl_->each,
                              [&](std::span<Vec3> out) { impl_->engine().read_positions(out); });
      },
      "positions");
}

std::span<const Vec3> WorldBatch::velocities() const {
  return impl_->run(
      [&] {
        return impl_->velocities.get(size_t{impl_->worlds} * impl_->each,
                                     [&](std::span<Vec3> out) { impl_->engine().read_velocities(out); });
      },
      "velocities");
}

std::span<const uint64_t> WorldBatch::state_hashes() const {
  return impl_->run(
      [&] {
        return impl_->hashes.get(impl_->worlds,
                                 [&](std::span<uint64_t> out) { impl_->engine().hash_worlds(out); });
      },
      "state_hashes");
}

BatchArrays WorldBatch::device_arrays() const {
  return impl_->run([&] { return impl_->device_arrays(); }, "device_arrays");
}

World WorldBatch::extract(uint32_t world) const {
  impl_->check_world("extract", world);
  return impl_->extract(world);
}

MemoryStats WorldBatch::memory_stats() const {
  return impl_->running.memory_stats();
}

}  // namespace meniscus
