// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Heaps of grains: the slope at which they come to rest, how far columns run out, and whether a layer on a
// slope stays. The columns are cylinders of poured grains, whose walls vanish.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/validation/measures.h"
#include "tests/worlds.h"

namespace meniscus::tests {
namespace {

constexpr float s = 0.02f, r0 = 9 * s, dt = 1.0f / 60;
constexpr double degrees = 180 / 3.14159265358979;

float radius_of(Vec3 p) {
  return std::hypot(p.x, p.z);
}

struct Column {
  World world;
  float height;  ///< m, at the start
};

/// Poured between smooth walls, then cut to a cylinder of radius r0 and height aspect · r0.
Column column(pbd::DeviceKind device, float friction, float aspect) {
  World world(world_def(device, s));
  GranularDef sand;
  sand.friction = friction;
  const FluidId id = world.create_granular(sand);
  ShapeDef floor = shape(PlaneGeometry{});
  floor.surface.friction = 0.6f;
  world.create_shape(floor);
  const ShapeId walls = world.create_shape(tank({-r0, 0, -r0}, {r0, 10 * r0 * aspect, r0}));
  std::mt19937 random(7);
  std::vector<Vec3> points;
  const float apart = 1.4f * s;
  const int layers = static_cast<int>(2.2f * aspect * r0 / s) + 3;
  for (Vec3 p : lattice(12, layers, 12, apart, {-6 * apart, 0, -6 * apart}))
    points.push_back(p + random_vector(random, 0.2f * s));
  world.add_particles(id, points);
  run(world, 120, dt);
  const float height = aspect * r0;
  std::vector<ParticleId> gone;
  for (size_t i = 0; i < world.particle_count(); ++i) {
    const Vec3 p = world.positions()[i];
    if (radius_of(p) > r0 || p.y > height) gone.push_back(world.ids()[i]);
  }
  world.remove_particles(gone);
  world.destroy_shape(walls);
  return {std::move(world), height};
}

/// The slope of a heap's flank, by least squares through the surface over rings of 1.5 spacings, without the
/// top and the foot.
double slope_of(const World& world) {
  constexpr int rings = 24;
  constexpr double width = 1.5;
  std::vector<std::vector<float>> heights(rings);
  for (Vec3 p : world.positions()) {
    const int ring = static_cast<int>(radius_of(p) / (width * s));
    if (ring < rings) heights[static_cast<size_t>(ring)].push_back(p.y / s + 0.5f);
  }
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (size_t ring = 2; ring < rings; ++ring) {
    std::vector<float>& h = heights[ring];
    if (h.size() < 4) continue;
    std::sort(h.rbegin(), h.rend());
    const double at = (double(ring) + 0.5) * width, top = h[std::min(h.size() - 1, 1 + h.size() / 12)];
    if (top < 1.8) continue;
    n += 1;
    x += at;
    y += top;
    xx += at * at;
    xy += at * top;
  }
  return -degrees * std::atan((n * xy - x * y) / (n * xx - x * x));
}

double run_out(const World& world) {
  std::vector<float> radii;
  for (Vec3 p : world.positions()) radii.push_back(radius_of(p) + 0.5f * s);
  return (percentile(radii, 0.98) - r0) / r0;
}

class GrainsValidation : public OnDevice {};

TEST_P(GrainsValidation, AngleOfReposeFollowsFriction) {
  double last = 0;
  for (float friction : {0.3f, 0.45f, 0.6f}) {
    Column c = column(GetParam(), friction, 0.8f);
    run(c.world, 180, dt);
    const double slope = slope_of(c.world);
    record("repose_degrees_at_" + std::to_string(int(100 * friction + 0.5f)), slope);
    EXPECT_NEAR(slope, degrees * std::atan(friction), 4) << friction;
    EXPECT_GT(slope, last);
    last = slope;
  }
}

/// The run-out is in proportion to the aspect ratio a, as in the experiments of Lube et al. 2004: Δr/r0
/// = 1.24 a for a < 1.7. It falls short of theirs, 0.6 a to 0.7 a: it is that of a cone at the angle of
/// repose, as grains that do not turn do not roll on over the floor.
TEST_P(GrainsValidation, ColumnsRunOut) {
  for (float aspect : {0.6f, 1.0f, 1.5f}) {
    Column c = column(GetParam(), 0.5f, aspect);
    run(c.world, 150, dt);
    const double ratio = run_out(c.world) / aspect;
    record("run_out_over_aspect_at_" + std::to_string(int(10 * aspect + 0.5f)), ratio);
    EXPECT_GT(ratio, 0.5) << aspect;
    EXPECT_LT(ratio, 1.6) << aspect;
  }
}

/// A layer of eight grains on a rough bed, tilted to two thirds of its friction: it stays where it is.
TEST_P(GrainsValidation, ALayerOnASlopeStays) {
  constexpr float friction = 0.5f, slope = 0.33f;
  WorldDef def = world_def(GetParam(), s);
  const float tilt = std::atan(slope);
  def.gravity = {9.81f * std::sin(tilt), -9.81f * std::cos(tilt), 0};
  World world(def);
  GranularDef sand;
  sand.friction = friction;
  const FluidId id = world.create_granular(sand);
  ShapeDef box = tank({-15 * s, 0, -4 * s}, {15 * s, 30 * s, 4 * s});
  box.surface.friction = friction;
  world.create_shape(box);
  std::mt19937 random(11);
  std::vector<Vec3> points;
  for (Vec3 p : lattice(27, 8, 7, 1.1f * s, {-14.85f * s, 0, -3.85f * s}))
    points.push_back(p + random_vector(random, 0.1f * s));
  world.add_particles(id, points);
  run(world, 240, dt);
  const std::vector<Vec3> before(world.positions().begin(), world.positions().end());
  run(world, 60, dt);
  double mean = 0;
  for (size_t i = 0; i < before.size(); ++i) mean += length(world.positions()[i] - before[i]);
  mean /= static_cast<double>(before.size());  // m in one second
  record("creep_mm_per_second", 1000 * mean);
  EXPECT_LT(mean, 1e-3);
}

MENISCUS_ON_EACH_DEVICE(GrainsValidation);

}  // namespace
}  // namespace meniscus::tests
