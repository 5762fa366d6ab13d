// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Walls by the method of images. A particle beside a wall lacks neighbours behind it. The wall supplies
// mirror ghosts of the particles in front of it, the particle itself included, with the multipliers of the
// originals. Then three quantities are as inside the fluid: density, the push of a constant pressure, and the
// pressure differences along the wall. The usual integral of the kernel over the solid gives the first alone.
// Without the last, the layer at a wall is heavier than the pressure supports. Then fluid at rest circulates:
// down along the walls, up in the middle.
//
// The mirror ghost of j is farther from i than j is, so the neighbour list contains all relevant mirror
// ghosts. The forces on i and j through a plane wall are opposite along it, and add up normal to it. So the
// wall receives pressure but no drag. Where walls meet there are mirror ghosts of mirror ghosts, exact for
// walls at right angles.
//
// With d the distances from mirror n,
//   x_i − x_j' = x_i − x_j + 2 d_j n,   |x_i − x_j'|² = |x_i − x_j|² + 4 d_i d_j,
// and so on for mirror ghosts of mirror ghosts. A mirror ghost costs a few operations, and a pair has the
// same values from both sides.
#pragma once

#include "fluid/kernel/kernel.h"
#include "fluid/kernel/tuning.h"
#include "pbd/contacts.h"
#include "pbd/particles.h"

namespace meniscus::fluid {

/// The mirrors near one particle: at most the three nearest.
struct MirrorPlanes {
  static constexpr int most = 3;
  static constexpr int most_ghosts = 1 << most;  ///< including the original, number 0

  int count = 0;
  uint32_t contact[most];
  Vec3 normal[most];
  float offset[most];           ///< m: the plane is normal · x = offset
  float distance[most];         ///< m, of the particle; 0 if it is behind the plane
  float weight[most];           ///< the fraction of a half-space behind it
  float fraction[most_ghosts];  ///< of each mirror ghost that counts
  float slack;                  ///< m: a penetration up to this depth counts as on the surface

  /// Mirror ghosts are numbered 1 to ghost_count(): bit k is set if mirror k takes part.
  MENISCUS_HD int ghost_count() const { return (1 << count) - 1; }
};

// The following is for at most n mirrors. Most particles at walls have one, and one alone needs no tests.

template <int n>
MENISCUS_HD bool is_used(const MirrorPlanes& m, int k) {
  return n == 1 || k < m.count;
}

/// The position of another particle relative to each mirror.
template <class R, int n>
struct MirrorDistances {
  R distance[n];
  R present[n];  ///< 0 for a particle behind the mirror, which has no mirror ghost in it

  MirrorDistances() = default;
  MENISCUS_HD MirrorDistances(const MirrorPlanes& m, const pbd::Vec3Of<R>& x) {
    MENISCUS_UNROLL
    for (int k = 0; k < n; ++k) {
      if (!is_used<n>(m, k)) break;
      const R d = R(m.normal[k].x) * x.x + R(m.normal[k].y) * x.y + R(m.normal[k].z) * x.z - R(m.offset[k]);
      distance[k] = max(d, R(0.0f));
      present[k] = select_less(d, R(-m.slack), R(0.0f), R(1.0f));
    }
  }
};

/// The coefficients c of one pair in a sum of c (x_i − x_j) over neighbours and mirror ghosts. With `apart`
/// the mirror ghosts of different mirrors are kept separate.
template <class R, int n, bool apart>
struct PairTerms {
  R total{0.0f};   ///< of j; unless apart, and of its mirror ghosts
  R by_first[n];   ///< if apart: of its mirror ghosts, by the first mirror of each
  R by_mirror[n];  ///< of the mirror ghosts in mirror k, alone or with others

  MENISCUS_HD PairTerms() {
    MENISCUS_UNROLL
    for (int k = 0; k < n; ++k) by_first[k] = by_mirror[k] = R(0.0f);
  }

  /// Adds the coefficients of the mirror ghosts; `coefficient(fraction, r²)` gives each. j: distances of the
  /// pair's other particle.
  template <class Coefficient>
  MENISCUS_HD void add_ghosts(const MirrorPlanes& m, const MirrorDistances<R, n>& j, const R& r2,
                              const Coefficient& coefficient) {
    MENISCUS_UNROLL
    for (int ghost = 1; ghost < 1 << n; ++ghost) {
      if (n > 1 && ghost > m.ghost_count()) break;
      R fraction(m.fraction[ghost]), ghost_r2 = r2;
      MENISCUS_UNROLL
      for (int k = 0; k < n; ++k) {
        if (!(ghost >> k & 1)) continue;
        fraction = fraction * j.present[k];
        ghost_r2 += R(4 * m.distance[k]) * j.distance[k];
      }
      const R c = coefficient(fraction, ghost_r2);
      if constexpr (!apart) total += c;
      MENISCUS_UNROLL
      for (int k = 0; k < n; ++k) {
        if (!(ghost >> k & 1)) continue;
        by_mirror[k] += c;
        if constexpr (apart) by_first[k] += (ghost & ((1 << k) - 1)) == 0 ? c : R(0.0f);
      }
    }
  }

