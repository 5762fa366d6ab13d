// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// World's queries: rays, overlaps and the nearest place.
#include <meniscus/error.h>
#include <meniscus/world.h>

#include <algorithm>
#include <cmath>

#include "pbd/feature_pair.h"
#include "pbd/math/vec.h"
#include "sdk/world/check/check.h"
#include "sdk/world/queries/geometry.h"
#include "sdk/world/world_calls.h"

namespace meniscus {

namespace {

using collision::RigidRef;

/// Calls visit(cloth, triangle, a, b, c) for each triangle of all cloth.
void for_each_triangle(auto& world, const auto& visit) {
  world.fetch_cloth();
  world.cloths.for_each([&](uint32_t index, const ClothEntry& cloth) {
    const std::vector<Vec3>& x = cloth.range.state.positions;
    uint32_t number = 0;
    for (const auto& t : cloth.mesh.triangles)
      visit(world.cloths.id(index), number++, x[t[0]], x[t[1]], x[t[2]]);
  });
}

/// Calls visit(rope, segment, a, b, radius) for each segment of all ropes.
void for_each_segment(auto& world, const auto& visit) {
  world.fetch_cloth();
  world.ropes.for_each([&](uint32_t index, const RopeEntry& rope) {
    const std::vector<Vec3>& x = rope.range.state.positions;
    const size_t segments = rope.def.closed ? x.size() : x.size() - 1;
    for (size_t k = 0; k < segments; ++k)
      visit(world.ropes.id(index), static_cast<uint32_t>(k), x[k], x[(k + 1) % x.size()], rope.def.radius);
  });
}

/// What a ray meets first.
struct RayCast {
  Vec3 from, ray;
  float nearest = 2;  // fraction of the ray
  std::optional<RayHit> hit{};

  /// Notes a hit at a fraction of the ray, if it is the first; returns the new hit.
  RayHit* note(std::optional<float> t) {
    if (!t || *t >= nearest) return nullptr;
    nearest = *t;
    hit = RayHit{};
    hit->point = from + nearest * ray;
    hit->distance = nearest * length(ray);
    return &*hit;
  }
};

void cast_at_solids(auto& world, RayCast& cast) {
  collision::RigidRayHit solid;
  if (!world.rigid.cast_ray(cast.from, cast.from + cast.ray, solid)) return;
  RayHit& hit = *cast.note(solid.fraction);
  hit.point = solid.point;
  hit.normal = solid.normal;
  if (solid.solid.is_body)
    hit.body = world.body_id(solid.solid.number);
  else
    hit.shape = world.shape_id(solid.solid.number);
}

}  // namespace

std::optional<RayHit> World::Calls::cast_ray(Vec3 from, Vec3 to, const QueryTargets& targets) const {
  check::value("cast_ray's from", from);
  check::value("cast_ray's to", to);
  RayCast cast{from, to - from};
  if (targets.solids) cast_at_solids(*impl_, cast);
  const float radius = 0.5f * impl_->def.particle_spacing;
  const std::span<const Vec3> particles = targets.particles ? positions() : std::span<const Vec3>{};
  for (size_t i = 0; i < particles.size(); ++i) {
    RayHit* const hit = cast.note(queries::meet_ball(from, cast.ray, particles[i], radius));
    if (!hit) continue;
    hit->particle = impl_->ids[i];
    hit->normal = normalized_or(hit->point - particles[i], {0, 1, 0});
  }
  if (targets.cloth) {
    for_each_triangle(*impl_, [&](ClothId cloth, uint32_t number, Vec3 a, Vec3 b, Vec3 c) {
      RayHit* const hit = cast.note(queries::meet_triangle(from, cast.ray, a, b, c));
      if (!hit) return;
      const Vec3 normal = normalized_or(cross(b - a, c - a), {0, 1, 0});
      hit->cloth = cloth;
      hit->element = number;
      hit->normal = dot(normal, cast.ray) > 0 ? -normal : normal;
    });
  }
  if (targets.ropes) {
    for_each_segment(*impl_, [&](RopeId rope, uint32_t number, Vec3 a, Vec3 b, float thick) {
      RayHit* const hit = cast.note(queries::meet_segment(from, cast.ray, a, b, thick));
      if (!hit) return;
      hit->rope = rope;
      hit->element = number;
      hit->normal = normalized_or(hit->point - queries::nearest_on_segment(hit->point, a, b), {0, 1, 0});
    });
  }
  return cast.hit;
}

namespace {

/// The nearest place so far.
struct NearestSearch {
  Vec3 from;
  float reach;
  std::optional<NearestPoint> found{};

