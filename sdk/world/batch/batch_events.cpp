// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Contacts and events of the bodies of one world of a batch.
#include <algorithm>

#include "sdk/world/batch/batch_impl.h"
#include "sdk/world/queries/solid_events.h"

namespace meniscus {

BodyId WorldBatch::Impl::body_id(uint32_t number) const {
  return *std::ranges::find(ids, number, &BodyId::index);
}

ShapeId WorldBatch::Impl::shape_id(uint32_t number) const {
  return *std::ranges::find(shape_ids, number, &ShapeId::index);
}

std::vector<SolidContact> WorldBatch::solid_contacts(uint32_t world) const {
  impl_->check_world("solid_contacts", world);
  if (impl_->bodies_each == 0) return {};
  return impl_->run(
      [&] {
        return impl_->host().origin.outward(
            named_contacts(impl_->engine().rigid_worlds().world(world).contacts(), *impl_));
      },
      "solid_contacts");
}

std::vector<ContactEvent> WorldBatch::contact_events(uint32_t world) const {
  impl_->check_world("contact_events", world);
  if (impl_->bodies_each == 0) return {};
  const collision::RigidNews& news = impl_->engine().rigid_worlds().news(world);
  return contact_events_between(news.touches_before, news.touches, *impl_);
}

std::vector<SleepEvent> WorldBatch::sleep_events(uint32_t world) const {
  impl_->check_world("sleep_events", world);
  std::vector<SleepEvent> events;
  if (impl_->bodies_each == 0) return events;
  const collision::RigidNews& news = impl_->engine().rigid_worlds().news(world);
  for (const BodyId id : impl_->ids) {
    const bool was = id.index >= news.awake_before.size() || news.awake_before[id.index] != 0;
    const bool is = id.index >= news.awake.size() || news.awake[id.index] != 0;
    if (was != is) events.push_back({id, is});
  }
  return events;
}

}  // namespace meniscus