  /// Σ c (x_i' − x_j): from the view of j, with the mirror ghosts of i.
  MENISCUS_HD pbd::Vec3Of<R> seen_by_other(const MirrorPlanes& m, const pbd::Vec3Of<R>& d) const {
    static_assert(!apart);
    pbd::Vec3Of<R> v = total * d;
    MENISCUS_UNROLL
    for (int k = 0; k < n; ++k) {
      if (!is_used<n>(m, k)) break;
      const Vec3 shift = (-2 * m.distance[k]) * m.normal[k];
      v += by_mirror[k] * pbd::Vec3Of<R>{R(shift.x), R(shift.y), R(shift.z)};
    }
    return v;
  }
};

/// Σ c (x_i − x_j) over neighbours and mirror ghosts.
template <class R, int n, bool apart>
struct GhostSums {
  using Terms = PairTerms<R, n, apart>;

  pbd::Vec3Of<R> along{R(0.0f), R(0.0f),
                       R(0.0f)};  // Σ c (x_i − x_j): of neighbours if apart, else of mirror ghosts too
  pbd::Vec3Of<R> to_ghosts[n];    // if apart: the same for mirror ghosts, by their first mirror
  R lift[n];                      // Σ c d_j over the mirror ghosts in mirror k
  R weight[n];                    // Σ c

  MENISCUS_HD GhostSums() {
    MENISCUS_UNROLL
    for (int k = 0; k < n; ++k) {
      lift[k] = weight[k] = R(0.0f);
      to_ghosts[k] = {R(0.0f), R(0.0f), R(0.0f)};
    }
  }

  MENISCUS_HD void add(const MirrorPlanes& m, const MirrorDistances<R, n>& j, const pbd::Vec3Of<R>& d,
                       const Terms& terms) {
    along += terms.total * d;
    MENISCUS_UNROLL
    for (int k = 0; k < n; ++k) {
      if (!is_used<n>(m, k)) break;
      if constexpr (apart) to_ghosts[k] += terms.by_first[k] * d;
      lift[k] += terms.by_mirror[k] * j.distance[k];
      weight[k] += terms.by_mirror[k];
    }
  }

  /// The sums over all lanes.
  MENISCUS_HD GhostSums<float, n, apart> in_one(const MirrorPlanes& m) const {
    GhostSums<float, n, apart> one;
    const auto vector_sum = [](const pbd::Vec3Of<R>& v) {
      const Vec3 total = sum(v);
      return pbd::Vec3Of<float>{total.x, total.y, total.z};
    };
    one.along = vector_sum(along);
    MENISCUS_UNROLL
    for (int k = 0; k < n; ++k) {
      if (!is_used<n>(m, k)) break;
      if constexpr (apart) one.to_ghosts[k] = vector_sum(to_ghosts[k]);
      one.lift[k] = sum(lift[k]);
      one.weight[k] = sum(weight[k]);
    }
    return one;
  }

  /// The contribution of mirror k to the mirror ghosts' vector, along its normal.
  MENISCUS_HD float through(const MirrorPlanes& m, int k) const {
    return m.distance[k] * sum(weight[k]) + sum(lift[k]);
  }

  /// If apart: the push of the mirror ghosts of mirror k parallel to it.
  MENISCUS_HD Vec3 along_mirror(const MirrorPlanes& m, int k) const {
    const Vec3 to = sum(to_ghosts[k]);
    return to - dot(to, m.normal[k]) * m.normal[k];
  }

