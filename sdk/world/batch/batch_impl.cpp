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
  if (def.cfl_number > 0) refuse("cfl_number must be 0, as it looks at all fluid");
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
      shape_ids(archetype_world.shape_ids()),
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
  waiting.resize(worlds);
  stepping.resize(worlds);
  substeps.resize(worlds);
  run([&] { make_worlds(def); }, "WorldBatch");
  last.assign(worlds, kept_last);
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
    if (m.fluid.dynamic_viscosity > 0) refuse("FluidDef::dynamic_viscosity must be 0");
  });
  if (w.cloths.size() > 0) check_cloth();
  if (each == 0 && w.cloths.size() == 0) refuse("the archetype has no particles and no cloth");
  if (w.engine->any_crowd())
    refuse("the archetype's add_particles() may have crowded particles; step it until they have parted");
}

void WorldBatch::Impl::check_cloth() const {
  const World::Impl& w = host();
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
    engine().rigid_worlds().keep_news(w.touches, w.awake);
    engine().rigid_worlds().make_many(worlds, std::move(threads), [&] {
      auto made = std::make_unique<collision::RigidWorld>(rigid_world_def(w.def));
      World::Impl::make_rigid(*made, w, layout);
      if (w.uploaded_cloth) made->keep_awake(attached_bodies(*w.uploaded_cloth));
      return made;
    });
  }
  VertexNumbers numbers;
  w.cloths.for_each([&](uint32_t owner, const ClothEntry& entry) {
    for (size_t v = 0; v < entry.range.count(); ++v)
      numbers.push_back(element_number(HashedKind::cloth, owner, v));
  });
  vertices_each = static_cast<uint32_t>(numbers.size());
  kept_last = engine().last_substeps();
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

void WorldBatch::Impl::changed() {
  for (auto* readout : {&positions, &velocities, &vertex_positions, &vertex_velocities})
    readout->valid = false;
  hashes.valid = bodies.valid = false;
}

BatchReport WorldBatch::Impl::step(float length) {
  const auto start = std::chrono::steady_clock::now();
  BatchReport report;
  bool any = false;
  for (uint32_t w = 0; w < worlds; ++w) {
    waiting[w] = status[w].active && !status[w].failed;
    any |= waiting[w] != 0;
  }
  if (!any) return report;
  dt = length;
  engine().rigid_worlds().set_stepping(waiting);
  engine().find_substeps(length, substeps);
  const bool are_alike = choose_worlds_alike();
  are_alike ? step_chosen(report, true) : step_in_turns(report);
  report.ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  return report;
}

/// Chooses worlds that can step together: they need as many substeps, and start from substeps of the same
/// length. One that was reset to a state before all steps goes with any. Returns whether no others wait.
bool WorldBatch::Impl::choose_worlds_alike() {
  const auto goes_with_any = [&](uint32_t w) { return kept_last.none() && last[w].none(); };
  uint32_t leader = worlds;
  for (uint32_t w = 0; w < worlds; ++w) {
    if (!waiting[w]) continue;
    if (leader == worlds || (substeps[w] == substeps[leader] && !goes_with_any(w))) leader = w;
    if (!goes_with_any(leader)) break;
  }
  bool are_all = true;
  for (uint32_t w = 0; w < worlds; ++w) {
    const bool is_alike = last[w] == last[leader] || goes_with_any(w);
    stepping[w] = waiting[w] && substeps[w] == substeps[leader] && is_alike;
    waiting[w] = waiting[w] && !stepping[w];
    are_all &= waiting[w] == 0;
  }
  engine().rigid_worlds().set_stepping(stepping);
  engine().continue_from(last[leader]);
  return are_all;
}

void WorldBatch::Impl::step_chosen(BatchReport& report, bool is_only_turn) {
  place_bodies();
  engine().begin_step(dt, host().def.iterations);
  const EngineStep done = engine().end_step();
  if (is_only_turn) host().monitor().commit();
  changed();
  report.substeps = std::max(report.substeps, done.result.substeps);
  report.contacts = std::max(report.contacts, done.result.contacts);
  report.max_neighbours = std::max(report.max_neighbours, done.result.max_neighbours);
  ++report.turns;
  report.rigid_ms += done.rigid_ms;
  for (size_t s = 0; s < stage_count; ++s) report.stage_ms[s] += done.stage_ms[s];
  if (done.result.summary.non_finite || done.any_world_failed) {
    engine().count_non_finite(bad);
  } else {
    std::fill(bad.begin(), bad.end(), 0);
  }
  note_failures(report);
}

/// Each turn computes all worlds, and takes back those whose turn it is not. If one fails, all go back, with
/// the events of the last step.
void WorldBatch::Impl::step_in_turns(BatchReport& report) {
  before_turns.start_over();
  pbd::StateSaver saver(engine().device(), before_turns, pbd::SavedTo::device);
  visit_state(saver);
  std::vector<collision::RigidNews> news = engine().rigid_worlds().all_news();
  try {
    for (bool are_all = false;; are_all = choose_worlds_alike()) {
      step_chosen(report, false);
      if (are_all) return;
    }
  } catch (...) {
    restore_or_lose(before_turns);
    engine().rigid_worlds().set_all_news(std::move(news));
    throw;
  }
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
    last[w] = engine().last_substeps();
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
    last[w] = kept_last;
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
