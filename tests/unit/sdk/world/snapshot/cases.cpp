// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Worlds in the midst of something.
#include "tests/unit/sdk/world/snapshot/cases.h"

namespace meniscus::tests {

namespace {

WorldDef with_spacing(WorldDef def, float spacing) {
  def.particle_spacing = spacing;
  return def;
}

BodyDef box_body(const char* name, Vec3 position, float half, float density = 500) {
  BodyDef def;
  def.name = name;
  def.geometry = BoxGeometry{{half, half, half}};
  def.pose.position = position;
  def.density = density;
  return def;
}

/// Two fluids with all forces, some of them placed far too dense, spray, and probes.
World fluids(const WorldDef& given) {
  WorldDef def = with_spacing(given, 0.06f);
  def.diffuse = DiffuseDef{};
  def.diffuse->capacity = 4000;
  def.diffuse->air = {0.05f, 1};
  def.diffuse->energy = {0.05f, 1};
  World world(def);
  FluidDef first, second;
  first.vorticity_confinement = 0.2f;
  first.surface_tension = 0.05f;
  second.name = "oil";
  second.rest_density = 700;
  second.dynamic_viscosity = 1;
  const FluidId a = world.create_fluid(first), b = world.create_fluid(second);
  const ShapeId walls = world.create_shape(tank({0, 0, 0}, {1, 1, 0.5f}));
  world.add_fluid(block(a, {0, 0, 0}, {0.4f, 0.6f, 0.5f}));
  world.add_fluid(block(b, {0.7f, 0, 0}, {1, 0.3f, 0.5f}));
  world.add_particles(a, lattice(5, 5, 5, 0.02f, {0.5f, 0.3f, 0.2f}));
  ProbeDef probe;
  probe.name = "floor";
  probe.kind = ProbeKind::wall_force;
  probe.shape = walls;
  world.create_probe(probe);
  probe.kind = ProbeKind::point_pressure;
  probe.point = {0.1f, 0.1f, 0.2f};
  world.create_probe(probe);
  return world;
}

/// A jet that starts and a drain, so that particles have left gaps in their numbers.
World flow(const WorldDef& given) {
  World world(with_spacing(given, 0.05f));
  const FluidId water = world.create_fluid({});
  world.create_shape(tank({0, 0, 0}, {0.6f, 1, 0.6f}));
  world.add_fluid(block(water, {0, 0, 0}, {0.6f, 0.15f, 0.6f}));
  EmitterDef jet;
  jet.name = "jet";
  jet.fluid = water;
  jet.opening = DiscOpening{0.1f};
  jet.pose.position = {0.3f, 0.7f, 0.3f};
  jet.pose.rotation = about_z(180);
  jet.speed = 2;
  world.create_emitter(jet);
  SinkDef drain;
  drain.name = "drain";
  drain.region = BoxRegion{{0, 0, 0}, {0.2f, 0.1f, 0.2f}};
  world.create_sink(drain);
  return world;
}

/// Boxes that fall asleep on one another, in water, at joints and on a turning plate, with forces that wait.
World bodies(const WorldDef& given) {
  World world(with_spacing(given, 0.06f));
  const FluidId water = world.create_fluid({});
  world.create_shape(tank({0, 0, 0}, {1.2f, 1, 0.6f}));
  world.add_fluid(block(water, {0, 0, 0}, {0.4f, 0.3f, 0.6f}));
  const ShapeId gone = world.create_shape(shape(SphereGeometry{0.1f}, {0.9f, 0.5f, 0.3f}));
  world.create_body(box_body("floats", {0.2f, 0.4f, 0.3f}, 0.1f, 300));
  for (int k = 0; k < 3; ++k)
    world.create_body(box_body("stack", {0.8f, 0.081f + 0.161f * float(k), 0.3f}, 0.08f));
  const BodyId lost = world.create_body(box_body("lost", {1, 0.9f, 0.3f}, 0.03f));
  const BodyId arm = world.create_body(box_body("arm", {0.6f, 0.8f, 0.5f}, 0.04f));
  BodyDef plate = box_body("plate", {1.05f, 0.3f, 0.15f}, 0.05f);
  plate.motion = BodyMotion::kinematic;
  plate.keyframes = {{0, {{1.05f, 0.3f, 0.15f}, {0, 0, 0, 1}}}, {1, {{1.05f, 0.5f, 0.15f}, about_z(90)}}};
  world.create_body(plate);
  JointDef hinge;
  hinge.name = "hinge";
  hinge.a = arm;
  hinge.frame.position = {0.5f, 0.8f, 0.5f};
  hinge.kind = HingeJoint{};
  world.create_joint(hinge);
  world.destroy_shape(gone);  // leaves a gap in the numbers
  world.destroy_body(lost);
  world.create_body(box_body("late", {0.6f, 0.5f, 0.2f}, 0.05f));
  world.apply_force(arm, {0, 0, 3}, {0.6f, 0.8f, 0.5f});
  return world;
}

/// Cloth that tears, a balloon, two layers that touch, a body that hangs from cloth, and wind with gusts.
World cloth(const WorldDef& given) {
  World world(with_spacing(given, 0.1f));
  world.create_shape(shape(PlaneGeometry{}, {0, 0, 0}));
  ClothDef weak = sheet(0.6f, 0.6f, 13, 13, {0, 1, 0});
  weak.fabric.tear_strain = 0.02f;
  weak.fabric.warp_stiffness = weak.fabric.weft_stiffness = 300;
  const ClothId torn = world.create_cloth(weak);
  world.create_attachment(attach(torn, {0, 12, 156, 168}));
  ClothDef balloon;
  balloon.name = "balloon";
  balloon.geometry = ClothSphere{0.15f, 3};
  balloon.pose.position = {1, 0.2f, 0};
  balloon.inflation = InflationDef{200, 101325};
  world.create_cloth(balloon);
  ClothDef upper = sheet(0.4f, 0.4f, 9, 9, {2, 0.3f, 0});
  world.create_cloth(upper);
  upper.pose.position.y = 0.32f;
  const ClothId held = world.create_cloth(upper);
  const BodyId weight = world.create_body(box_body("weight", {2.2f, 0.25f, 0.2f}, 0.03f));
  AttachmentDef hook = attach(held, {80});
  hook.body = weight;
  world.create_attachment(hook);
  world.create_body(box_body("pebble", {0, 1.1f, 0}, 0.05f, 4000));
  WindDef wind;
  wind.velocity = {2, 0, 0};
  wind.gust_speed = 1;
  world.set_wind(wind);
  return world;
}

/// A rod that bends, a rope with a load, and a seam between rope and cloth.
World ropes(const WorldDef& given) {
  World world(with_spacing(given, 0.1f));
  RopeDef rod = rope({{0, 1, 0}, {0.8f, 1, 0}}, 16);
  rod.bends_and_twists = true;
  const RopeId a = world.create_rope(rod);
  AttachmentDef clamp = attach(a, {0, 1});
  clamp.clamped = true;
  world.create_attachment(clamp);
  const RopeId b = world.create_rope(rope({{0, 1, 1}, {0, 0.4f, 1}}, 12));
  world.create_attachment(attach(b, {0}));
  const BodyId load = world.create_body(box_body("load", {0, 0.3f, 1}, 0.08f, 2000));
  AttachmentDef hook = attach(b, {12});
  hook.body = load;
  world.create_attachment(hook);
  const ClothId flag = world.create_cloth(sheet(0.3f, 0.3f, 7, 7, {0.15f, 0.8f, 1.2f}));
  AttachmentDef seam = attach(b, {2, 3, 4});
  seam.other_cloth = flag;
  seam.reach = 0.4f;
  world.create_attachment(seam);
  return world;
}

/// Grains that slide, in water.
World grains(const WorldDef& given) {
  World world(with_spacing(given, 0.06f));
  const FluidId water = world.create_fluid({}), sand = world.create_granular({});
  world.create_shape(tank({0, 0, 0}, {1, 1, 0.4f}));
  world.add_fluid(block(sand, {0, 0, 0}, {0.35f, 0.5f, 0.4f}));
  world.add_fluid(block(water, {0.7f, 0, 0}, {1, 0.4f, 0.4f}));
  return world;
}

/// Cloth that carries water, takes some of it up, lets some through, and drips.
World wet(const WorldDef& given) {
  World world(with_spacing(given, 0.05f));
  const FluidId water = world.create_fluid({});
  world.create_shape(shape(PlaneGeometry{}, {0, 0, 0}));
  ClothDef towel = sheet(0.5f, 0.5f, 11, 11, {0, 0.5f, 0});
  towel.fabric.absorbency = 0.6f;
  towel.fabric.permittivity = 0.05f;
  towel.fabric.retention = 0.2f;
  const ClothId cloth = world.create_cloth(towel);
  world.create_attachment(attach(cloth, {0, 10, 110, 120}));
  world.add_fluid(block(water, {-0.15f, 0.55f, -0.15f}, {0.15f, 0.75f, 0.15f}));
  return world;
}

World seams(const WorldDef& given) {
  WorldDef def = with_spacing(given, 0.06f);
  def.periodic.x = PeriodicExtent{0, 1.2f};
  World world(def);
  FluidDef fluid;
  fluid.dynamic_viscosity = 0.5f;
  const FluidId water = world.create_fluid(fluid);
  world.create_shape(shape(PlaneGeometry{}, {0, 0, 0}));
  FluidVolumeDef volume = block(water, {0, 0, 0}, {1.2f, 0.2f, 0.4f});
  volume.velocity = {1, 0, 0};
  world.add_fluid(volume);
  return world;
}

World grid(const WorldDef& given) {
  WorldDef def = given;
  def.density.solver = DensitySolver::grid;
  def.density.tolerance = 1e-3f;
  def.cfl_number = 0.4f;
  return dam_break(with_spacing(def, 0.06f));
}

World of_others(const WorldDef& given) {
  WorldDef def = given;
  def.density.solver = DensitySolver::dfsph;
  return dam_break(with_spacing(def, 0.07f));
}

/// About an origin of its own, with a body that is destroyed last, so that the snapshot carries that out.
World far(const WorldDef& given) {
  WorldDef def = with_spacing(given, 0.1f);
  def.origin = {10000, 0, -10000};
  World world(def);
  const FluidId water = world.create_fluid({});
  const Vec3 low = def.origin;
  world.create_shape(tank(low, low + Vec3{2, 2, 1}));
  world.add_fluid(block(water, low, low + Vec3{1, 1, 1}));
  const BodyId gone = world.create_body(box_body("gone", low + Vec3{1.5f, 1.5f, 0.5f}, 0.125f));
  world.create_body(box_body("stays", low + Vec3{1.5f, 1, 0.5f}, 0.125f));
  world.step(snapshot_step);
  world.destroy_body(gone);
  return world;
}

/// A driven surface on its way through water, and cloth that it carries.
World driven(const WorldDef& given) {
  World world(with_spacing(given, 0.06f));
  const FluidId water = world.create_fluid({});
  world.create_shape(tank({0, 0, 0}, {1.2f, 1, 0.6f}));
  ClothDef plate = sheet(0.3f, 0.3f, 5, 5);
  const ClothId flat = world.create_cloth(plate);
  DrivenTriangles motion;
  const auto corners = world.cloth_triangles(flat);
  motion.triangles.assign(corners.begin(), corners.end());
  for (const float t : {0.0f, 0.1f, 0.3f}) {
    ClothKeyframe& k = motion.keyframes.emplace_back(ClothKeyframe{t, {}});
    for (const Vec3 x : world.cloth_positions(flat))
      k.vertices.push_back(x + Vec3{0.3f + 2 * t, 0.2f + t * t, 0.3f});
  }
  motion.keyframes.push_back({0.6f, motion.keyframes.front().vertices});
  motion.loop = true;
  world.destroy_cloth(flat);
  plate.geometry = motion;
  world.create_cloth(plate);
  world.create_cloth(sheet(0.2f, 0.2f, 5, 5, {0.3f, 0.25f, 0.3f}));
  world.add_fluid(block(water, {0, 0, 0}, {1.2f, 0.15f, 0.6f}));
  return world;
}

}  // namespace

const std::vector<SnapshotCase>& snapshot_cases() {
  static const std::vector<SnapshotCase> cases{
      {"fluids", fluids, 8}, {"flow", flow, 25},          {"bodies", bodies, 190}, {"cloth", cloth, 12},
      {"ropes", ropes, 10},  {"grains", grains, 12},      {"wet", wet, 14},        {"seams", seams, 8},
      {"grid", grid, 6},     {"of_others", of_others, 4}, {"far", far, 0},         {"driven", driven, 10}};
  return cases;
}

}  // namespace meniscus::tests