  /// The vector of neighbours and mirror ghosts.
  MENISCUS_HD Vec3 vector(const MirrorPlanes& m) const {
    Vec3 v = sum(along);
    MENISCUS_UNROLL
    for (int k = 0; k < n; ++k) {
      if (!is_used<n>(m, k)) break;
      v += (2 * sum(lift[k])) * m.normal[k];
      if constexpr (apart) v += sum(to_ghosts[k]);
    }
    return v;
  }
};

/// Mirrors at right angles have mirror ghosts of mirror ghosts; parallel mirrors do not.
MENISCUS_HD inline float fraction_of_ghost(const MirrorPlanes& m, int ghost) {
  float fraction = 1;
  MENISCUS_UNROLL
  for (int k = 0; k < MirrorPlanes::most; ++k) {
    if (!(ghost >> k & 1)) continue;
    fraction *= m.weight[k];
    MENISCUS_UNROLL
    for (int l = 0; l < k; ++l) {
      if (ghost >> l & 1) fraction *= 1 - fabsf(dot(m.normal[k], m.normal[l]));
    }
  }
  return fraction;
}

/// The mirror that a contact at distance d replaces: a free one, or the farthest if that is farther.
MENISCUS_HD inline int place_for(const MirrorPlanes& m, float d) {
  if (m.count < MirrorPlanes::most) return m.count;
  int at = 0;
  float farthest = m.distance[0];
  MENISCUS_UNROLL
  for (int k = 1; k < MirrorPlanes::most; ++k) {
    if (m.distance[k] > farthest) {
      at = k;
      farthest = m.distance[k];
    }
  }
  return farthest > d ? at : MirrorPlanes::most;
}

/// Whether a contact at distance d (m) from a particle may be its mirror.
MENISCUS_HD inline bool may_mirror(const pbd::Contact& contact, float d, float h) {
  return d < h && contact.fraction != 0;
}

/// The number of contacts of particle i at x that may be its mirrors. Beyond MirrorPlanes::most the furthest
/// are none.
MENISCUS_HD inline int walls_at(const pbd::ContactView& contacts, uint32_t i, Vec3 x, float h) {
  int count = 0;
  for (uint32_t c = contacts.start[i]; c < contacts.start[i + 1]; ++c)
    count += may_mirror(contacts.contacts[c], plane_distance(contacts.contacts[c], x), h);
  return count;
}

/// The mirrors of the contacts of particle i at x. Loops are unrolled, so that a GPU keeps the mirrors in
/// registers.
MENISCUS_HD inline MirrorPlanes mirrors_at(const pbd::ContactView& contacts, uint32_t i, Vec3 x, float h) {
  MirrorPlanes m{};
  m.slack = kernel_tuning::mirror_slack * h;
  for (uint32_t c = contacts.start[i]; c < contacts.start[i + 1]; ++c) {
    const pbd::Contact& contact = contacts.contacts[c];
    const float d = plane_distance(contact, x);
    if (!may_mirror(contact, d, h)) continue;
    const int at = place_for(m, d);
    MENISCUS_UNROLL
    for (int k = 0; k < MirrorPlanes::most; ++k) {
      if (k != at) continue;
      m.distance[k] = d;
      m.contact[k] = c;
      m.normal[k] = contact.normal;
      m.offset[k] = dot(contact.normal, contact.point);
      m.weight[k] = contact.fraction;
    }
    m.count = m.count < at + 1 && at < MirrorPlanes::most ? at + 1 : m.count;
  }
  MENISCUS_UNROLL
  for (int k = 1; k < MirrorPlanes::most; ++k) {  // two solids that form one wall share it
    MENISCUS_UNROLL
    for (int l = 0; l < k; ++l) {
      if (dot(m.normal[k], m.normal[l]) > kernel_tuning::same_wall)
        m.weight[k] = pbd::min(m.weight[k], 1 - m.weight[l]);
    }
  }
  MENISCUS_UNROLL
  for (int k = 0; k < MirrorPlanes::most; ++k) m.distance[k] = pbd::max(m.distance[k], 0.0f);
  MENISCUS_UNROLL
  for (int ghost = 1; ghost < MirrorPlanes::most_ghosts; ++ghost) {
    m.fraction[ghost] = ghost <= m.ghost_count() ? fraction_of_ghost(m, ghost) : 0;
  }
  return m;
}

/// The sums over the mirror ghosts of the particle itself.
template <int n, bool apart, class Coefficient>
MENISCUS_HD GhostSums<float, n, apart> self_ghosts(const MirrorPlanes& m, const Coefficient& coefficient) {
  MirrorDistances<float, n> self;
  MENISCUS_UNROLL
  for (int k = 0; k < n; ++k) {
    self.distance[k] = m.distance[k];
    self.present[k] = 1;
  }
  PairTerms<float, n, apart> terms;
  terms.add_ghosts(m, self, float{tiny_distance2}, coefficient);
  GhostSums<float, n, apart> sums;
  sums.add(m, self, {0, 0, 0}, terms);
  return sums;
}

}  // namespace meniscus::fluid
