// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include "collision/find_contact.h"
#include "collision/shape_contacts.h"

namespace meniscus::collision {

namespace shape_contact_kernels {

struct Finder {
  ShapeSet set;
  pbd::View<const pbd::Vec4> position, previous;
  float radius, h;

  MENISCUS_HD FoundContact operator()(uint32_t i, uint32_t shape) const {
    return find_contact(set, set.shapes[shape], {previous[i].xyz(), position[i].xyz()}, radius, h);
  }
};

struct Count {
  Finder find;
  pbd::View<uint32_t> counts;

  MENISCUS_HD void operator()(uint32_t i) const {
    uint32_t found = 0;
    for (uint32_t s = 0; s < find.set.shapes.count; ++s) found += find(i, s).found;
    counts[i] += found;
  }
};

struct Fill {
  Finder find;
  pbd::View<const pbd::Vec4> velocity;
  pbd::View<uint32_t> cursor;
  pbd::View<pbd::Contact> contacts;

  MENISCUS_HD void operator()(uint32_t i) const {
    uint32_t at = cursor[i];
    for (uint32_t s = 0; s < find.set.shapes.count; ++s) {
      const FoundContact f = find(i, s);
      if (f.found) contacts[at++] = make_contact(i, find.set.shapes[s], f);
    }
    cursor[i] = at;
  }

  MENISCUS_HD pbd::Contact make_contact(uint32_t i, const Shape& shape, const FoundContact& f) const {
    using pbd::no_index;
    const Vec3 normal = f.sample.surface.normal;
    pbd::Contact c{};
    c.particle[0] = i;
    for (int k = 1; k < 4; ++k) c.particle[k] = no_index;
    c.weight[0] = 1;
    c.point = f.point;
    c.body = shape.owner;
    c.normal = normal;
    c.distance = dot(normal, find.position[i].xyz() - f.point);
    c.approach_speed = dot(normal, velocity[i].xyz());
    c.friction = shape.friction;
    c.restitution = shape.restitution;
    c.fraction = f.sample.fraction;
    c.side = dot(normal, find.previous[i].xyz() - f.point) < 0 ? -1.0f : 1.0f;
    return c;
  }
};

}  // namespace shape_contact_kernels

template <class D>
void ShapeContacts<D>::count(const pbd::Substep<D>& substep, pbd::View<uint32_t> counts) {
  if (shapes_.shapes.count == 0) return;
  using namespace shape_contact_kernels;
  const Finder finder{shapes_, substep.particles.position, substep.particles.previous, contact_radius_,
                      support_radius_};
  device_.parallel_for("contacts/count", substep.particles.owned, Count{finder, counts});
}

template <class D>
void ShapeContacts<D>::fill(const pbd::Substep<D>& substep, pbd::View<uint32_t> cursor,
                            pbd::View<pbd::Contact> contacts) {
  if (shapes_.shapes.count == 0) return;
  using namespace shape_contact_kernels;
  const Finder finder{shapes_, substep.particles.position, substep.particles.previous, contact_radius_,
                      support_radius_};
  device_.parallel_for("contacts/fill", substep.particles.owned,
                       Fill{finder, substep.particles.velocity, cursor, contacts});
}

}  // namespace meniscus::collision
