// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace meniscus::cloth {

/// What the vertices of one piece of cloth have in common. A vertex knows its piece by its phase's group.
struct Piece {
  uint32_t first_vertex = 0, end_vertex = 0;
  float stretch_damping = 0, bending_damping = 0;  ///< τ, s: Rayleigh's, in proportion to stiffness;
                                                   ///< negative: it has no such constraints

  float drag = 0, lift = 0;  ///< coefficients C_D and C_L of a flat plate; 0: no air

  float inside = 0;  ///< m³, the volume that the gas inside would fill unstrained; 0: there is none
  float inside_compliance = 0;  ///< m³/Pa
  float tear_strain = 0;        ///< edges stretched further than this tear; 0: never
  bool bears_fluid = false;     ///< whether fluid may load it
};

/// Rayleigh's damping of all pieces, s, or negative where they differ.
struct CommonDamping {
  float stretch = -1, bending = -1;
};

}  // namespace meniscus::cloth
