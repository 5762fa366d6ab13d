// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The kernels of contacts among grains. All of them gather: a kernel writes the row and the position of its
// own grain alone.
#pragma once

#include "collision/grains/rows.h"
#include "pbd/contacts.h"
#include "pbd/device/base/atomics.h"
#include "pbd/neighbours.h"
#include "pbd/particles.h"

namespace meniscus::collision::grain_kernels {

using pbd::Phase;
using pbd::Vec4;
using pbd::View;

/// Unit normal from j to i. Grains at the same point are separated along y.
MENISCUS_HD inline Vec3 contact_normal(Vec3 d, float distance, uint32_t i, uint32_t j) {
  if (distance > 0) return (1 / distance) * d;
  return {0, i < j ? 1.0f : -1.0f, 0};
}

/// Lists the grains that may touch a grain before the substep's end. The solve starts from a fraction of the
/// impulse that such a contact had in the last substep.
struct FindTouching {
  View<const Vec4> position, previous;
  View<const Phase> phase;
  pbd::NeighbourView neighbours;
  View<const float> roughness;  ///< √μ, by group
  float diameter, reach;        ///< m
  float recovery;               ///< fraction of an overlap that is undone in this substep
  GrainRows last;
  View<const uint32_t> origin;  ///< by grain: its index when the last rows were written
  float fraction;
  GrainRows rows;
  View<Vec4> change;  ///< of the impulses, in the last iteration; w: distance to keep, m
  View<uint32_t> next_origin;
  View<float> pressing;  ///< see Stage
  View<uint32_t> longest;

  MENISCUS_HD void operator()(uint32_t i) const {
    next_origin[i] = i;
    uint32_t found = 0;
    if (pbd::is_grain(phase[i])) {
      const uint32_t count = neighbours.size(i);
      for (uint32_t k = 0; k < count; ++k) {
        const uint32_t j = neighbours.at(i, k);
        if (!pbd::is_grain(phase[j])) continue;
        const Vec3 d = position[i].xyz() - position[j].xyz();
        if (!(dot(d, d) < reach * reach)) continue;
        if (found < rows.capacity) write(i, j, found);
        ++found;
      }
      pbd::atomic_max(longest[0], found);
    }
    rows.count[i] = pbd::min(found, rows.capacity);
    pressing[i] = 0;
  }

  MENISCUS_HD void write(uint32_t i, uint32_t j, uint32_t k) const {
    const size_t at = rows.place(i, k);
    const Vec3 before = previous[i].xyz() - previous[j].xyz();
    const float distance = length(before);
    const float keep = distance < diameter ? distance + recovery * (diameter - distance) : diameter;
    const float friction = roughness[pbd::phase_group(phase[i])] * roughness[pbd::phase_group(phase[j])];
    rows.partner.data[at] = j;
    rows.impulse.data[at] = pbd::with_w(fraction * last_impulse(origin[i], origin[j]), friction);
    change.data[at] = {0, 0, 0, keep};
  }

  MENISCUS_HD Vec3 last_impulse(uint32_t i, uint32_t j) const {
    if (i == pbd::no_index || j == pbd::no_index) return {0, 0, 0};
    for (uint32_t k = 0; k < last.count[i]; ++k) {
      const size_t at = last.place(i, k);
      if (last.partner.data[at] == j) return last.impulse.data[at].xyz();
    }
    return {0, 0, 0};
  }
};

/// Copies rows to longer ones.
struct CopyRows {
  GrainRows from, to;

  MENISCUS_HD void operator()(uint32_t i) const {
    const uint32_t count = pbd::min(from.count[i], from.capacity);  // rows that are not in use have any
    for (uint32_t k = 0; k < count; ++k) {
      const size_t at = to.place(i, k), there = from.place(i, k);
      to.partner.data[at] = from.partner.data[there];
      to.impulse.data[at] = from.impulse.data[there];
    }
  }
};

/// Writes the longest row for the host.
struct NoteLongest {
  View<const uint32_t> longest;
  View<uint32_t> found;

