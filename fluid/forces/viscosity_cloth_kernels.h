// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The kernels of viscosity_set.h by which vertices of cloth take part in the solve.
//
// A contact c has the weight a_c, the projection P_c on its tangents, and the shares b_vc of its vertices v.
// The brake of the particle is a_c P_c (u_c − Σ_v b_vc v_v). A vertex gets Σ_c b_vc a_c P_c (u_c − v_v). So
// it has the velocity
//
//   v_v = D_v⁻¹ (m_v v*_v + Σ_c b_vc a_c P_c u_c),   D_v = m_v + Σ_c b_vc a_c P_c
//
// where v* is the velocity before. Only particles remain as unknowns. That converges however light vertices
// are. The matrix stays symmetric, and the sum of all momenta is kept.
#pragma once

#include "fluid/forces/viscosity_kernels.h"
#include "pbd/math/matrix.h"

namespace meniscus::fluid::viscosity_kernels {

/// The weights of the contacts with cloth.
struct WeighCloth {
  ContactView contacts;
  View<const float> weights;  ///< of all contacts
  View<Vec4> at_contacts;     ///< w: a, kg

  MENISCUS_HD void operator()(uint32_t k) const {
    const bool is_cloth = k < contacts.total() && contacts.contacts[k].body == pbd::on_cloth;
    at_contacts[k] = {0, 0, 0, is_cloth ? weights[k] : 0.0f};
  }
};

/// A part of a P of each contact: its diagonal, or xy, yz and zx.
struct Projections {
  ContactView contacts;
  View<Vec4> at_contacts;  ///< w: a
  bool diagonal;

  MENISCUS_HD void operator()(uint32_t k) const {
    const float a = at_contacts[k].w;
    if (!(a > 0)) return;
    const Vec3 n = contacts.contacts[k].normal;
    const Vec3 part = diagonal ? Vec3{1 - n.x * n.x, 1 - n.y * n.y, 1 - n.z * n.z}
                               : Vec3{-n.x * n.y, -n.y * n.z, -n.z * n.x};
    at_contacts[k] = pbd::with_w(a * part, a);
  }
};

/// a P u of each contact on cloth, with u of its particle.
struct DragCloth {
  ContactView contacts;
  View<Vec4> at_contacts;  ///< w: a
  View<const Vec4> vector;
  View<const Vec4> change;  ///< is added after an iteration, if there is a view
  View<const Progress> progress;

  MENISCUS_HD void operator()(uint32_t k) const {
    const float a = at_contacts[k].w;
    if (!(a > 0)) return;
    const uint32_t i = contacts.particle[k];
    Vec3 u = vector[i].xyz();
    if (change.count && progress[0].iterations > 0) u += change[i].xyz();
    at_contacts[k] = pbd::with_w(a * Walls::along(contacts.contacts[k], u), a);
  }
};

/// The vertices of cloth, which are particles from `first` on.
struct Vertices {
  uint32_t first;
  View<const Vec4> sums;       ///< by vertex: Σ_c b_vc of what the contacts have
  View<Vec4> diagonal, mixed;  ///< by vertex: Σ_c b_vc a_c P_c
  View<Vec4> velocity;         ///< by vertex: v_v, or its change, as contacts read it
  pbd::Withstanding held;      ///< its contacts are those of all particles

  /// Whether nothing moves the vertex.
  MENISCUS_HD bool is_held(uint32_t v) const {
    return pbd::is_held(held.contacts, first + v, held.position[first + v].w);
  }
  MENISCUS_HD float mass(uint32_t v) const { return 1 / held.position[first + v].w; }
  /// (D_v − m_v) x.
  MENISCUS_HD Vec3 brake(uint32_t v, Vec3 x) const {
    const Vec4 d = diagonal[v], m = mixed[v];
    return Sym3{d.x, d.y, d.z, m.x, m.z, m.y} * x;
  }
  /// x of D_v x = b, by elimination without pivots: D_v is positive definite. Rounding must not take the last
  /// of them below the mass, which is the least eigenvalue.
  MENISCUS_HD Vec3 solve(uint32_t v, Vec3 b) const {
    const Vec4 d = diagonal[v], m = mixed[v];
    const float least = mass(v), xx = d.x + least;
    const float y_of_x = m.x / xx, z_of_x = m.z / xx;
    const float yy = d.y + least - y_of_x * m.x, yz = m.y - y_of_x * m.z;
    const float z_of_y = yz / yy;
    const float zz = pbd::max(d.z + least - z_of_x * m.z - z_of_y * yz, least);
    const float by = b.y - y_of_x * b.x;
    const float z = (b.z - z_of_x * b.x - z_of_y * by) / zz, y = (by - yz * z) / yy;
    return {(b.x - m.x * y - m.z * z) / xx, y, z};
  }
};

/// Keeps a part of Σ_c b_vc a_c P_c.
struct KeepSums {
  View<const Vec4> sums;
  View<Vec4> kept;

  MENISCUS_HD void operator()(uint32_t v) const { kept[v] = sums[v]; }
};

/// v_v. Of a change of velocities v* is 0.
struct SolveVertices {
  Vertices vertices;
  View<const Vec4> before;  ///< v*, by particle; empty: 0

  MENISCUS_HD void operator()(uint32_t v) const {
    const Vec3 start = before.count ? before[vertices.first + v].xyz() : Vec3{0, 0, 0};
    const bool moves = !vertices.is_held(v);
    const Vec3 solved = moves ? vertices.solve(v, vertices.mass(v) * start + vertices.sums[v].xyz()) : start;
    vertices.velocity[v] = pbd::with_w(solved, 0);
  }
};

/// Sets the velocities of vertices. Held ones withstand what fluid exerts on them.
struct FinishVertices {
  Vertices vertices;
  View<Vec4> velocity;
  float dt;

  MENISCUS_HD void operator()(uint32_t v) const {
    const uint32_t i = vertices.first + v;
    const Vec3 solved = vertices.velocity[v].xyz();
    if (vertices.is_held(v))
      vertices.held.add(i, dt * (vertices.sums[v].xyz() - vertices.brake(v, solved)));
    else
      velocity[i] = pbd::with_w(solved, velocity[i].w);
  }
};

}  // namespace meniscus::fluid::viscosity_kernels
