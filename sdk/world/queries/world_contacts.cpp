// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// World's read-outs of contacts.
#include <meniscus/world.h>

#include "sdk/world/queries/solid_events.h"
#include "sdk/world/world_calls.h"

namespace meniscus {

std::vector<ParticleContact> World::Calls::particle_contacts() const {
  std::vector<ParticleContact> contacts;
  for (const ContactReadout& c : impl_->engine->read_contacts()) {
    if (c.slot >= impl_->ids.size()) continue;
    if (c.kind == TouchedKind::cloth && !impl_->cloths.find(impl_->touched_pieces[c.solid])) continue;
    ParticleContact contact{impl_->ids[c.slot], {}, {}, {}, c.point, c.normal, c.impulse};
    switch (c.kind) {
      case TouchedKind::body:
        contact.body = impl_->body_id(c.solid);
        break;
      case TouchedKind::cloth:
        contact.cloth = impl_->touched_pieces[c.solid];
        break;
      case TouchedKind::shape:
        contact.shape = impl_->shape_id(c.solid);
    }
    contacts.push_back(contact);
  }
  return contacts;
}

std::vector<SolidContact> World::Calls::solid_contacts() const {
  return named_contacts(impl_->rigid.contacts(), *impl_);
}

}  // namespace meniscus
