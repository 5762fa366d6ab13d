// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Each definition as users write it: members by name, and those left out that have a default. It is compiled
// with -Wall -Wextra -Werror, and never run.
#include <meniscus/meniscus.h>
#include <meniscus/version.h>

#include <vector>

static_assert(MENISCUS_VERSION_MAJOR >= 0 && sizeof(MENISCUS_VERSION_STRING) > 5);

int main() {
  using namespace meniscus;
  World world({.particle_spacing = 0.1f, .diffuse = DiffuseDef{.capacity = 10}});
  const FluidId water = world.create_fluid({.rest_density = 1000});
  world.create_granular({.friction = 0.5f});
  const ShapeId floor =
      world.create_shape({.geometry = PlaneGeometry{.offset = 0}, .surface = {.friction = 1}});
  world.create_shape({.geometry = MeshGeometry{.file = "cup.obj", .scale = 0.01f}});
  world.create_shape({.geometry = HeightFieldGeometry{.columns = 2, .rows = 2}});
  const BodyId crate =
      world.create_body({.geometry = BoxGeometry{.half_extents = {1, 1, 1}}, .density = 300});
  world.create_joint({.a = crate, .kind = SpringJoint{.stiffness = {1, 1, 1}}});
  world.add_fluid({.fluid = water, .region = MeshRegion{.file = "bunny.obj"}});
  world.add_fluid({.fluid = water, .velocity = {1, 0, 0}});
  const ClothId sheet =
      world.create_cloth({.geometry = SheetGeometry{.columns = 8}, .fabric = {.density = 0.3f}});
  world.create_cloth({.geometry = ClothFile{.file = "flag.obj"}, .inflation = InflationDef{.pressure = 10}});
  const RopeId rope = world.create_rope({.points = {{0, 1, 0}, {1, 1, 0}}, .segments = 8});
  world.create_attachment({.cloth = sheet, .vertices = {0, 1}});
  world.create_attachment({.rope = rope, .vertices = {0}, .body = crate});
  world.create_emitter({.fluid = water, .opening = MeshOpening{.file = "tap.obj"}, .speed = 2});
  world.create_sink({.region = HalfSpaceRegion{.offset = -1}});
  world.create_probe({.kind = ProbeKind::wall_force, .shape = floor});
  world.set_wind({.velocity = {1, 0, 0}});
  return world.step(0.01f).substeps;
}
