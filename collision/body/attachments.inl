// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Kernels and functions of BodyAttachments.
#pragma once

#include <algorithm>
#include <numeric>
#include <utility>

#include "collision/body/attachments.h"
#include "collision/body/tuning.h"

namespace meniscus::collision {

namespace attachment_kernels {

using pbd::Vec4;
using pbd::View;

/// Attachments in the order of their vertices. The first attachment of each vertex does the work for all of
/// them.
struct Attachments {
  View<const BodyAttachment> attachments;
  uint32_t sorted;  ///< see ParticleView

  MENISCUS_HD bool leads(uint32_t n) const {
    return n == 0 || attachments[n - 1].vertex != attachments[n].vertex;
  }
  MENISCUS_HD uint32_t particle_of(uint32_t n) const { return sorted + attachments[n].vertex; }
  template <class Visit>
  MENISCUS_HD void for_each_beside(uint32_t n, const Visit& visit) const {
    for (uint32_t k = n; k < attachments.count && attachments[k].vertex == attachments[n].vertex; ++k)
      visit(k);
  }
};

struct Count {
  Attachments attachments;
  pbd::ContactCounter counter;

  MENISCUS_HD void operator()(uint32_t n) const {
    if (!attachments.leads(n)) return;
    uint32_t found = 0;
    attachments.for_each_beside(n, [&](uint32_t) { ++found; });
    counter.add(attachments.particle_of(n), found);
  }
};

/// Into how many parts a body is split: half of it is for its contacts.
MENISCUS_HD inline float splits(View<const uint32_t> attachments_of_body, uint32_t body) {
  return body_tuning::splits * static_cast<float>(attachments_of_body[body]);
}

struct Fill {
  Attachments attachments;
  View<const uint32_t> attachments_of_body;
  View<const BodyProxy> bodies;
  pbd::ContactWriter writer;

  MENISCUS_HD void operator()(uint32_t n) const {
    if (!attachments.leads(n)) return;
    attachments.for_each_beside(n, [&](uint32_t k) {
      writer.write(attachments.particle_of(n), make_contact(attachments.attachments[k]));
    });
  }

  /// The contact at the anchor of the predicted body. It has no normal, because it pushes nothing out.
  MENISCUS_HD pbd::Contact make_contact(const BodyAttachment& attachment) const {
    const BodyProxy& body = bodies[attachment.body];
    pbd::Contact c{};
    c.point = to_world(body.pose, attachment.anchor);
    c.solid = c.body = attachment.body;
    c.radius = -1;
    c.arm = c.point - body.pose.position;
    c.body_inverse_mass = splits(attachments_of_body, attachment.body) * largest_inverse_mass_at(body, c.arm);
    return c;
  }
};

/// Attachments with their vertices and contacts, while these are solved. A vertex's attachments are its first
/// contacts.
struct JoinedAttachments {
  Attachments attachments;
  View<const uint32_t> start;
  View<pbd::Contact> contacts;
  View<Vec4> position, accumulated_delta;
  /// By leading attachment. w: the vertex's own. xyz: the vertex's accumulated delta when its bodies last got
  /// their part of it. For a vertex held by an immovable body: its displacement to the anchor, m.
  View<Vec4> joined;

  /// Where there is no room for all contacts, the step is repeated.
  template <class Visit>
  MENISCUS_HD void for_each_contact(uint32_t n, const Visit& visit) const {
    const uint32_t first = start[attachments.particle_of(n)];
    attachments.for_each_beside(n, [&](uint32_t k) {
      if (first + k - n < contacts.count) visit(contacts[first + k - n]);
    });
  }
};

/// Moves the vertices that immovable bodies hold to their anchors. The first of several holds.
struct Hold {
  Attachments attachments;
  View<const BodyProxy> bodies;
  View<Vec4> position, accumulated_delta, velocity;
  View<Vec4> joined;  ///< see JoinedAttachments
  float inverse_dt;

  MENISCUS_HD void operator()(uint32_t n) const {
    if (!attachments.leads(n)) return;
    const uint32_t i = attachments.particle_of(n);
    const Vec4 x = position[i];
    const Vec3 displacement = accumulated_delta[i].xyz();
    joined[n] = pbd::with_w(displacement, x.w);
    bool is_held = x.w == 0;
    attachments.for_each_beside(n, [&](uint32_t k) {
      const BodyAttachment& a = attachments.attachments[k];
      const BodyProxy& body = bodies[a.body];
      const Vec3 anchor = to_world(body.pose, a.anchor);
      if (is_held || largest_inverse_mass_at(body, anchor - body.pose.position) > 0) return;
      is_held = true;
      const Vec3 to_anchor = displacement + anchor - x.xyz();
      joined[n] = pbd::with_w(to_anchor, x.w);
      velocity[i] = pbd::shifted(velocity[i], inverse_dt * to_anchor);
      position[i] = pbd::with_w(anchor, 0);
      accumulated_delta[i] = {0, 0, 0, 0};  // from now on, the impulse that the attachment resists
    });
  }
};

/// Gives the vertices that are not held the mass of what they are attached to.
struct Join {
  JoinedAttachments of;

