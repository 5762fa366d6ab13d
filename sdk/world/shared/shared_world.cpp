// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Shares a world among ranks, and says what a shared world cannot have.
#include "sdk/world/shared/shared_world.h"

#include <meniscus/error.h>

#include <exception>
#include <string>
#include <utility>

#include "sdk/world/world_boundary.h"

namespace meniscus {

namespace {

[[noreturn]] void refuse(const std::string& what) {
  throw Error(ErrorCode::invalid_argument,
              "a world that several ranks share has no " + what + "; it has fluids and fixed shapes");
}

void check_solver(const WorldDef& def) {
  if (def.periodic.x || def.periodic.y || def.periodic.z) refuse("periodic axes");
  if (def.diffuse) refuse("diffuse particles");
  if (def.density.tolerance > 0) refuse("DensitySolverDef::tolerance");
  if (def.density.solver == DensitySolver::grid) refuse("pressure grid");
  if (is_baseline(def.density.solver)) refuse("solvers pcisph, wcsph and dfsph");
}

void check_contents(const WorldTables& world) {
  world.fluids.for_each([](uint32_t, const ParticleMaterial& m) {
    if (m.grain.is_grain) refuse("granular materials");
    if (m.fluid.dynamic_viscosity > 0) refuse("fluids with FluidDef::dynamic_viscosity");
  });
  if (world.bodies.size()) refuse("bodies");
  if (world.cloths.size()) refuse("cloth");
  if (world.ropes.size()) refuse("ropes");
  if (world.emitters.size()) refuse("emitters");
  if (world.sinks.size()) refuse("sinks");
  if (world.probes.size()) refuse("probes");
  if (world.force_fields.size()) refuse("force fields");
}

}  // namespace

void SharedWorld::check(const World& world) {
  World::Impl& impl = *world.impl_;
  if (impl.device.kind == "cuda" && impl.def.sums != Sums::fixed)
    throw Error(ErrorCode::invalid_argument,
                "GPUs that share a world need WorldDef::sums = fixed, in scenes \"sums\": \"fixed\"");
  check_solver(impl.def);
  check_contents(impl);
  if (!impl.hooks.empty()) refuse("hooks");
  if (impl.recorder) refuse("recording");
  if (impl.engine->any_crowd())
    refuse("particles of add_particles before the first step, since they may be too near to each other");
}

SharedWorld::SharedWorld(World& world, pbd::Ranks& ranks, const pbd::CutPolicy& policy)
    : world_(*world.impl_), ranks_(ranks) {
  world_.run(
      [&](auto) {
        check(world);
        if (world_.device.kind == "cuda") ranks.use_gpu(world_.def.cuda_device.value_or(0));
        world_.with_all().share(ranks, policy);
        world_.shared_by = static_cast<uint32_t>(ranks.count());
        world_.state_changed();
      },
      "SharedWorld");
}

SharedWorld::~SharedWorld() {
  if (!leads() || world_.lost) return;
  try {
    world_.engine->end_following();
  } catch (const std::exception&) {
    // The others know of a failure.
  }
}

std::size_t SharedWorld::own_particles() const {
  return world_.engine->own_particles();
}

void SharedWorld::pause() {
  world_.engine->pause_following();
}

ParticlesOfRank SharedWorld::read_own_particles() {
  OwnParticles own = world_.run([&](auto) { return world_.engine->read_own_particles(); }, "follow");
  ParticlesOfRank particles{{},
                            std::move(own.positions),
                            std::move(own.velocities),
                            std::move(own.fluids),
                            std::move(own.density_errors),
                            std::move(own.pressures)};
  for (const uint32_t slot : own.slots) particles.ids.push_back(world_.ids[slot]);
  for (Vec3& p : particles.positions) p += world_.def.origin;
  return particles;
}

bool SharedWorld::follow() {
  return world_.run([&](auto) { return world_.engine->follow(); }, "follow");
}

}  // namespace meniscus
