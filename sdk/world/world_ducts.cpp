// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// World's imposed emitters. A step moves the layers in their ducts. After it, layers that have passed the
// opening are ordinary fluid, and new ones follow at the back.
#include <meniscus/world.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "sdk/world/check/check.h"
#include "sdk/world/world_calls.h"

namespace meniscus {

namespace {

bool is_imposed(const EmitterEntry& e) {
  return e.def.mode == EmitterMode::imposed;
}

/// m/s, of the piston: rate over area, where a rate is given.
double speed_of(const EmitterEntry& e) {
  return e.def.rate > 0 ? std::min(double{e.def.rate} / e.sites.area, double{e.def.speed})
                        : double{e.def.speed};
}

/// The layers that may still pass the opening.
double layers_left(const EmitterEntry& e) {
  if (!e.def.most_particles) return std::numeric_limits<double>::infinity();
  const double left = static_cast<double>(*e.def.most_particles) - static_cast<double>(e.count.total);
  return std::floor(left / static_cast<double>(e.sites.places.size()));
}

/// m, how far the piston is to move from one time to another. It starts at the end of its first step.
double asked_stroke(const EmitterEntry& e, double from, double to) {
  if (!e.duct.is_due) return 0;
  const double last = (static_cast<double>(e.duct.passed) + layers_left(e)) * e.sites.layer;
  const double due = speed_of(e) * (std::min(to, double{e.def.stop}) - from);
  return std::max(0.0, std::min(due, last - e.duct.travelled));
}

bool is_over(const EmitterEntry& e, double time) {
  return time >= e.def.stop || layers_left(e) <= 0;
}

Piston piston_of(const EmitterEntry& e, float last_step) {
  const auto* disc = std::get_if<DiscOpening>(&e.def.opening);
  const auto* rectangle = std::get_if<RectangleOpening>(&e.def.opening);
  Piston piston{e.def.pose, {0, 0, 0}, disc != nullptr, {0, 0, 0}, 0};
  piston.half =
      disc ? Vec3{disc->radius, 0, disc->radius} : Vec3{rectangle->width / 2, 0, rectangle->depth / 2};
  piston.velocity = static_cast<float>(e.duct.stroke / double{last_step}) * piston.direction();
  piston.front = static_cast<float>(e.duct.travelled + e.duct.stroke -
                                    static_cast<double>(e.duct.passed) * e.sites.layer);
  return piston;
}

/// C of a fluid with one particle more than at rest in each support: a volume s³ more in 4π/3 h³. Less is no
/// particle too many, so the piston has room.
double one_more_particle(double spacing, double h) {
  return std::pow(spacing / h, 3) / (4 * std::numbers::pi / 3);
}

}  // namespace

double World::Calls::emitter_pressure(EmitterId id) const {
  return impl_->emitters.get(id).duct.pressure;
}

/// Throws if this emitter cannot be imposed.
void World::Impl::check_imposed(const EmitterDef& emitter) const {
  if (emitter.mode != EmitterMode::imposed) return;
  const auto refuse = [](const char* allowed) { check::refuse("EmitterDef::mode", "imposed", allowed); };
  if (std::holds_alternative<MeshOpening>(emitter.opening)) refuse("free for the opening of a mesh");
  if (emitter.body) refuse("free for an opening that a body carries");
  if (fluids.get(emitter.fluid).grain.is_grain) refuse("free for granular materials");
  check_solver_pushes(def.density.solver);
}

/// Throws if there are imposed emitters, or is one to be, and this solver has none.
void World::Impl::check_solver_pushes(DensitySolver solver) const {
  if (solver == DensitySolver::grid || is_baseline(solver))
    check::refuse("DensitySolverDef::solver",
                  solver == DensitySolver::grid ? "grid" : "pcisph, wcsph or dfsph",
                  "jacobi or chebyshev in a world with imposed emitters");
}

/// m, in a step of this length: at most a support radius, as the fluid is known so far in front.
double World::Impl::most_stroke(const EmitterEntry& e, float dt) const {
  return std::min(speed_of(e) * double{dt}, double{kernel.h});
}

bool World::Impl::has_imposed() const {
  bool any = false;
  emitters.for_each([&](uint32_t, const EmitterEntry& e) { any |= is_imposed(e); });
  return any;
}

/// Decides how far the pistons move in a step. Returns how many particles their ducts may need after it.
double World::Impl::plan_ducts(float dt) {
  const double until = time + double{dt}, h = kernel.h;
  double particles = 0;
  planned_step = dt;
  emitters.for_each([&](uint32_t, EmitterEntry& e) {
    if (!is_imposed(e)) return;
    Duct& duct = e.duct;
    const double layer = e.sites.layer;
    duct.asked = asked_stroke(e, time, until);
    const bool moves = duct.is_open && !duct.is_full_ahead;
    duct.stroke = moves ? std::max(0.0, std::min({duct.asked, duct.room(layer, h), h})) : 0;
    if (until < e.def.start || is_over(e, until)) return;
    const uint64_t needed = duct.needed(layer, h, duct.stroke + most_stroke(e, dt));
    particles += static_cast<double>((needed - std::min(needed, duct.made())) * e.sites.places.size());
  });
  return particles;
}

/// Tells the engine what the pistons do.
void World::Impl::upload_pistons() {
  if (!has_pistons && !has_imposed()) return;
  std::vector<Piston> pistons;
  std::vector<PistonParticle> pushed;
  emitters.for_each([&](uint32_t, const EmitterEntry& e) {
    if (!e.duct.is_open) return;
    for (const ParticleId first : e.duct.layers) {
      const ParticleId end = first + e.sites.places.size();
      for (auto at = std::ranges::lower_bound(ids, first); at != ids.end() && *at < end; ++at)
        pushed.push_back({static_cast<uint32_t>(at - ids.begin()), static_cast<uint32_t>(pistons.size())});
    }
    pistons.push_back(piston_of(e, planned_step));
  });
  std::ranges::sort(pushed, {}, &PistonParticle::slot);
  engine->set_pistons(pistons, pushed);
  has_pistons = !pistons.empty();
}

/// Notes what the pistons have done in a step, and lets layers pass, follow and end.
void World::Impl::advance_ducts(std::span<const PistonReading> readings, float dt, StepReport& report) {
  size_t next = 0;
  emitters.for_each([&](uint32_t index, EmitterEntry& e) {
    if (!is_imposed(e)) return;
    Duct& duct = e.duct;
    report.emission_refused += (duct.asked - duct.stroke) * e.sites.area;
    e.count.last_step = 0;
    duct.pressure = 0;
    if (duct.is_open) {
      const PistonReading& met = readings[next++];
      duct.pressure = met.impulse / (double{dt} * e.sites.area);
      duct.is_full_ahead =
          met.error_ahead > one_more_particle(double{def.particle_spacing}, double{kernel.h});
      duct.travelled += duct.stroke;
    }
    const double close_to = 1e-6 * e.sites.layer;
    while (!duct.layers.empty() && duct.centre(duct.passed, e.sites.layer) >= 0.5 * e.sites.layer - close_to)
      pass_layer(e, emitters.id(index));
    is_over(e, time) ? close_duct(e, emitters.id(index)) : follow_up(e, dt);
    duct.stroke = 0;
    report.emitted += e.count.last_step;
  });
}

void World::Impl::pass_layer(EmitterEntry& e, EmitterId id) {
  const auto particles = static_cast<uint32_t>(e.sites.places.size());
  const ParticleId first = e.duct.layers.front();
  for (auto at = std::ranges::lower_bound(ids, first); at != ids.end() && *at < first + particles; ++at)
    flows.push_back({id, {}, *at});
  e.duct.layers.erase(e.duct.layers.begin());
  ++e.duct.passed;
  e.count.last_step += particles;
  e.count.total += particles;
}

/// Adds layers at the back, so that the duct is filled to a support radius after a step like the last one.
/// Other particles in the way of a layer keep it back.
void World::Impl::follow_up(EmitterEntry& e, float dt) {
  if (time < e.def.start) return;
  e.duct.is_due = true;
  const uint64_t needed = e.duct.needed(e.sites.layer, double{kernel.h}, most_stroke(e, dt));
  while (e.duct.made() < needed) {
    const uint64_t k = e.duct.made();
    const auto along = static_cast<float>(e.duct.centre(k, e.sites.layer));
    emission.arrivals.clear();
    emission.batch.clear();
    for (const EmitterSite& site : e.sites.places) {
      const Vec3 at = to_world(e.def.pose, site.position + along * site.direction);
      emission.arrivals.push_back({at, at, {0, 0, 0}, {}, 0, 1});
      add_to(emission.batch, e.def.fluid, at, {0, 0, 0});
      emission.batch.phase.back() |= pbd::phase_piston;
    }
    engine->find_room(emission.arrivals, emission.has_room);
    if (std::ranges::find(emission.has_room, uint8_t{0}) != emission.has_room.end()) return;
    const ParticleId first = next_id;
    append(emission.batch);
    e.duct.layers.push_back(first);
    e.duct.is_open = true;
  }
}

/// Ends an emission. Layers that are more than half out of the opening have left, and the others are removed.
void World::Impl::close_duct(EmitterEntry& e, EmitterId id) {
  while (!e.duct.layers.empty() && e.duct.centre(e.duct.passed, e.sites.layer) >= 0) pass_layer(e, id);
  const std::vector<bool> removed = particles_in(e);
  if (!removed.empty()) drop(removed);
  e.duct.layers.clear();
  e.duct.is_open = false;
}

/// By slot, the particles in the duct; empty if there are none.
std::vector<bool> World::Impl::particles_in(const EmitterEntry& e) const {
  if (e.duct.layers.empty()) return {};
  std::vector<bool> in(ids.size());
  for (const ParticleId first : e.duct.layers) {
    const ParticleId end = first + e.sites.places.size();
    for (auto at = std::ranges::lower_bound(ids, first); at != ids.end() && *at < end; ++at)
      in[static_cast<size_t>(at - ids.begin())] = true;
  }
  return in;
}

void World::Calls::destroy_emitter(EmitterId id) {
  const EmitterEntry& e = impl_->emitters.get(id);
  std::vector<bool> in = impl_->particles_in(e);
  std::vector<bool>& removed = impl_->removed_particles;
  if (removed.empty()) removed.swap(in);
  for (size_t slot = 0; slot < in.size(); ++slot) removed[slot] = removed[slot] || in[slot];
  impl_->emitters.erase(id);
}

}  // namespace meniscus
