// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// World's calls that create fluids, shapes, probes and particles, and its step.
#include <meniscus/world.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <new>
#include <utility>

#include "sdk/fields/probes.h"
#include "sdk/world/check/check.h"
#include "sdk/world/check/periodic.h"
#include "sdk/world/crowding.h"
#include "sdk/world/seeding.h"
#include "sdk/world/solids/seam_images.h"
#include "sdk/world/tuning.h"
#include "sdk/world/world_calls.h"

namespace meniscus {

const WorldDef& World::Calls::def() const {
  return impl_->given;
}
DeviceInfo World::Calls::device() const {
  return impl_->device;
}
float World::Calls::support_radius() const {
  return impl_->kernel.h;
}

float World::Calls::particle_mass(FluidId id) const {
  return static_cast<float>(impl_->particle_mass(id));
}

// ---- contents of the world ----

FluidId World::Calls::create_fluid(const FluidDef& def) {
  check::def(def);
  return impl_->create_material(material_of(def));
}

FluidId World::Calls::create_granular(const GranularDef& def) {
  check::def(def);
  check::no_periodic_axes(impl_->def, "granular materials");
  impl_->check_solver_allows("granular materials");
  fluid::Material displaces;
  displaces.rest_density = def.density;
  return impl_->create_material({displaces,
                                 {true, collision::contact_friction(def.friction)},
                                 def.filter,
                                 def.name,
                                 def.color,
                                 def.friction});
}

ShapeId World::Calls::create_shape(const ShapeDef& def) {
  check::def(def);
  impl_->shapes.prepare();
  ShapeEntry entry = impl_->make_shape(def, {});
  impl_->solids_changed();
  impl_->note_repairs(entry.solid);
  return impl_->shapes.insert(std::move(entry));
}

/// Adds the shape to the rigid world.
ShapeEntry World::Impl::make_shape(const ShapeDef& shape, const collision::RigidPlace& place) {
  ShapeEntry entry{shape, {}};
  {
    const pbd::CallMonitor::Cancellable undone_within(monitor());
    entry.solid =
        make_solid(shape.geometry, shape.surface, shape.filter, SolidRole::fixed, 0, solid_context());
  }
  const pbd::PeriodicAxes axes = periodic_axes(def.periodic);
  for (const SolidPieces::Piece& piece : entry.solid.pieces)
    with_seam_images(placed(piece, shape.pose), axes, kernel.h, shape.name);
  rigid.add_fixed(rigid_solid(entry.solid, shape.pose, shape.surface, shape.filter), place);
  return entry;
}

void World::Calls::destroy_shape(ShapeId id) {
  impl_->shapes.get(id);
  impl_->forget_solid({false, id.index});
  impl_->solids_changed();
  impl_->shapes.erase(id);
  impl_->probes_changed();
}

ProbeId World::Calls::create_probe(const ProbeDef& def) {
  check::def(def);
  if (def.kind == ProbeKind::fluid_angular_momentum || def.kind == ProbeKind::fluid_centre)
    check::no_periodic_axes(impl_->def, "probes of angular momentum or of a centre of mass");
  if (is_of_shape(def.kind)) impl_->shapes.get(def.shape);
  if (is_of_fluid(def.kind) && def.fluid) impl_->fluids.get(*def.fluid);
  const size_t values = std::max<size_t>(impl_->probe_values.size(), impl_->probes.prepare() + 1);
  impl_->probe_values.resize(values);
  const ProbeId id = impl_->probes.insert(def);
  impl_->probe_values[id.index] = {};
  impl_->probes_changed();
  return id;
}

void World::Calls::destroy_probe(ProbeId id) {
  impl_->probes.erase(id);
  impl_->probes_changed();
}

// ---- particles ----

size_t World::Calls::add_fluid(const FluidVolumeDef& def) {
  impl_->fluids.get(def.fluid);
  check::def(def);
  if (const auto* region = std::get_if<BoxRegion>(&def.region)) {
    const Vec3 cells = (region->upper - region->lower) / impl_->def.particle_spacing;
    check_room(ids().size(), double{cells.x} * cells.y * cells.z);
  }
  if (const auto* region = std::get_if<BallRegion>(&def.region)) {
    const double cells = 2.0 * region->radius / impl_->def.particle_spacing;
    check_room(ids().size(), cells * cells * cells);
  }
  const float spacing = impl_->def.particle_spacing;
  const ParticleMaterial& material = impl_->fluids.get(def.fluid);
  if (material.grain.is_grain && def.seeding != Seeding::lattice) {
    throw Error(ErrorCode::invalid_argument,
                "FluidVolumeDef::seeding must be lattice for grains, which have a disorder of their own");
  }
  if (def.seeding == Seeding::disordered) impl_->with_solids();
  const float rounding = impl_->origin.input_step();
  const FileReader& files = impl_->def.read_file;
  std::vector<Vec3> points = [&] {
    const pbd::CallMonitor::Cancellable nothing_to_undo(impl_->monitor());
    if (def.seeding == Seeding::lattice) return fill_region(def, *impl_->engine, spacing, rounding, files);
    return fill_in_disorder(def, impl_->with_solids(), spacing, files, positions(), material.filter,
                            [&](std::vector<Vec3>& p) { impl_->keep_off_cloth(p, material.filter); });
  }();
  if (material.grain.is_grain)
    points = shaken(std::move(points), impl_->with_solids(), spacing, material.filter);
  const pbd::PeriodicAxes axes = periodic_axes(impl_->def.periodic);
  check::between_seams(axes, points, "a particle of add_fluid");
  std::vector<Vec3> safe = safe_points(points, with_seam_images(positions(), axes, spacing),
                                       impl_->with_solids(), spacing, rounding, material.filter);
  impl_->keep_off_cloth(safe, material.filter);
  check_room(ids().size(), static_cast<double>(safe.size()));
  const size_t before = ids().size();
  impl_->add(def.fluid, safe, {}, def.velocity, false);
  if (def.seeding == Seeding::disordered) impl_->relax_from(before);
  return safe.size();
}

ParticleId World::Calls::add_particles(FluidId fluid, std::span<const Vec3> positions,
                                       std::span<const Vec3> velocities) {
  impl_->fluids.get(fluid);
  check_room(ids().size(), static_cast<double>(positions.size()));
  if (!velocities.empty() && velocities.size() != positions.size()) {
    throw Error(ErrorCode::invalid_argument, "add_particles got " + std::to_string(velocities.size()) +
                                                 " velocities for " + std::to_string(positions.size()) +
                                                 " positions; it takes none, or as many");
  }
  for (Vec3 p : positions) check::value("a position of add_particles", p);
  for (Vec3 v : velocities) check::value("a velocity of add_particles", v);
  check::between_seams(periodic_axes(impl_->def.periodic), positions, "a position of add_particles");
  check_crowding(
      impl_->crowding_bound, positions, [this] { return this->positions(); }, impl_->kernel.h,
      "add_particles");
  const ParticleId first = impl_->next_id;
  impl_->add(fluid, positions, velocities, {0, 0, 0}, true);
  return first;
}

void World::Calls::remove_particles(std::span<const ParticleId> gone) {
  std::vector<bool>& removed = impl_->removed_particles;
  std::vector<size_t> slots;
  for (ParticleId id : gone) {
    const auto at = std::lower_bound(impl_->ids.begin(), impl_->ids.end(), id);
    const auto slot = static_cast<size_t>(at - impl_->ids.begin());
    if (at == impl_->ids.end() || *at != id || (!removed.empty() && removed[slot]))
      throw Error(ErrorCode::not_found, "no particle has the id " + std::to_string(id));
    slots.push_back(slot);
  }
  if (gone.empty()) return;
  if (removed.empty()) removed.resize(impl_->ids.size());
  for (const size_t slot : slots) removed[slot] = true;
}

void World::Calls::relax(int iterations) {
  check::value("relax's iterations", iterations, between(0, 100000));
  impl_->read_reactions();  // of the last step
  impl_->with_all().relax(world_tuning::relaxing_step, iterations);
  impl_->state_changed();
  impl_->cloth_is_on_host = impl_->vertex_count == 0;
}

// ---- time ----

namespace {

double ms_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

void World::Calls::begin(float dt, std::optional<int> iterations) {
  check::value("step's dt", dt, at_least(1e-12), "s");  // substeps of a shorter step may round to 0
  if (iterations) check::value("step's iterations", *iterations, between(1, 1000));
  if (!std::exchange(impl_->has_begun, true)) impl_->log_before_steps();
  impl_->step_start = std::chrono::steady_clock::now();
  const WorldDef& def = impl_->def;
  impl_->begun_iterations =
      iterations.value_or(impl_->budget.choose(double{def.step_budget_ms}, def.iterations));
  impl_->plan_dripping();
  impl_->plan_emission(dt);
  Engine& engine = impl_->with_all();
  impl_->state_changed();
  impl_->forget_reactions();  // if the step fails, there are none
  engine.begin_step(dt, impl_->begun_iterations);
  impl_->begun_step = dt;
  impl_->begin_ms = ms_since(impl_->step_start);
}

StepReport World::Calls::finish() {
  const auto start = std::chrono::steady_clock::now();
  Engine& engine = *impl_->engine;
  const float dt = impl_->begun_step;
  EngineStep done = engine.end_step();
  if (const pbd::ParticleSummary& summary = done.result.summary; summary.non_finite) {
    throw Error(ErrorCode::non_finite,
                std::to_string(summary.non_finite) + " particles became non-finite, the first of them " +
                    impl_->name_particle(summary.first_bad_slot) +
                    "; the state is the one before the step. A shorter step or more substeps may help");
  }
  impl_->monitor().commit();
  impl_->time += dt;
  impl_->last_substep = dt / static_cast<float>(done.result.substeps);
  impl_->touched_pieces = impl_->pieces;
  impl_->read_probes();
  impl_->note_events();
  impl_->note_sleep();
  impl_->flows.clear();
  impl_->note_cloth_step(dt);
  StepReport report;
  impl_->wet_cloth(dt, report);
  impl_->tear_cloth();  // last: contacts with cloth use the vertex numbers of before
  report.removed = impl_->take_sinks();
  report.overflows = done.overflows;
  impl_->advance_ducts(done.pistons, dt, report);
  impl_->emit(dt, report);
  report.ms = ms_since(impl_->step_start);
  report.substeps = done.result.substeps;
  report.iterations = impl_->begun_iterations;
  report.density_iterations = double(done.density_iterations) / report.substeps;
  report.stage_ms = done.stage_ms;
  report.rigid_ms = done.rigid_ms;
  report.contacts = done.result.contacts;
  report.max_neighbours = done.result.max_neighbours;
  report.max_speed = std::sqrt(done.result.summary.max_speed2);
  report.diffuse = engine.diffuse_count();
  report.diffuse_refused = engine.diffuse_refused();
  impl_->budget.note(report, impl_->begin_ms + ms_since(start));
  try {
    impl_->log_step(report);
  } catch (const std::bad_alloc&) {  // the step is done, and a message is not worth it
  }
  return report;
}

double World::Calls::time() const {
  return impl_->time;
}

}  // namespace meniscus
