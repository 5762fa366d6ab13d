// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Invalid values in the definition structs are refused, and the message names the field.
#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "tests/expect_error.h"
#include "tests/worlds.h"

namespace meniscus::tests {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float inf = std::numeric_limits<float>::infinity();
constexpr ErrorCode invalid = ErrorCode::invalid_argument;

struct BadWorld {
  const char* name;
  std::function<void(WorldDef&)> spoil;
};

TEST(WorldDefError, EachFieldIsChecked) {
  const BadWorld bad[] = {
      {"device", [](WorldDef& d) { d.device = static_cast<DeviceChoice>(3); }},
      {"threads", [](WorldDef& d) { d.threads = -1; }},
      {"gravity", [](WorldDef& d) { d.gravity.y = nan; }},
      {"gravity", [](WorldDef& d) { d.gravity.x = inf; }},
      {"particle_spacing", [](WorldDef& d) { d.particle_spacing = 0; }},
      {"particle_spacing", [](WorldDef& d) { d.particle_spacing = -0.05f; }},
      {"particle_spacing", [](WorldDef& d) { d.particle_spacing = nan; }},
      {"support_ratio", [](WorldDef& d) { d.support_ratio = 1.4f; }},
      {"support_ratio", [](WorldDef& d) { d.support_ratio = 3.1f; }},
      {"substeps", [](WorldDef& d) { d.substeps = 0; }},
      {"iterations", [](WorldDef& d) { d.iterations = 0; }},
      {"cfl_number", [](WorldDef& d) { d.cfl_number = -1; }},
      {"min_substeps", [](WorldDef& d) { d.min_substeps = 0; }},
      {"max_substeps", [](WorldDef& d) { d.min_substeps = 9, d.max_substeps = 8; }},
      {"contact_radius", [](WorldDef& d) { d.contact_radius = 0; }},
      {"DensitySolverDef::solver", [](WorldDef& d) { d.density.solver = static_cast<DensitySolver>(7); }},
      {"DensitySolverDef::solver", [](WorldDef& d) { d.density.solver = static_cast<DensitySolver>(-1); }},
      {"relaxation", [](WorldDef& d) { d.density.relaxation = 0.5f; }},
      {"warm_start", [](WorldDef& d) { d.density.warm_start = 0.6f; }},
      {"spectral_bound", [](WorldDef& d) { d.density.spectral_bound = 1; }},
      {"tolerance", [](WorldDef& d) { d.density.tolerance = -1e-9f; }},
      {"compressibility", [](WorldDef& d) { d.density.compressibility = -1e-9f; }},
      {"correction_limit", [](WorldDef& d) { d.density.correction_limit = 0; }},
      {"strength", [](WorldDef& d) { d.density.artificial_pressure.strength = nan; }},
      {"strength", [](WorldDef& d) { d.density.artificial_pressure.strength = 1e20f; }},
      {"exponent", [](WorldDef& d) { d.density.artificial_pressure.exponent = 0; }},
      {"distance", [](WorldDef& d) { d.density.artificial_pressure.distance = 1; }},
  };
  for (const BadWorld& b : bad) {
    WorldDef def;
    def.device = DeviceChoice::cpu;
    b.spoil(def);
    expect_error(invalid, b.name, [&] { World world(def); });
  }
}

TEST(WorldDefError, ASpacingWithoutAFiniteKernelIsRefused) {
  for (float spacing : {1e-12f, 1e12f}) {
    WorldDef def;
    def.device = DeviceChoice::cpu;
    def.particle_spacing = spacing;
    expect_error(invalid, "particle_spacing", [&] { World world(def); });
  }
}

class DefErrorTest : public OnDevice {
 protected:
  World world_{world_def(GetParam(), 0.05f)};

