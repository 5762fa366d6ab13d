// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include "collision/find_contact.h"
#include "collision/shape_contacts.h"
#include "collision/sweep.h"

namespace meniscus::collision {

namespace shape_contact_kernels {

struct LimitMotion {
  ShapeSet set;
  pbd::View<const pbd::Vec4> from;
  pbd::View<pbd::Vec4> to;
  float radius;
  bool planes_too;

  MENISCUS_HD void operator()(uint32_t i) const {
    const Motion motion{from[i].xyz(), to[i].xyz()};
    const Vec3 path = motion.to - motion.from;
    // A slower one comes no further than where its contact sees it.
    if (!(dot(path, path) > radius * radius) || !is_finite(path)) return;
    to[i] = pbd::with_w(collision::limit_motion(set, motion, radius, planes_too), to[i].w);
  }
};

template <bool only_planes>
struct Finder {
  ShapeSet set;
  pbd::View<const pbd::Vec4> position, previous;
  float radius, h;

  MENISCUS_HD FoundContact operator()(uint32_t i, uint32_t shape) const {
    const Motion motion{previous[i].xyz(), position[i].xyz()};
    if constexpr (only_planes) return find_plane_contact(set, set.shapes[shape], motion, radius, h);
    return find_contact(set, set.shapes[shape], motion, radius, h);
  }
};

template <bool only_planes>
struct Count {
  Finder<only_planes> find;
  pbd::View<uint32_t> counts;

  MENISCUS_HD void operator()(uint32_t i) const {
    uint32_t found = 0;
    for (uint32_t s = 0; s < find.set.shapes.count; ++s) found += find(i, s).found;
    counts[i] += found;
  }
};

template <bool only_planes>
struct Fill {
  Finder<only_planes> find;
  pbd::View<const pbd::Vec4> velocity;
  pbd::ContactWriter writer;

  MENISCUS_HD void operator()(uint32_t i) const {
    if (!writer.has_any(i)) return;
    for (uint32_t s = 0; s < find.set.shapes.count; ++s) {
      const FoundContact f = find(i, s);
      if (f.found) writer.write(i, make_contact(i, find.set.shapes[s], f));
    }
    writer.finish(i, inert(i));
  }

  /// A contact that is too far away to do anything.
  MENISCUS_HD pbd::Contact inert(uint32_t i) const {
    const Vec3 up{0, 1, 0};
    FoundContact f{{{find.h, up}}, find.position[i].xyz() - 1000 * find.h * up, false};
    f.sample.fraction = 0;
    pbd::Contact c = make_contact(i, Shape{}, f);
    c.body = pbd::no_index;
    return c;
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
template <bool only_planes>
auto ShapeContacts<D>::finder(const pbd::Substep<D>& substep) const {
  return shape_contact_kernels::Finder<only_planes>{
      shapes_, substep.particles.position, substep.particles.previous, contact_radius_, support_radius_};
}

template <class D>
void ShapeContacts<D>::limit_motion(pbd::View<const pbd::Vec4> from, pbd::View<pbd::Vec4> to, uint32_t count,
                                    bool planes_too) {
  if (only_planes_ && !planes_too) return;
  device_.parallel_for("contacts/limit motion", count,
                       shape_contact_kernels::LimitMotion{shapes_, from, to, contact_radius_, planes_too});
}

template <class D>
void ShapeContacts<D>::count(const pbd::Substep<D>& substep, pbd::View<uint32_t> counts) {
  using namespace shape_contact_kernels;
  const uint32_t particles = substep.particles.owned;
  if (shapes_.shapes.count == 0) return;
  if (only_planes_) {
    device_.parallel_for("contacts/count", particles, Count<true>{finder<true>(substep), counts});
  } else {
    device_.parallel_for("contacts/count", particles, Count<false>{finder<false>(substep), counts});
  }
}

template <class D>
void ShapeContacts<D>::fill(const pbd::Substep<D>& substep, const pbd::ContactWriter& writer) {
  using namespace shape_contact_kernels;
  const pbd::ParticleView& p = substep.particles;
  if (shapes_.shapes.count == 0) return;
  if (only_planes_) {
    device_.parallel_for("contacts/fill", p.owned, Fill<true>{finder<true>(substep), p.velocity, writer});
  } else {
    device_.parallel_for("contacts/fill", p.owned, Fill<false>{finder<false>(substep), p.velocity, writer});
  }
}

}  // namespace meniscus::collision
