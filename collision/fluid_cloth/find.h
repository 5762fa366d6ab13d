// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Finds the contacts of particles with cloth in the tree: one for each layer of cloth near a particle,
// however many triangles the layer has.
#pragma once

#include "collision/fluid_cloth/area.h"
#include "collision/fluid_cloth/cloth_shapes.h"
#include "collision/fluid_cloth/cloth_surface.h"
#include "collision/fluid_cloth/marks.h"
#include "collision/fluid_cloth/spread.h"
#include "collision/fluid_cloth/tuning.h"
#include "pbd/contacts.h"
#include "pbd/device/base/atomics.h"

namespace meniscus::collision::fluid_cloth_kernels {

/// The box of everything within `by` (m) of a particle's motion.
MENISCUS_HD inline Aabb motion_box(Vec3 from, Vec3 to, float by) {
  return pbd::inflated({min(from, to), max(from, to)}, by);
}

/// Lists the particles that have boxes of cloth within the support radius.
struct ListNear {
  Surface surface;
  NearList near;
  View<pbd::Phase> phase;
  float h;

  MENISCUS_HD void operator()(uint32_t i) const {
    const Aabb box = motion_box(surface.previous[i].xyz(), surface.position[i].xyz(), h);
    if (!pbd::overlaps_any(surface.tree, surface.world_of(i), box, 1)) {
      if (phase[i] & pbd::phase_pressing) phase[i] &= ~pbd::phase_pressing;
      return;
    }
    const uint32_t at = pbd::append(near.counter[0], 1);
    if (at < near.particle.count) near.particle[at] = i;
  }
};

/// A place on a triangle that a particle may touch.
struct Place {
  float distance;  // m; less than 0 where they meet during the motion, and lower the sooner they meet
  Vec3 normal;     // unit, at the substep's end, towards the particle's side
  uint32_t triangle;
  float u, v;
};

/// The layers of cloth near one particle. Places that face it from the same direction belong to one layer.
class Layers {
 public:
  MENISCUS_HD uint32_t count() const { return count_ < most_touches ? count_ : most_touches; }
  /// Whether there were more layers than fit.
  MENISCUS_HD bool is_crowded() const { return count_ > most_touches; }
  MENISCUS_HD const Place& operator[](uint32_t k) const { return layer_[k]; }

  /// Adds a place inside a triangle, or one met during the motion: the surface around it is nowhere nearer.
  MENISCUS_HD void add(const Place& place) {
    for (uint32_t k = 0; k < count(); ++k) {
      if (dot(layer_[k].normal, place.normal) < fluid_cloth_tuning::same_layer) continue;
      if (place.distance < layer_[k].distance) layer_[k] = place;
      return;
    }
    if (count_ < most_touches) {
      layer_[count_++] = place;
      return;
    }
    uint32_t furthest = 0;
    for (uint32_t k = 1; k < most_touches; ++k)
      furthest = layer_[k].distance > layer_[furthest].distance ? k : furthest;
    if (place.distance < layer_[furthest].distance) layer_[furthest] = place;
    count_ = most_touches + 1;
  }
  /// Merges what a warp's threads have found, for all of them.
  MENISCUS_HD void gather() {
    Layers all;
    const bool crowded = SearchTeam::any(is_crowded());
    for (uint32_t left = SearchTeam::ballot(count_ > 0); left; left &= left - 1) {
      const uint32_t thread = pbd::lowest_bit(left), places = SearchTeam::from(thread, count());
      for (uint32_t k = 0; k < places; ++k) all.add(from(thread, layer_[k]));
    }
    *this = all;
    if (crowded && count_ == most_touches) ++count_;
  }
  /// The distance of the nearest place, m; less than 0 where one was met during the motion.
  MENISCUS_HD float nearest() const {
    float least = 3e38f;
    for (uint32_t k = 0; k < count(); ++k) least = pbd::min(least, layer_[k].distance);
    return least;
  }
  /// Adds the nearest place on an edge that a warp's threads have found, if no other place is nearer.
  MENISCUS_HD void add_edge(const Place& edge) {
    const float least = SearchTeam::least(edge.distance);
    if (least < nearest() && least < 1e30f)
      add(from(pbd::lowest_bit(SearchTeam::ballot(edge.distance == least)), edge));
  }

 private:
  MENISCUS_HD static Place from(uint32_t thread, const Place& p) {
    return {SearchTeam::from(thread, p.distance), SearchTeam::from(thread, p.normal),
            SearchTeam::from(thread, p.triangle), SearchTeam::from(thread, p.u),
            SearchTeam::from(thread, p.v)};
  }