  MENISCUS_HD void operator()(uint32_t) const { found[0] = longest[0]; }
};

/// Moves grains by the impulses that the solve starts from.
struct Start {
  GrainRows rows;
  View<Vec4> position, accumulated_delta;

  MENISCUS_HD void operator()(uint32_t i) const {
    const uint32_t count = rows.count[i];
    if (count == 0) return;
    Vec3 push{0, 0, 0};
    for (uint32_t k = 0; k < count; ++k) push += rows.impulse.data[rows.place(i, k)].xyz();
    const Vec4 p = position[i];
    const Vec3 step = p.w * push;
    position[i] = pbd::with_w(p.xyz() + step, p.w);
    accumulated_delta[i] = pbd::shifted(accumulated_delta[i], step);
  }
};

/// Copies the positions for Project, so that all grains read the same ones. Counts the largest number of
/// contacts that press on a grain at once in this substep: a grain is split among these. With one too few, an
/// iteration overcorrects: a row of grains that met at 0.05 m/s flew apart at 20 m/s.
struct Stage {
  GrainRows rows;
  View<const Vec4> change, position;
  View<float> pressing;
  View<Vec4> staged;  ///< w: inverse mass, as seen by each of the grain's contacts

  MENISCUS_HD void operator()(uint32_t i) const {
    const uint32_t count = rows.count[i];
    if (count == 0) return;
    const Vec4 p = position[i];
    uint32_t now = 0;
    for (uint32_t k = 0; k < count; ++k) now += presses(p.xyz(), rows.place(i, k));
    const float most = pressing[i] = pbd::max(pressing[i], static_cast<float>(now));
    staged[i] = pbd::with_w(p.xyz(), pbd::max(1.0f, most) * p.w);
  }
  /// Whether the next iteration changes the contact.
  MENISCUS_HD bool presses(Vec3 x, size_t at) const {
    const Vec3 impulse = rows.impulse.data[at].xyz(), d = x - position[rows.partner.data[at]].xyz();
    const float keep = change.data[at].w;
    return dot(impulse, impulse) > 0 || dot(d, d) < keep * keep;
  }
};

struct Project {
  GrainRows rows;
  View<Vec4> change;
  View<const Vec4> staged, previous;
  View<Vec4> position, accumulated_delta;
  float momentum, step;

  MENISCUS_HD void operator()(uint32_t i) const {
    const uint32_t count = rows.count[i];
    if (count == 0) return;
    const Vec4 self = staged[i];
    const Vec3 start = previous[i].xyz();
    Vec3 push{0, 0, 0};
    for (uint32_t k = 0; k < count; ++k) {
      const size_t at = rows.place(i, k);
      const uint32_t j = rows.partner.data[at];
      const Vec4 old = rows.impulse.data[at], last = change.data[at];
      const Vec4 other = staged[j];
      const Vec3 d = self.xyz() - other.xyz();
      const Vec3 displacement = d - (start - previous[j].xyz());
      const float distance = length(d);
      const Vec3 normal = contact_normal(d, distance, i, j);
      const Vec3 slip = displacement - dot(displacement, normal) * normal;
      const Vec3 wanted = old.xyz() + momentum * last.xyz() -
                          (step / (self.w + other.w)) * ((distance - last.w) * normal + slip);
      const Vec3 now = within_cone(wanted, normal, old.w);
      push += now - old.xyz();
      rows.impulse.data[at] = pbd::with_w(now, old.w);
      change.data[at] = pbd::with_w(now - old.xyz(), last.w);
    }
    const float w = position[i].w;
    const Vec3 shift = w * push;
    position[i] = pbd::with_w(self.xyz() + shift, w);
    accumulated_delta[i] = pbd::shifted(accumulated_delta[i], shift);
  }

  /// Projects the impulse into the friction cone: grains never pull, and friction is at most μ times the
  /// load.
  MENISCUS_HD static Vec3 within_cone(Vec3 impulse, Vec3 normal, float friction) {
    const float load = dot(impulse, normal);
    if (!(load > 0)) return {0, 0, 0};
    return load * normal + shortened_to(impulse - load * normal, friction * load);
  }
};

}  // namespace meniscus::collision::grain_kernels
