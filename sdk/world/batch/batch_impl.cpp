// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Making, stepping and resetting a batch: a world whose engine has made many of it, and what is known of
// each.
#include "sdk/world/batch/batch_impl.h"

#include <meniscus/error.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "sdk/world/batch/batch_solids.h"
#include "sdk/world/check/check.h"
#include "sdk/world/state/hashed_elements.h"

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
  if (def.rigid.solver != RigidSolver::bullet) refuse("rigid.solver must be bullet");
  if (def.density.solver != DensitySolver::jacobi && def.density.solver != DensitySolver::chebyshev)
    refuse("density.solver must be jacobi or chebyshev");
  if (def.diffuse) refuse("diffuse particles are not supported");
  if (def.periodic != PeriodicDef{}) refuse("periodic axes are not supported");
}

}  // namespace

WorldBatch::Impl::Impl(const World& archetype_world, const BatchDef& def)
    : archetype(archetype_world.clone()),
      running(archetype_world.clone()),
      ids(archetype_world.body_ids()),
      worlds(def.worlds),
      each(static_cast<uint32_t>(running.particle_count())) {
  if (worlds < 1 || worlds > most_worlds)
    check::refuse("BatchDef::worlds", std::to_string(worlds), "1 to " + std::to_string(most_worlds));
  if (!archetype_world.impl_->hooks.empty()) refuse("hooks are not supported");
  check::value("BatchDef::rigid_threads", def.rigid_threads, between(0, 1024));
  check_archetype();
  if (size_t{worlds} * each > most_particles)
    throw Error(ErrorCode::capacity, "WorldBatch: " + std::to_string(worlds) + " worlds of " +
                                         std::to_string(each) + " particles are more than " +
                                         std::to_string(most_particles));
  status.assign(worlds, {true, false, running.time()});
  gravities.assign(worlds, host().given.gravity);
  chosen.resize(worlds);
  bad.resize(worlds);
  placed.resize(worlds);
  stepping.resize(worlds);
  run([&] { make_worlds(def); }, "WorldBatch");
  set_gravities(gravities);
}

void WorldBatch::Impl::check_archetype() const {
  World::Impl& w = host();
  check_def(w.def);
  const std::pair<const char*, size_t> refused[] = {{"ropes", w.ropes.size()},
                                                    {"emitters", w.emitters.size()},
                                                    {"sinks", w.sinks.size()},
                                                    {"probes", w.probes.size()},
                                                    {"force fields", w.force_fields.size()}};
  for (const auto& [what, count] : refused) {
    if (count > 0) refuse(std::string(what) + " are not supported");
  }
  w.fluids.for_each([](uint32_t, const ParticleMaterial& m) {
    if (m.grain.is_grain) refuse("granular materials are not supported");
    if (m.fluid.dynamic_viscosity > 0) refuse("FluidDef::dynamic_viscosity must be 0");
  });
  if (w.cloths.size() > 0) check_cloth();
  if (each == 0 && w.cloths.size() == 0) refuse("the archetype has no particles and no cloth");
  if (w.engine->any_crowd())
    refuse("the archetype's add_particles() may have crowded particles; step it until they have parted");
}

/// Bodies that come fast at cloth would give all worlds more substeps.
void WorldBatch::Impl::check_cloth() const {
  const World::Impl& w = host();
  if (w.bodies.size() > 0) refuse("worlds with cloth and bodies are not supported");
  w.cloths.for_each([&](uint32_t, const ClothEntry& entry) {
    const FabricDef& fabric = entry.def.fabric;
    if (entry.track) refuse("driven cloth is not supported");
    if (fabric.tear_strain > 0) refuse("FabricDef::tear_strain must be 0");
    if (fabric.absorbency > 0) refuse("FabricDef::absorbency must be 0");
    if (fabric.permittivity > 0) refuse("FabricDef::permittivity must be 0");
  });
  const size_t pieces = worlds * size_t{w.cloths.size()};
  if (pieces > pbd::phase_group_mask)
    throw Error(ErrorCode::capacity, "WorldBatch: the worlds have " + std::to_string(pieces) +
                                         " pieces of cloth together; at most " +
                                         std::to_string(pbd::phase_group_mask) + " fit");
}

/// The rigid worlds go by the definitions, in the order of the archetype's lists. So they have its bits.
void WorldBatch::Impl::make_worlds(const BatchDef& def) {
  World::Impl& w = host();
  w.with_all();
  bodies_each = w.rigid.body_slots();
  if (bodies_each > 0) {
    const collision::RigidLayout layout = w.rigid.layout();
    auto threads = std::make_unique<pbd::HostThreads>(def.rigid_threads,
                                                      def.rigid_threads ? ParallelFor{} : w.def.parallel_for);
    engine().rigid_worlds().make_many(worlds, std::move(threads), [&] {
      auto made = std::make_unique<collision::RigidWorld>(rigid_world_def(w.def));
      World::Impl::make_rigid(*made, w, layout);
      return made;
    });
  }
  VertexNumbers numbers;
  w.cloths.for_each([&](uint32_t owner, const ClothEntry& entry) {
    for (size_t v = 0; v < entry.range.count(); ++v)
      numbers.push_back(element_number(HashedKind::cloth, owner, v));
  });
  vertices_each = static_cast<uint32_t>(numbers.size());
  static const EngineCloth none;
  engine().make_worlds(of_all_worlds(w.solid_shapes(), worlds, bodies_each),
                       w.uploaded_cloth ? *w.uploaded_cloth : none, numbers);
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

void WorldBatch::Impl::changed() {
  for (auto* readout : {&positions, &velocities, &vertex_positions, &vertex_velocities})
    readout->valid = false;
  hashes.valid = bodies.valid = false;
}

BatchReport WorldBatch::Impl::step(float length) {
  const auto start = std::chrono::steady_clock::now();
  BatchReport report;
  const auto may_step = [](const WorldStatus& s) { return s.active && !s.failed; };
  if (std::none_of(status.begin(), status.end(), may_step)) return report;
  for (uint32_t w = 0; w < worlds; ++w) stepping[w] = may_step(status[w]);
  engine().rigid_worlds().set_stepping(stepping);
  place_bodies();
  engine().begin_step(length, host().def.iterations);
  const EngineStep done = engine().end_step();
  host().monitor().commit();
  dt = length;
  changed();
  report.substeps = done.result.substeps;
  report.contacts = done.result.contacts;
  report.max_neighbours = done.result.max_neighbours;
  if (done.result.summary.non_finite || done.any_world_failed) {
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
    const bool takes_part = stepping[w], fails = takes_part && bad[w] > 0;
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
    placed[w] = 0;
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
  collision::RigidWorldDef rigid = rigid_world_def(host().def);
  for (uint32_t w = 0; w < worlds && bodies_each > 0; ++w) {
    if (values[w] == gravities[w]) continue;
    rigid.gravity = values[w];
    engine().rigid_worlds().world(w).set_def(rigid);
  }
  gravities.assign(values.begin(), values.end());
}

}  // namespace meniscus