  Place layer_[most_touches];
  uint32_t count_ = 0;  // most_touches + 1: there were more
};

/// Finds the contacts of the listed particles, a warp each. No particle has passed through cloth at the
/// substep's start, so its side is known from there. If the motion is short relative to the distance, the
/// triangle is tested at its predicted position. Otherwise it is tested where the two meet during the motion.
///
/// Few of the triangles near a particle lie straight below it. Edges are tested afterwards, and only those
/// that may be nearer than what has been found.
struct FindTouches {
  Surface surface;
  NearList near;
  pbd::ContactCounter counter;
  View<uint32_t> entries;  // number of contacts of each vertex
  View<const GroupShape> shapes;
  View<uint32_t> found;  // see Found
  float h, largest_gap;

  MENISCUS_HD void operator()(uint32_t k) const {
    if (k >= near.count()) return;
    const uint32_t i = near.particle[k];
    const uint32_t world = surface.world_of(i);
    const Vec3 from = surface.previous[i].xyz(), to = surface.position[i].xyz();
    Layers layers;
    bool at_border = false;
    // The motion cannot meet what is not near it.
    const Aabb on_way = motion_box(from, to, largest_gap);
    const auto wanted = [&](uint32_t group) {
      return shapes[group].may_be_over(to) || pbd::overlap(surface.tree.box(1, group), on_way);
    };
    pbd::for_each_overlap_in_warp(surface.tree, world, motion_box(from, to, h), wanted, [&](uint32_t place) {
      const pbd::SurfaceTriangle t = load(surface.tree.triangles, place);
      if (!surface.meets(i, t.piece)) return;
      const bool border = (surface.marks[place] & border_marks) != 0;
      const bool may_meet = pbd::overlap(surface.tree.box(0, place), on_way);
      if (!border && !may_meet &&
          !pbd::is_over_triangle(to, surface.end(t.a), surface.end(t.b), surface.end(t.c)))
        return;
      const pbd::FeaturePair pair = surface.pair(from, to, t);
      if (find_place(layers, pair, may_meet, place, surface.pieces[t.piece].radius)) at_border |= border;
    });
    at_border = SearchTeam::any(at_border);
    layers.gather();
    if (layers.nearest() > 0) layers.add_edge(nearest_edge(i, to, pbd::min(h, layers.nearest())));
    for (uint32_t n = 0; n < most_touches; ++n) {
      FluidClothContact& touch = near.touches[most_touches * k + n];
      if (n < layers.count())
        write_touch(touch, world, layers[n], at_border);
      else if (SearchTeam::leads())
        touch.vertices = 0;
    }
    if (SearchTeam::leads()) counter.add(i, layers.count());
    if (SearchTeam::leads() && layers.is_crowded()) pbd::atomic_add(found[crowded], 1);
  }

  /// Whether the triangle is within the support radius. Of the places at the end, only those inside the
  /// triangle count.
  MENISCUS_HD bool find_place(Layers& layers, const pbd::FeaturePair& pair, bool may_meet, uint32_t place,
                              float radius) const {
    const pbd::Nearest end = nearest(pair, 1);
    const float motion = may_meet ? relative_motion(pair) : 0;
    if (may_meet && motion >= fluid_cloth_tuning::fast_by_end * end.distance) {
      const float start = nearest(pair, 0).distance;
      const float gap = fluid_cloth_tuning::meeting * pbd::min(start, radius);
      const float t = start > 0 && motion > start - gap ? time_of_nearness(pair, gap) : 2;
      if (t <= 1) {
        const pbd::Nearest met = nearest(pair, t);
        if (met.distance > 0) {
          layers.add({t - 2, turned_to_end(pair, met.r / met.distance, t), place, met.u, met.v});
          return true;
        }
      }
    }
    if (end.distance >= h || end.distance == 0) return false;
    if (end.on == 7) layers.add({end.distance, end.r / end.distance, place, end.u, end.v});
    return true;
  }

  /// The nearest place that this thread finds within `reach` (m); at 3e38 m if there is none.
  MENISCUS_HD Place nearest_edge(uint32_t i, Vec3 to, float reach) const {
    Place edge{3e38f, {0, 0, 0}, no_index, 0, 0};
    const pbd::GroupsInBall wanted{surface.tree, to, reach};
    const Aabb around = motion_box(to, to, reach);
    pbd::for_each_overlap_in_warp(surface.tree, surface.world_of(i), around, wanted, [&](uint32_t place) {
      const pbd::SurfaceTriangle t = load(surface.tree.triangles, place);
      if (!surface.meets(i, t.piece)) return;
      const pbd::Nearest end =
          pbd::nearest_on_triangle(to, surface.end(t.a), surface.end(t.b), surface.end(t.c));
      if (end.distance > 0 && end.distance < pbd::min(reach, edge.distance))
        edge = {end.distance, end.r / end.distance, place, end.u, end.v};
    });
    return edge;
  }

