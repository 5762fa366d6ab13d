// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// From the tree to the contacts of particles with sheets: one for each layer of cloth that a particle is
// near, however many triangles that layer is made of.
#pragma once

#include "collision/sheet_area.h"
#include "collision/sheet_spread.h"
#include "collision/sheet_surface.h"
#include "pbd/contacts.h"
#include "pbd/device/atomics.h"

namespace meniscus::collision::sheet_kernels {

/// What is within `by` (m) of a particle's way.
MENISCUS_HD inline Aabb way_box(Vec3 from, Vec3 to, float by) {
  return pbd::inflated({min(from, to), max(from, to)}, by);
}

/// Lists the particles that have a sheet's boxes within the support radius.
struct ListNear {
  Surface surface;
  NearList near;
  View<pbd::Phase> phase;
  float h;

  MENISCUS_HD void operator()(uint32_t i) const {
    const Aabb box = way_box(surface.previous[i].xyz(), surface.position[i].xyz(), h);
    bool any = false;
    pbd::for_each_overlap(surface.tree, box, 1, 0, [&](uint32_t) { any = true; });
    if (!any) {
      if (phase[i] & pbd::phase_pressing) phase[i] &= ~pbd::phase_pressing;
      return;
    }
    const uint32_t at = pbd::append(near.counter[0], 1);
    if (at < near.particle.count) near.particle[at] = i;
  }
};

/// A place on a triangle that a particle may touch.
struct Place {
  float distance;  // m; less than 0 where they meet on the way, the less the sooner
  Vec3 normal;     // unit, at the substep's end, towards the particle's side
  uint32_t triangle;
  float u, v;
};

/// The layers of cloth near one particle. Places that face it from one direction are of one layer.
class Layers {
 public:
  MENISCUS_HD int count() const { return count_; }
  MENISCUS_HD const Place& operator[](int k) const { return layer_[k]; }

  /// One on a triangle's inside, or met on the way: the surface is nowhere nearer around it.
  MENISCUS_HD void add(const Place& place) {
    for (int k = 0; k < count_; ++k) {
      if (dot(layer_[k].normal, place.normal) < same) continue;
      if (place.distance < layer_[k].distance) layer_[k] = place;
      return;
    }
    if (count_ < static_cast<int>(most_touches)) {
      layer_[count_++] = place;
      return;
    }
    int furthest = 0;
    for (int k = 1; k < count_; ++k) furthest = layer_[k].distance > layer_[furthest].distance ? k : furthest;
    if (place.distance < layer_[furthest].distance) layer_[furthest] = place;
  }
  /// One on a triangle's edge: it counts if nothing is nearer.
  MENISCUS_HD void add_edge(const Place& place) {
    if (place.distance < edge_.distance) edge_ = place;
  }
  MENISCUS_HD void finish() {
    for (int k = 0; k < count_; ++k) {
      if (layer_[k].distance <= edge_.distance) return;
    }
    if (edge_.distance < 1e30f) add(edge_);
  }

 private:
  static constexpr float same = 0.7f;  // cosine

  Place layer_[most_touches];
  Place edge_{3e38f, {0, 0, 0}, no_index, 0, 0};
  int count_ = 0;
};

/// Finds what the listed particles touch. Nothing has passed through a sheet at the substep's start, so that
/// the side is known from there. Where the motion is short for the distance, a triangle is looked at where it
/// is predicted to be; else where the two meet on the way.
struct FindTouches {
  Surface surface;
  NearList near;
  View<uint32_t> counts;   // contacts of each particle
  View<uint32_t> entries;  // touches of each vertex
  float h;

  MENISCUS_HD void operator()(uint32_t k) const {
    if (k >= near.count()) return;
    const uint32_t i = near.particle[k];
    const Vec3 from = surface.previous[i].xyz(), to = surface.position[i].xyz();
    Layers layers;
    bool at_border = false;
    pbd::for_each_overlap(surface.tree, way_box(from, to, h), 0, 0, [&](uint32_t place) {
      const pbd::SurfaceTriangle t = load(surface.tree.triangles, place);
      if (!surface.meets(i, t.part)) return;
      if (look_at(layers, surface.pair(from, to, t), place, surface.parts[t.part].radius))
        at_border |= surface.borders[place] != 0;
    });
    layers.finish();
    for (int n = 0; n < static_cast<int>(most_touches); ++n) {
      SheetTouch& touch = near.touches[most_touches * k + static_cast<uint32_t>(n)];
      if (n < layers.count())
        touch = touch_at(layers[n], at_border);
      else
        touch.vertices = 0;
    }
    counts[i] += static_cast<uint32_t>(layers.count());
  }

