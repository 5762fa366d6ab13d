// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Mass, centre and inertia of bodies. Densities are in kg/m³, lengths in m. Functions throw
// Error(invalid_argument) for a length or density that is not positive and finite. They throw Error(mesh) for
// a body with degenerate inertia: one without volume, or a needle with a principal moment below a millionth
// of the largest.
#pragma once

#include <span>

#include "collision/mesh/mesh.h"

namespace meniscus::collision {

struct MassProperties {
  double mass = 0;        ///< kg
  Vec3 centre{0, 0, 0};   ///< of mass, m
  Vec3 inertia{0, 0, 0};  ///< kg m², principal moments about the centre
  Quat axes{0, 0, 0, 1};  ///< rotates the principal frame to the geometry's; identity if that is principal
};

MassProperties sphere_mass(float radius, double density);
MassProperties box_mass(Vec3 half_extents, double density);
/// Along y: a cylinder of twice the half height, and a half-ball at each end.
MassProperties capsule_mass(float radius, float half_height, double density);
/// Along y.
MassProperties cylinder_mass(float radius, float half_height, double density);

/// For the inside of a closed mesh whose triangles face outwards (load_solid), exact except for rounding.
/// Sums over the tetrahedra between the triangles and a point (Blow & Binstock 2004; the integrals of Mirtich
/// 1996).
MassProperties mesh_mass(const TriangleMesh& mesh, double density);

/// The same body with the mass `mass`, kg. Moments are proportional to the mass.
MassProperties with_mass(const MassProperties& body, double mass);

struct PlacedMass {
  MassProperties body;
  Pose pose;  ///< of the body's geometry in the compound's frame
};

/// The mass properties of a compound, in its frame. Where parts overlap, both count. Throws
/// Error(invalid_argument) without parts.
MassProperties combine(std::span<const PlacedMass> parts);

}  // namespace meniscus::collision
