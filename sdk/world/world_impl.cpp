// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The implementation behind World: materials, uploads of solids, and removal of particles.
#include "sdk/world/world_impl.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "collision/contact/tuning.h"
#include "sdk/world/check/check.h"
#include "sdk/world/check/periodic.h"
#include "sdk/world/solids/seam_images.h"
#include "sdk/world/tuning.h"

namespace meniscus {

namespace {

fluid::DensityMethod method_of(DensitySolver solver) {
  switch (solver) {
    case DensitySolver::pcisph:
      return fluid::DensityMethod::pcisph;
    case DensitySolver::wcsph:
      return fluid::DensityMethod::wcsph;
    case DensitySolver::dfsph:
      return fluid::DensityMethod::dfsph;
    default:
      return fluid::DensityMethod::constraint;
  }
}

}  // namespace

EngineDef World::Impl::engine_def() {
  EngineDef e;
  e.kernel = kernel;
  e.rigid = &rigid;
  e.origin = origin.at();
  e.particle_spacing = def.particle_spacing;
  e.solver.gravity = def.gravity;
  e.solver.support_radius = kernel.h;
  e.solver.contact_radius = def.contact_radius * def.particle_spacing;
  e.solver.substeps = def.substeps;
  e.solver.iterations = def.iterations;
  e.solver.cfl_number = def.cfl_number;
  e.solver.min_substeps = def.min_substeps;
  e.solver.max_substeps = def.max_substeps;
  e.solver.periodic = periodic_axes(def.periodic);
  e.solver.fixed_sums = def.sums == Sums::fixed;
  const DensitySolverDef& d = def.density;
  e.density.chebyshev = d.solver != DensitySolver::jacobi;
  e.density.pressure_grid = d.solver == DensitySolver::grid;
  e.density.relaxation = d.relaxation;
  e.density.warm_start = d.warm_start;
  e.density.spectral_bound = d.spectral_bound;
  e.density.tolerance = d.tolerance;
  e.density.compressibility = d.compressibility;
  e.density.correction_limit = d.correction_limit * def.particle_spacing;
  e.density.courant_number = d.courant_number;
  e.density.parting_speed = e.solver.contact_radius / collision::shape_tuning::exit_time;
  e.density.spacing = def.particle_spacing;
  e.density.gravity = def.gravity;
  e.density.method = method_of(d.solver);
  e.cloth = {def.cloth.over_relaxation, def.cloth.warm_start, def.cloth.stretch_rounds};
  // The repulsion scales with the hydrostatic pressure of one support radius of water. Without gravity,
  // Earth's gravity is used.
  const float g = length(def.gravity);
  e.density.artificial_pressure = {d.artificial_pressure.strength * 1000.0f * (g > 0 ? g : 9.81f) * kernel.h,
                                   d.artificial_pressure.exponent, d.artificial_pressure.distance};
  if (def.diffuse)
    e.diffuse = fluid::diffuse_parameters(*def.diffuse, def.particle_spacing, kernel.h, def.gravity);
  return e;
}

ParticleMaterial material_of(const FluidDef& def) {
  return {{def.rest_density, def.dynamic_viscosity, def.xsph, def.vorticity_confinement, def.cohesion,
           def.surface_tension},
          {},
          def.filter,
          def.name,
          def.color};
}

void check_room(size_t present, double added, std::string_view emitter) {
  constexpr size_t most = size_t{1} << 27;
  const double wanted = static_cast<double>(present) + added;
  if (wanted <= static_cast<double>(most)) return;
  std::ostringstream why;
  why.precision(4);
  why << "a world holds at most " << most << " particles; " << wanted << " were asked for";
  if (!emitter.empty()) why << ", most of them by the emitter \"" << emitter << "\"";
  why << ". A wider particle_spacing needs fewer";
  throw Error(ErrorCode::capacity, why.str());
}

void check_baseline_kernel(const WorldDef& def) {
  if (!is_baseline(def.density.solver) || def.kernel == SmoothingKernel::poly6_spiky) return;
  check::refuse("WorldDef::kernel", "wendland_c2 or cubic_spline",
                "poly6_spiky with the solvers pcisph, wcsph and dfsph");
}

collision::RigidWorldDef rigid_world_def(const WorldDef& def) {
  return {def.gravity, def.rigid.substeps, def.rigid.iterations, def.rigid.solver == RigidSolver::device};
}

World::Impl::Impl(const WorldDef& world_def)
    : WorldTables((check::def(world_def), check_baseline_kernel(world_def), world_def)),
      rigid(rigid_world_def(def)),
      kernel(fluid::calibrate(def.particle_spacing, double(def.support_ratio) * def.particle_spacing,
                              def.kernel)),
      log(def.log) {
  check::def(def);  // far from zero, the ends of a periodic axis may round to one
  engine = make_engine(engine_def(), def, device);
  log.note("the world runs on " + device.name + (device.reason.empty() ? "" : "; " + device.reason));
}

void World::Impl::check_solver_allows(const char* what) const {
  if (!is_baseline(def.density.solver)) return;
  check::refuse("DensitySolverDef::solver", "pcisph, wcsph or dfsph",
                std::string("jacobi, chebyshev or grid in a world with ") + what);
}

void World::Impl::check_baseline_suits() const {
  bool any_grains = false;
  fluids.for_each([&](uint32_t, const ParticleMaterial& m) { any_grains |= m.grain.is_grain; });
  const char* present = cloths.size() ? "cloth" : ropes.size() ? "ropes" : "granular materials";
  if (!cloths.size() && !ropes.size() && !any_grains) return;
  check::refuse("DensitySolverDef::solver", "pcisph, wcsph or dfsph",
                std::string("jacobi, chebyshev or grid in a world with ") + present);
}

FluidId World::Impl::create_material(const ParticleMaterial& material) {
  if (fluids.prepare() > pbd::phase_group_mask)
    throw Error(ErrorCode::capacity, "a world has no room for more than 65536 fluids");
  cloth_changed();  // this fluid may load it
  materials_are_on_device = false;
  return fluids.insert(material);
}

void World::Impl::set_materials() {
  std::vector<ParticleMaterial> all;
  fluids.for_each([&](uint32_t, const ParticleMaterial& m) { all.push_back(m); });
  materials_are_on_device = false;  // should this fail in the middle
  engine->set_materials(all);
  materials_are_on_device = true;
}

void World::Impl::upload_materials() {
  if (!materials_are_on_device) set_materials();
}

void World::Impl::add(FluidId fluid, std::span<const Vec3> new_positions,
                      std::span<const Vec3> new_velocities, Vec3 velocity, bool may_crowd) {
  ParticleBatch batch;
  batch.by_hand = true;
  batch.may_crowd = may_crowd;
  for (size_t i = 0; i < new_positions.size(); ++i)
    add_to(batch, fluid, new_positions[i], new_velocities.empty() ? velocity : new_velocities[i]);
  append(batch);
}

void World::Impl::add_to(ParticleBatch& batch, FluidId fluid, Vec3 position, Vec3 velocity) const {
  const float s = def.particle_spacing;
  const ParticleMaterial& material = fluids.get(fluid);
  const pbd::Phase kind = material.grain.is_grain ? pbd::phase_grain : pbd::phase_fluid;
  batch.position.push_back(pbd::with_w(position, 1 / (material.fluid.rest_density * s * s * s)));
  batch.velocity.push_back(pbd::with_w(velocity, 0));
  batch.phase.push_back(kind | fluid.index);
}

void World::Impl::append(const ParticleBatch& batch) {
  upload_materials();
  const size_t needed = ids.size() + batch.position.size();
  if (needed > ids.capacity()) ids.reserve(std::max(needed, 2 * ids.size()));
  engine->append(batch);  // commits
  for (size_t i = 0; i < batch.position.size(); ++i) ids.push_back(next_id++);
  state_changed();
}

void World::Impl::relax_from(size_t slot) {
  try {
    with_all().relax_from(static_cast<uint32_t>(slot), world_tuning::relaxing_step,
                          world_tuning::seeding_relaxations);
    state_changed();
  } catch (...) {
    std::vector<bool> added(ids.size(), false);
    std::fill(added.begin() + static_cast<std::ptrdiff_t>(slot), added.end(), true);
    drop(added);
    throw;
  }
}

/// Fields of solids are removed from the engine, so that they go first.
World::Impl::~Impl() {
  shapes.clear();
  bodies.clear();
}

void World::Impl::solids_changed() {
  note_revision();
  solids_are_on_device = false;
  forces_are_on_device &= force_fields.size() == 0;
  state_changed();
}

void World::Impl::upload_solids() {
  if (solids_are_on_device) return;
  engine->set_shapes(solid_shapes());
  solids_are_on_device = true;
}

SolidShapes World::Impl::solid_shapes() const {
  SolidShapes all;
  const pbd::PeriodicAxes axes = periodic_axes(def.periodic);
  const auto add = [&](uint32_t owner, const SolidPieces& solid, const auto& finish) {
    const auto first_wall = static_cast<uint32_t>(all.shapes.size());
    for (const SolidPieces::Piece& piece : solid.pieces) {
      collision::Shape shape = piece.shape;
      finish(piece, shape);
      shape.owner = owner;
      shape.first_opening += static_cast<uint32_t>(all.openings.size());
      shape.first_wall = first_wall;
      shape.wall_count = solid.openings.empty() ? 0 : static_cast<uint32_t>(solid.pieces.size());
      if (axes.any()) {
        const std::vector<collision::Shape> images = with_seam_images(shape, axes, kernel.h, {});
        all.shapes.insert(all.shapes.end(), images.begin(), images.end());
      } else {
        all.shapes.push_back(shape);
      }
    }
    all.openings.insert(all.openings.end(), solid.openings.begin(), solid.openings.end());
  };
  shapes.for_each([&](uint32_t number, const ShapeEntry& entry) {
    add(number, entry.solid, [&](const SolidPieces::Piece& piece, collision::Shape& shape) {
      shape = placed(piece, entry.def.pose);
    });
  });
  all.fixed = static_cast<uint32_t>(all.shapes.size());
  bodies.for_each([&](uint32_t number, const BodyEntry& entry) {
    add(number, entry.solid, [&](const SolidPieces::Piece& piece, collision::Shape& shape) {
      shape.body = number;
      collision::CarriedShape carried = piece.place;
      carried.shape = static_cast<uint32_t>(all.shapes.size());
      carried.body = number;
      carried.pose = inverse(entry.principal) * piece.place.pose;
      all.carried.push_back(carried);
      if (piece.film) all.films.push_back({carried.shape, number, carried.pose, piece.film});
    });
  });
  return all;
}

namespace {

fluid::ProbeMeasure measure_of(ProbeKind kind) {
  using enum fluid::ProbeMeasure;
  switch (kind) {
    case ProbeKind::point_pressure:
      return pressure;
    case ProbeKind::wall_pressure:
    case ProbeKind::wall_force:
      return force;
    case ProbeKind::wall_torque:
      return torque;
    case ProbeKind::point_velocity:
      return velocity;
    case ProbeKind::point_density:
      return density;
    case ProbeKind::flow:
      return flow;
    case ProbeKind::level:
      return level;
    case ProbeKind::fluid_momentum:
      return momentum;
    case ProbeKind::fluid_angular_momentum:
      return angular_momentum;
    case ProbeKind::fluid_centre:
      return centre;
  }
  return pressure;
}

}  // namespace

void World::Impl::upload_probes() {
  if (probes_are_on_device) return;
  std::vector<fluid::Probe> all;
  constexpr float everywhere = 1e30f;
  probes.for_each([&](uint32_t, const ProbeDef& probe) {
    // A removed shape has no contacts, and the shape that took its number is a different one.
    const uint32_t shape = shapes.find(probe.shape) ? probe.shape.index : pbd::no_index;
    const Aabb all_space{{-everywhere, -everywhere, -everywhere}, {everywhere, everywhere, everywhere}};
    all.push_back({.measure = measure_of(probe.kind),
                   .point = probe.point,
                   .shape = shape,
                   .patch = probe.patch.value_or(all_space),
                   .normal = normalized_or(probe.normal, {0, 1, 0}),
                   .radius = probe.radius,
                   .group = probe.fluid ? probe.fluid->index : pbd::no_index});
  });
  engine->set_probes(all);
  probe_sums.assign(all.size(), {});
  probes_are_on_device = true;
}

void World::Impl::read_probes() {
  engine->read_probes(probe_sums);
  size_t place = 0;
  probes.for_each([&](uint32_t index, const ProbeDef&) { probe_values[index] = probe_sums[place++]; });
}

void World::Impl::state_changed() {
  positions.valid = velocities.valid = fluid_indices.valid = false;
  diffuse.valid = ellipsoids.valid = density_errors.valid = full_support.valid = pressures.valid = false;
  outward_positions.valid = outward_ellipsoids.valid = outward_diffuse.valid = false;
}

void World::Impl::settle() {
  rigid.remove(removed_solids);
  removed_solids.clear();
  if (removed_particles.empty()) return;
  drop(removed_particles);
  monitor().restored();  // the world is whole again
  removed_particles.clear();
}

void World::Impl::drop(const std::vector<bool>& removed) {
  std::vector<bool> kept = removed;
  kept.flip();
  engine->keep(kept);  // commits
  remove(removed);
}

void World::Impl::remove(const std::vector<bool>& removed) {
  size_t kept = 0;
  for (size_t slot = 0; slot < ids.size(); ++slot) {
    if (!removed[slot]) ids[kept++] = ids[slot];
  }
  ids.resize(kept);
  state_changed();
}

}  // namespace meniscus
