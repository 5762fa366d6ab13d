// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The state of rods that the kernels of RodSet share.
#pragma once

#include "cloth/rods/band.h"
#include "pbd/contacts.h"
#include "pbd/particles.h"

namespace meniscus::cloth::rod_kernels {

using pbd::Vec4;
using pbd::View;

/// C or λ of a segment and of the joint after it.
struct Strain {
  Vec3 stretch, bend;
};

/// The state of a segment at the linearization of its constraints.
struct Link {
  Vec3 reach;  ///< m, from a to b, in the segment's axes
  Mat3 bend;   ///< the gradient of the joint's bending by a rotation of the next frame
};

struct RodView {
  pbd::ParticleView particles;
  View<const RodSegment> segment;
  View<Vec4> frame;     ///< x, y, z, w of the quaternion
  View<Vec4> previous;  ///< at the substep's start
  View<Vec4> spin;      ///< rad/s; w: 1, or 0 where the segment is held
  View<Strain> start;   ///< C at the substep's start
  View<Strain> multiplier;
  View<Link> link;
  View<BandRow> rows;
  View<Vec4> torque;  ///< kg·m², times h², in the world's axes
  View<float> pull;   ///< kg·m, the tension of the segment in N times h²
  float dt;
};

MENISCUS_HD inline Quat quat(const Vec4& q) {
  return {q.x, q.y, q.z, q.w};
}
MENISCUS_HD inline Vec4 vec4(const Quat& q) {
  return {q.x, q.y, q.z, q.w};
}

/// The inverse of rotation_by, rad. Where w < 0 it is the longer way round.
MENISCUS_HD inline Vec3 rotation_vector(Quat q) {
  const Vec3 v{q.x, q.y, q.z};
  const float sine = length(v);
  return (sine < 1e-3f && q.w > 0 ? 2 + sine * sine / 3 : 2 * atan2f(sine, q.w) / sine) * v;
}

/// q̄ q₊. Of the two signs with this meaning, it takes the one nearer to the rest rotation.
MENISCUS_HD inline Quat relative_frame(Quat q, Quat after, Quat rest) {
  const Quat p = conjugate(q) * after;
  const float sign = p.x * rest.x + p.y * rest.y + p.z * rest.z + p.w * rest.w;
  return sign < 0 ? Quat{-p.x, -p.y, -p.z, -p.w} : p;
}

/// C = x_b − x_a − l d₃, in the segment's axes
MENISCUS_HD inline Vec3 stretch_strain(Vec3 reach, float rest_length) {
  return {reach.x, reach.y, reach.z - rest_length};
}

/// The bending of a joint, and its gradient by a small rotation δ of a frame, in the frame's own axes: dθ = G
/// δ for the next frame, and dθ = −Gᵀ δ for the frame before. G = 1 + ½ [θ]× + (1 − ½θ cot ½θ)/θ² [θ]×² is
/// the inverse of the right Jacobian of the exponential map.
struct Joint {
  Vec3 bend;  ///< θ, rad
  Mat3 gradient;
};

MENISCUS_HD inline Joint joint_of(Quat relative) {
  const Vec3 bend = rotation_vector(relative);
  const float angle2 = dot(bend, bend);
  const float sine = length({relative.x, relative.y, relative.z});
  const float square =
      angle2 < 0.1f ? 1.0f / 12 + angle2 / 720 : (1 - 0.5f * sqrtf(angle2) * relative.w / sine) / angle2;
  const float diagonal = 1 - square * angle2;
  Mat3 gradient = cross_matrix(0.5f * bend, diagonal);
  gradient.x += square * bend.x * bend;
  gradient.y += square * bend.y * bend;
  gradient.z += square * bend.z * bend;
  return {bend, gradient};
}

/// 1/(kg·m²), about the segment's axes. A tension N straightens a segment: it resists a rotation across the
/// segment by l N. This adds h² l N to the inertia. Without it a rod with a weight at its end overshoots
/// (Tournier, Nesme, Gilles & Faure 2015, "Stable Constrained Dynamics").
MENISCUS_HD inline Vec3 mobility(const RodView& rods, uint32_t k) {
  const RodSegment& s = rods.segment[k];
  const float free = rods.spin[k].w;
  const float bend = free * s.bend_mobility / (1 + s.bend_mobility * s.rest_length * rods.pull[k]);
  return {bend, bend, free * s.twist_mobility};
}

}  // namespace meniscus::cloth::rod_kernels
