// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A layer of particles on a rough surface: when it starts to slip, and where it stops.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/coupling/body_worlds.h"

namespace meniscus::tests {
namespace {

constexpr float s = 0.05f, radius = 0.5f * s, gravity = 9.81f, degree = 3.14159265f / 180;
constexpr float step = 0.01f, substep = step / 4;  // s

/// A layer as it lies on a level floor. Particles come to rest up to a hundredth of their radius lower than
/// that: one that starts above its place falls at first, and feels no friction meanwhile.
std::vector<Vec3> resting_layer(pbd::DeviceKind device) {
  World world(world_def(device, s));
  world.create_shape(shape(PlaneGeometry{}));
  std::vector<Vec3> layer;
  for (const Vec3& p : lattice(6, 1, 6, s, {-3 * s, 0, -3 * s})) layer.push_back({p.x, radius, p.z});
  world.add_particles(world.create_fluid({}), layer);
  run(world, 30, step);
  return {world.positions().begin(), world.positions().end()};
}

class LayerFrictionTest : public OnDevice {
 protected:
  /// A layer that touches the surface, a particle deep; `about_z` is the slope's angle, x points down it.
  struct Layer {
    World world;
    std::vector<Vec3> start;
    Vec3 down;

    Layer(pbd::DeviceKind device, float friction, float angle, float speed, bool on_body)
        : world(world_def(device, s)), down{std::cos(angle), -std::sin(angle), 0} {
      const Vec3 normal{std::sin(angle), std::cos(angle), 0};
      const Quat turn = about_z(-angle / degree);
      if (on_body) {
        BodyDef slab = kinematic(BoxGeometry{{3, 0.1f, 1}}, -0.1f * normal);
        slab.pose.rotation = turn;
        slab.surface.friction = friction;
        world.create_body(slab);
      } else {
        ShapeDef slope = shape(PlaneGeometry{normal, 0});
        slope.surface.friction = friction;
        world.create_shape(slope);
      }
      for (const Vec3& p : resting_layer(device)) {
        start.push_back(p.x * down + p.y * normal + Vec3{0, 0, p.z});
      }
      const std::vector<Vec3> velocities(start.size(), speed * down);
      world.add_particles(world.create_fluid({}), start, velocities);
    }

    /// How far down the slope particles have got: the least, the mean and the most.
    struct Ways {
      float least, mean, most;
    };
    Ways ways() const {
      Ways w{1e9f, 0, -1e9f};
      for (size_t i = 0; i < start.size(); ++i) {
        const float way = dot(world.positions()[i] - start[i], down);
        w = {std::min(w.least, way), w.mean + way / static_cast<float>(start.size()), std::max(w.most, way)};
      }
      return w;
    }
  };

  void expect_slip_angle(bool on_body) {
    for (float mu : {0.1f, 0.3f, 0.5f, 0.7f}) {
      const float critical = std::atan(mu);
      Layer held(GetParam(), mu, critical - degree, 0, on_body);
      run(held.world, 100, step);
      EXPECT_LT(held.ways().most, 0.002f) << "μ " << mu;
      Layer slipping(GetParam(), mu, critical + degree, 0, on_body);
      run(slipping.world, 100, step);
      const float angle = critical + degree;
      const float expected = 0.5f * gravity * (std::sin(angle) - mu * std::cos(angle));
      EXPECT_GT(slipping.ways().least, 0.9f * expected) << "μ " << mu;
      EXPECT_NEAR(slipping.ways().mean, expected, 0.02f * expected) << "μ " << mu;
    }
  }

  void expect_stopping_distance(bool on_body) {
    constexpr float speed = 2;
    for (float mu : {0.3f, 0.5f, 0.7f}) {
      Layer layer(GetParam(), mu, 0, speed, on_body);
      run(layer.world, 100, step);
      const float expected = speed * speed / (2 * mu * gravity);
      const float margin = 0.01f * expected + 0.5f * speed * substep;
      EXPECT_NEAR(layer.ways().least, expected, margin) << "μ " << mu;
      EXPECT_NEAR(layer.ways().most, expected, margin) << "μ " << mu;
      EXPECT_LT(layer.world.diagnostics().max_speed, 1e-3f);
    }
  }
};

TEST_P(LayerFrictionTest, OnAPlaneItSlipsAtTheAngleOfFriction) {
  expect_slip_angle(false);
}

TEST_P(LayerFrictionTest, OnABodyItSlipsAtTheAngleOfFriction) {
  expect_slip_angle(true);
}

TEST_P(LayerFrictionTest, OnAPlaneItStopsWhereTheTextbookSays) {
  expect_stopping_distance(false);
}

TEST_P(LayerFrictionTest, OnABodyItStopsWhereTheTextbookSays) {
  expect_stopping_distance(true);
}

// A slab that may move takes over what the layer loses: at the end both go on as one.
TEST_P(LayerFrictionTest, AFreeSlabIsDraggedAlong) {
  World world(world_def(GetParam(), s));
  ShapeDef ice = shape(PlaneGeometry{{0, 1, 0}, -0.2f});
  ice.surface.solid_friction = 0;
  world.create_shape(ice);
  BodyDef slab = body(BoxGeometry{{1, 0.1f, 0.3f}}, {0, -0.1f, 0}, 50);
  slab.surface.friction = 0.5f;
  slab.surface.solid_friction = 0;
  slab.can_sleep = false;
  const BodyId id = world.create_body(slab);
  const std::vector<Vec3> layer = resting_layer(GetParam());
  const FluidId water = world.create_fluid({});
  world.add_particles(water, layer, std::vector<Vec3>(layer.size(), Vec3{1, 0, 0}));
  const float given = world.particle_mass(water) * static_cast<float>(layer.size());
  const float together = given / (given + world.body_mass(id).mass);
  run(world, 60, step);
  EXPECT_NEAR(world.body_state(id).velocity.x, together, 0.01f * together);
  for (Vec3 v : world.velocities()) EXPECT_NEAR(v.x, together, 0.01f * together);
}

MENISCUS_ON_EACH_DEVICE(LayerFrictionTest);

}  // namespace
}  // namespace meniscus::tests
