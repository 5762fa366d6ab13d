// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A box that floats, the level of the water that it floats in, and bodies as dense as water.
#include "sdk/validation/cases/floating_box.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "pbd/math/vec.h"
#include "sdk/validation/parts.h"

namespace meniscus::validation {
namespace {

constexpr float frame = 0.016f, xsph = 50;

/// A square about the body's middle, in its own frame, over which the water's level is not looked at.
struct LeftOut {
  Pose pose{};
  double half_width = 0;  ///< m
};

/// The mean of where the highest particle's centre is, m, over columns a spacing wide in a tank around the
/// origin.
double highest_centres(const World& world, float tank_width, const LeftOut& left_out) {
  const double s = double{world.def().particle_spacing}, half = 0.5 * double{tank_width};
  const int across = static_cast<int>(std::lround(2 * half / s));
  std::vector<double> top(static_cast<size_t>(across * across), -1);
  const auto column = [&](float at) {
    return std::clamp(static_cast<int>((double{at} + half) / s), 0, across - 1);
  };
  for (Vec3 p : world.positions()) {
    const Vec3 local = rotate(conjugate(left_out.pose.rotation), p - left_out.pose.position);
    if (double{std::max(std::fabs(local.x), std::fabs(local.z))} < left_out.half_width) continue;
    double& highest = top[static_cast<size_t>(column(p.x) * across + column(p.z))];
    highest = std::max(highest, double{p.y});
  }
  double sum = 0;
  int columns = 0;
  for (double y : top) {
    if (y < 0) continue;
    sum += y;
    ++columns;
  }
  return sum / columns;
}

/// Without the columns nearer to the box than four spacings.
double highest_centres(const World& world, const DraftCase& draft, const Pose& box) {
  const double clear = 0.5 * double{draft.base()} + 4 * double{draft.spacing};
  return highest_centres(world, draft.tank_width(), {box, clear});
}

void add_pool(World& world, float half, float depth) {
  world.add_fluid(block(world.create_fluid({.xsph = xsph}), {-half, 0, -half}, {half, depth, half}));
}

World draft_world(const WorldDef& def, const DraftCase& draft, BodyId& box) {
  World world(def);
  const float half = 0.5f * draft.tank_width(), depth = draft.depth();
  const float b = 0.5f * draft.base(), h = 0.5f * draft.box_height();
  world.create_shape(tank({-half, 0, -half}, {half, 3 * depth, half}));
  box = world.create_body(body(BoxGeometry{{b, h, b}}, {0, depth - draft.draft() + h, 0}, draft.density));
  add_pool(world, half, depth);
  return world;
}

/// What the surface lies above the highest centres, m: measured where the volume says how high it is. In a
/// lattice it is half a spacing; in a fluid a column's highest particle lies lower than that.
double surface_offset(const WorldDef& def) {
  World world(def);
  const float half = 9 * def.particle_spacing, depth = 12 * def.particle_spacing;
  world.create_shape(tank({-half, 0, -half}, {half, 3 * depth, half}));
  add_pool(world, half, depth);
  double sum = 0;
  int frames = 0;
  while (world.time() < 6) {
    world.step(frame);
    if (world.time() < 4) continue;
    sum += double{depth} - highest_centres(world, 2 * half, {});
    ++frames;
  }
  return sum / frames;
}

}  // namespace

DraftMeasure measure_draft(const WorldDef& base, const DraftCase& draft) {
  WorldDef def = base;
  def.particle_spacing = draft.spacing;
  const double offset = surface_offset(def);
  BodyId box;
  World world = draft_world(def, draft, box);
  double sum = 0;
  int frames = 0;
  while (world.time() < 10) {
    world.step(frame);
    if (world.time() < 9) continue;
    const Pose pose = world.body_state(box).pose;
    sum += highest_centres(world, draft, pose) + offset - double{pose.position.y};
    ++frames;
  }
  const BodyState state = world.body_state(box);
  const double height = double{draft.box_height()};
  const double upright = double{rotate(state.pose.rotation, {0, 1, 0}).y};
  DraftMeasure measure;
  measure.surface_offset = offset / double{draft.spacing};
  measure.error = (sum / frames + 0.5 * height - double{draft.draft()}) / height;
  measure.tilt = std::acos(std::min(1.0, upright)) * 180 / M_PI;
  measure.speed = double{length(state.velocity)};
  measure.outside = world.diagnostics().outside;
  return measure;
}

double rise(const WorldDef& base, float size, const Geometry& geometry, float density, float seconds) {
  const float spacing = base.particle_spacing;
  const float half = 0.5f * size + 5 * spacing, depth = 2 * size + 6 * spacing;
  World world(base);
  world.create_shape(tank({-half, 0, -half}, {half, 2 * depth, half}));
  BodyDef def = body(geometry, {0, 0.5f * depth, 0}, density);
  def.can_sleep = false;
  const BodyId id = world.create_body(def);
  world.add_fluid(block(world.create_fluid({}), {-half, 0, -half}, {half, depth, half}));
  run_steps(world, 30, frame);
  world.set_body_velocity(id, {0, 0, 0}, {0, 0, 0});
  const double start = double{world.body_state(id).centre_of_mass.y};
  run_steps(world, static_cast<int>(seconds / frame), frame);
  return double{world.body_state(id).centre_of_mass.y} - start;
}

}  // namespace meniscus::validation
