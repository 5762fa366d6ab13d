// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Kernels and functions of ShapeContacts.
#pragma once

#include <algorithm>

#include "collision/contact/limit_motion.h"
#include "collision/contact/shape_contacts.h"
#include "collision/contact/tuning.h"

namespace meniscus::collision {

namespace shape_contact_kernels {

struct LimitByFixed {
  ShapeSet set;
  Touches touches;
  pbd::MotionView motions;
  bool planes_too;

  MENISCUS_HD void operator()(uint32_t i) const {
    const Motion motion{motions.from[i].xyz(), motions.to[i].xyz()};
    const Vec3 path = motion.to - motion.from;
    if (motions.to[i].w == 0 || touches.is_face(i)) return;  // of a face, the vertices are limited
    const Touch touch = touches.of(i);
    // The contact search sees a slower particle wherever it ends.
    if (!(dot(path, path) > touch.radius * touch.radius) || !is_finite(path)) return;
    const Vec3 end = limit_by_fixed(set, motion, touch.radius, planes_too, touch.filter);
    motions.to[i] = pbd::with_w(end, motions.to[i].w);
    if (motions.accumulated_delta.count)
      motions.accumulated_delta[i] = pbd::shifted(motions.accumulated_delta[i], end - motion.to);
  }
};

struct LimitByMoving {
  ShapeSet set;
  CandidateView candidates;
  Touches touches;
  pbd::MotionView motions;
  pbd::ContactView contacts;

  MENISCUS_HD void operator()(uint32_t i) const {
    const Motion motion{motions.from[i].xyz(), motions.to[i].xyz()};
    // The shape would hold a particle that overlaps it inside.
    if (!is_finite(motion.to) || touches.is_face(i) || touches.may_overlap(i)) return;
    if (touches.is_vertex(i) && is_held(contacts, i, motions.to[i].w)) return;
    const Touch touch = touches.of(i);
    const Vec3 end = limit_by_moving(set, candidates, i, motion, touch.radius, [&](const Shape& shape) {
      return collide(shape, touch.filter) && !touches.is_attached(i, shape.body);
    });
    motions.to[i] = pbd::with_w(end, motions.to[i].w);
  }
};

template <bool only_fixed_planes>
struct Finder {
  ShapeSet set;
  CandidateView candidates;
  Touches touches;
  pbd::View<const pbd::Vec4> position, previous;
  float h;

  /// Calls visit(shape, found) for each contact of particle i.
  template <class Visit>
  MENISCUS_HD void for_each(uint32_t i, const Visit& visit) const {
    const Touch touch = touches.of(i);
    const bool face = touches.is_face(i);
    if (face && !touches.is_used_point(i)) return;
    const auto look_at = [&](uint32_t number) {
      const Shape& shape = set.shapes[number];
      if (!collide(shape, touch.filter) || touches.is_attached(i, shape.body)) return;
      const FoundContact found = find(shape, {previous[i].xyz(), position[i].xyz()}, touch.radius, face);
      if (found.found) visit(shape, found);
    };
    if constexpr (only_fixed_planes) {
      // Most particles are near no plane and need no other data of it.
      const Vec3 to = position[i].xyz();
      for (uint32_t first = 0; first < set.shapes.count; first += shapes_at_once) {
        uint32_t near = which_shapes(first, set.shapes.count - first, [&](uint32_t s) {
          return plane_surface(set.shapes[s], to).distance < h - touch.radius;
        });
        for (; near; near &= near - 1) look_at(first + pbd::lowest_bit(near));
      }
    } else {
      candidates.for_each_near(set, i, {previous[i].xyz(), position[i].xyz()}, h, look_at);
    }
  }

  MENISCUS_HD FoundContact find(const Shape& shape, const Motion& motion, float radius, bool face) const {
    if constexpr (only_fixed_planes) return find_plane_contact(set, shape, motion, radius, h);
    if (face) return find_face_contact(set, shape, motion_beside(shape, motion), radius, h);
    if (shape.body == pbd::no_index) return find_contact(set, shape, motion, radius, h);
    if (shape.kind != ShapeKind::plane && out_of_reach(shape, motion.from, motion.to, h)) return no_contact();
    return find_contact(set, shape, motion_beside(shape, motion), radius, h);
  }
};

template <bool only_fixed_planes>
struct Count {
  Finder<only_fixed_planes> find;
  pbd::ContactCounter counter;
  pbd::View<pbd::Phase> phase;

