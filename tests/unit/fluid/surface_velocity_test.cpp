// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tests of the velocities of the vertices of a surface mesh.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fluid/surface/surface_mesh.h"
#include "tests/unit/fluid/surfaces.h"
#include "tests/worlds.h"

namespace meniscus::tests {
namespace {

constexpr float s = 0.05f;

class SurfaceVelocityTest : public OnDevice {
 protected:
  /// A ball of fluid about the origin.
  World ball(float radius) const {
    WorldDef def = world_def(GetParam(), s);
    def.gravity = {0, 0, 0};
    World world(def);
    FluidVolumeDef volume;
    volume.fluid = world.create_fluid({});
    volume.region = BallRegion{radius};
    world.add_fluid(volume);
    return world;
  }
};

/// The mean velocity at a place by the particles' parts of the field, without a grid.
Vec3 field_velocity(const fluid::SurfaceField& f, std::span<const Ellipsoid> ellipsoids,
                    std::span<const Vec3> velocities, Vec3 at) {
  double sum = 0, x = 0, y = 0, z = 0;
  for (size_t i = 0; i < ellipsoids.size(); ++i) {
    const Ellipsoid& e = ellipsoids[i];
    const Vec3 d = rotate(conjugate(e.rotation), at - e.centre) / f.reach;
    const Vec3 q{d.x / e.radii.x, d.y / e.radii.y, d.z / e.radii.z};
    const double volume = double{e.radii.x} * e.radii.y * e.radii.z;
    const double part = f.weight * std::pow(f.unit_volume / volume, f.power) *
                        std::pow(std::max(0.0, 1 - double{dot(q, q)}), 3);
    sum += part;
    x += part * velocities[i].x;
    y += part * velocities[i].y;
    z += part * velocities[i].z;
  }
  return {static_cast<float>(x / sum), static_cast<float>(y / sum), static_cast<float>(z / sum)};
}

TEST_P(SurfaceVelocityTest, VerticesMoveAsTheFluid) {
  World world = ball(5.3f * s);
  std::vector<Vec3> turning;
  for (const Vec3 p : world.positions()) turning.push_back(cross({2, -3, 5}, p) + Vec3{0.5f, 0, -1});
  world.set_velocities(turning);
  const std::vector<Vec3> velocities(world.velocities().begin(), world.velocities().end());
  const std::span<const Ellipsoid> ellipsoids = world.ellipsoids();
  const float turn = length(Vec3{2, -3, 5});
  const fluid::SurfaceField field = fluid::calibrate_surface(s, 2 * s);
  // The interpolation along edges is of second order in the size of cells.
  for (const auto& [cell, bound] : {std::pair{0.5f, 0.45f}, std::pair{0.25f, 0.12f}}) {
    const SurfaceMesh mesh = world.surface_mesh({.cell_size = cell});
    ASSERT_EQ(mesh.velocities.size(), mesh.vertices.size());
    float most = 0;
    for (size_t v = 0; v < mesh.vertices.size(); v += 17) {
      const Vec3 wanted = field_velocity(field, ellipsoids, velocities, mesh.vertices[v]);
      most = std::max(most, length(mesh.velocities[v] - wanted));
      // Particles are within about a spacing below the surface.
      const Vec3 rigid = cross({2, -3, 5}, mesh.vertices[v]) + Vec3{0.5f, 0, -1};
      ASSERT_LT(length(mesh.velocities[v] - rigid), turn * s) << v;
    }
    EXPECT_LT(most, bound * turn * s) << "cells of " << cell;
  }
}

TEST_P(SurfaceVelocityTest, AUniformVelocityIsThatOfEachVertex) {
  World world = ball(3.1f * s);
  for (const Vec3 velocity : {Vec3{1e-3f, -2, 3}, Vec3{7000, 0, -7000}}) {
    world.set_velocities(std::vector<Vec3>(world.particle_count(), velocity));
    for (const Vec3 v : world.surface_mesh().velocities)
      ASSERT_LT(length(v - velocity), 1e-6f + 1e-6f * length(velocity));
  }
  world.set_velocities(std::vector<Vec3>(world.particle_count(), {1e5f, 0, 0}));
  for (const Vec3 v : world.surface_mesh().velocities) ASSERT_NEAR(v.x, 8192, 0.1f) << "it is the most";
}

MENISCUS_ON_EACH_DEVICE(SurfaceVelocityTest);

}  // namespace
}  // namespace meniscus::tests