  MENISCUS_HD void write_touch(FluidClothContact& touch, uint32_t world, const Place& place,
                               bool at_border) const {
    const pbd::SurfaceTriangle t = surface.tree.triangles[place.triangle];
    const float w = 1 - place.u - place.v;
    const Vec3 point = w * surface.end(t.a) + place.u * surface.end(t.b) + place.v * surface.end(t.c);
    const float fraction = at_border ? covered(world, point, place) : 1;
    uint32_t vertices = spread_out(
        surface, {point, place.normal, surface.pieces[t.piece].spread, t.piece, world}, touch, found[cut]);
    if (SearchTeam::leads()) {
      if (vertices == 0) {
        touch.set(vertices++, t.a, w);
        touch.set(vertices++, t.b, place.u);
        touch.set(vertices++, t.c, place.v);
      }
      touch.begin(point, place.normal, fraction, t.piece, vertices);
    }
    SearchTeam::sync();
    for (uint32_t k = SearchTeam::rank(); k < touch.vertices; k += SearchTeam::count())
      pbd::atomic_add(entries[touch.vertex[k]], 1);
  }

  /// The fraction of the plane through the place that cloth covers, within the particle's support.
  MENISCUS_HD float covered(uint32_t world, Vec3 foot, const Place& place) const {
    const float reach2 = h * h - pbd::max(0, place.distance) * pbd::max(0, place.distance);
    const float reach = sqrtf(pbd::max(reach2, fluid_cloth_tuning::least_cover2 * h * h));
    const Disc disc(foot, place.normal, reach);
    float sum = 0;
    pbd::for_each_overlap_in_warp(surface.tree, world, motion_box(foot, foot, reach),
                                  pbd::GroupsInBall{surface.tree, foot, reach}, [&](uint32_t n) {
                                    const pbd::SurfaceTriangle t = load(surface.tree.triangles, n);
                                    const Vec3 a = surface.end(t.a), b = surface.end(t.b),
                                               c = surface.end(t.c);
                                    const Vec3 normal = normalized_or(cross(b - a, c - a), {0, 0, 0});
                                    if (fabsf(dot(normal, disc.normal())) > fluid_cloth_tuning::covering)
                                      sum += disc.covered(a, b, c);
                                  });
    return pbd::min(1, SearchTeam::sum(sum));
  }
};

/// Writes the contacts that were found. They come before those with shapes.
struct WriteContacts {
  Surface surface;
  NearList near;
  View<const Vec4> velocity;
  pbd::ContactWriter writer;
  float dt;

  MENISCUS_HD void operator()(uint32_t k) const {
    if (k >= near.count()) return;
    const uint32_t i = near.particle[k];
    for (uint32_t n = 0; n < most_touches; ++n) {
      FluidClothContact& touch = near.touches[most_touches * k + n];
      if (!is_used(touch)) return;
      const pbd::Contact contact = contact_of(touch, i);
      if (!TouchTeam::leads()) continue;
      const uint32_t at = writer.start[i + 1] - writer.remaining[i];
      // Where there is no room for the contact, the step is repeated.
      touch.contact = at >= writer.start[i] && at < writer.start[i + 1] ? at : no_index;
      writer.write(i, contact);
    }
  }

  MENISCUS_HD pbd::Contact contact_of(const FluidClothContact& touch, uint32_t i) const {
    const FluidClothPiece piece = surface.pieces[touch.piece];
    pbd::Contact c{};
    const Vec3 speed = touch.mean([&](uint32_t v) { return velocity[surface.first_vertex + v].xyz(); });
    c.point = touch.point;
    c.solid = touch.piece;
    c.normal = touch.normal;
    c.fraction = touch.fraction;
    c.radius = piece.radius;
    c.friction = piece.friction;
    c.adhesion = piece.adhesion * dt * dt;
    c.body = pbd::on_cloth;
    c.approach_speed = dot(touch.normal, velocity[i].xyz() - speed);
    c.surface_motion = touch.mean([&](uint32_t v) { return surface.end(v) - surface.start(v); });
    return c;
  }
};

/// Adds each contact to the lists of its vertices.
struct EnterTouches {
  NearList near;
  View<const uint32_t> start;
  View<uint32_t> left;     // by vertex: entries still to be written; 0 at the end
  View<uint32_t> entries;  // number of the contact, and in the lowest five bits the index of the vertex in it

  MENISCUS_HD void operator()(uint32_t n) const {
    if (n >= most_touches * near.count() || !is_used(near.touches[n])) return;
    for (uint32_t k = TouchTeam::rank(); k < near.touches[n].vertices; k += TouchTeam::count()) {
      const uint32_t v = near.touches[n].vertex[k];
      entries[start[v] + pbd::atomic_add(left[v], ~0u) - 1] = n << 5 | k;
    }
  }
};

}  // namespace meniscus::collision::fluid_cloth_kernels
