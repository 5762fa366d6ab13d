// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Viscous fluid that cloth holds by its slip length.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/cloth_worlds.h"
#include "tests/coupling/body_worlds.h"

namespace meniscus::tests {
namespace {

constexpr float s = 0.05f, frame = 1 / 60.0f, pi = 3.14159265f;
constexpr float free_slip = std::numeric_limits<float>::infinity();

class ClothSlip : public OnDevice {
 protected:
  static WorldDef weightless(pbd::DeviceKind device) {
    WorldDef def = world_def(device, s);
    def.gravity = {0, 0, 0};
    def.iterations = 5;
    return def;
  }
  static FluidId syrup(World& world, float viscosity) {
    FluidDef def;
    def.dynamic_viscosity = viscosity;
    def.xsph = 0;
    return world.create_fluid(def);
  }
};

/// Fluid between an axle at rest and a tube of cloth around it, whose vertices are all held by a body that
/// turns. A light free tube may hang in between.
class CouetteOfTubes {
 public:
  CouetteOfTubes(const WorldDef& def, float slip_length, bool parted) : world_(def), slip_(slip_length) {
    world_.set_wind({.air_density = 0});
    world_.create_shape(shape(PlaneGeometry{}));
    world_.create_shape(shape(PlaneGeometry{{0, -1, 0}, -height}));
    ShapeDef axle = shape(CylinderGeometry{inner, 2 * height}, {0, 0.5f * height, 0});
    axle.surface.slip_length = slip_;
    world_.create_shape(axle);
    hub_ = world_.create_body(kinematic(SphereGeometry{s}, hub));
    AttachmentDef held = attach(tube(outer), {});
    held.vertices = vertices_from(0, static_cast<uint32_t>(world_.cloth_positions(*held.cloth).size()));
    held.body = hub_;
    world_.create_attachment(held);
    if (parted) middle = tube(0.5f * (inner + outer));
    FluidDef fluid;
    fluid.dynamic_viscosity = 100;
    fluid.xsph = 0;
    fill(world_.create_fluid(fluid));
  }

  /// The relative L2 error of the profile of speed about the axis.
  double error(int frames) {
    double sum[layers] = {}, count[layers] = {};
    for (int k = 0; k < frames; ++k) {
      const auto half = static_cast<float>(0.5 * turn * double{frame} * ++steps_);
      world_.move_body(hub_, {hub, {0, std::sin(half), 0, std::cos(half)}}, frame);
      world_.step(frame);
      for (size_t i = 0; i < world_.particle_count(); ++i) {
        const Vec3 x = world_.positions()[i];
        const int n = std::clamp(static_cast<int>((radius(x) - inner) / s), 0, layers - 1);
        sum[n] += speed(x, world_.velocities()[i]);
        ++count[n];
      }
    }
    double off = 0, norm = 0;
    for (int n = 0; n < layers; ++n) {
      const double is = exact(inner + (static_cast<float>(n) + 0.5f) * s), u = sum[n] / count[n];
      off += (u - is) * (u - is);
      norm += is * is;
    }
    return std::sqrt(off / norm);
  }
  /// The speed of the free tube over that of the fluid there.
  double speed_of_middle() const {
    const auto x = world_.cloth_positions(*middle), v = world_.cloth_velocities(*middle);
    double sum = 0;
    for (size_t k = 0; k < x.size(); ++k) sum += speed(x[k], v[k]) / double(x.size());
    return sum / exact(0.5f * (inner + outer));
  }

  std::optional<ClothId> middle;

 private:
  static constexpr int layers = 8;
  static constexpr float inner = 8 * s, outer = inner + layers * s, height = 3 * s;
  static constexpr double turn = 0.5;  // rad/s
  static constexpr Vec3 hub{0, 2, 0};

  static float radius(Vec3 x) { return std::hypot(x.x, x.z); }
  static double speed(Vec3 x, Vec3 v) { return double{x.z * v.x - x.x * v.z} / double{radius(x)}; }

  /// u = A r + B/r, with a rate of shear of −2 B/r². At a wall, u differs from its speed by b times that.
  double exact(float r) const {
    const double b = slip_, r1 = inner, r2 = outer;
    const double c1 = 1 / r1 + 2 * b / (r1 * r1), c2 = 1 / r2 - 2 * b / (r2 * r2);
    const double by = turn * r2 / (r1 * c2 - r2 * c1);
    return -by * c1 * double{r} + by * r1 / double{r};
  }

  ClothId tube(float r) {
    ClothDef def;
    def.name = "tube";
    const int columns = static_cast<int>(std::lround(2 * pi * r / s));
    def.geometry = ClothTube{r, r, height, columns, 4, false};
    def.pose.position = {0, 0.5f * height, 0};
    def.fabric.slip_length = slip_;
    def.self_collision = false;
    return world_.create_cloth(def);
  }

  /// With rings of particles, which move as the exact flow does.
  void fill(FluidId fluid) {
    std::vector<Vec3> positions, velocities;
    for (int n = 0; n < layers; ++n) {
      const float r = inner + (static_cast<float>(n) + 0.5f) * s;
      const int around = static_cast<int>(std::lround(2 * pi * r / s));
      for (int k = 0; k < 3 * around; ++k) {
        const float angle = 2 * pi * (static_cast<float>(k % around) + 0.5f * float(n % 2)) / float(around);
        const auto u = static_cast<float>(exact(r));
        positions.push_back(
            {r * std::cos(angle), (static_cast<float>(k / around) + 0.5f) * s, r * std::sin(angle)});
        velocities.push_back({u * std::sin(angle), 0, -u * std::cos(angle)});
      }
    }
    world_.add_particles(fluid, positions, velocities);
  }

