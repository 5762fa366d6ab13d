// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Sleep of bodies whose contacts a device solves. Bodies in contact with one another are an island. It falls
// asleep when all of it has rested for Bullet's time, and wakes as a whole. A sleeping body is fixed to the
// device, which finds no contacts of it with others that are.
#include <algorithm>
#include <numeric>

#include "collision/rigid/rigid_impl.h"

namespace meniscus::collision {

namespace {

bool moves(const btRigidBody& body) {
  return !body.getLinearVelocity().isZero() || !body.getAngularVelocity().isZero();
}

/// Sets of bodies, each named by its lowest number.
class Islands {
 public:
  explicit Islands(size_t bodies) : parent_(bodies) { std::iota(parent_.begin(), parent_.end(), 0u); }

  uint32_t find(uint32_t n) {
    while (parent_[n] != n) n = parent_[n] = parent_[parent_[n]];
    return n;
  }
  void unite(uint32_t a, uint32_t b) {
    const uint32_t i = find(a), j = find(b);
    parent_[std::max(i, j)] = std::min(i, j);
  }

 private:
  std::vector<uint32_t> parent_;
};

}  // namespace

/// Whether the solid is fixed, kinematic or asleep, or gone.
bool RigidWorld::Impl::rests(const RigidRef& solid) const {
  if (!solid.is_body || !bodies.has(solid.number)) return true;
  const RigidBodyRecord& body = *bodies.slots[solid.number];
  return body.kinematic || !body.bullet->isActive();
}

/// Moves contacts of solids that rest all from the device to the list of resting ones, or those of others
/// back.
void RigidWorld::Impl::part_resting(bool fall) {
  const auto rest = [&](const auto& c) {
    return rests(solid_of_key(c.key_a)) && rests(solid_of_key(c.key_b));
  };
  std::vector<SavedContact> all = contacts->save();
  if (fall) {
    std::ranges::copy_if(all, std::back_inserter(resting), rest);
    return;
  }
  std::ranges::copy_if(resting, std::back_inserter(all), std::not_fn(rest));
  contacts->restore(all);
  std::erase_if(resting, std::not_fn(rest));
}

/// Wakes all of each island of which a body has been woken. Returns whether there were any.
bool RigidWorld::Impl::wake_islands() {
  if (!may_have_islands) return false;
  std::vector<bool> woken(bodies.slots.size());
  bool any = false;
  may_have_islands = false;
  for_each_body([&](uint32_t, const RigidBodyRecord& body) {
    const uint32_t island = body.memory.island;
    may_have_islands |= island != pbd::no_index;
    if (island == pbd::no_index || !body.bullet->isActive()) return;
    if (woken.size() <= island) woken.resize(island + 1);
    woken[island] = any = true;
  });
  if (!any) return false;
  for (const auto& body : bodies.slots) {
    if (!body || body->memory.island == pbd::no_index || body->memory.island >= woken.size() ||
        !woken[body->memory.island])
      continue;
    body->memory.island = pbd::no_index;
    if (!body->bullet->isActive()) wake_up(*body->bullet);
  }
  part_resting(false);
  return true;
}

/// Wakes what kinematic bodies that move touch, or are about to. The device sees no contacts of these two.
void RigidWorld::Impl::wake_beside_driven() {
  for (const auto& body : bodies.slots)
    if (body && body->kinematic && moves(*body->bullet)) wake_overlapping(*body->bullet);
}

/// Wakes the islands that a body touches which is awake. gather_bodies() has seen whether any body sleeps.
bool RigidWorld::Impl::wake_touched() {
  if (!any_asleep) return false;
  const auto asleep = [&](uint32_t n) {
    return bodies.has(n) && !bodies.slots[n]->kinematic && !bodies.slots[n]->bullet->isActive();
  };
  const auto wakes = [&](uint32_t n) {
    return bodies.has(n) && !bodies.slots[n]->kinematic && bodies.slots[n]->bullet->isActive();
  };
  for (const ContactBodies& c : contacts->found()) {
    if (asleep(c.a) && wakes(c.b)) wake_up(*bodies.slots[c.a]->bullet);
    if (asleep(c.b) && wakes(c.a)) wake_up(*bodies.slots[c.b]->bullet);
  }
  return wake_islands();
}

/// Wakes what rests on solids that change.
void RigidWorld::Impl::wake_resting(std::span<btRigidBody* const> changed) {
  const auto changes = [&](const RigidRef& solid) {
    return std::ranges::any_of(changed, [&](const btRigidBody* body) {
      const RigidRef ref = solid_of(body);
      return ref.is_body == solid.is_body && ref.number == solid.number;
    });
  };
  for (const SavedContact& c : resting) {
    const RigidRef a = solid_of_key(c.key_a), b = solid_of_key(c.key_b);
    if (a.is_body && bodies.has(a.number) && changes(b)) bodies.slots[a.number]->bullet->activate();
    if (b.is_body && bodies.has(b.number) && changes(a)) bodies.slots[b.number]->bullet->activate();
  }
}

/// Wakes sleeping bodies whose boxes overlap that of a solid.
void RigidWorld::Impl::wake_overlapping(btRigidBody& changed) {
  dynamics.updateSingleAabb(&changed);
  const btBroadphaseProxy& own = *changed.getBroadphaseHandle();
  for (const auto& body : bodies.slots) {
    if (!body || body->bullet->isActive()) continue;
    const btBroadphaseProxy& other = *body->bullet->getBroadphaseHandle();
    if (TestAabbAgainstAabb2(own.m_aabbMin, own.m_aabbMax, other.m_aabbMin, other.m_aabbMax))
      body->bullet->activate();
  }
}

/// Counts how long each body has rested. A body with a steady push swings within each step, so its speed is
/// that of its displacement. Returns whether any has rested for long enough to fall asleep.
bool RigidWorld::Impl::note_rest(float dt) {
  bool any = false;
  for (uint32_t n = 0; n < bodies.slots.size(); ++n) {
    if (!bodies.has(n)) continue;
    RigidBodyRecord& body = *bodies.slots[n];
    btRigidBody& b = *body.bullet;
    if (body.kinematic || !b.isActive()) continue;
    const KinematicVelocity mean = velocity_to(contact_bodies[n].pose, contact_motions[n].pose, dt);
    const bool is_slow = length(mean.linear) < b.getLinearSleepingThreshold() &&
                         length(mean.angular) < b.getAngularSleepingThreshold();
    b.setDeactivationTime(is_slow && !body.kept_awake ? b.getDeactivationTime() + dt : 0);
    any |= b.wantsSleeping();
  }
  return any;
}

void RigidWorld::Impl::fall_asleep() {
  const auto slots = static_cast<uint32_t>(bodies.slots.size());
  const auto is_ready = [&](uint32_t n) {
    return bodies.has(n) && !bodies.slots[n]->kinematic && bodies.slots[n]->bullet->isActive() &&
           bodies.slots[n]->bullet->wantsSleeping();
  };
  Islands islands(slots);
  std::vector<bool> restless(slots);
  const std::vector<ContactBodies> touching = contacts->found();
  const auto is_dynamic = [&](uint32_t n) { return bodies.has(n) && !bodies.slots[n]->kinematic; };
  for (const ContactBodies& c : touching)
    if (is_dynamic(c.a) && is_dynamic(c.b)) islands.unite(c.a, c.b);
  for (const ContactBodies& c : touching) {
    for (const auto& [n, other] : {std::pair{c.a, c.b}, std::pair{c.b, c.a}}) {
      if (is_dynamic(n) && bodies.has(other) && !is_dynamic(other) && moves(*bodies.slots[other]->bullet))
        restless[islands.find(n)] = true;
    }
  }
  for (uint32_t n = 0; n < slots; ++n)
    if (is_dynamic(n) && !is_ready(n)) restless[islands.find(n)] = true;
  bool any = false;
  for (uint32_t n = 0; n < slots; ++n) {
    if (!is_ready(n) || restless[islands.find(n)]) continue;
    btRigidBody& b = *bodies.slots[n]->bullet;
    bodies.slots[n]->memory.island = islands.find(n);
    set_speed(b, {0, 0, 0}, {0, 0, 0});
    dynamics.updateSingleAabb(&b);
    any = true;
  }
  if (!any) return;
  may_have_islands = true;
  for (const auto& body : bodies.slots)
    if (body && body->memory.island != pbd::no_index) body->bullet->forceActivationState(ISLAND_SLEEPING);
  part_resting(true);
}

}  // namespace meniscus::collision
