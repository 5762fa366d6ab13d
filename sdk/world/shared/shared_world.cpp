// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Shares a world among ranks, and says what a shared world cannot have.
#include "sdk/world/shared/shared_world.h"

#include <meniscus/error.h>

#include <algorithm>
#include <exception>
#include <string>
#include <utility>

#include "sdk/world/world_boundary.h"

namespace meniscus {

namespace {

[[noreturn]] void refuse_shared(const std::string& what) {
  throw Error(ErrorCode::invalid_argument,
              "a world that several ranks share has no " + what +
                  "; it has fluids, fixed shapes, bodies, emitters, sinks, probes and diffuse particles");
}

void check_solver(const WorldDef& def) {
  if (def.periodic.x || def.periodic.y || def.periodic.z) refuse_shared("periodic axes");
  if (def.density.tolerance > 0) refuse_shared("DensitySolverDef::tolerance");
  if (is_baseline(def.density.solver)) refuse_shared("solvers pcisph, wcsph and dfsph");
}

void check_contents(const WorldTables& world) {
  world.fluids.for_each([](uint32_t, const ParticleMaterial& m) {
    if (m.grain.is_grain) refuse_shared("granular materials");
    if (m.fluid.dynamic_viscosity > 0) refuse_shared("fluids with FluidDef::dynamic_viscosity");
  });
  if (world.cloths.size()) refuse_shared("cloth");
  if (world.ropes.size()) refuse_shared("ropes");
  if (world.force_fields.size()) refuse_shared("force fields");
}

void check_sums(const WorldTables& world, const WorldDef& def) {
  if (def.sums == Sums::fixed) return;
  const auto require = [](const char* what) {
    throw Error(ErrorCode::invalid_argument,
                std::string("a world that several ranks share needs WorldDef::sums = fixed for its ") + what +
                    ", in scenes \"sums\": \"fixed\"");
  };
  if (world.bodies.size() > 0) require("bodies");
  if (def.density.solver == DensitySolver::grid) require("pressure grid");
  world.emitters.for_each([&](uint32_t, const EmitterEntry& e) {
    if (e.def.mode == EmitterMode::imposed) require("imposed emitters");
  });
}

/// The pressure grid has its nodes in layers of slabs.
pbd::CutKind cut_kind(pbd::CutKind kind, const WorldDef& def) {
  if (def.density.solver != DensitySolver::grid) return kind;
  if (kind == pbd::CutKind::pencils)
    throw Error(ErrorCode::invalid_argument, "a world with the pressure grid is cut into slabs, not pencils");
  return pbd::CutKind::slabs;
}

}  // namespace

void SharedWorld::check(const World& world) {
  World::Impl& impl = *world.impl_;
  if (impl.device.kind == "cuda" && impl.def.sums != Sums::fixed)
    throw Error(ErrorCode::invalid_argument,
                "GPUs that share a world need WorldDef::sums = fixed, in scenes \"sums\": \"fixed\"");
  check_solver(impl.def);
  check_sums(impl, impl.def);
  check_contents(impl);
  if (!impl.hooks.empty()) refuse_shared("hooks");
  if (impl.recorder) refuse_shared("recording");
  if (impl.engine->any_crowd())
    refuse_shared(
        "particles of add_particles before the first step, since they may be too near to each other");
}

void SharedWorld::hold_back(World& world) {
  World::Impl& impl = *world.impl_;
  if (impl.engine->particle_count() > 0) return;
  impl.engine->hold_back();
  impl.holds_back = true;
}

SharedWorld::SharedWorld(World& world, pbd::Ranks& ranks, const pbd::CutPolicy& policy)
    : world_(*world.impl_), ranks_(ranks) {
  world_.run(
      [&](auto) {
        check(world);
        if (world_.device.kind == "cuda") ranks.use_gpu(world_.def.cuda_device.value_or(0));
        pbd::CutPolicy own = policy;
        own.kind = cut_kind(policy.kind, world_.def);
        own.expects_more |= world_.emitters.size() > 0;
        world_.with_all().share(ranks, own);
        world_.shared_by = static_cast<uint32_t>(ranks.count());
        world_.holds_back = false;
        if (!leads()) std::vector<ParticleId>().swap(world_.ids);  // rank 0 gives and removes them
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

bool SharedWorld::has_diffuse() const {
  return world_.def.diffuse.has_value();
}

void SharedWorld::pause() {
  world_.engine->pause_following();
}

/// Rank 0 tells the others the ids of their particles.
std::vector<ParticleId> SharedWorld::ids_of(const std::vector<uint32_t>& slots) const {
  const std::vector<uint64_t> counts = pbd::values_of_all(ranks_, uint64_t{slots.size()});
  std::vector<ParticleId> ids(slots.size());
  if (!leads()) {
    const pbd::Sent sent{0, slots.data(), slots.size() * sizeof(uint32_t)};
    ranks_.exchange({&sent, 1}, {});
    const pbd::Received received{0, ids.data(), ids.size() * sizeof(ParticleId)};
    ranks_.exchange({}, {&received, 1});
    return ids;
  }
  const auto look_up = [&](const std::vector<uint32_t>& from, std::vector<ParticleId>& to) {
    std::transform(from.begin(), from.end(), to.begin(), [&](uint32_t slot) { return world_.ids[slot]; });
  };
  look_up(slots, ids);
  for (int r = 1; r < ranks_.count(); ++r) {
    std::vector<uint32_t> its_slots(counts[static_cast<size_t>(r)]);
    const pbd::Received received{r, its_slots.data(), its_slots.size() * sizeof(uint32_t)};
    ranks_.exchange({}, {&received, 1});
    std::vector<ParticleId> its_ids(its_slots.size());
    look_up(its_slots, its_ids);
    const pbd::Sent sent{r, its_ids.data(), its_ids.size() * sizeof(ParticleId)};
    ranks_.exchange({&sent, 1}, {});
  }
  return ids;
}

ParticlesOfRank SharedWorld::read_own_particles() {
  OwnParticles own = world_.run([&](auto) { return world_.engine->read_own_particles(); }, "follow");
  ParticlesOfRank particles{{},
                            std::move(own.positions),
                            std::move(own.velocities),
                            std::move(own.fluids),
                            std::move(own.density_errors),
                            std::move(own.pressures),
                            std::move(own.diffuse)};
  particles.ids = ids_of(own.slots);
  for (Vec3& p : particles.positions) p += world_.def.origin;
  for (DiffuseParticle& p : particles.diffuse) p.position += world_.def.origin;
  return particles;
}

bool SharedWorld::follow() {
  return world_.run([&](auto) { return world_.engine->follow(); }, "follow");
}

}  // namespace meniscus