  template <class Geometry>
  void expect_bad_shape(const char* name, const Geometry& geometry) {
    expect_error(invalid, name, [&] { world_.create_shape(shape(geometry)); });
  }
};

TEST_P(DefErrorTest, Fluids) {
  const std::pair<const char*, std::function<void(FluidDef&)>> bad[] = {
      {"FluidDef::rest_density is 0; it must be at least 0.001 and at most 1000000 kg/m³",
       [](FluidDef& d) { d.rest_density = 0; }},
      {"rest_density", [](FluidDef& d) { d.rest_density = 1e-20f; }},
      {"rest_density", [](FluidDef& d) { d.rest_density = 1e20f; }},
      {"dynamic_viscosity", [](FluidDef& d) { d.dynamic_viscosity = -1; }},
      {"xsph", [](FluidDef& d) { d.xsph = nan; }},
      {"vorticity_confinement", [](FluidDef& d) { d.vorticity_confinement = -1; }},
      {"vorticity_confinement", [](FluidDef& d) { d.vorticity_confinement = 1e20f; }},
      {"cohesion", [](FluidDef& d) { d.cohesion = inf; }},
      {"cohesion", [](FluidDef& d) { d.cohesion = 1e20f; }},
      {"surface_tension", [](FluidDef& d) { d.surface_tension = -1; }},
      {"surface_tension", [](FluidDef& d) { d.surface_tension = 1e20f; }},
      {"color", [](FluidDef& d) { d.color.y = nan; }},
      {"color", [](FluidDef& d) { d.color.x = 1.1f; }},
      {"color", [](FluidDef& d) { d.color.z = -0.1f; }},
  };
  for (const auto& [name, spoil] : bad) {
    FluidDef def;
    spoil(def);
    expect_error(invalid, name, [&] { world_.create_fluid(def); });
  }
  GranularDef grains;
  grains.color.y = 2;
  expect_error(invalid, "GranularDef::color is (0.53, 2, 0.17)", [&] { world_.create_granular(grains); });
  for (float density : {0.0f, 1e-20f, 1e20f}) {
    GranularDef light;
    light.density = density;
    expect_error(invalid, "GranularDef::density", [&] { world_.create_granular(light); });
  }
  EXPECT_EQ(world_.create_fluid({}).index, 0u);  // the refused ones left nothing behind
}

TEST_P(DefErrorTest, FluidsAtTheirBoundsStayFinite) {
  const std::function<void(FluidDef&)> extremes[] = {
      [](FluidDef& d) { d.rest_density = 0.001f; },        [](FluidDef& d) { d.rest_density = 1e6f; },
      [](FluidDef& d) { d.vorticity_confinement = 1e6f; }, [](FluidDef& d) { d.cohesion = 1e6f; },
      [](FluidDef& d) { d.surface_tension = 1e6f; },
  };
  for (const auto& make_extreme : extremes) {
    World world(world_def(GetParam(), 0.05f));
    world.create_shape(shape(PlaneGeometry{{0, 1, 0}, 0}));
    FluidDef def;
    make_extreme(def);
    world.add_fluid(block(world.create_fluid(def), {0, 0, 0}, {0.4f, 0.4f, 0.4f}));
    for (int k = 0; k < 5; ++k) EXPECT_NO_THROW(world.step(1 / 60.0f));
  }
}

TEST_P(DefErrorTest, Shapes) {
  expect_bad_shape("normal", PlaneGeometry{{0, 0, 0}, 0});
  expect_bad_shape("normal", PlaneGeometry{{0, nan, 0}, 0});
  expect_bad_shape("normal", PlaneGeometry{{0, 1e19f, 0}, 0});
  expect_bad_shape("offset", PlaneGeometry{{0, 1, 0}, inf});
  expect_bad_shape("half_extents", BoxGeometry{{1, 0, 1}});
  expect_bad_shape("half_extents", ContainerGeometry{{1, -1, 1}, {}});
  expect_bad_shape("region", ContainerGeometry{{1, 1, 1}, {{Face::x_low, Aabb{{0, 1, 0}, {0, 0, 0}}}}});
  std::vector<Opening> nothing_left;
  for (int face = 0; face < 6; ++face) nothing_left.push_back({static_cast<Face>(face), {}});
  expect_bad_shape("openings", ContainerGeometry{{1, 1, 1}, nothing_left});
  expect_bad_shape("face", ContainerGeometry{{1, 1, 1}, {{static_cast<Face>(6), {}}}});
  expect_bad_shape("radius", SphereGeometry{0});
  expect_bad_shape("radius", CapsuleGeometry{-1, 1});
  expect_bad_shape("half_height", CapsuleGeometry{1, -1});
  expect_bad_shape("radius", CylinderGeometry{nan, 1});
  expect_bad_shape("half_height", CylinderGeometry{1, 0});
  expect_bad_shape("scale", MeshGeometry{"x.obj", 0, 0});
  expect_bad_shape("cell_size", MeshGeometry{"x.obj", 1, -1});
  expect_bad_shape("columns", HeightFieldGeometry{1, 2, 1, {0, 0}});
  expect_bad_shape("rows", HeightFieldGeometry{2, 0, 1, {0, 0}});
  expect_bad_shape("cell_size", HeightFieldGeometry{2, 2, 0, {0, 0, 0, 0}});
  expect_bad_shape("heights", HeightFieldGeometry{2, 2, 1, {0, 0, 0}});
  expect_bad_shape("heights", HeightFieldGeometry{2, 2, 1, {0, 0, 0, nan}});
}

TEST_P(DefErrorTest, WhatAllShapesShare) {
  ShapeDef def = shape(SphereGeometry{1});
  def.surface.friction = -0.1f;
  expect_error(invalid, "friction", [&] { world_.create_shape(def); });
  def.surface.friction = 0;
  def.surface.restitution = 1.1f;
  expect_error(invalid, "restitution", [&] { world_.create_shape(def); });
  def.surface.restitution = 0;
  def.pose.rotation = {0, 0, 0, 2};
  expect_error(invalid, "pose", [&] { world_.create_shape(def); });
  def.pose = {};
  def.pose.position.z = inf;
  expect_error(invalid, "pose", [&] { world_.create_shape(def); });
}

TEST_P(DefErrorTest, AMeshFileThatIsNotThere) {
  expect_error(ErrorCode::io, "/no/such/file.obj", [&] {
    world_.create_shape(shape(MeshGeometry{"/no/such/file.obj", 1, 0}));
  });
  FluidVolumeDef fill;
  fill.fluid = world_.create_fluid({});
  fill.region = MeshRegion{"/no/such/file.obj", 1};
  expect_error(ErrorCode::io, "/no/such/file.obj", [&] { world_.add_fluid(fill); });
}

TEST_P(DefErrorTest, SinksAndProbes) {
  SinkDef sink;
  sink.region = BoxRegion{{0, 0, 1}, {1, 1, 0}};
  expect_error(invalid, "BoxRegion::lower", [&] { world_.create_sink(sink); });
  sink.region = BallRegion{0};
  expect_error(invalid, "BallRegion::radius", [&] { world_.create_sink(sink); });
  sink.region = HalfSpaceRegion{{0, 0, 0}, 1};
  expect_error(invalid, "HalfSpaceRegion::normal", [&] { world_.create_sink(sink); });
  sink = {};
  sink.pose.position.y = nan;
  expect_error(invalid, "SinkDef::pose", [&] { world_.create_sink(sink); });
  sink = {};
  sink.body = BodyId{};
  expect_error(ErrorCode::not_found, "body", [&] { world_.create_sink(sink); });
  ProbeDef probe;
  probe.point.x = nan;
  expect_error(invalid, "point", [&] { world_.create_probe(probe); });
  probe = {};
  probe.kind = static_cast<ProbeKind>(99);
  expect_error(invalid, "ProbeDef::kind", [&] { world_.create_probe(probe); });
  probe.kind = ProbeKind::wall_force;
  expect_error(ErrorCode::not_found, "shape", [&] { world_.create_probe(probe); });
  probe.kind = ProbeKind::wall_pressure;
  probe.shape = world_.create_shape(shape(PlaneGeometry{}));
  probe.patch = Aabb{{0, 0, 0}, {1, 1, 1}};
  expect_error(invalid, "area", [&] { world_.create_probe(probe); });
  probe.area = 1;
  probe.patch.reset();
  expect_error(invalid, "patch", [&] { world_.create_probe(probe); });
}

MENISCUS_ON_EACH_DEVICE(DefErrorTest);

}  // namespace
}  // namespace meniscus::tests
