// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Fluids and granular materials, and the surface around their particles. Units as in defs.h.
#pragma once

#include <meniscus/ids.h>
#include <meniscus/types.h>

#include <optional>
#include <string>

namespace meniscus {

/// A liquid.
struct FluidDef {
  std::string name = "water";    ///< what World::find_fluid takes
  float rest_density = 1000.0f;  ///< ρ₀, kg/m³, 0.001 to 1e6
  /// μ, Pa·s, 0 to 1e6: implicit, so that any substep is stable. Rigid rotation is not braked. Between two
  /// fluids the harmonic mean acts. Solids and cloth hold the fluid by SurfaceDef::slip_length and
  /// FabricDef::slip_length.
  float dynamic_viscosity = 0.0f;
  /// 1/s: rate at which a particle takes the mean velocity of its neighbours. Its effect vanishes as h². It
  /// acts as a viscosity does, and removes the motion that the density solve leaves in water at rest. In a
  /// pool 0.6 m deep with a spacing of 5 cm, at 4 × 10, the RMS speed is 3.6 % of √(g·H) at 5/s. With 0 it is
  /// 11 %, and more with shorter substeps. The column of hydrostatic.json has 100/s.
  float xsph = 5.0f;
  /// ε, no unit, 0 to 1e6; the force is ε · h · (N × ω). It is no force between pairs, so momentum drifts.
  float vorticity_confinement = 0.0f;
  /// σ, N/m, 0 to 1e6: attraction and curvature (Akinci et al. 2013). The forces are explicit: substeps must
  /// be shorter than √(ρ₀ s³/(2πσ)). Solids and cloth hold fluid against a force that would pull it off them,
  /// and get the opposite force. The same holds for cohesion.
  float surface_tension = 0.0f;
  float cohesion = 0.0f;     ///< N/m, in addition: attraction alone, which holds threads and sheets together
  CollisionFilter filter{};  ///< which solids it collides with
  Vec3 color{0.10f, 0.35f, 0.75f};  ///< linear RGB, 0 to 1
};

/// Sand, gravel and the like: balls of one spacing in diameter that touch with friction and do not rotate
/// (Macklin et al. 2014, Unified Particle Physics, section 6). On solids the friction of the surface counts.
/// Grains do not bounce off one another. In a substep, grains should move no further than half a spacing, or
/// they penetrate one another (see WorldDef::cfl_number). Use 10 iterations. Fewer than 5 make a soft pile.
///
/// In a fluid a grain displaces a spacing cubed. So it floats if it is lighter than the fluid. The viscosity
/// and `xsph` of the fluid drag it along. Densities from a fifth to ten times that of the fluid are tested.
struct GranularDef {
  std::string name = "sand";  ///< what World::find_fluid takes
  float density = 1600.0f;    ///< kg/m³, 0.001 to 1e6, bulk: mass of a grain over a spacing cubed
  /// ≥ 0: tangent of the slope at which a collapsing column comes to rest. Below 0.18 it is that of grains
  /// without friction. A poured heap is up to 5° steeper. The μ of contacts is (friction − 0.18)/1.4, since
  /// balls that do not rotate interlock. Between two materials the geometric mean of their μ counts.
  float friction = 0.6f;
  CollisionFilter filter{};         ///< which solids it collides with
  Vec3 color{0.53f, 0.36f, 0.17f};  ///< linear RGB, 0 to 1
};

/// Which particles World::surface_mesh covers, and how finely.
struct SurfaceMeshDef {
  std::optional<FluidId> fluid{};  ///< or granular material; none: all fluids as one, without grains
  float cell_size = 0.5f;          ///< of marching cubes, spacings, 0.1 to 2
  /// Iso level of the particles' field, 0.2 to 3. At 1 the surface keeps the volume of the fluid, to within
  /// 0.1 spacings of its true place. A smaller level makes it fatter.
  float level = 1.0f;
};

}  // namespace meniscus
