// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The properties that all vertices of a piece of cloth share.
#pragma once

#include <cstdint>

namespace meniscus::cloth {

/// The properties that the vertices of one piece of cloth share. The group of a vertex's phase gives its
/// piece.
struct Piece {
  uint32_t first_vertex = 0, end_vertex = 0;
  float stretch_damping = 0, bending_damping = 0;  ///< τ, s: Rayleigh damping, in proportion to stiffness;
                                                   ///< negative: there are no such constraints

  float drag = 0, lift = 0;  ///< coefficients C_D and C_L of a flat plate; 0: no air

  float inside = 0;             ///< m³, the volume that the gas inside would fill without strain; 0: no gas
  float inside_compliance = 0;  ///< m³/Pa
  float tear_strain = 0;        ///< edges with a greater strain tear; 0: never
  bool carries_fluid = false;   ///< whether fluid may load it
};

/// Rayleigh damping of all pieces, s; negative where pieces differ.
struct CommonDamping {
  float stretch = -1, bending = -1;
};

}  // namespace meniscus::cloth