  MENISCUS_HD void operator()(uint32_t i) const {
    uint32_t found = 0;
    find.for_each(i, [&](const Shape&, const FoundContact&) { ++found; });
    counter.add(i, found);
    if (found == 0 && find.touches.may_overlap(i)) phase[i] &= ~pbd::phase_overlapping;
  }
};

template <bool only_fixed_planes>
struct Fill {
  Finder<only_fixed_planes> find;
  pbd::View<const pbd::Vec4> velocity;
  float dt;
  pbd::ContactWriter writer;
  pbd::View<const uint32_t> number;
  pbd::View<pbd::Phase> phase;

  /// At planes all threads do the same work, so particles that touch are processed side by side. At other
  /// shapes the work differs. There a warp waits less if fewer of its threads have contacts.
  static constexpr bool takes_touching = only_fixed_planes;

  MENISCUS_HD void operator()(uint32_t n) const {
    const uint32_t i = takes_touching ? writer.touching.at(n, writer.start) : n;
    if (i == pbd::no_index || writer.start[i] == writer.start[i + 1]) return;
    const bool placed = find.touches.may_overlap(i);
    float in = 0;  // depth in a solid, m
    find.for_each(i, [&](const Shape& shape, const FoundContact& found) {
      pbd::Contact c = make_contact(i, shape, found);
      if (placed) in = pbd::max(in, recede(i, shape, c));
      writer.write(i, c);
    });
    writer.finish(i, inert(i));
    if (placed && in == 0) phase[i] &= ~pbd::phase_overlapping;
  }

  /// Moves the surface back so that the particle leaves it slowly, and returns by how much, m. So deep
  /// inside, the surface yields as readily as the particle does. The cloth around a vertex may leave by
  /// another side, and must not be torn.
  MENISCUS_HD float recede(uint32_t i, const Shape& shape, pbd::Contact& c) const {
    const Motion motion{find.previous[i].xyz(), find.position[i].xyz()};
    const Vec3 start = shape.body == pbd::no_index ? motion.from : motion_beside(shape, motion).from;
    const float stop = pbd::fraction_of_radius(number[i]) * c.radius;
    const float displacement = exit_distance(find.touches.of(i).radius, dt);
    const float back = pbd::max(0.0f, stop - plane_distance(c, start) - displacement);
    c.point -= back * c.normal;
    if (back > 0) c.body_inverse_mass = find.position[i].w;
    return back;
  }

  /// A contact that is too far away to act.
  MENISCUS_HD pbd::Contact inert(uint32_t i) const {
    pbd::Contact c{};
    c.normal = {0, 1, 0};
    c.point = find.position[i].xyz() - 1000 * find.h * c.normal;
    c.solid = c.body = pbd::no_index;
    return c;
  }

