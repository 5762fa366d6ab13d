// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Viscous flows between periodic axes, for which the Navier–Stokes equations have solutions.
#pragma once

#include <meniscus/world.h>

#include <functional>

#include "sdk/validation/case.h"

namespace meniscus::validation {

/// A world without gravity, 8 spacings long along z, and with one fluid of 1000 kg/m³.
class PeriodicFlow {
 public:
  static constexpr float frame = 1 / 60.0f;  ///< s

  /// `length_y`: 0 if y is not periodic. The device and the spacing are those of `world`.
  PeriodicFlow(const WorldDef& world, float length_x, float kinematic_viscosity, float length_y = 0);

  void fill(float height);
  void set_viscosity(float kinematic);
  void set_gravity(Vec3 gravity);
  void set_velocities(const std::function<Vec3(Vec3)>& wanted);
  /// A second and a half in which fluid without viscosity is stirred and comes to rest: it is no lattice any
  /// more.
  void stir(float speed);
  void run(int frames);

 private:
  WorldDef def_;
  FluidDef fluid_;
  FluidId id_{};

 public:
  World world;
};

/// A plane without slip that bounds the flow from below (`direction` 1) or above (−1).
ShapeDef flow_wall(float direction, float height, float belt_speed);

/// The velocities along x over a profile.
struct ProfileFit {
  double error;                ///< L2, over that of the profile
  double scale;                ///< of the profile that fits best
  double shape;                ///< L2, from that one
  Curve measured{"measured"};  ///< m/s over m
};

/// The flow between a wall at rest and one that moves, `layers` spacings apart: linear.
ProfileFit couette_flow(WorldDef world, int layers);
/// The flow that a force drives between two walls, from water that was stirred: a parabola.
ProfileFit poiseuille_flow(WorldDef world, int layers);
double couette_velocity(double y);      ///< m/s
double poiseuille_velocity(double y);   ///< m/s
constexpr float channel_height = 0.4f;  ///< m

/// Vortices of Taylor & Green, with a Reynolds number of one period of 20, in a square of 1 m.
struct VortexDecay {
  double rate = 0;              ///< over that of theory, 2 ν k²
  bool monotone = true;         ///< whether the amplitude falls in each frame
  Curve amplitude{"measured"};  ///< over the first one, over 2 ν k² t
};

/// From water that was stirred, one after the other with each kinematic viscosity.
std::vector<VortexDecay> taylor_green(const WorldDef& world, const std::vector<float>& viscosities);

}  // namespace meniscus::validation