  World world_;
  float slip_;
  BodyId hub_{};
  int steps_ = 0;
};

TEST_P(ClothSlip, AHeldTubeThatTurnsDragsFluidAsCouettesWallDoes) {
  CouetteOfTubes flow(weightless(GetParam()), 0, false);
  const double error = flow.error(12);
  RecordProperty("error", std::to_string(error));
  EXPECT_LT(error, 0.03);
}

TEST_P(ClothSlip, FluidSlipsByTheLengthThatWasAskedFor) {
  CouetteOfTubes flow(weightless(GetParam()), 0.1f, false);
  const double error = flow.error(12);
  RecordProperty("error", std::to_string(error));
  EXPECT_LT(error, 0.03);
}

/// Both sides of the free tube act on it. It weighs a two hundredth of a layer of particles.
TEST_P(ClothSlip, LightClothTransmitsTheStressFromSideToSide) {
  CouetteOfTubes flow(weightless(GetParam()), 0, true);
  const double error = flow.error(12);
  RecordProperty("error", std::to_string(error));
  RecordProperty("speed", std::to_string(flow.speed_of_middle()));
  EXPECT_LT(error, 0.05);
  EXPECT_NEAR(flow.speed_of_middle(), 1, 0.05);
}

/// A free, inclined sheet between two streams of different speeds along it.
class Streams {
 public:
  Streams(const WorldDef& def, float slip_length, float density) : world(def) {
    world.set_wind({.air_density = 0});
    ClothDef flat = sheet(0.5f, 0.5f, 11, 11);
    flat.pose.rotation = about_z(10);
    flat.self_collision = false;
    flat.fabric.density = density;
    flat.fabric.slip_length = slip_length;
    cloth = world.create_cloth(flat);
    FluidDef def_of_fluid;
    def_of_fluid.dynamic_viscosity = 200;
    def_of_fluid.xsph = 0;
    fluid = world.create_fluid(def_of_fluid);
    for (const float side : {-1.0f, 1.0f}) {
      const Vec3 a{-0.25f, 0.02f, -0.25f}, b{0.25f, 0.17f, 0.25f};
      FluidVolumeDef stream;
      stream.fluid = fluid;
      stream.region = side > 0 ? BoxRegion{a, b} : BoxRegion{{a.x, -b.y, a.z}, {b.x, -a.y, b.z}};
      stream.pose.rotation = about_z(10);
      stream.velocity = (0.4f + 0.2f * side) * along;
      world.add_fluid(stream);
    }
  }

  Momentum momentum() const { return fluid_momentum(world, fluid) + cloth_momentum(world, cloth); }
  float speed_of_cloth() const {
    const ClothState state = world.cloth_state(cloth);
    return dot(state.momentum, along) / state.mass;
  }

  static constexpr Vec3 along{0.98480775f, 0.17364818f, 0};
  World world;
  ClothId cloth{};
  FluidId fluid{};
};

TEST_P(ClothSlip, ASheetGetsTheMomentumThatStreamsLose) {
  for (const float density : {0.2f, 40.0f}) {
    Streams streams(weightless(GetParam()), 0, density);
    const Momentum before = streams.momentum();
    double drift = 0;
    for (int k = 0; k < 15; ++k) {
      streams.world.step(frame);
      drift = std::max(drift, norm(streams.momentum().linear - before.linear) / before.gross);
    }
    RecordProperty("drift at " + std::to_string(density) + " kg/m2", std::to_string(1e6 * drift) + "e-6");
    EXPECT_LT(drift, 1e-6) << density << " kg/m²";
    if (density < 1)
      EXPECT_NEAR(streams.speed_of_cloth(), 0.4f, 0.02f);
    else
      EXPECT_GT(streams.speed_of_cloth(), 0.1f);
  }
}

TEST_P(ClothSlip, LeftOutFluidSlipsFreely) {
  Streams streams(weightless(GetParam()), free_slip, 0.2f);
  run(streams.world, 5, frame);
  EXPECT_NEAR(streams.speed_of_cloth(), 0, 1e-3f);
}

TEST_P(ClothSlip, WhatHoldsASheetWithstandsItsDrag) {
  Streams streams(weightless(GetParam()), 0, 0.2f);
  World& world = streams.world;
  AttachmentDef held = attach(streams.cloth, vertices_from(0, 121));
  const AttachmentId id = world.create_attachment(held);
  for (int k = 0; k < 10; ++k) {
    const Momentum before = streams.momentum();
    world.step(frame);
    const Sum3 lost = before.linear - streams.momentum().linear;
    const Sum3 withstood = double{frame} * Sum3(world.attachment_force(id));
    EXPECT_LT(norm(lost - withstood), 1e-5 * before.gross) << "frame " << k;
    EXPECT_GT(norm(lost), 1e-3 * before.gross) << "frame " << k;
  }
}

TEST_P(ClothSlip, ThreadsLeaveNoTrace) {
  if (GetParam() == pbd::DeviceKind::cuda) GTEST_SKIP() << "threads of the CPU";
  uint64_t hash[2] = {};
  for (const int threads : {1, 2}) {
    WorldDef def = weightless(GetParam());
    def.threads = threads;
    Streams streams(def, 0, 0.2f);
    run(streams.world, 4, frame);
    hash[threads - 1] = streams.world.state_hash();
  }
  EXPECT_EQ(hash[0], hash[1]);
}

MENISCUS_ON_EACH_DEVICE(ClothSlip);

}  // namespace
}  // namespace meniscus::tests
