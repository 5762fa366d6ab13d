// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What began and ended in a step: touches, sleep, and particles that come and go.
#include <algorithm>
#include <iterator>
#include <tuple>

#include "sdk/world/world_calls.h"

namespace meniscus {

namespace {

using collision::RigidRef;
using collision::RigidTouch;

bool before(const RigidTouch& x, const RigidTouch& y) {
  const auto key = [](const RigidTouch& t) {
    return std::tuple(!t.a.is_body, t.a.number, !t.b.is_body, t.b.number);
  };
  return key(x) < key(y);
}

}  // namespace

/// Drops the touches of solids that were removed since the last step.
void World::Impl::forget_touches() {
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
  std::vector<RigidTouch> now = rigid.touches(), began, ended;
  std::set_difference(now.begin(), now.end(), touches.begin(), touches.end(), std::back_inserter(began),
                      before);
  std::set_difference(touches.begin(), touches.end(), now.begin(), now.end(), std::back_inserter(ended),
                      before);
  events.clear();
  const auto note = [&](const RigidTouch& touch, bool begins) {
    ContactEvent event{body_id(touch.a.number), {}, {}, begins};
    if (touch.b.is_body)
      event.b = body_id(touch.b.number);
    else
      event.shape = shape_id(touch.b.number);
    events.push_back(event);
  };
  for (const RigidTouch& touch : began) note(touch, true);
  for (const RigidTouch& touch : ended) note(touch, false);
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
void World::Impl::forget_solid(const RigidRef& solid) {
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
