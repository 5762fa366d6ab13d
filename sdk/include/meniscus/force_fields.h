// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Force fields as data: what acts on fluids, grains, cloth, ropes and bodies beside gravity. Units as in
// defs.h. docs/methods/force-fields.md has the equations and their tests.
#pragma once

#include <meniscus/defs.h>

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace meniscus {

// All vectors and places below are in the frame of the field, ForceFieldDef::pose. x is the place in that
// frame, r = |x|, v the velocity. "Amount" is an acceleration in m/s², or a force per volume in N/m³, as
// ForceFieldDef::quantity says.

/// The same amount everywhere: a = value.
struct UniformForce {
  Vec3 value{0, 0, 0};  ///< m/s², or N/m³
};

/// Away from the origin, or towards it where strength < 0: a = strength · (radius/s)ⁿ · x/s, with
/// s² = r² + softening². n = 2 is gravity of a point, n = −1 a spring.
struct RadialForce {
  float strength = -1.0f;    ///< m/s², or N/m³: the amount at r = radius, without softening
  float radius = 1.0f;       ///< m, > 0
  int exponent = 2;          ///< n, −1 to 4
  float softening = 0.001f;  ///< m, > 0: keeps the amount finite at the origin
};

/// A vortex about the y axis that turns as a rigid body does, u = Ω ŷ × x:
/// a = −Ω² (x − ŷ(ŷ·x)) + rate · (u − v). The first term is the centripetal acceleration of that flow. So
/// what moves with u goes on along its circle, and all else takes that velocity at the rate. The field is an
/// acceleration alone.
struct VortexForce {
  float angular_velocity = 1.0f;  ///< Ω, rad/s
  float rate = 1.0f;              ///< 1/s, ≥ 0
};

/// Drag towards a velocity u: a = (linear + quadratic · |u − v|) · (u − v). Each part is integrated exactly
/// over a substep, so that any drag is stable.
struct DragForce {
  Vec3 velocity{0, 0, 0};  ///< u, m/s
  float linear = 1.0f;     ///< 1/s, or kg/(m³·s), ≥ 0
  float quadratic = 0.0f;  ///< 1/m, or kg/m⁴, ≥ 0
};

/// Turbulence without divergence: the curl of gradient noise (Bridson et al. 2007). It depends on the seed,
/// the place and the time of the world alone.
struct NoiseForce {
  float strength = 1.0f;  ///< m/s², or N/m³: RMS of the amount
  float size = 0.5f;      ///< m, > 0: distance between the nodes of the noise
  float period = 0.0f;    ///< s, ≥ 0: time from one pattern to the next; 0: it does not change
  uint32_t seed = 0;      ///< another seed is another field
};

/// Values on a grid, linear between its nodes. Outside of the grid there is no force.
struct GridForce {
  Vec3 lower{0, 0, 0};     ///< m, of the first node
  float cell_size = 0.1f;  ///< m, > 0
  int nodes_x = 2;         ///< 2 to 4096
  int nodes_y = 2;         ///< 2 to 4096
  int nodes_z = 2;         ///< 2 to 4096; at most 2²⁴ nodes in all
  /// m/s², or N/m³: nodes_x · nodes_y · nodes_z of them, x fastest, then y.
  std::vector<Vec3> values = std::vector<Vec3>(8);
};

/// The law of a force field.
using Force = std::variant<UniformForce, RadialForce, VortexForce, DragForce, NoiseForce, GridForce>;

/// All of space.
struct EverywhereRegion {};

/// Where a force field acts: at the places inside.
using ForceRegion = std::variant<EverywhereRegion, BoxRegion, BallRegion>;

/// What the amounts of a force field are.
enum class ForceQuantity {
  acceleration,  ///< m/s²: the same for all masses
  /// N/m³, on the volume: of particles mass over density, of bodies their own, and of ropes that of their
  /// radius. Cloth has the volume of FabricDef::thickness, without its fluid. Where that is 0, it has none.
  force_density,
};

/// A force field. Fields add up in the order of their ids. They act on velocities at the start of each
/// substep, as gravity does: v ← v + h·a(x, v, t).
///
/// A body feels the field at six points, which have its mass and its moments of inertia together. This is
/// exact for fields that are linear in x and v, in force and torque. A body that a field pulls does not fall
/// asleep. World::relax takes no account of fields.
struct ForceFieldDef {
  std::string name{};                                    ///< what outputs call it
  Force force = UniformForce{};                          ///< the law
  ForceQuantity quantity = ForceQuantity::acceleration;  ///< what the law gives
  ForceRegion region = EverywhereRegion{};               ///< in the frame of the field
  Pose pose{};                                           ///< of the field in the world
  bool fluids = true;                                    ///< whether it acts on fluids
  bool grains = true;                                    ///< whether it acts on granular materials
  bool cloth = true;                                     ///< whether it acts on cloth and ropes
  bool bodies = true;                                    ///< whether it acts on dynamic bodies
};

}  // namespace meniscus
