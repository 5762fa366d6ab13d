// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The constraints of cloth as kernels read them. Vertices are numbered over all cloth of a world. XPBD's
// compliance α (Macklin, Müller & Chentanez 2016) is the inverse of a stiffness: 0 is unyielding.
#pragma once

#include <cstdint>

#include "pbd/math/vec.h"

namespace meniscus::cloth {

/// C = |x_b − x_a| − L
struct alignas(16) EdgeConstraint {
  uint32_t a, b;
  float rest_length;  ///< L, m
  float compliance;   ///< m/N
};

/// The three strains of a triangle (Müller, Chentanez, Kim & Macklin 2014), of F = [x_b − x_a, x_c − x_a] ·
/// inverse_rest, with columns f_u along the warp and f_v along the weft:
///
///   C_u = |f_u| − 1,  C_v = |f_v| − 1,  C_uv = f_u·f_v / (|f_u||f_v|)
struct alignas(8) StrainConstraint {
  uint32_t a, b, c;
  float inverse_rest[4];  ///< 1/m, row by row: of (x_b − x_a, x_c − x_a) in the fabric's u and v
  float warp_compliance, weft_compliance, shear_compliance;  ///< 1/J: 1/(stiffness · area)
};

/// C = θ − θ₀ between the triangles (a, b, c) and (b, a, d). θ is 0 where they lie flat, and positive where c
/// and d are bent towards the side that the normal of (a, b, c) points to.
struct alignas(16) HingeConstraint {
  uint32_t a, b, c, d;
  float rest_angle;  ///< θ₀, rad
  float compliance;  ///< 1/J: (A₁ + A₂)/(D l²)
};

/// C = |k_a x_a + k_b x_b + k_c x_c + k_d x_d|, with the cotangent weights of Bergou, Wardetzky, Harmon,
/// Zorin & Grinspun 2006. It equals l·2 sin(θ/2) while lengths are kept. For hinges that are flat at rest.
struct alignas(16) IsometricConstraint {
  uint32_t a, b, c, d;
  float weight[3];   ///< k of b, c and d; all four add up to 0
  float compliance;  ///< m²/J: (A₁ + A₂)/D
};

/// C = |x_vertex − x_anchor| − length ≤ 0, with a fixed anchor (Kim, Chentanez & Müller 2012).
struct Tether {
  uint32_t vertex, anchor;
  float length;      ///< m
  float compliance;  ///< m/N
  /// kg: a greater mass of the vertex stiffens the tether in proportion. 0: the mass has no effect.
  float self_mass = 0;
};

}  // namespace meniscus::cloth