  MENISCUS_HD void operator()(uint32_t n) const {
    if (!of.attachments.leads(n)) return;
    const uint32_t i = of.attachments.particle_of(n);
    const float w = of.position[i].w;
    if (w == 0) return;
    float mass = 1 / w;
    of.for_each_contact(n, [&](const pbd::Contact& c) { mass += 1 / c.body_inverse_mass; });
    of.joined[n] = pbd::with_w(of.accumulated_delta[i].xyz(), w);
    of.position[i].w = 1 / mass;
  }
};

/// Pulls vertices and anchors towards one another.
struct Pull {
  JoinedAttachments of;
  View<const uint32_t> attachments_of_body;
  View<const BodyProxy> bodies;

  MENISCUS_HD void operator()(uint32_t n) const {
    if (!of.attachments.leads(n)) return;
    const uint32_t i = of.attachments.particle_of(n);
    const Vec4 x = of.position[i], joined = of.joined[n];
    const Vec3 accumulated_delta = of.accumulated_delta[i].xyz();
    const bool moves = x.w > 0;
    const float w = moves ? joined.w : 0;
    // What displaced the vertex before the first iteration displaced its fraction of the body as well.
    const Vec3 together = moves ? x.xyz() - (accumulated_delta - joined.xyz()) : x.xyz();
    Vec3 pulled{0, 0, 0};  // kg·m
    of.for_each_contact(n, [&](pbd::Contact& c) {
      if (c.body_inverse_mass == 0) return;
      const Sym3 mobility =
          diagonal(w) + splits(attachments_of_body, c.body) * inverse_mass_matrix(bodies[c.body], c.arm);
      const Vec3 pull = inverse(mobility) * (c.point - (together + w * pulled));
      c.tangent_multiplier += pull;
      pulled += pull;
    });
    of.accumulated_delta[i] = pbd::with_w(accumulated_delta + (moves ? w : 1) * pulled, 0);
    if (!moves) return;
    of.position[i] = pbd::with_w(x.xyz() + w * pulled, x.w);
    of.joined[n] = pbd::with_w(joined.xyz() + w * pulled, w);
  }
};

/// Transfers the displacements of vertices to their bodies.
struct TransferPush {
  JoinedAttachments of;

  MENISCUS_HD void operator()(uint32_t n) const {
    if (!of.attachments.leads(n)) return;
    const uint32_t i = of.attachments.particle_of(n);
    if (of.position[i].w == 0) return;
    const Vec3 accumulated_delta = of.accumulated_delta[i].xyz(),
               displacement = accumulated_delta - of.joined[n].xyz();
    of.for_each_contact(n,
                        [&](pbd::Contact& c) { c.tangent_multiplier -= displacement / c.body_inverse_mass; });
    of.joined[n] = pbd::with_w(accumulated_delta, of.joined[n].w);
  }
};

/// Restores the vertices' own masses. Attachments that held a vertex get the impulse that they resisted.
struct ReleaseVertices {
  JoinedAttachments of;

  MENISCUS_HD void operator()(uint32_t n) const {
    if (!of.attachments.leads(n)) return;
    const Vec4 joined = of.joined[n];
    const uint32_t i = of.attachments.particle_of(n);
    const bool is_held = of.position[i].w == 0;
    of.position[i].w = joined.w;
    if (!is_held || joined.w == 0) return;
    // The anchor accelerated the vertex itself as well.
    Vec3 withstood = 1 / joined.w * joined.xyz() - of.accumulated_delta[i].xyz();
    of.for_each_contact(n, [&](pbd::Contact& c) {
      if (c.body_inverse_mass > 0) return;
      c.tangent_multiplier += withstood;
      withstood = {0, 0, 0};  // the first of several takes it all
    });
    of.accumulated_delta[i] = {0, 0, 0, 0};  // the velocity is the anchor's already
  }
};

struct AddImpulses {
  JoinedAttachments of;
  View<pbd::Vec4> impulse;
  float inverse_dt;

