// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Worlds of each kind that a batch may have copies of.
#include "tests/unit/sdk/world/batch/batch_archetypes.h"

#include <cmath>

namespace meniscus::tests {

namespace {

void open_above(ShapeDef& walls) {
  std::get<ContainerGeometry>(walls.geometry).openings = {{Face::y_high}};
}

/// A disc of triangles, whose rows of edges have unequal lengths.
ClothDef disc(float radius, Vec3 position) {
  ClothTriangles mesh;
  constexpr int rings = 4;
  mesh.vertices.push_back({0, 0, 0});
  for (int ring = 1; ring <= rings; ++ring) {
    for (int k = 0; k < 6 * ring; ++k) {
      const float angle = 6.2831853f * static_cast<float>(k) / static_cast<float>(6 * ring);
      const float r = radius * static_cast<float>(ring) / rings;
      mesh.vertices.push_back({r * std::cos(angle), 0, r * std::sin(angle)});
    }
  }
  const auto at = [](int ring, int k) {
    return ring == 0 ? 0u : static_cast<uint32_t>(1 + 3 * ring * (ring - 1) + (k % (6 * ring)));
  };
  for (int ring = 1; ring <= rings; ++ring) {
    for (int sector = 0; sector < 6; ++sector) {
      for (int k = 0; k < ring; ++k) {
        const int out = sector * ring + k, in = sector * (ring - 1) + k;
        mesh.triangles.insert(mesh.triangles.end(), {at(ring, out), at(ring, out + 1), at(ring - 1, in)});
        if (k + 1 < ring)
          mesh.triangles.insert(mesh.triangles.end(),
                                {at(ring, out + 1), at(ring - 1, in + 1), at(ring - 1, in)});
      }
    }
  }
  ClothDef made;
  made.geometry = mesh;
  made.pose.position = position;
  return made;
}

}  // namespace

ClothDef without_self_collision(ClothDef cloth) {
  cloth.self_collision = false;
  return cloth;
}

World fluids(const WorldDef& def) {
  World world(def);
  FluidDef first, second;
  first.vorticity_confinement = 0.2f;
  first.surface_tension = 0.07f;
  second.rest_density = 500;
  const FluidId a = world.create_fluid(first), b = world.create_fluid(second);
  ShapeDef walls = tank({0, 0, 0}, {1, 1, 0.5f});
  open_above(walls);
  walls.surface.friction = 0.3f;
  world.create_shape(walls);
  world.create_shape(shape(SphereGeometry{0.15f}, {0.8f, 0.1f, 0.25f}));
  world.add_fluid(block(a, {0, 0, 0}, {0.5f, 0.5f, 0.5f}));
  world.add_fluid(block(b, {0, 0.5f, 0}, {0.5f, 0.7f, 0.5f}));
  return world;
}

Pool pool(const WorldDef& def) {
  Pool made{World(def), {}, {}, {}, {}};
  World& world = made.world;
  const FluidId water = world.create_fluid({});
  ShapeDef walls = tank({0, 0, 0}, {1, 1, 0.5f});
  open_above(walls);
  world.create_shape(walls);
  made.box = world.create_body(validation::body(BoxGeometry{{0.1f, 0.1f, 0.1f}}, {0.7f, 0.1f, 0.25f}, 1500));
  made.ball = world.create_body(validation::body(SphereGeometry{0.1f}, {0.25f, 0.75f, 0.25f}, 400));
  BodyDef arm = validation::body(BoxGeometry{{0.15f, 0.05f, 0.05f}}, {0.65f, 0.6f, 0.25f}, 600);
  made.arm = world.create_body(arm);
  JointDef hinge;
  hinge.a = made.arm;
  hinge.frame.position = {0.8f, 0.6f, 0.25f};
  hinge.kind = HingeJoint{};
  world.create_joint(hinge);
  BodyDef paddle = validation::body(BoxGeometry{{0.03f, 0.2f, 0.2f}}, {0.95f, 0.5f, 0.25f}, 1000);
  paddle.motion = BodyMotion::kinematic;
  made.paddle = world.create_body(paddle);
  world.add_fluid(block(water, {0, 0, 0}, {0.5f, 0.6f, 0.5f}));
  return made;
}

World washing(WorldDef def) {
  def.particle_spacing = 0.06f;
  World world(def);
  const FluidId water = world.create_fluid({});
  ShapeDef walls = tank({0, 0, 0}, {1, 1, 0.5f});
  open_above(walls);
  walls.surface.friction = 0.5f;
  world.create_shape(walls);
  world.create_shape(shape(SphereGeometry{0.12f}, {0.8f, 0.12f, 0.25f}));
  const ClothId net =
      world.create_cloth(without_self_collision(sheet(0.4f, 0.4f, 9, 7, {0.3f, 0.35f, 0.25f})));
  world.create_attachment(attach(net, {0, 8, 54, 62}));
  ClothDef flap = without_self_collision(sheet(0.2f, 0.4f, 5, 7, {0.6f, 0.35f, 0.25f}));
  flap.fabric.stretch_model = StretchModel::triangles;
  flap.fabric.bending_model = BendingModel::dihedral;
  const ClothId other = world.create_cloth(flap);
  AttachmentDef seam = attach(other, {0, 5, 10, 15, 20, 25, 30});
  seam.other_cloth = net;
  world.create_attachment(seam);
  world.create_cloth(without_self_collision(disc(0.16f, {0.8f, 0.3f, 0.25f})));
  ClothDef balloon;
  balloon.geometry = ClothSphere{0.08f, 3};
  balloon.pose.position = {0.15f, 0.8f, 0.25f};
  balloon.inflation = InflationDef{300, 101325};
  world.create_cloth(without_self_collision(balloon));
  world.add_fluid(block(water, {0.15f, 0.4f, 0.1f}, {0.45f, 0.6f, 0.4f}));
  world.set_wind({.velocity = {1, 0, 0.5f}, .gust_speed = 1});
  return world;
}

World folding(const WorldDef& def) {
  World world(def);
  world.create_shape(tank({0, 0, 0}, {2, 2, 1}));
  ClothDef curtain = sheet(0.5f, 0.3f, 11, 7, {0.4f, 0.3f, 0.5f});
  curtain.pose.rotation = about_z(85);
  world.create_cloth(curtain);
  ClothDef left = sheet(0.3f, 0.3f, 7, 7, {1, 0.6f, 0.5f}),
           right = sheet(0.4f, 0.2f, 9, 5, {1.3f, 0.65f, 0.5f});
  left.pose.rotation = right.pose.rotation = about_z(80);
  left.velocity = {1, 0, 0};
  right.velocity = {-12, 1, 0};
  world.create_cloth(left);
  world.create_cloth(right);
  return world;
}

Rigging rigging(WorldDef def) {
  def.particle_spacing = 0.06f;
  Rigging made{World(def), {}, {}, {}, {}};
  World& world = made.world;
  const FluidId water = world.create_fluid({});
  ShapeDef walls = tank({0, 0, 0}, {1.4f, 1, 0.5f});
  open_above(walls);
  walls.surface.friction = 0.5f;
  world.create_shape(walls);

  const ClothId net = world.create_cloth(sheet(0.4f, 0.4f, 9, 7, {0.25f, 0.35f, 0.25f}));
  world.create_attachment(attach(net, {0, 8, 54, 62}));
  made.ball = world.create_body(validation::body(SphereGeometry{0.06f}, {0.2f, 0.46f, 0.25f}, 700));
  world.add_fluid(block(water, {0.3f, 0.42f, 0.12f}, {0.42f, 0.6f, 0.36f}));

  ClothDef sail = without_self_collision(sheet(0.3f, 0.3f, 6, 6, {0.65f, 0.75f, 0.25f}));
  const ClothId parachute = world.create_cloth(sail);
  made.crate =
      world.create_body(validation::body(BoxGeometry{{0.05f, 0.04f, 0.05f}}, {0.65f, 0.7f, 0.25f}, 600));
  AttachmentDef lines = attach(parachute, {14, 15, 20, 21});
  lines.body = made.crate;
  world.create_attachment(lines);
  const BodyId weight =
      world.create_body(validation::body(SphereGeometry{0.05f}, {0.65f, 0.55f, 0.25f}, 500));
  JointDef hinge;
  hinge.a = made.crate;
  hinge.b = weight;
  hinge.frame.position = {0.65f, 0.63f, 0.25f};
  hinge.kind = HingeJoint{};
  world.create_joint(hinge);

  BodyDef rod = validation::body(BoxGeometry{{0.02f, 0.02f, 0.2f}}, {0.95f, 0.8f, 0.25f}, 1000);
  rod.motion = BodyMotion::kinematic;
  made.rod = world.create_body(rod);
  ClothDef curtain = without_self_collision(sheet(0.3f, 0.3f, 6, 5, {0.95f, 0.63f, 0.25f}));
  curtain.pose.rotation = about_z(-90);
  AttachmentDef rings = attach(world.create_cloth(curtain), {0, 6, 12, 18, 24});
  rings.body = made.rod;
  world.create_attachment(rings);

  world.create_cloth(without_self_collision(sheet(0.25f, 0.3f, 6, 6, {1.2f, 0.02f, 0.25f})));
  made.box =
      world.create_body(validation::body(BoxGeometry{{0.07f, 0.06f, 0.07f}}, {1.2f, 0.12f, 0.25f}, 900));
  return made;
}

World sandpit(const WorldDef& def) {
  World world(def);
  GranularDef sand;
  sand.friction = 0.5f;
  const FluidId grains = world.create_granular(sand);
  const FluidId water = world.create_fluid({});
  ShapeDef walls = tank({0, 0, 0}, {1, 1, 0.6f});
  open_above(walls);
  walls.surface.friction = 0.4f;
  world.create_shape(walls);
  world.create_shape(shape(SphereGeometry{0.15f}, {0.7f, 0.1f, 0.3f}));
  world.create_body(validation::body(BoxGeometry{{0.12f, 0.1f, 0.12f}}, {0.3f, 0.1f, 0.3f}, 1200));
  world.add_fluid(block(grains, {0, 0.3f, 0}, {0.6f, 0.8f, 0.6f}));
  world.add_fluid(block(water, {0.7f, 0.3f, 0}, {1, 0.6f, 0.6f}));
  return world;
}

}  // namespace meniscus::tests
