// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What began and ended in a step: touches, sleep, and particles that come and go.
#include <algorithm>

#include "sdk/world/queries/solid_events.h"
#include "sdk/world/world_calls.h"

namespace meniscus {

/// Drops the touches of solids that were removed since the last step.
void World::Impl::forget_touches() {
  using collision::RigidRef, collision::RigidTouch;
  const auto key = [](const RigidRef& r) { return std::pair(r.is_body, r.number); };
  std::ranges::sort(forgotten, {}, key);
  const auto is_gone = [&](const RigidRef& r) {
    return std::ranges::binary_search(forgotten, key(r), {}, key);
  };
  std::erase_if(touches, [&](const RigidTouch& t) { return is_gone(t.a) || is_gone(t.b); });
  forgotten.clear();
}

/// Compares the touching pairs with those of the step before.
void World::Impl::note_events() {
  forget_touches();
  std::vector<collision::RigidTouch> now = rigid.touches();
  events = contact_events_between(touches, now, *this);
  touches = std::move(now);
}

/// Compares which bodies are awake with the end of the step before.
void World::Impl::note_sleep() {
  sleeps.clear();
  bodies.for_each([&](uint32_t number, const BodyEntry&) {
    if (awake.size() <= number) awake.resize(number + 1, 1);
    const bool is_awake = rigid.awake(number);
    if (is_awake != (awake[number] != 0)) sleeps.push_back({body_id(number), is_awake});
    awake[number] = is_awake;
  });
}

/// Notes that a solid is removed. Takes memory before it changes anything.
void World::Impl::forget_solid(const collision::RigidRef& solid) {
  if (forgotten.size() == forgotten.capacity()) forgotten.reserve(2 * forgotten.size() + 1);
  if (removed_solids.size() == removed_solids.capacity())
    removed_solids.reserve(2 * removed_solids.size() + 1);
  engine->forget_contacts(solid.number, solid.is_body ? TouchedKind::body : TouchedKind::shape);
  forgotten.push_back(solid);
  removed_solids.push_back(solid);
}

const std::vector<ContactEvent>& World::Calls::contact_events() const {
  return impl_->events;
}

const std::vector<SleepEvent>& World::Calls::sleep_events() const {
  return impl_->sleeps;
}

const std::vector<FlowEvent>& World::Calls::flow_events() const {
  return impl_->flows;
}

}  // namespace meniscus