  MENISCUS_HD void operator()(uint32_t n) const {
    if (!of.attachments.leads(n)) return;
    uint32_t k = n;
    of.for_each_contact(n, [&](const pbd::Contact& c) {
      impulse[k] = pbd::with_w(impulse[k].xyz() + inverse_dt * c.tangent_multiplier, 0);
      ++k;
    });
  }
};

}  // namespace attachment_kernels

template <class D>
void BodyAttachments<D>::set_attachments(std::span<const BodyAttachment> attachments) {
  std::vector<uint32_t> order(attachments.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::stable_sort(order, {}, [&](uint32_t k) { return attachments[k].vertex; });
  std::vector<BodyAttachment> by_vertex;
  place_.resize(attachments.size());
  for (uint32_t k : order) {
    place_[k] = static_cast<uint32_t>(by_vertex.size());
    by_vertex.push_back(attachments[k]);
  }
  std::vector<uint32_t> attached_start(attachments.empty() ? 0 : by_vertex.back().vertex + 2);
  std::vector<uint32_t> attached, attachments_of_body;
  for (const BodyAttachment& attachment : by_vertex) {
    ++attached_start[attachment.vertex + 1];
    attached.push_back(attachment.body);
    if (attachments_of_body.size() <= attachment.body) attachments_of_body.resize(attachment.body + 1);
    ++attachments_of_body[attachment.body];
  }
  std::partial_sum(attached_start.begin(), attached_start.end(), attached_start.begin());

  device_.wait();
  attachments_.resize_discard(by_vertex.size());
  attachments_.write(by_vertex);
  impulse_.resize_discard(by_vertex.size());
  impulse_.fill(0);
  joined_.resize_discard(by_vertex.size());
  attachments_of_body_.resize_discard(attachments_of_body.size());
  attachments_of_body_.write(attachments_of_body);
  attached_start_.resize_discard(attached_start.size());
  attached_start_.write(attached_start);
  attached_body_.resize_discard(attached.size());
  attached_body_.write(attached);
}

template <class D>
std::vector<Vec3> BodyAttachments<D>::read_impulses() const {
  const std::vector<pbd::Vec4> by_vertex = impulse_.read(impulse_.size());
  std::vector<Vec3> out;
  for (uint32_t place : place_) out.push_back(by_vertex[place].xyz());
  return out;
}

template <class D>
attachment_kernels::JoinedAttachments BodyAttachments<D>::joined(const pbd::Substep<D>& substep) {
  const pbd::ParticleView& p = substep.particles;
  return {{attachments_.view(), p.sorted},
          substep.contacts.start,
          substep.contacts.contacts,
          p.position,
          p.accumulated_delta,
          joined_.view()};
}

template <class D>
void BodyAttachments<D>::count(const pbd::Substep<D>& substep, const pbd::ContactCounter& counter) {
  device_.parallel_for("attachments/count", attachments_.view().count,
                       attachment_kernels::Count{{attachments_.view(), substep.particles.sorted}, counter});
}

template <class D>
void BodyAttachments<D>::fill(const pbd::Substep<D>& substep, const pbd::ContactWriter& writer) {
  device_.parallel_for("attachments/fill", attachments_.view().count,
                       attachment_kernels::Fill{{attachments_.view(), substep.particles.sorted},
                                                attachments_of_body_.view(),
                                                bodies_.proxies(),
                                                writer});
}

template <class D>
void BodyAttachments<D>::arrange(pbd::Substep<D>& substep) {
  hold(substep);
  holds_ = true;
}

template <class D>
void BodyAttachments<D>::hold(pbd::Substep<D>& substep) {
  const pbd::ParticleView& p = substep.particles;
  device_.parallel_for("attachments/hold", attachments_.view().count,
                       attachment_kernels::Hold{{attachments_.view(), p.sorted},
                                                bodies_.proxies(),
                                                p.position,
                                                p.accumulated_delta,
                                                p.velocity,
                                                joined_.view(),
                                                1 / substep.dt});
}

/// Overlaps are relaxed without arrange().
template <class D>
void BodyAttachments<D>::begin(pbd::Substep<D>& substep) {
  if (!std::exchange(holds_, false)) hold(substep);
  device_.parallel_for("attachments/join", attachments_.view().count,
                       attachment_kernels::Join{joined(substep)});
}

template <class D>
void BodyAttachments<D>::project(pbd::Substep<D>& substep, int) {
  device_.parallel_for(
      "attachments/pull", attachments_.view().count,
      attachment_kernels::Pull{joined(substep), attachments_of_body_.view(), bodies_.proxies()});
}

template <class D>
void BodyAttachments<D>::transfer_push(pbd::Substep<D>& substep) {
  device_.parallel_for("attachments/transfer", attachments_.view().count,
                       attachment_kernels::TransferPush{joined(substep)});
}

/// Fail-safes may have moved the vertices since the last iteration.
template <class D>
void BodyAttachments<D>::release_vertices(pbd::Substep<D>& substep) {
  transfer_push(substep);
  device_.parallel_for("attachments/release", attachments_.view().count,
                       attachment_kernels::ReleaseVertices{joined(substep)});
}

template <class D>
void BodyAttachments<D>::observe(const pbd::Substep<D>& substep) {
  device_.parallel_for("attachments/impulses", attachments_.view().count,
                       attachment_kernels::AddImpulses{joined(substep), impulse_.view(), 1 / substep.dt});
}

}  // namespace meniscus::collision