  /// Notes a place at a distance, where it is nearer; `out` is unit.
  NearestPoint* note(float distance, Vec3 out) {
    if (!(distance < reach)) return nullptr;
    reach = distance;
    found = NearestPoint{};
    found->normal = out;
    found->point = from - distance * out;
    found->distance = distance;
    return &*found;
  }
};

}  // namespace

std::optional<NearestPoint> World::Calls::nearest(Vec3 point, float reach,
                                                  const QueryTargets& targets) const {
  check::value("nearest's point", point);
  check::value("nearest's reach", reach, positive, "m");
  NearestSearch search{point, reach};
  if (targets.solids) {
    if (const auto solid = impl_->with_solids().nearest_solid(point, reach)) {
      NearestPoint& place = *search.note(solid->distance, solid->normal);
      if (solid->kind == TouchedKind::body)
        place.body = impl_->body_id(solid->solid);
      else
        place.shape = impl_->shape_id(solid->solid);
    }
  }
  const float radius = 0.5f * impl_->def.particle_spacing;
  const std::span<const Vec3> particles = targets.particles ? positions() : std::span<const Vec3>{};
  for (size_t i = 0; i < particles.size(); ++i) {
    const Vec3 off = point - particles[i];
    NearestPoint* const place = search.note(length(off) - radius, normalized_or(off, {0, 1, 0}));
    if (place) place->particle = impl_->ids[i];
  }
  if (targets.cloth) {
    for_each_triangle(*impl_, [&](ClothId cloth, uint32_t number, Vec3 a, Vec3 b, Vec3 c) {
      const pbd::Nearest to = pbd::nearest_on_triangle(point, a, b, c);
      NearestPoint* const place =
          search.note(to.distance, normalized_or(to.r, normalized_or(cross(b - a, c - a), {0, 1, 0})));
      if (!place) return;
      place->cloth = cloth;
      place->element = number;
    });
  }
  if (targets.ropes) {
    for_each_segment(*impl_, [&](RopeId rope, uint32_t number, Vec3 a, Vec3 b, float thick) {
      const Vec3 off = point - queries::nearest_on_segment(point, a, b);
      NearestPoint* const place = search.note(length(off) - thick, normalized_or(off, {0, 1, 0}));
      if (!place) return;
      place->rope = rope;
      place->element = number;
    });
  }
  return search.found;
}

namespace {

/// Adds an id once, where ids come in order.
template <class Id>
void add_once(std::vector<Id>& ids, Id id) {
  if (ids.empty() || ids.back() != id) ids.push_back(id);
}

/// `volume` tells what is inside: holds(point), meets(a, b, c) and meets(a, b, radius).
Overlaps overlaps(const auto& world, const std::vector<RigidRef>& solids, const auto& volume,
                  const QueryTargets& targets) {
  Overlaps found;
  for (const RigidRef& solid : solids) {
    if (solid.is_body)
      found.bodies.push_back(world.impl_->body_id(solid.number));
    else
      found.shapes.push_back(world.impl_->shape_id(solid.number));
  }
  const std::span<const Vec3> positions = targets.particles ? world.positions() : std::span<const Vec3>{};
  for (size_t i = 0; i < positions.size(); ++i) {
    if (volume.holds(positions[i])) found.particles.push_back(world.ids()[i]);
  }
  if (targets.cloth) {
    for_each_triangle(*world.impl_, [&](ClothId cloth, uint32_t, Vec3 a, Vec3 b, Vec3 c) {
      if (volume.meets(a, b, c)) add_once(found.cloths, cloth);
    });
  }
  if (targets.ropes) {
    for_each_segment(*world.impl_, [&](RopeId rope, uint32_t, Vec3 a, Vec3 b, float radius) {
      if (volume.meets(a, b, radius)) add_once(found.ropes, rope);
    });
  }
  return found;
}

struct BallVolume {
  Vec3 centre;
  float radius;

  bool holds(Vec3 p) const { return length(p - centre) <= radius; }
  bool meets(Vec3 a, Vec3 b, Vec3 c) const {
    return pbd::nearest_on_triangle(centre, a, b, c).distance <= radius;
  }
  bool meets(Vec3 a, Vec3 b, float thick) const {
    return length(centre - queries::nearest_on_segment(centre, a, b)) <= radius + thick;
  }
};

struct BoxVolume {
  Pose pose;
  Vec3 half;

  bool holds(Vec3 p) const { return max_component(abs(to_local(pose, p)) - half) <= 0; }
  bool meets(Vec3 a, Vec3 b, Vec3 c) const {
    return queries::overlaps_box(half, to_local(pose, a), to_local(pose, b), to_local(pose, c));
  }
  bool meets(Vec3 a, Vec3 b, float thick) const {
    return queries::comes_near_box(half, to_local(pose, a), to_local(pose, b), thick);
  }
};

std::vector<RigidRef> solids_in(const auto& world, const Pose& pose, Vec3 half, bool ball,
                                const QueryTargets& targets) {
  return targets.solids ? world.rigid.overlaps(pose, half, ball) : std::vector<RigidRef>{};
}

}  // namespace

Overlaps World::Calls::overlap_ball(Vec3 centre, float radius, const QueryTargets& targets) const {
  check::value("overlap_ball's centre", centre);
  check::value("overlap_ball's radius", radius, positive, "m");
  const Pose pose{centre, {0, 0, 0, 1}};
  return overlaps(*this, solids_in(*impl_, pose, {radius, radius, radius}, true, targets),
                  BallVolume{centre, radius}, targets);
}

Overlaps World::Calls::overlap_box(const Pose& pose, Vec3 half_extents, const QueryTargets& targets) const {
  check::value("overlap_box's pose", pose);
  check::value("overlap_box's half_extents", half_extents, positive, "m");
  return overlaps(*this, solids_in(*impl_, pose, half_extents, false, targets), BoxVolume{pose, half_extents},
                  targets);
}

}  // namespace meniscus
