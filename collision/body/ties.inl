// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <numeric>

#include "collision/body/ties.h"

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
  pbd::ContactCounter counter;

  MENISCUS_HD void operator()(uint32_t n) const {
    if (!ties.leads(n)) return;
    uint32_t found = 0;
    ties.for_each_beside(n, [&](uint32_t) { ++found; });
    counter.add(ties.particle_of(n), found);
  }
};

/// In how many parts a body is: half of it is for what touches it.
MENISCUS_HD inline float splits(View<const uint32_t> ties_of_body, uint32_t body) {
  return 2 * static_cast<float>(ties_of_body[body]);
}

struct Fill {
  Ties ties;
  View<const uint32_t> ties_of_body;
  View<const BodyProxy> bodies;
  pbd::ContactWriter writer;

  MENISCUS_HD void operator()(uint32_t n) const {
    if (!ties.leads(n)) return;
    ties.for_each_beside(n,
                         [&](uint32_t k) { writer.write(ties.particle_of(n), make_contact(ties.ties[k])); });
  }

  /// Where the body will be. There is no normal: nothing is pushed out.
  MENISCUS_HD pbd::Contact make_contact(const BodyTie& tie) const {
    const BodyProxy& body = bodies[tie.body];
    pbd::Contact c{};
    c.point = to_world(body.pose, tie.anchor);
    c.solid = c.body = tie.body;
    c.radius = -1;
    c.arm = c.point - body.pose.position;
    c.body_inverse_mass = splits(ties_of_body, tie.body) * largest_inverse_mass_at(body, c.arm);
    return c;
  }
};

/// Ties with their vertices and contacts, while these are solved. A vertex's ties are its first contacts.
struct JoinedTies {
  Ties ties;
  View<const uint32_t> start;
  View<pbd::Contact> contacts;
  View<Vec4> position, moved;
  /// By tie that leads; w: the vertex's own, and `moved` when its bodies had last got their share of that. Of
  /// a vertex that a body holds which nothing moves: the way that it makes, m.
  View<Vec4> joined;

  /// Without room for all contacts the step is done again.
  template <class Visit>
  MENISCUS_HD void for_each_contact(uint32_t n, const Visit& visit) const {
    const uint32_t first = start[ties.particle_of(n)];
    ties.for_each_beside(n, [&](uint32_t k) {
      if (first + k - n < contacts.count) visit(contacts[first + k - n]);
    });
  }
};

/// Vertices get the weight of what they are tied to. What nothing moves holds them in their places.
struct Join {
  JoinedTies of;

  MENISCUS_HD void operator()(uint32_t n) const {
    if (!of.ties.leads(n)) return;
    const uint32_t i = of.ties.particle_of(n);
    const Vec4 x = of.position[i];
    const Vec3 way = of.moved[i].xyz();
    of.joined[n] = pbd::with_w(way, x.w);
    if (x.w == 0) return;
    float mass = 1 / x.w;
    bool is_held = false;
    Vec3 anchor{0, 0, 0};
    of.for_each_contact(n, [&](const pbd::Contact& c) {
      if (c.body_inverse_mass > 0) mass += 1 / c.body_inverse_mass;
      if (c.body_inverse_mass == 0 && !is_held) {
        is_held = true;
        anchor = c.point;
      }
    });
    of.position[i].w = is_held ? 0 : 1 / mass;
    if (!is_held) return;
    of.joined[n] = pbd::with_w(way + anchor - x.xyz(), x.w);
    of.position[i] = pbd::with_w(anchor, 0);
    of.moved[i] = {0, 0, 0, 0};  // from now on, what it withstands
  }
};

/// Vertices and anchors are drawn to one another.
struct Pull {
  JoinedTies of;
  View<const uint32_t> ties_of_body;
  View<const BodyProxy> bodies;

  MENISCUS_HD void operator()(uint32_t n) const {
    if (!of.ties.leads(n)) return;
    const uint32_t i = of.ties.particle_of(n);
    const Vec4 x = of.position[i], joined = of.joined[n];
    const Vec3 moved = of.moved[i].xyz();
    const bool moves = x.w > 0;
    const float w = moves ? joined.w : 0;
    // What it was moved by before the first iteration, its share of the body was as well.
    const Vec3 together = moves ? x.xyz() - (moved - joined.xyz()) : x.xyz();
    Vec3 pulled{0, 0, 0};  // kg·m
    of.for_each_contact(n, [&](pbd::Contact& c) {
      if (c.body_inverse_mass == 0) return;
      const Sym3 mobility =
          diagonal(w) + splits(ties_of_body, c.body) * inverse_mass_matrix(bodies[c.body], c.arm);
      const Vec3 pull = inverse(mobility) * (c.point - (together + w * pulled));
      c.tangent_multiplier += pull;
      pulled += pull;
    });
    of.moved[i] = pbd::with_w(moved + (moves ? w : 1) * pulled, 0);
    if (!moves) return;
    of.position[i] = pbd::with_w(x.xyz() + w * pulled, x.w);
    of.joined[n] = pbd::with_w(joined.xyz() + w * pulled, w);
  }
};

