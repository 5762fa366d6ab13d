// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A box that floats, and the level of the water that it floats in.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/coupling/body_worlds.h"
#include "tests/validation/measures.h"

namespace meniscus::tests {

/// A box `height` spacings high on a square base half as wide again, in a tank with six spacings of water
/// around it and below it.
struct DraftCase {
  float density;  ///< kg/m³
  float spacing;  ///< m
  int height;     ///< spacings

  float box_height() const { return static_cast<float>(height) * spacing; }
  float base() const { return 1.5f * box_height(); }
  float draft() const { return density / 1000 * box_height(); }
  float tank_width() const { return base() + 12 * spacing; }
  float depth() const { return draft() + 6 * spacing; }
};

/// A square about the body's middle, in its own frame, over which the water's level is not looked at.
struct LeftOut {
  Pose pose{};
  double half_width = 0;  ///< m
};

/// The mean of where the highest particle's centre is, m, over columns a spacing wide in a tank around the
/// origin.
inline double highest_centres(const World& world, float spacing, float tank_width, const LeftOut& left_out) {
  const double s = double{spacing}, half = 0.5 * double{tank_width};
  const int across = static_cast<int>(std::lround(2 * half / s));
  std::vector<double> top(static_cast<size_t>(across * across), -1);
  const auto column = [&](float at) {
    return std::clamp(static_cast<int>((double{at} + half) / s), 0, across - 1);
  };
  for (Vec3 p : world.positions()) {
    const Sum3 local = rotated_back(left_out.pose.rotation, Sum3(p) - left_out.pose.position);
    if (std::max(std::fabs(local.x), std::fabs(local.z)) < left_out.half_width) continue;
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
inline double highest_centres(const World& world, const DraftCase& draft, const Pose& box) {
  const double clear = 0.5 * double{draft.base()} + 4 * double{draft.spacing};
  return highest_centres(world, draft.spacing, draft.tank_width(), {box, clear});
}

inline World draft_world(pbd::DeviceKind device, const DraftCase& draft, float xsph, BodyId& box) {
  World world(world_def(device, draft.spacing));
  const float half = 0.5f * draft.tank_width(), depth = draft.depth();
  const float b = 0.5f * draft.base(), h = 0.5f * draft.box_height();
  world.create_shape(tank({-half, 0, -half}, {half, 3 * depth, half}));
  box = world.create_body(body(BoxGeometry{{b, h, b}}, {0, depth - draft.draft() + h, 0}, draft.density));
  FluidDef water;
  water.xsph = xsph;
  world.add_fluid(block(world.create_fluid(water), {-half, 0, -half}, {half, depth, half}));
  return world;
}

/// What the surface lies above the highest centres, m: measured where the volume says how high it is. In a
/// lattice it is half a spacing; in a fluid a column's highest particle lies lower than that.
inline double surface_offset(pbd::DeviceKind device, float spacing, float xsph) {
  World world(world_def(device, spacing));
  const float half = 9 * spacing, depth = 12 * spacing;
  world.create_shape(tank({-half, 0, -half}, {half, 3 * depth, half}));
  FluidDef water;
  water.xsph = xsph;
  world.add_fluid(block(world.create_fluid(water), {-half, 0, -half}, {half, depth, half}));
  double sum = 0;
  int frames = 0;
  while (world.time() < 6) {
    world.step(0.016f);
    if (world.time() < 4) continue;
    sum += double{depth} - highest_centres(world, spacing, 2 * half, {});
    ++frames;
  }
  return sum / frames;
}

/// Ten seconds with xsph at 50 1/s. In the last one the box's mean draft must be what Archimedes says, within
/// 3 % of the box's height; at the end it is at rest (1 cm/s) and level (1°).
inline void expect_draft(pbd::DeviceKind device, const DraftCase& draft) {
  const double offset = surface_offset(device, draft.spacing, 50);
  BodyId box;
  World world = draft_world(device, draft, 50, box);
  record_device(world);
  double sum = 0;
  int frames = 0;
  while (world.time() < 10) {
    world.step(0.016f);
    if (world.time() < 9) continue;
    const Pose pose = world.body_state(box).pose;
    sum += highest_centres(world, draft, pose) + offset - double{pose.position.y};
    ++frames;
  }
  const BodyState state = world.body_state(box);
  const double height = double{draft.box_height()};
  const double error = (sum / frames + 0.5 * height - double{draft.draft()}) / height;
  const double upright = rotated(state.pose.rotation, {0, 1, 0}).y;
  record("surface_offset_spacings", offset / double{draft.spacing});
  record("draft_error_percent", 100 * std::fabs(error));
  record("tilt_degrees", std::acos(std::min(1.0, upright)) * 180 / M_PI);
  record("speed", norm(state.velocity));
  EXPECT_LT(std::fabs(error), 0.03);
  EXPECT_GT(upright, std::cos(M_PI / 180));
  EXPECT_LT(norm(state.velocity), 0.01);
  EXPECT_EQ(world.diagnostics().outside, 0u);
}

}  // namespace meniscus::tests
