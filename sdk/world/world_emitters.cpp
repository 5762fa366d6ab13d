// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// World's emitters. The particles of a step are planned before it, while nothing has changed and a failure is
// harmless. They are made after the step.
#include <meniscus/world.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "sdk/world/check/check.h"
#include "sdk/world/check/periodic.h"
#include "sdk/world/tuning.h"
#include "sdk/world/world_calls.h"

namespace meniscus {

namespace {

/// The pose at a fraction of the time of a constant motion from a to b.
Pose between(const Pose& a, const Pose& b, float fraction) {
  const Quat p = a.rotation, q = b.rotation;
  const float cosine = p.x * q.x + p.y * q.y + p.z * q.z + p.w * q.w;
  const float u = 1 - fraction, v = cosine < 0 ? -fraction : fraction;
  return {u * a.position + fraction * b.position,
          normalized({u * p.x + v * q.x, u * p.y + v * q.y, u * p.z + v * q.z, u * p.w + v * q.w})};
}

/// The flow of all places together, m³/s.
double flow_of(const EmitterDef& def, const EmitterSites& sites) {
  const double full = sites.area * double{def.speed};
  if (def.rate > 1.0001 * full) {
    std::ostringstream value, allowed;
    value << def.rate << " m³/s";
    allowed << "at most speed · area = " << full << " m³/s";
    check::refuse("EmitterDef::rate", value.str(), allowed.str());
  }
  return def.rate > 0 ? std::min(double{def.rate}, full) : full;
}

EmitterClock clock_of(const EmitterDef& def, const EmitterSites& sites, double now) {
  const double flow = flow_of(def, sites), full = sites.area * double{def.speed};
  const double period = sites.layer * sites.area / flow;
  return {static_cast<uint32_t>(sites.places.size()), std::max(now, double{def.start}), double{def.stop},
          period, std::min(1.0, 2 * (1 - flow / full))};
}

/// Whether none is due at the clock's times any more. Those of a duct never are.
bool is_done(const EmitterEntry& e) {
  if (e.def.mode == EmitterMode::imposed) return true;
  return e.def.most_particles && e.count.total >= *e.def.most_particles;
}

}  // namespace

EmitterId World::Calls::create_emitter(const EmitterDef& def) {
  check::def(def);
  check::no_periodic_axes(impl_->def, "emitters");
  impl_->fluids.get(def.fluid);
  if (def.body) impl_->bodies.get(*def.body);
  impl_->check_imposed(def);
  EmitterSites sites = emitter_sites(def.opening, impl_->def.particle_spacing, impl_->def.read_file);
  const EmitterClock clock = clock_of(def, sites, impl_->time);
  return impl_->emitters.insert({def, std::move(sites), clock, {}, {}, {}, {}});
}

FlowCount World::Calls::emitter_count(EmitterId id) const {
  return impl_->emitters.get(id).count;
}

/// Finds the departures that will be due, and reserves room for them.
void World::Impl::plan_emission(float dt) {
  const double until = time + double{dt}, in_ducts = plan_ducts(dt);
  double expected = in_ducts, most = 0;
  std::string_view busiest;
  emitters.for_each([&](uint32_t, EmitterEntry& e) {
    if (is_done(e)) return;
    const double of_this = e.clock.expected(until);
    expected += of_this;
    if (of_this > most) busiest = e.def.name;
    most = std::max(most, of_this);
  });
  if (expected == 0) {
    emitters.for_each([](uint32_t, EmitterEntry& e) { e.departures.clear(); });
    return;
  }
  check_room(ids.size() + planned_drips, expected, busiest);
  if (expected > world_tuning::most_arrivals) {
    std::ostringstream why;
    why.precision(4);
    why << "the emitters would make " << expected << " particles in one step of " << dt
        << " s, most of them \"" << busiest << "\"; a step makes at most "
        << static_cast<uint64_t>(world_tuning::most_arrivals) << ". A shorter step makes fewer";
    throw Error(ErrorCode::capacity, why.str());
  }
  auto due = static_cast<size_t>(in_ducts);
  emitters.for_each([&](uint32_t, EmitterEntry& e) {
    e.departures.clear();
    if (is_done(e)) return;
    e.clock.due(until, e.departures);
    if (e.def.body) e.body_before = rigid.pose(e.def.body->index);
    due += e.departures.size();
  });
  if (due > 0) engine->make_room(static_cast<uint32_t>(due) + planned_drips);
}

/// Adds the places that the departures reach by the end of the step.
void World::Impl::add_arrivals(const EmitterEntry& e, float dt) {
  const auto spacing = double{def.particle_spacing};
  const auto lead = static_cast<float>(0.5 * std::max(e.sites.layer, spacing));
  const CollisionFilter filter = fluids.get(e.def.fluid).filter;
  const Pose body_after = e.def.body ? rigid.pose(e.def.body->index) : Pose{};
  const Pose opening_after = e.def.body ? body_after * e.def.pose : e.def.pose;
  for (const Departure& d : e.departures) {
    const auto age = static_cast<float>(time - d.time);
    const EmitterSite& site = e.sites.places[d.place];
    const Vec3 front = site.position + lead * site.direction;
    Pose opening = opening_after;
    Vec3 carried{0, 0, 0};
    if (e.def.body) {
      opening = between(e.body_before, body_after, std::max(0.0f, 1 - age / dt)) * e.def.pose;
      carried = carried_velocity(*e.def.body, to_world(opening_after, front),
                                 opening.rotation * conjugate(opening_after.rotation));
    }
    const Vec3 velocity = carried + e.def.speed * rotate(opening.rotation, site.direction);
    const Vec3 to = to_world(opening, front) + age * velocity + 0.5f * age * age * def.gravity;
    emission.arrivals.push_back(
        {to_world(opening_after, front), to, velocity + age * def.gravity, filter, d.waits});
  }
}

/// The velocity that a body gave to a particle that is now at p; `turned` is the body's rotation then,
/// relative to now.
Vec3 World::Impl::carried_velocity(BodyId body, Vec3 p, Quat turned) const {
  const Vec3 arm = p - rigid.centre_of_mass(body.index);
  return rigid.velocity(body.index) + rotate(turned, cross(rigid.angular_velocity(body.index), arm));
}

/// The number of steps for which a particle keeps its velocity: until it is a support radius in front of the
/// opening.
double World::Impl::held_steps(const EmitterEntry& e, const Departure& d, float dt) const {
  const double left = double{kernel.h} / double{e.def.speed} - (time - d.time);
  return std::max(std::ceil(left / double{dt}), 0.0);
}

/// Makes the particles that are due and have room.
void World::Impl::emit(float dt, StepReport& report) {
  emission.arrivals.clear();
  emitters.for_each([&](uint32_t, EmitterEntry& e) {
    if (e.def.mode == EmitterMode::imposed) return;
    e.count.last_step = 0;
    add_arrivals(e, dt);
  });
  if (emission.arrivals.empty()) return;
  state_changed();
  engine->find_room(emission.arrivals, emission.has_room);
  emission.batch.clear();
  size_t next = 0;
  ParticleId made = next_id;
  emitters.for_each([&](uint32_t index, EmitterEntry& e) {
    for (const Departure& d : e.departures) {
      const size_t at = next++;
      const bool leaves = emission.has_room[at] && !is_done(e);
      e.clock.note(d, leaves);
      if (!leaves && !is_done(e))
        report.emission_refused +=
            e.clock.refused(d, time, double{dt}) * std::pow(double{def.particle_spacing}, 3);
      if (!leaves) continue;
      add_to(emission.batch, e.def.fluid, emission.arrivals[at].to, emission.arrivals[at].velocity);
      const double steps = held_steps(e, d, dt), most = pbd::most_held;
      emission.batch.phase.back() |= pbd::held_for(static_cast<uint32_t>(std::min(steps, most)));
      if (steps > most) ++report.overflows.emitter_hold;
      ++e.count.last_step;
      ++e.count.total;
      flows.push_back({emitters.id(index), {}, made++});
    }
  });
  append(emission.batch);
  report.emitted += static_cast<uint32_t>(emission.batch.position.size());
}

}  // namespace meniscus