/// Bodies get what their vertices were moved by.
struct HandOn {
  JoinedTies of;

  MENISCUS_HD void operator()(uint32_t n) const {
    if (!of.ties.leads(n)) return;
    const uint32_t i = of.ties.particle_of(n);
    if (of.position[i].w == 0) return;
    const Vec3 moved = of.moved[i].xyz(), way = moved - of.joined[n].xyz();
    of.for_each_contact(n, [&](pbd::Contact& c) { c.tangent_multiplier -= way / c.body_inverse_mass; });
    of.joined[n] = pbd::with_w(moved, of.joined[n].w);
  }
};

/// Gives vertices their own weight back; and ties by which they were held, what these have withstood.
struct LetGo {
  JoinedTies of;

  MENISCUS_HD void operator()(uint32_t n) const {
    if (!of.ties.leads(n)) return;
    const Vec4 joined = of.joined[n];
    const uint32_t i = of.ties.particle_of(n);
    const bool is_held = of.position[i].w == 0;
    of.position[i].w = joined.w;
    if (!is_held || joined.w == 0) return;
    Vec3 withstood = 1 / joined.w * joined.xyz() - of.moved[i].xyz();
    of.for_each_contact(n, [&](pbd::Contact& c) {
      if (c.body_inverse_mass > 0) return;
      c.tangent_multiplier += withstood;
      withstood = {0, 0, 0};  // by the first of several
    });
    of.moved[i] = pbd::with_w(joined.xyz(), 0);
  }
};

struct AddImpulses {
  JoinedTies of;
  View<pbd::Vec4> impulse;
  float inverse_dt;

  MENISCUS_HD void operator()(uint32_t n) const {
    if (!of.ties.leads(n)) return;
    uint32_t k = n;
    of.for_each_contact(n, [&](const pbd::Contact& c) {
      impulse[k] = pbd::with_w(impulse[k].xyz() + inverse_dt * c.tangent_multiplier, 0);
      ++k;
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
  std::vector<uint32_t> ties_of_body;
  for (const BodyTie& tie : by_vertex) {
    tied[tie.vertex] = tie.body;
    if (ties_of_body.size() <= tie.body) ties_of_body.resize(tie.body + 1);
    ++ties_of_body[tie.body];
  }

  device_.wait();
  ties_.resize_discard(by_vertex.size());
  ties_.write(by_vertex);
  impulse_.resize_discard(by_vertex.size());
  impulse_.fill(0);
  joined_.resize_discard(by_vertex.size());
  ties_of_body_.resize_discard(ties_of_body.size());
  ties_of_body_.write(ties_of_body);
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
tie_kernels::JoinedTies BodyTies<D>::joined(const pbd::Substep<D>& substep) {
  const pbd::ParticleView& p = substep.particles;
  return {{ties_.view(), p.sorted},
          substep.contacts.start,
          substep.contacts.contacts,
          p.position,
          p.moved,
          joined_.view()};
}

template <class D>
void BodyTies<D>::count(const pbd::Substep<D>& substep, const pbd::ContactCounter& counter) {
  device_.parallel_for("ties/count", ties_.view().count,
                       tie_kernels::Count{{ties_.view(), substep.particles.sorted}, counter});
}

template <class D>
void BodyTies<D>::fill(const pbd::Substep<D>& substep, const pbd::ContactWriter& writer) {
  device_.parallel_for(
      "ties/fill", ties_.view().count,
      tie_kernels::Fill{
          {ties_.view(), substep.particles.sorted}, ties_of_body_.view(), bodies_.proxies(), writer});
}

template <class D>
void BodyTies<D>::begin(pbd::Substep<D>& substep) {
  device_.parallel_for("ties/join", ties_.view().count, tie_kernels::Join{joined(substep)});
}

template <class D>
void BodyTies<D>::project(pbd::Substep<D>& substep, int) {
  device_.parallel_for("ties/pull", ties_.view().count,
                       tie_kernels::Pull{joined(substep), ties_of_body_.view(), bodies_.proxies()});
}

template <class D>
void BodyTies<D>::hand_on(pbd::Substep<D>& substep) {
  device_.parallel_for("ties/hand on", ties_.view().count, tie_kernels::HandOn{joined(substep)});
}

template <class D>
void BodyTies<D>::let_go(pbd::Substep<D>& substep) {
  device_.parallel_for("ties/let go", ties_.view().count, tie_kernels::LetGo{joined(substep)});
}

template <class D>
void BodyTies<D>::observe(const pbd::Substep<D>& substep) {
  device_.parallel_for("ties/impulses", ties_.view().count,
                       tie_kernels::AddImpulses{joined(substep), impulse_.view(), 1 / substep.dt});
}

}  // namespace meniscus::collision
