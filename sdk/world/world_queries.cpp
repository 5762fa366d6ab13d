// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// World's queries about contacts, rays and overlaps.
#include <meniscus/error.h>
#include <meniscus/world.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <tuple>

#include "pbd/math/vec.h"
#include "sdk/world/check/check.h"
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

/// The first intersection of a ray with a ball, as a fraction of the ray; nothing if the ray starts inside.
std::optional<float> meet_ball(Vec3 from, Vec3 ray, Vec3 centre, float radius) {
  const Vec3 to_start = from - centre;
  const float radius2 = radius * radius, a = dot(ray, ray), b = dot(to_start, ray);
  if (dot(to_start, to_start) < radius2 || b >= 0) return {};
  // The distance by which the ray misses the centre. The formula b² − ac would subtract numbers far larger
  // than the result.
  const Vec3 miss = to_start - (b / a) * ray;
  const float inside2 = radius2 - dot(miss, miss);
  if (inside2 < 0) return {};
  const float t = -b / a - std::sqrt(inside2 / a);
  return t <= 1 ? std::optional(t) : std::nullopt;
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
  std::vector<SolidContact> contacts;
  for (const collision::RigidContact& c : impl_->rigid.contacts()) {
    SolidContact contact{impl_->body_id(c.a.number), {}, {}, c.point, c.normal, c.distance, c.impulse};
    if (c.b.is_body)
      contact.b = impl_->body_id(c.b.number);
    else
      contact.shape = impl_->shape_id(c.b.number);
    contacts.push_back(contact);
  }
  return contacts;
}

std::optional<RayHit> World::Calls::cast_ray(Vec3 from, Vec3 to) const {
  check::value("cast_ray's from", from);
  check::value("cast_ray's to", to);
  const Vec3 ray = to - from;
  std::optional<RayHit> hit;
  float nearest = 2;
  if (collision::RigidRayHit solid; impl_->rigid.cast_ray(from, to, solid)) {
    nearest = solid.fraction;
    hit = RayHit{{}, {}, {}, solid.point, solid.normal, nearest * length(ray)};
    if (solid.solid.is_body)
      hit->body = impl_->body_id(solid.solid.number);
    else
      hit->shape = impl_->shape_id(solid.solid.number);
  }
  const std::span<const Vec3> particles = positions();
  for (size_t i = 0; i < particles.size(); ++i) {
    const std::optional<float> t = meet_ball(from, ray, particles[i], 0.5f * impl_->def.particle_spacing);
    if (!t || *t >= nearest) continue;
    nearest = *t;
    const Vec3 point = from + nearest * ray;
    hit = RayHit{
        {}, {}, impl_->ids[i], point, normalized_or(point - particles[i], {0, 1, 0}), nearest * length(ray)};
  }
  return hit;
}

namespace {

template <class Inside>
Overlaps overlaps(const auto& world, const std::vector<RigidRef>& solids, const Inside& inside,
                  const auto& body_id, const auto& shape_id) {
  Overlaps found;
  for (const RigidRef& solid : solids) {
    if (solid.is_body)
      found.bodies.push_back(body_id(solid.number));
    else
      found.shapes.push_back(shape_id(solid.number));
  }
  const std::span<const Vec3> positions = world.positions();
  for (size_t i = 0; i < positions.size(); ++i) {
    if (inside(positions[i])) found.particles.push_back(world.ids()[i]);
  }
  return found;
}

}  // namespace

Overlaps World::Calls::overlap_ball(Vec3 centre, float radius) const {
  check::value("overlap_ball's centre", centre);
  check::value("overlap_ball's radius", radius, positive, "m");
  return overlaps(
      *this, impl_->rigid.overlaps({centre, {0, 0, 0, 1}}, {radius, radius, radius}, true),
      [&](Vec3 p) { return length(p - centre) <= radius; },
      [&](uint32_t number) { return impl_->body_id(number); },
      [&](uint32_t number) { return impl_->shape_id(number); });
}

Overlaps World::Calls::overlap_box(const Pose& pose, Vec3 half_extents) const {
  check::value("overlap_box's pose", pose);
  check::value("overlap_box's half_extents", half_extents, positive, "m");
  return overlaps(
      *this, impl_->rigid.overlaps(pose, half_extents, false),
      [&](Vec3 p) { return max_component(abs(to_local(pose, p)) - half_extents) <= 0; },
      [&](uint32_t number) { return impl_->body_id(number); },
      [&](uint32_t number) { return impl_->shape_id(number); });
}

}  // namespace meniscus