  /// Whether the triangle is within the support radius.
  MENISCUS_HD bool look_at(Layers& layers, const pbd::FeaturePair& pair, uint32_t place, float radius) const {
    const float motion = relative_motion(pair);
    const pbd::Nearest end = nearest(pair, 1);
    if (motion >= 0.3f * end.distance) {
      const float start = nearest(pair, 0).distance;
      const float gap = 0.5f * pbd::min(start, radius);
      const float t = start > 0 && motion > start - gap ? time_of_nearness(pair, start, motion, gap) : 2;
      if (t <= 1) {
        const pbd::Nearest met = nearest(pair, t);
        if (met.distance > 0) {
          layers.add({t - 2, turned_to_end(pair, met.r / met.distance, t), place, met.u, met.v});
          return true;
        }
      }
    }
    if (end.distance >= h || end.distance == 0) return false;
    const Place found{end.distance, end.r / end.distance, place, end.u, end.v};
    end.on == 7 ? layers.add(found) : layers.add_edge(found);
    return true;
  }

  MENISCUS_HD SheetTouch touch_at(const Place& place, bool at_border) const {
    const pbd::SurfaceTriangle t = surface.tree.triangles[place.triangle];
    SheetTouch touch{};
    const float w = 1 - place.u - place.v;
    touch.part = t.part;
    touch.normal = place.normal;
    touch.point = w * surface.end(t.a) + place.u * surface.end(t.b) + place.v * surface.end(t.c);
    touch.fraction = at_border ? covered(touch.point, place) : 1;
    if (!spread_out(surface, surface.parts[t.part].spread, touch)) {
      touch.add(t.a, w);
      touch.add(t.b, place.u);
      touch.add(t.c, place.v);
    }
    for (uint32_t k = 0; k < touch.vertices; ++k) pbd::atomic_add(entries[touch.vertex[k]], 1);
    return touch;
  }

  /// Of the plane through the place, as far as the particle's support reaches.
  MENISCUS_HD float covered(Vec3 foot, const Place& place) const {
    const float reach2 = h * h - pbd::max(0, place.distance) * pbd::max(0, place.distance);
    const float reach = sqrtf(pbd::max(reach2, 0.01f * h * h));
    const Disc disc(foot, place.normal, reach);
    float sum = 0;
    pbd::for_each_overlap(surface.tree, way_box(foot, foot, reach), 0, 0, [&](uint32_t n) {
      const pbd::SurfaceTriangle t = load(surface.tree.triangles, n);
      const Vec3 a = surface.end(t.a), b = surface.end(t.b), c = surface.end(t.c);
      const Vec3 normal = normalized_or(cross(b - a, c - a), {0, 0, 0});
      if (fabsf(dot(normal, disc.normal())) > 0.5f) sum += disc.covered(a, b, c);
    });
    return pbd::min(1, sum);
  }
};

/// Writes the contacts of what was found. They come before those with shapes.
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
      SheetTouch& touch = near.touches[most_touches * k + n];
      if (!is_used(touch)) return;
      const uint32_t at = writer.start[i + 1] - writer.remaining[i];
      // Where there is no room for it the step will be done again.
      touch.contact = at >= writer.start[i] && at < writer.start[i + 1] ? at : no_index;
      writer.write(i, contact_of(touch, i));
    }
  }

  MENISCUS_HD pbd::Contact contact_of(const SheetTouch& touch, uint32_t i) const {
    const SheetPart part = surface.parts[touch.part];
    pbd::Contact c{};
    const Vec3 speed = touch.mean([&](uint32_t v) { return velocity[surface.first_vertex + v].xyz(); });
    c.point = touch.point;
    c.solid = touch.part;
    c.normal = touch.normal;
    c.fraction = touch.fraction;
    c.radius = part.radius;
    c.friction = part.friction;
    c.adhesion = part.adhesion * dt * dt;
    c.body = pbd::on_sheet;
    c.approach_speed = dot(touch.normal, velocity[i].xyz() - speed);
    c.surface_motion = touch.mean([&](uint32_t v) { return surface.end(v) - surface.start(v); });
    return c;
  }
};

/// Enters each touch with its vertices.
struct EnterTouches {
  NearList near;
  View<const uint32_t> start;
  View<uint32_t> left;     // by vertex: entries still to come; 0 in the end
  View<uint32_t> entries;  // touch, and in the lowest five bits which of its vertices it is

  MENISCUS_HD void operator()(uint32_t n) const {
    if (n >= most_touches * near.count() || !is_used(near.touches[n])) return;
    for (uint32_t k = 0; k < near.touches[n].vertices; ++k) {
      const uint32_t v = near.touches[n].vertex[k];
      entries[start[v] + pbd::atomic_add(left[v], ~0u) - 1] = n << 5 | k;
    }
  }
};

}  // namespace meniscus::collision::sheet_kernels
