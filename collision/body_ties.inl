// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <numeric>

#include "collision/body_ties.h"

namespace meniscus::collision {

namespace tie_kernels {

using pbd::Vec4;
using pbd::View;

/// Ties in the order of their vertices. The first one of each vertex does the work for all of them.
struct Ties {
  View<const BodyTie> ties;
  uint32_t sorted;  ///< see ParticleView

  MENISCUS_HD bool leads(uint32_t n) const { return n == 0 || ties[n - 1].vertex != ties[n].vertex; }
  MENISCUS_HD uint32_t particle_of(uint32_t n) const { return sorted + ties[n].vertex; }
  template <class Visit>
  MENISCUS_HD void for_each_beside(uint32_t n, const Visit& visit) const {
    for (uint32_t k = n; k < ties.count && ties[k].vertex == ties[n].vertex; ++k) visit(k);
  }
};

struct Count {
  Ties ties;
  View<uint32_t> counts;

  MENISCUS_HD void operator()(uint32_t n) const {
    if (!ties.leads(n)) return;
    uint32_t found = 0;
    ties.for_each_beside(n, [&](uint32_t) { ++found; });
    counts[ties.particle_of(n)] += found;
  }
};

struct Fill {
  Ties ties;
  View<const BodyProxy> bodies;
  pbd::ContactWriter writer;

  MENISCUS_HD void operator()(uint32_t n) const {
    if (!ties.leads(n)) return;
    ties.for_each_beside(n,
                         [&](uint32_t k) { writer.write(ties.particle_of(n), make_contact(ties.ties[k])); });
  }

  /// Where the body will be. There is no normal: nothing is pushed out.
  MENISCUS_HD pbd::Contact make_contact(const BodyTie& tie) const {
    pbd::Contact c{};
    c.point = to_world(bodies[tie.body].pose, tie.anchor);
    c.solid = c.body = tie.body;
    c.radius = -1;
    return c;
  }
};

/// Puts vertices where bodies that nothing moves have them, and holds them there.
struct Hold {
  Ties ties;
  View<const BodyProxy> bodies;
  View<Vec4> position, moved;
  View<Vec4> held;

  MENISCUS_HD void operator()(uint32_t n) const {
    held[n] = {0, 0, 0, 0};
    const BodyProxy& body = bodies[ties.ties[n].body];
    const uint32_t i = ties.particle_of(n);
    const Vec4 x = position[i];
    if (!ties.leads(n) || body.inverse_mass > 0 || x.w == 0) return;
    const Vec3 anchor = to_world(body.pose, ties.ties[n].anchor);
    held[n] = pbd::with_w(moved[i].xyz() + anchor - x.xyz(), x.w);
    position[i] = pbd::with_w(anchor, 0);
    moved[i] = {0, 0, 0, 0};  // from now on, what it withstands
  }
};

/// Gives held vertices back, and their ties what they have withstood.
struct LetGo {
  Ties ties;
  View<const uint32_t> start;
  View<pbd::Contact> contacts;
  View<const Vec4> held;
  View<Vec4> position, moved;

  MENISCUS_HD void operator()(uint32_t n) const {
    const Vec4 way = held[n];
    if (way.w == 0) return;
    const uint32_t i = ties.particle_of(n), at = start[i];
    // Without room for it the step is done again.
    if (at < contacts.count) contacts[at].tangent_multiplier += 1 / way.w * way.xyz() - moved[i].xyz();
    position[i].w = way.w;
    moved[i] = pbd::with_w(way.xyz(), 0);
  }
};

/// A vertex's ties are its first contacts.
struct AddImpulses {
  Ties ties;
  View<const uint32_t> start;
  View<const pbd::Contact> contacts;
  View<pbd::Vec4> impulse;
  float inverse_dt;

  MENISCUS_HD void operator()(uint32_t n) const {
    if (!ties.leads(n)) return;
    uint32_t at = start[ties.particle_of(n)];
    ties.for_each_beside(n, [&](uint32_t k) {
      // Without room for it the step is done again.
      if (at < contacts.count)
        impulse[k] = pbd::with_w(impulse[k].xyz() + inverse_dt * contacts[at].tangent_multiplier, 0);
      ++at;
    });
  }
};

}  // namespace tie_kernels

template <class D>
void BodyTies<D>::set_ties(std::span<const BodyTie> ties) {
  std::vector<uint32_t> order(ties.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::stable_sort(order, {}, [&](uint32_t k) { return ties[k].vertex; });
  std::vector<BodyTie> by_vertex;
  place_.resize(ties.size());
  for (uint32_t k : order) {
    place_[k] = static_cast<uint32_t>(by_vertex.size());
    by_vertex.push_back(ties[k]);
  }
  std::vector<uint32_t> tied(ties.empty() ? 0 : by_vertex.back().vertex + 1, pbd::no_index);
  for (const BodyTie& tie : by_vertex) tied[tie.vertex] = tie.body;

  device_.wait();
  ties_.resize_discard(by_vertex.size());
  ties_.write(by_vertex);
  impulse_.resize_discard(by_vertex.size());
  impulse_.fill(0);
  held_.resize_discard(by_vertex.size());
  tied_body_.resize_discard(tied.size());
  tied_body_.write(tied);
}

template <class D>
std::vector<Vec3> BodyTies<D>::read_impulses() const {
  const std::vector<pbd::Vec4> by_vertex = impulse_.read(impulse_.size());
  std::vector<Vec3> out;
  for (uint32_t place : place_) out.push_back(by_vertex[place].xyz());
  return out;
}

template <class D>
void BodyTies<D>::count(const pbd::Substep<D>& substep, pbd::View<uint32_t> counts) {
  device_.parallel_for("ties/count", ties_.view().count,
                       tie_kernels::Count{{ties_.view(), substep.particles.sorted}, counts});
}

template <class D>
void BodyTies<D>::fill(const pbd::Substep<D>& substep, const pbd::ContactWriter& writer) {
  device_.parallel_for(
      "ties/fill", ties_.view().count,
      tie_kernels::Fill{{ties_.view(), substep.particles.sorted}, bodies_.proxies(), writer});
}

template <class D>
void BodyTies<D>::begin(pbd::Substep<D>& substep) {
  const pbd::ParticleView& p = substep.particles;
  device_.parallel_for(
      "ties/hold", ties_.view().count,
      tie_kernels::Hold{{ties_.view(), p.sorted}, bodies_.proxies(), p.position, p.moved, held_.view()});
}

template <class D>
void BodyTies<D>::let_go(pbd::Substep<D>& substep) {
  const pbd::ParticleView& p = substep.particles;
  device_.parallel_for("ties/let go", ties_.view().count,
                       tie_kernels::LetGo{{ties_.view(), p.sorted},
                                          substep.contacts.start,
                                          substep.contacts.contacts,
                                          held_.view(),
                                          p.position,
                                          p.moved});
}

template <class D>
void BodyTies<D>::observe(const pbd::Substep<D>& substep) {
  device_.parallel_for("ties/impulses", ties_.view().count,
                       tie_kernels::AddImpulses{{ties_.view(), substep.particles.sorted},
                                                substep.contacts.start,
                                                substep.contacts.contacts,
                                                impulse_.view(),
                                                1 / substep.dt});
}

}  // namespace meniscus::collision
