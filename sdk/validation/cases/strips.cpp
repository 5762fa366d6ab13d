// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Strips of cloth that bend under their own weight, and sheets on slopes.
#include "sdk/validation/cases/strips.h"

#include <algorithm>
#include <cmath>

#include "sdk/validation/cases/cloth_parts.h"

namespace meniscus::validation {

double strip_drop(const WorldDef& base, float load, int squares, BendingModel model) {
  const float side = 1 / (float(squares) + 0.5f);
  const int rows = squares == 10 ? 7 : 9;
  World world(cloth_world(base, 40 * squares * squares / 100, 2));
  ClothDef def = sheet(float(squares + 1) * side, float(rows - 1) * side, squares + 2, rows);
  def.self_collision = def.tethers = false;
  def.fabric.bending_model = model;
  def.fabric.bending_stiffness = def.fabric.density * 9.81f / load;
  def.fabric.bending_damping = def.fabric.lift = 0;
  const ClothId id = world.create_cloth(def);
  world.create_attachment(held(id, columns_of(def, {0, 1})));
  world.set_wind({.air_density = 20});
  run_steps(world, 480, cloth_frame);
  return -double{mean_of(world.cloth_positions(id), columns_of(def, {squares + 1})).y};
}

double slide(const WorldDef& base, float friction, float degrees) {
  World world(cloth_world(base, 10, 2));
  ShapeDef slope = shape(PlaneGeometry{});
  slope.pose.rotation = about_z(degrees);
  slope.surface.friction = friction;
  world.create_shape(slope);
  ClothDef def = sheet(0.5f, 0.5f, 17, 17);
  def.fabric.thickness = 0.008f;
  def.fabric.drag = def.fabric.lift = 0;
  def.pose.rotation = slope.pose.rotation;
  def.pose.position = rotate(slope.pose.rotation, {0, 0.0045f, 0});
  const ClothId id = world.create_cloth(def);
  run_steps(world, 30, cloth_frame);
  const Vec3 before = world.cloth_state(id).centre;
  run_steps(world, 60, cloth_frame);
  return double{length(world.cloth_state(id).centre - before)};
}

double exact_slide(float friction, float degrees) {
  const double angle = double{degrees} * M_PI / 180;
  return std::max(0.0, 9.81 * (std::sin(angle) - double{friction} * std::cos(angle)));  // ½ a (1.5² − 0.5²)
}

}  // namespace meniscus::validation
