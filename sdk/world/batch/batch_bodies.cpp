// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// WorldBatch's calls about bodies, and about whole worlds that come and go.
#include <meniscus/error.h>

#include <algorithm>
#include <string>
#include <vector>

#include "sdk/world/batch/batch_impl.h"
#include "sdk/world/check/check.h"
#include "sdk/world/state/hashed_elements.h"

namespace meniscus {

// ---- bodies ----

/// Throws Error(not_found) for the id of another world.
const BodyEntry& WorldBatch::Impl::body(BodyId id) const {
  const auto& all = host().bodies;
  const bool is_known = std::find(ids.begin(), ids.end(), id) != ids.end();
  return all.get(is_known ? all.id(id.index) : id);
}

template <class Call>
void WorldBatch::Impl::for_body(const char* name, uint32_t world, BodyId id, const Call& call) {
  check_world(name, world);
  run(
      [&] {
        call(BodyCalls{body(id), engine().rigid_worlds().world(world), id.index});
        bodies.valid = hashes.valid = false;
      },
      name);
}

/// Particles that bodies were placed on are noted in those worlds alone, as a step of a world alone notes
/// them.
void WorldBatch::Impl::place_bodies() {
  bool any = false;
  for (uint32_t w = 0; w < worlds; ++w) {
    chosen[w] = placed[w] && stepping[w];
    any |= chosen[w] != 0;
    if (chosen[w]) placed[w] = 0;
  }
  if (any) engine().place_worlds(chosen);
}

std::span<const BodyState> WorldBatch::Impl::read_bodies() {
  World::Impl& w = host();
  return bodies.get(size_t{worlds} * w.bodies.size(), [&](std::span<BodyState> out) {
    const std::span<const collision::RigidImpulse> forces = engine().body_forces();
    size_t next = 0;
    for (uint32_t k = 0; k < worlds; ++k) {
      collision::RigidWorld& rigid = engine().rigid_worlds().world(k);
      w.bodies.for_each([&](uint32_t number, const BodyEntry& entry) {
        const BodyState state = BodyCalls{entry, rigid, number}.state(forces[k * bodies_each + number]);
        out[next++] = w.origin.outward(state);
      });
    }
  });
}

void WorldBatch::Impl::hash_worlds(std::span<uint64_t> out) const {
  engine().hash_worlds(out);
  for (uint32_t w = 0; w < worlds && bodies_each > 0; ++w)
    out[w] += hash_bodies(host().bodies, engine().rigid_worlds().world(w));
}

std::size_t WorldBatch::body_count() const {
  return impl_->host().bodies.size();
}

std::vector<BodyId> WorldBatch::body_ids() const {
  return impl_->ids;
}

std::span<const BodyState> WorldBatch::body_states() const {
  return impl_->run([&] { return impl_->read_bodies(); }, "body_states");
}

void WorldBatch::set_body_pose(uint32_t world, BodyId body, const Pose& pose) {
  check::value("set_body_pose's pose", pose);
  impl_->for_body("set_body_pose", world, body, [&](const BodyCalls& calls) {
    calls.rigid.set_pose(calls.number, impl_->host().origin.inward(pose));
    impl_->placed[world] = 1;
  });
}

void WorldBatch::set_body_velocity(uint32_t world, BodyId body, Vec3 velocity, Vec3 angular_velocity) {
  impl_->for_body("set_body_velocity", world, body,
                  [&](const BodyCalls& calls) { calls.set_velocity(velocity, angular_velocity); });
}

void WorldBatch::apply_force(uint32_t world, BodyId body, Vec3 force) {
  impl_->for_body("apply_force", world, body, [&](const BodyCalls& calls) {
    calls.apply_force(force, calls.rigid.centre_of_mass(calls.number));
  });
}

void WorldBatch::apply_force(uint32_t world, BodyId body, Vec3 force, Vec3 point) {
  impl_->for_body("apply_force", world, body, [&](const BodyCalls& calls) {
    calls.apply_force(force, impl_->host().origin.inward(point));
  });
}

void WorldBatch::apply_torque(uint32_t world, BodyId body, Vec3 torque) {
  impl_->for_body("apply_torque", world, body, [&](const BodyCalls& calls) { calls.apply_torque(torque); });
}

void WorldBatch::apply_impulse(uint32_t world, BodyId body, Vec3 impulse, Vec3 point) {
  impl_->for_body("apply_impulse", world, body, [&](const BodyCalls& calls) {
    calls.apply_impulse(impulse, impl_->host().origin.inward(point));
  });
}

void WorldBatch::move_body(uint32_t world, BodyId body, const Pose& target, float duration) {
  impl_->for_body("move_body", world, body,
                  [&](const BodyCalls& calls) { calls.move(impl_->host().origin.inward(target), duration); });
}

// ---- whole worlds ----

namespace {

[[noreturn]] void refuse_insert(const std::string& why) {
  throw Error(ErrorCode::invalid_argument, "WorldBatch::insert: " + why);
}

void expect_same(const char* what, size_t got, size_t have) {
  if (got != have)
    refuse_insert("the world has " + std::to_string(got) + " " + what + ", and the archetype " +
                  std::to_string(have));
}

/// Whether two rigid worlds have the same bodies, of the same masses, in the same places of their lists.
bool are_alike(const collision::RigidWorld& a, const collision::RigidWorld& b) {
  const collision::RigidLayout x = a.layout(), y = b.layout();
  if (x.objects != y.objects || x.proxies != y.proxies || x.moving != y.moving || x.joints != y.joints)
    return false;
  for (uint32_t n = 0; n < a.body_slots(); ++n) {
    const collision::RigidMass m = a.mass(n), o = b.mass(n);
    if (m.inverse_mass != o.inverse_mass || m.inverse_inertia != o.inverse_inertia) return false;
  }
  return true;
}

/// Whether cloth has the same triangles, lengths at rest, masses, fabrics, held vertices and attachments.
bool are_alike(const EngineCloth& a, const EngineCloth& b) {
  const auto same = [](const auto& x, const auto& y, const auto& equal) {
    return std::equal(x.begin(), x.end(), y.begin(), y.end(), equal);
  };
  const cloth::ClothModel &m = a.model, &n = b.model;
  return m.held == n.held && m.rest == n.rest && m.constraints.masses == n.constraints.masses &&
         same(a.position, b.position, [](const pbd::Vec4& x, const pbd::Vec4& y) { return x.w == y.w; }) &&
         same(m.triangles, n.triangles,
              [](const pbd::SurfaceTriangle& x, const pbd::SurfaceTriangle& y) {
                return x.a == y.a && x.b == y.b && x.c == y.c && x.piece == y.piece;
              }) &&
         same(m.constraints.edges.items, n.constraints.edges.items,
              [](const cloth::EdgeConstraint& x, const cloth::EdgeConstraint& y) {
                return x.a == y.a && x.b == y.b && x.rest_length == y.rest_length &&
                       x.compliance == y.compliance;
              }) &&
         same(a.attachments, b.attachments,
              [](const collision::BodyAttachment& x, const collision::BodyAttachment& y) {
                return x.vertex == y.vertex && x.body == y.body && x.anchor == y.anchor;
              });
}

}  // namespace

World WorldBatch::Impl::extract(uint32_t world) const {
  World made = archetype.clone();
  WorldDef def = made.def();
  def.gravity = gravities[world];
  if (def.gravity != made.def().gravity) made.set_def(def);
  const EngineWorld state = run(
      [&] {
        engine().continue_from(last[world]);
        return engine().read_world(world);
      },
      "extract");
  World::Impl& to = *made.impl_;
  to.run([&](auto) {
    to.with_all();
    if (bodies_each > 0) {
      const collision::RigidWorld::SnapshotPtr rigid = collision::RigidWorld::make_snapshot();
      engine().rigid_worlds().world(world).save(*rigid);
      to.rigid.restore(*rigid);
      to.engine->place_bodies();
      to.touches = to.rigid.touches();
      to.note_sleep();
      to.sleeps.clear();
      to.events.clear();
    }
    to.engine->write_world(0, state);
    if (vertices_each > 0) to.note_cloth_step(dt);
    if (placed[world]) to.engine->place_bodies();  // which notes what they overlap
    to.state_changed();
    to.time = status[world].time;
    if (to.time > archetype.time()) to.last_substep = state.last.of_all;
  });
  return made;
}

/// What differs beyond the places and velocities of particles and bodies would act in all worlds, or in none.
void WorldBatch::Impl::check_insert(World::Impl& state) const {
  const World::Impl& own = *archetype.impl_;
  expect_same("particles", state.ids.size(), each);
  expect_same("fluids", state.fluids.size(), own.fluids.size());
  expect_same("shapes", state.shapes.size(), own.shapes.size());
  expect_same("bodies", state.bodies.size(), own.bodies.size());
  expect_same("joints", state.joints.size(), own.joints.size());
  expect_same("pieces of cloth", state.cloths.size(), own.cloths.size());
  if (vertices_each > 0 && !are_alike(*state.uploaded_cloth, *own.uploaded_cloth))
    refuse_insert("the world has other cloth, or other vertices are held or attached");
  std::vector<uint32_t> fluids(each), others(each);
  own.engine->read_fluids(fluids);
  state.engine->read_fluids(others);
  if (fluids != others) refuse_insert("the world has its fluids in another order");
  if (state.engine->any_crowd())
    refuse_insert("add_particles() may have crowded particles; step the world until they have parted");
  if (!are_alike(state.rigid, own.rigid)) refuse_insert("the world has other bodies or joints");
}

void WorldBatch::Impl::insert(uint32_t world, const World& state) {
  const World copy = state.clone();
  World::Impl& from = *copy.impl_;
  EngineWorld particles;
  const collision::RigidWorld::SnapshotPtr rigid = collision::RigidWorld::make_snapshot();
  from.run([&](auto) {
    from.with_all();
    check_insert(from);
    particles = from.engine->read_world(0);
    from.rigid.save(*rigid);
  });
  std::vector<Vec3> all = gravities;
  all[world] = from.def.gravity;
  set_gravities(all);
  run(
      [&] {
        host().monitor().commit();
        engine().write_world(world, particles);
        if (bodies_each > 0) {
          engine().rigid_worlds().world(world).restore(*rigid);
          engine().rigid_worlds().renew(world);
        }
        engine().place_worlds(std::vector<uint32_t>(worlds, 0));
        placed[world] = 0;
        last[world] = particles.last;
        status[world].failed = false;
        status[world].time = from.time;
        changed();
      },
      "insert");
}

void WorldBatch::insert(uint32_t world, const World& state) {
  impl_->check_world("insert", world);
  impl_->insert(world, state);
}

}  // namespace meniscus
