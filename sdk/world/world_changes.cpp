// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// World's calls that change parameters and state while it runs.
#include <meniscus/error.h>
#include <meniscus/world.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "sdk/world/check/check.h"
#include "sdk/world/world_calls.h"

namespace meniscus {

namespace {

void check_impulses(std::size_t targets, std::span<const Vec3> impulses) {
  if (impulses.size() != targets) {
    throw Error(ErrorCode::invalid_argument, "apply_impulses got " + std::to_string(impulses.size()) +
                                                 " impulses for " + std::to_string(targets) +
                                                 "; it takes one for each");
  }
}

constexpr const char* each_impulse = "an impulse of apply_impulses";

/// The indices of `values` in ascending order of the values. Throws if two are equal.
template <class T>
std::vector<uint32_t> ascending(std::span<const T> values, const char* what) {
  std::vector<uint32_t> order(values.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) { return values[a] < values[b]; });
  for (std::size_t k = 1; k < order.size(); ++k) {
    if (values[order[k - 1]] == values[order[k]])
      throw Error(ErrorCode::invalid_argument, std::string("apply_impulses got the ") + what + " " +
                                                   std::to_string(values[order[k]]) + " twice");
  }
  return order;
}

template <class T>
void expect_same(const char* name, const T& now, const T& wanted) {
  if (now == wanted) return;
  throw Error(ErrorCode::invalid_argument,
              std::string("set_def cannot change WorldDef::") + name + "; make a new world for that");
}

}  // namespace

void World::Calls::set_def(const WorldDef& asked) {
  const WorldDef given = asked;  // a copy, as it may be the world's own
  check::def(given);
  expect_same("origin", impl_->given.origin, given.origin);
  WorldDef def = impl_->origin.inward(given);
  const WorldDef& now = impl_->def;
  def.parallel_for = now.parallel_for;  // the device has it
  expect_same("device", now.device, def.device);
  expect_same("threads", now.threads, def.threads);
  expect_same("cuda_device", now.cuda_device, def.cuda_device);
  expect_same("cuda_stream", now.cuda_stream, def.cuda_stream);
  expect_same("particle_spacing", now.particle_spacing, def.particle_spacing);
  expect_same("support_ratio", now.support_ratio, def.support_ratio);
  expect_same("contact_radius", now.contact_radius, def.contact_radius);
  expect_same("kernel", now.kernel, def.kernel);
  expect_same("sums", now.sums, def.sums);
  expect_same("rigid.solver", now.rigid.solver, def.rigid.solver);
  expect_same("diffuse", now.diffuse, def.diffuse);
  expect_same("periodic", now.periodic, def.periodic);
  check_baseline_kernel(def);
  if (is_baseline(def.density.solver)) impl_->check_baseline_suits();
  if (impl_->has_imposed()) impl_->check_solver_pushes(def.density.solver);
  impl_->read_reactions();  // of the last step, with its gravity
  if (now.cloth != def.cloth) impl_->cloth_changed();
  const WorldDef before = std::exchange(impl_->def, def);
  const WorldDef given_before = std::exchange(impl_->given, given);
  impl_->given.parallel_for = now.parallel_for;
  try {
    impl_->engine->set_solvers(impl_->engine_def());
  } catch (...) {
    impl_->monitor().commit();
    impl_->def = before;
    impl_->given = given_before;
    impl_->engine->set_solvers(impl_->engine_def());
    impl_->monitor().restored();
    throw;
  }
  impl_->rigid.set_def(rigid_world_def(def));
  impl_->log.set_sink(def.log);
}

void World::Calls::apply_impulses(std::span<const ParticleId> targets, std::span<const Vec3> impulses) {
  check_impulses(targets.size(), impulses);
  std::vector<uint32_t> slots;
  std::vector<Vec3> pushes;
  for (const uint32_t k : ascending(targets, "particle")) {
    const auto at = std::lower_bound(impl_->ids.begin(), impl_->ids.end(), targets[k]);
    if (at == impl_->ids.end() || *at != targets[k])
      throw Error(ErrorCode::not_found, "no particle has the id " + std::to_string(targets[k]));
    const auto slot = static_cast<uint32_t>(at - impl_->ids.begin());
    check::impulse(each_impulse, impulses[k], particle_mass(impl_->fluids.id(fluids()[slot])));
    slots.push_back(slot);
    pushes.push_back(impulses[k]);
  }
  if (slots.empty()) return;
  impl_->engine->push_particles(slots, pushes);
  impl_->velocities.valid = false;
}

void World::Calls::apply_impulses(ClothId id, std::span<const uint32_t> vertices,
                                  std::span<const Vec3> impulses) {
  impl_->push_vertices(impl_->cloths.get(id).range, "cloth", vertices, impulses);
}

void World::Calls::apply_impulses(RopeId id, std::span<const uint32_t> vertices,
                                  std::span<const Vec3> impulses) {
  impl_->push_vertices(impl_->ropes.get(id).range, "rope", vertices, impulses);
}

void World::Impl::push_vertices(const VertexRange& range, const char* kind,
                                std::span<const uint32_t> vertices, std::span<const Vec3> impulses) {
  check_impulses(vertices.size(), impulses);
  for (const uint32_t k : ascending(vertices, "vertex")) {
    if (vertices[k] >= range.count())
      throw Error(ErrorCode::invalid_argument,
                  "apply_impulses got the vertex " + std::to_string(vertices[k]) + ", but the " + kind +
                      " has " + std::to_string(range.count()) + ", counted from 0");
    check::impulse(each_impulse, impulses[k], range.masses[vertices[k]]);
  }
  if (vertices.empty()) return;
  Engine& with_cloth = with_all();
  std::vector<uint32_t> numbers(vertices.begin(), vertices.end());
  for (uint32_t& v : numbers) v += range.first;
  with_cloth.push_vertices(numbers, impulses);
  cloth_is_on_host = false;
}

void World::Calls::set_fluid(FluidId id, const FluidDef& def) {
  const ParticleMaterial& now = impl_->fluids.get(id);
  if (now.grain.is_grain) throw Error(ErrorCode::invalid_argument, "set_fluid is for fluids alone");
  check::def(def);
  if (now.fluid.rest_density != def.rest_density)
    throw Error(ErrorCode::invalid_argument,
                "set_fluid cannot change FluidDef::rest_density: particles keep their mass");
  if (now.filter != def.filter) impl_->cloth_changed();  // the fluids that load it may differ now
  const ParticleMaterial before = std::exchange(impl_->fluids.edit(id), material_of(def));
  try {
    impl_->set_materials();
  } catch (...) {
    impl_->fluids.edit(id) = before;
    impl_->materials_are_on_device = false;  // the next call that needs them uploads them
    throw;
  }
  impl_->state_changed();
}

std::vector<float> World::Calls::solid_distances(std::span<const Vec3> points, float reach,
                                                 const CollisionFilter& filter) const {
  check::value("solid_distances's reach", reach, positive, "m");
  for (const Vec3 p : points) check::value("a point of solid_distances", p);
  if (points.empty()) return {};
  return impl_->with_solids().solid_distances(points, reach, filter);
}

}  // namespace meniscus
