// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#include "tests/bench/small_scenes.h"

namespace meniscus::bench {
namespace {

ShapeDef tank(Vec3 lower, Vec3 upper) {
  ShapeDef def;
  def.geometry = ContainerGeometry{
      {0.5f * (upper.x - lower.x), 0.5f * (upper.y - lower.y), 0.5f * (upper.z - lower.z)}, {}};
  def.pose.position = {0.5f * (upper.x + lower.x), 0.5f * (upper.y + lower.y), 0.5f * (upper.z + lower.z)};
  def.surface.friction = 0.3f;
  return def;
}

ShapeDef floor() {
  ShapeDef def;
  def.geometry = PlaneGeometry{};
  def.surface.friction = 0.4f;
  return def;
}

void fill(World& world, FluidId fluid, Vec3 lower, Vec3 upper) {
  FluidVolumeDef def;
  def.fluid = fluid;
  def.region = BoxRegion{lower, upper};
  world.add_fluid(def);
}

ClothId add_sheet(World& world, float height, const FabricDef& fabric = {}, int rows = 21) {
  ClothDef def;
  SheetGeometry sheet;
  sheet.columns = sheet.rows = rows;
  def.geometry = sheet;
  def.fabric = fabric;
  def.pose.position = {0.5f, height, 0.5f};
  return world.create_cloth(def);
}

BodyId add_body(World& world, const Geometry& geometry, Vec3 position, float density = 500) {
  BodyDef def;
  def.geometry = geometry;
  def.pose.position = position;
  def.density = density;
  return world.create_body(def);
}

void hold_corners(World& world, ClothId cloth, int rows = 21) {
  const auto n = static_cast<uint32_t>(rows);
  AttachmentDef def;
  def.cloth = cloth;
  def.vertices = {0, n - 1, n * (n - 1), n * n - 1};
  world.create_attachment(def);
}

void no_change(WorldDef&) {}

void two_fluids(World& world) {
  FluidDef oil;
  oil.rest_density = 600;
  oil.dynamic_viscosity = 0.01f * oil.rest_density;
  oil.surface_tension = 0.05f;
  FluidDef water;
  water.vorticity_confinement = 0.2f;
  world.create_shape(tank({0, 0, 0}, {1, 1, 0.6f}));
  fill(world, world.create_fluid(oil), {0, 0, 0}, {0.4f, 0.4f, 0.6f});
  fill(world, world.create_fluid(water), {0, 0.4f, 0}, {0.4f, 0.8f, 0.6f});
}

void grains(World& world) {
  world.create_shape(floor());
  fill(world, world.create_granular({}), {0, 0, 0}, {0.3f, 0.6f, 0.3f});
}

void bodies(World& world) {
  world.create_shape(tank({0, 0, 0}, {1, 1.5f, 1}));
  fill(world, world.create_fluid({}), {0, 0, 0}, {1, 0.4f, 1});
  const BodyId box = add_body(world, BoxGeometry{{0.1f, 0.1f, 0.1f}}, {0.4f, 0.6f, 0.5f});
  const BodyId ball = add_body(world, SphereGeometry{0.1f}, {0.62f, 0.6f, 0.5f}, 2000);
  JointDef joint;
  joint.a = box;
  joint.b = ball;
  joint.frame.position = {0.5f, 0.6f, 0.5f};
  world.create_joint(joint);
  add_body(world, CapsuleGeometry{0.06f, 0.1f}, {0.3f, 1, 0.4f}, 900);
}

/// A raft with a load, a heap on the floor, and a wedge. All touch from the start.
void touching_bodies(World& world) {
  world.create_shape(tank({0, 0, 0}, {1, 1.5f, 1}));
  fill(world, world.create_fluid({}), {0, 0, 0}, {1, 0.4f, 1});
  const Vec3 small{0.08f, 0.08f, 0.08f};
  add_body(world, BoxGeometry{{0.25f, 0.05f, 0.25f}}, {0.4f, 0.45f, 0.5f}, 50);
  add_body(world, BoxGeometry{small}, {0.4f, 0.579f, 0.5f}, 1000);
  add_body(world, SphereGeometry{0.08f}, {0.4f, 0.738f, 0.5f}, 1000);
  add_body(world, BoxGeometry{small}, {0.85f, 0.079f, 0.2f}, 3000);
  add_body(world, CapsuleGeometry{0.06f, 0.05f}, {0.85f, 0.268f, 0.2f}, 3000);
  const HullGeometry wedge{
      {{-0.1f, 0, -0.1f}, {0.1f, 0, -0.1f}, {0.1f, 0, 0.1f}, {-0.1f, 0, 0.1f}, {0, 0.2f, 0}}};
  add_body(world, wedge, {0.85f, -0.001f, 0.8f}, 3000);
}

void cloth_over_ball(World& world) {
  world.create_shape(floor());
  ShapeDef ball;
  ball.geometry = SphereGeometry{0.25f};
  ball.pose.position = {0.5f, 0.3f, 0.45f};
  ball.surface.friction = 0.5f;
  world.create_shape(ball);
  FabricDef fabric;
  fabric.stretch_model = StretchModel::triangles;
  add_sheet(world, 0.65f, fabric);
  fabric.stretch_model = StretchModel::edges;
  add_sheet(world, 0.7f, fabric);
}

void balloon(World& world) {
  world.create_shape(floor());
  ClothDef def;
  def.geometry = ClothSphere{0.3f, 6};
  def.pose.position = {0, 0.5f, 0};
  def.inflation = InflationDef{500, 101325};
  world.create_cloth(def);
  add_body(world, BoxGeometry{{0.1f, 0.05f, 0.1f}}, {0.05f, 0.95f, 0});
}

void ropes_and_rods(World& world) {
  world.create_shape(floor());
  for (const bool rod : {false, true}) {
    RopeDef def;
    def.points = {{0, 1, rod ? 0.3f : 0}, {1, 1, rod ? 0.3f : 0}};
    def.segments = 30;
    def.radius = 0.01f;
    def.bends_and_twists = rod;
    AttachmentDef held;
    held.rope = world.create_rope(def);
    held.vertices = {0, 1};
    held.clamped = rod;
    world.create_attachment(held);
    if (rod) continue;
    AttachmentDef load;
    load.rope = held.rope;
    load.vertices = {30};
    load.body = add_body(world, SphereGeometry{0.05f}, {1, 1, 0});
    world.create_attachment(load);
  }
}

void tearing(World& world) {
  FabricDef fabric;
  fabric.tear_strain = 0.02f;
  hold_corners(world, add_sheet(world, 0.5f, fabric));
  add_body(world, SphereGeometry{0.1f}, {0.5f, 0.7f, 0.5f}, 7000);
}

void wetting(World& world) {
  FabricDef fabric;
  fabric.absorbency = 1;
  fabric.permittivity = 0.2f;
  fabric.fluid_friction = 0.2f;
  hold_corners(world, add_sheet(world, 0.3f, fabric));
  fill(world, world.create_fluid({}), {0.3f, 0.35f, 0.3f}, {0.7f, 0.6f, 0.7f});
}

void water_in_cloth(World& world) {
  hold_corners(world, add_sheet(world, 0.3f));
  fill(world, world.create_fluid({}), {0.3f, 0.35f, 0.3f}, {0.7f, 0.6f, 0.7f});
  add_body(world, BoxGeometry{{0.1f, 0.1f, 0.1f}}, {0.5f, 0.8f, 0.5f});
}

void flow(World& world) {
  ShapeDef vessel = tank({0, 0, 0}, {1, 0.6f, 1});
  std::get<ContainerGeometry>(vessel.geometry).openings = {{Face::y_high, {}}};
  world.create_shape(vessel);
  const FluidId water = world.create_fluid({});
  fill(world, water, {0, 0, 0}, {0.5f, 0.3f, 1});
  EmitterDef emitter;
  emitter.fluid = water;
  emitter.pose.position = {0.7f, 0.9f, 0.5f};
  emitter.pose.rotation = {1, 0, 0, 0};
  world.create_emitter(emitter);
  SinkDef sink;
  sink.region = BoxRegion{{0, 0, 0}, {0.2f, 0.1f, 1}};
  world.create_sink(sink);
}

void stirred(World& world) {
  world.create_shape(tank({0, 0, 0}, {1, 1, 0.6f}));
  fill(world, world.create_fluid({}), {0, 0, 0}, {1, 0.4f, 0.6f});
  BodyDef paddle;
  paddle.motion = BodyMotion::kinematic;
  paddle.geometry = BoxGeometry{{0.03f, 0.3f, 0.2f}};
  paddle.keyframes = {{0, {{0.3f, 0.4f, 0.3f}, {0, 0, 0, 1}}},
                      {0.4f, {{0.7f, 0.4f, 0.3f}, {0, 0, 0.6f, 0.8f}}}};
  world.create_body(paddle);
}

/// Two sheets that fall over a bar and on to each other.
void folded_cloth(World& world) {
  world.create_shape(floor());
  add_body(world, CapsuleGeometry{0.06f, 0.5f}, {0.5f, 0.2f, 0.5f}, 2000);
  add_sheet(world, 0.4f);
  add_sheet(world, 0.45f);
}

void belt(World& world) {
  ShapeDef moving = floor();
  moving.surface.belt_velocity = {0.5f, 0, 0};
  moving.surface.slip_length = 0;
  world.create_shape(moving);
  FluidDef syrup;
  syrup.dynamic_viscosity = 5;
  fill(world, world.create_fluid(syrup), {0, 0, 0}, {0.5f, 0.3f, 0.5f});
}

void disorder(World& world) {
  world.create_shape(tank({0, 0, 0}, {0.6f, 0.8f, 0.6f}));
  FluidVolumeDef def;
  def.fluid = world.create_fluid({});
  def.region = BoxRegion{{0, 0, 0}, {0.6f, 0.4f, 0.6f}};
  def.seeding = Seeding::disordered;
  world.add_fluid(def);
}

}  // namespace

std::vector<SmallScene> small_scenes() {
  return {
      {"small/two_fluids", 30, no_change, two_fluids},
      {"small/artificial_pressure", 30,
       [](WorldDef& def) {
         def.density.artificial_pressure.strength = 0.05f;
         def.cfl_number = 0.4f;
       },
       two_fluids},
      {"small/jacobi_tolerance", 30,
       [](WorldDef& def) {
         def.density.solver = DensitySolver::jacobi;
         def.density.tolerance = 0.01f;
       },
       two_fluids},
      {"small/grid_solver", 30, [](WorldDef& def) { def.density.solver = DensitySolver::grid; }, bodies},
      {"small/grains", 30, no_change, grains},
      {"small/bodies", 30, no_change, bodies},
      {"small/touching_bodies", 30, [](WorldDef& def) { def.rigid.solver = RigidSolver::device; },
       touching_bodies},
      {"small/cloth_over_ball", 40, no_change, cloth_over_ball},
      {"small/balloon", 40, no_change, balloon},
      {"small/ropes_and_rods", 40, no_change, ropes_and_rods},
      {"small/tearing", 40, no_change, tearing},
      {"small/wetting", 40, no_change, wetting},
      {"small/water_in_cloth", 40, no_change, water_in_cloth},
      {"small/flow", 40, [](WorldDef& def) { def.diffuse = DiffuseDef{}; }, flow},
      {"small/stirred", 30, no_change, stirred},
      {"small/folded_cloth", 40, no_change, folded_cloth},
      {"small/belt", 30,
       [](WorldDef& def) {
         def.periodic.x = PeriodicExtent{0, 0.5f};
         def.periodic.z = PeriodicExtent{0, 0.5f};
       },
       belt},
      {"small/wendland", 30, [](WorldDef& def) { def.kernel = SmoothingKernel::wendland_c2; }, disorder},
      {"small/cubic_spline", 30, [](WorldDef& def) { def.kernel = SmoothingKernel::cubic_spline; }, disorder},
      {"small/pcisph", 30, [](WorldDef& def) { def.density.solver = DensitySolver::pcisph; }, bodies},
      {"small/wcsph", 10, [](WorldDef& def) { def.density.solver = DensitySolver::wcsph; }, bodies},
      {"small/dfsph", 30, [](WorldDef& def) { def.density.solver = DensitySolver::dfsph; }, bodies},
  };
}

}  // namespace meniscus::bench
