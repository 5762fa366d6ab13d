// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Parts of which the cases build their worlds.
#pragma once

#include <meniscus/world.h>

#include "pbd/math/vec.h"

namespace meniscus::validation {

/// A closed box that holds the fluid in.
inline ShapeDef tank(Vec3 lower, Vec3 upper) {
  ShapeDef def;
  def.name = "tank";
  def.geometry = ContainerGeometry{0.5f * (upper - lower), {}};
  def.pose.position = 0.5f * (lower + upper);
  return def;
}

inline ShapeDef shape(const Geometry& geometry, Vec3 position = {0, 0, 0}) {
  ShapeDef def;
  def.geometry = geometry;
  def.pose.position = position;
  return def;
}

inline FluidVolumeDef block(FluidId fluid, Vec3 lower, Vec3 upper) {
  FluidVolumeDef def;
  def.fluid = fluid;
  def.region = BoxRegion{lower, upper};
  return def;
}

inline BodyDef body(const Geometry& geometry, Vec3 position, float density) {
  BodyDef def;
  def.geometry = geometry;
  def.pose.position = position;
  def.density = density;
  return def;
}

inline void run_steps(World& world, int steps, float step) {
  for (int k = 0; k < steps; ++k) world.step(step);
}

inline void run(World& world, double seconds, float step) {
  const double end = world.time() + seconds - 0.5 * double{step};
  while (world.time() < end) world.step(step);
}

}  // namespace meniscus::validation
