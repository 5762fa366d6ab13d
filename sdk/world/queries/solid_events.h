// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Contacts and events of solids, with the ids of a user. `Names` has body_id(number) and shape_id(number).
#pragma once

#include <meniscus/bodies.h>

#include <algorithm>
#include <iterator>
#include <span>
#include <tuple>
#include <vector>

#include "collision/rigid/rigid_world.h"

namespace meniscus {

template <class Names>
std::vector<SolidContact> named_contacts(std::span<const collision::RigidContact> contacts,
                                         const Names& names) {
  std::vector<SolidContact> named;
  for (const collision::RigidContact& c : contacts) {
    SolidContact contact{names.body_id(c.a.number), {}, {}, c.point, c.normal, c.distance, c.impulse};
    if (c.b.is_body)
      contact.b = names.body_id(c.b.number);
    else
      contact.shape = names.shape_id(c.b.number);
    named.push_back(contact);
  }
  return named;
}

/// What began to touch, then what ceased to. Both lists are in the order of RigidTouch.
template <class Names>
std::vector<ContactEvent> contact_events_between(std::span<const collision::RigidTouch> before,
                                                 std::span<const collision::RigidTouch> now,
                                                 const Names& names) {
  using Touch = collision::RigidTouch;
  const auto comes_first = [](const Touch& x, const Touch& y) {
    const auto key = [](const Touch& t) {
      return std::tuple(!t.a.is_body, t.a.number, !t.b.is_body, t.b.number);
    };
    return key(x) < key(y);
  };
  std::vector<ContactEvent> events;
  const auto note = [&](std::span<const Touch> some, std::span<const Touch> others, bool began) {
    std::vector<Touch> only;
    std::ranges::set_difference(some, others, std::back_inserter(only), comes_first);
    for (const Touch& touch : only) {
      ContactEvent event{names.body_id(touch.a.number), {}, {}, began};
      if (touch.b.is_body)
        event.b = names.body_id(touch.b.number);
      else
        event.shape = names.shape_id(touch.b.number);
      events.push_back(event);
    }
  };
  note(now, before, true);
  note(before, now, false);
  return events;
}

}  // namespace meniscus
