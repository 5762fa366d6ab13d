// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Kernels and functions of StickAnchors.
#pragma once

#include <algorithm>
#include <cfloat>

#include "collision/body/stick_anchors.h"

namespace meniscus::collision {

namespace stick_kernels {

using pbd::Contact;
using pbd::View;

/// The contacts of vertices, which come after those of fluids.
struct VertexContacts {
  pbd::ContactView contacts;
  uint32_t sorted;    ///< see ParticleView
  uint32_t vertices;  ///< without points of faces

  /// The particle of contact n, or no_index if it is no vertex. Where contacts lack room, and the step will
  /// be repeated, not all that is listed is valid.
  MENISCUS_HD uint32_t vertex(uint32_t n) const {
    if (n < first() || n >= contacts.total()) return pbd::no_index;
    const uint32_t i = contacts.particle[n];
    return i >= sorted && i - sorted < vertices ? i : pbd::no_index;
  }
  MENISCUS_HD uint32_t first() const { return contacts.start[sorted]; }
  MENISCUS_HD static bool rubs(const Contact& c) {
    return c.solid != pbd::no_index && c.friction > 0 && !is_attachment(c);
  }
};

/// Adds to each contact's slip what its anchor has kept, and moves the anchor to what it may keep.
struct Recall {
  VertexContacts of;
  View<const StickAnchor> anchors;
  View<const uint32_t> start;  ///< of the anchors
  View<const pbd::Vec4> previous;
  View<const BodyProxy> bodies;
  View<StickAnchor> next;

  MENISCUS_HD void operator()(uint32_t n) const {
    const uint32_t i = of.vertex(n);
    if (i == pbd::no_index) return;
    Contact& c = of.contacts.contacts[n];
    const Vec3 x = previous[i].xyz();
    const Vec3 slipped = VertexContacts::rubs(c) ? kept_slip(i - of.sorted, c, x) : Vec3{0, 0, 0};
    c.surface_motion -= slipped;
    next[n - of.first()] = {to_solid(c, x - slipped), length(slipped), c.solid, c.body};
  }

  /// m, from the anchor of vertex v at x.
  MENISCUS_HD Vec3 kept_slip(uint32_t v, const Contact& c, Vec3 x) const {
    const uint32_t end = start[v + 1] < anchors.count ? start[v + 1] : anchors.count;
    for (uint32_t k = start[v]; k < end; ++k) {
      const StickAnchor anchor = anchors[k];
      if (anchor.solid != c.solid || anchor.body != c.body) continue;
      const Vec3 from = x - (c.body < bodies.count ? to_world(bodies[c.body].start, anchor.at) : anchor.at);
      return shortened_to(from - dot(from, c.normal) * c.normal, anchor.reach);
    }
    return {0, 0, 0};
  }
  MENISCUS_HD Vec3 to_solid(const Contact& c, Vec3 x) const {
    return c.body < bodies.count ? to_local(bodies[c.body].start, x) : x;
  }
};

/// Lets go of anchors without load, and lets those grow that still stick. Copies where the anchors begin.
struct Yield {
  VertexContacts of;
  View<uint32_t> start;
  View<StickAnchor> next;

  MENISCUS_HD void operator()(uint32_t n) const {
    if (n <= of.vertices) start[n] = of.contacts.start[of.sorted + n] - of.first();
    const uint32_t i = of.vertex(n);
    if (i == pbd::no_index) return;
    const Contact& c = of.contacts.contacts[n];
    const float most = most_friction(c);
    if (most == 0)
      next[n - of.first()].reach = 0;
    else if (length(c.tangent_multiplier) < body_tuning::sticking * most)
      next[n - of.first()].reach = FLT_MAX;
  }
};

}  // namespace stick_kernels

template <class D>
void StickAnchors<D>::set_vertices(uint32_t count) {
  device_.wait();
  vertices_ = count;
  start_.reserve(count ? count + 1 : 0, 0);
  lengths_.resize_discard(in_batch_ ? count : 0);
  if (count) device_.fill(start_.current().data, 0, (count + 1) * sizeof(uint32_t));
}

template <class D>
void StickAnchors<D>::begin(pbd::Substep<D>& substep) {
  const uint32_t room = substep.contacts.contacts.count;
  if (vertices_ == 0 || room == 0) return;
  const uint32_t worlds = kept_vertices_ > 0 ? vertices_ / kept_vertices_ : 0;
  const uint32_t wanted = in_batch_ ? 2 * room + worlds * kept_count_ : room;  // see replace()
  if (anchors_.current().count < wanted) anchors_.reserve(wanted, anchors_.current().count);
  const pbd::ParticleView& p = substep.particles;
  device_.parallel_for("anchors/recall", room,
                       stick_kernels::Recall{{substep.contacts, p.sorted, vertices_},
                                             anchors_.current(),
                                             start_.current(),
                                             p.previous,
                                             bodies_.proxies(),
                                             anchors_.next()});
}

template <class D>
void StickAnchors<D>::end(pbd::Substep<D>& substep) {
  if (vertices_ == 0) return;
  device_.parallel_for(
      "anchors/yield", std::max(substep.contacts.contacts.count, vertices_ + 1),
      stick_kernels::Yield{
          {substep.contacts, substep.particles.sorted, vertices_}, start_.next(), anchors_.next()});
  anchors_.flip();
  start_.flip();
}

template <class D>
void StickAnchors<D>::visit_state(pbd::StateVisitor& v) {
  uint32_t count = 0;
  if (!v.restores() && vertices_ > 0 && anchors_.current().count > 0) {
    device_.copy_out(&count, start_.current().data + vertices_, sizeof count);
    count = std::min(count, anchors_.current().count);
  }
  v.value("count", count);
  if (v.restores() && anchors_.current().count < count) anchors_.reserve(count, 0);
  v.array("anchor", anchors_.current(), count);
  v.array("start", start_.current(), vertices_ > 0 ? vertices_ + 1 : 0);
}

template <class D>
void StickAnchors<D>::save() {
  anchors_.save();
  start_.save();
}

template <class D>
void StickAnchors<D>::restore() {
  anchors_.restore();
  start_.restore();
}

}  // namespace meniscus::collision

#include "collision/body/stick_worlds.inl"