  MENISCUS_HD pbd::Contact make_contact(uint32_t i, const Shape& shape, const FoundContact& f) const {
    const Vec3 normal = f.surface.normal;
    pbd::Contact c{};
    c.point = f.at - f.surface.distance * normal;
    c.solid = shape.owner;
    c.normal = normal;
    c.fraction = 1;
    c.radius = find.touches.of(i).radius * (find.touches.is_face(i) ? shape_tuning::face_radius : 1.0f);
    if (!only_fixed_planes && !find.touches.is_vertex(i))
      c.fraction = solid_fraction(find.set, shape, f.at, f.surface.distance, find.h);
    c.friction = shape.surface.friction;
    c.restitution = shape.surface.restitution;
    c.adhesion = shape.surface.adhesion * dt * dt;
    c.body = shape.body;
    c.approach_speed = dot(normal, velocity[i].xyz());
    if (!only_fixed_planes && shape.body != pbd::no_index) {
      c.surface_motion = c.point - to_world(shape.start, to_local(shape.pose, c.point));
      if (dt > 0) c.approach_speed -= dot(normal, c.surface_motion) / dt;
    } else {
      const Vec3 belt = shape.surface.belt_velocity;
      c.surface_motion = dt * (belt - dot(belt, normal) * normal);
    }
    return c;
  }
};

}  // namespace shape_contact_kernels

template <class D>
void ShapeContacts<D>::set_shapes(const ShapeSet& shapes, bool fixed_are_planes) {
  shapes_ = shapes;
  fixed_are_planes_ = fixed_are_planes;
  reserve(room_);
}

template <class D>
void ShapeContacts<D>::set_filters(std::span<const CollisionFilter> filters) {
  const auto collides_with_all = [](const CollisionFilter& f) { return f == CollisionFilter{}; };
  const bool usual = std::all_of(filters.begin(), filters.end(), collides_with_all);
  filters_.resize_discard(usual ? 0 : filters.size());  // empty: no kernel reads them
  if (!usual) filters_.write(filters);
}

template <class D>
void ShapeContacts<D>::set_pieces(std::span<const Touch> pieces) {
  pieces_.resize_discard(pieces.size());
  pieces_.write(pieces);
  largest_radius_ = contact_radius_;
  for (const Touch& piece : pieces) largest_radius_ = std::max(largest_radius_, piece.radius);
}

template <class D>
void ShapeContacts<D>::reserve(uint32_t particles) {
  candidates_.reserve(particles, only_fixed_planes() ? 0 : shapes_.of_world());
  room_ = particles;
}

template <class D>
ParticleWorlds ShapeContacts<D>::worlds() const {
  const uint32_t worlds = shapes_.worlds;
  return {worlds, particles_.sorted() / worlds, particles_.vertices() / worlds,
          points_.triangles.count / worlds, points_.triangle_of};
}

template <class D>
template <bool only_fixed_planes>
auto ShapeContacts<D>::finder(const pbd::Substep<D>& substep) const {
  const pbd::ParticleView& p = substep.particles;
  return shape_contact_kernels::Finder<only_fixed_planes>{
      shapes_, candidates_.view(), touches(p.phase, p.sorted), p.position, p.previous, support_radius_};
}

template <class D>
void ShapeContacts<D>::limit_motion(const pbd::MotionView& motion, bool planes_too) {
  if (planes_too ? shapes_.fixed == 0 : !limits_motion()) return;
  device_.parallel_for(
      "contacts/limit motion", motion.count,
      shape_contact_kernels::LimitByFixed{shapes_, touches(motion.phase, motion.sorted), motion, planes_too});
}

template <class D>
void ShapeContacts<D>::limit_beside_moving(const pbd::MotionView& motion, const pbd::ContactView& contacts,
                                           float furthest) {
  if (shapes_.fixed == shapes_.shapes.count || motion.count == 0) return;
  candidates_.find(device_, shapes_, motion.from, motion.to, motion.count, largest_radius_ + furthest,
                   worlds());
  device_.parallel_for(
      "contacts/limit beside moving", motion.count,
      shape_contact_kernels::LimitByMoving{shapes_, candidates_.view(), touches(motion.phase, motion.sorted),
                                           motion, contacts});
}

template <class D>
CandidateView ShapeContacts<D>::find_near(pbd::View<const pbd::Vec4> position, uint32_t particles,
                                          float reach) {
  candidates_.reserve(room_, shapes_.of_world());
  candidates_.find(device_, shapes_, position, position, particles, reach, worlds());
  return candidates_.view();
}

template <class D>
void ShapeContacts<D>::count(const pbd::Substep<D>& substep, const pbd::ContactCounter& counter) {
  using namespace shape_contact_kernels;
  const pbd::ParticleView& p = substep.particles;
  if (shapes_.shapes.count == 0) return;
  const pbd::View<pbd::Phase> phase = particles_.phase.current.view();
  if (only_fixed_planes()) {
    device_.parallel_for("contacts/count", p.owned, Count<true>{finder<true>(substep), counter, phase});
  } else {
    candidates_.find(device_, shapes_, p.previous, p.position, p.owned, support_radius_, worlds());
    device_.parallel_for("contacts/count", p.owned, Count<false>{finder<false>(substep), counter, phase});
  }
}

template <class D>
void ShapeContacts<D>::fill(const pbd::Substep<D>& substep, const pbd::ContactWriter& writer) {
  using namespace shape_contact_kernels;
  const pbd::ParticleView& p = substep.particles;
  if (shapes_.shapes.count == 0) return;
  const pbd::View<pbd::Phase> phase = particles_.phase.current.view();
  if (only_fixed_planes()) {
    device_.parallel_for("contacts/fill", writer.touching.list.count,
                         Fill<true>{finder<true>(substep), p.velocity, substep.dt, writer, p.number, phase});
  } else {
    device_.parallel_for(
        "contacts/fill", p.owned,
        Fill<false>{finder<false>(substep), p.velocity, substep.dt, writer, p.number, phase});
  }
}

}  // namespace meniscus::collision
