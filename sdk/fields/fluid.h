// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What particles are made of, the regions that they fill, and the surface that they have.
#pragma once

#include <array>

#include "sdk/fields/names.h"
#include "sdk/fields/shapes.h"
#include "sdk/fields/values.h"

namespace meniscus {

/// Keys of earlier versions, with what a scene says instead.
constexpr auto retired_keys(const FluidDef&) {
  return std::array{
      RetiredKey{"viscosity",
                 "was kinematic, in m²/s; write \"dynamic_viscosity\" in Pa·s, which is the old "
                 "value times rest_density"}};
}

template <class V>
void fields(V& v, FluidDef& d) {
  v("name", d.name, not_empty, "", "what volumes call this fluid");
  v("rest_density", d.rest_density, between(1e-3, 1e6), "kg/m³", "density at rest");
  v("dynamic_viscosity", d.dynamic_viscosity, between(0, 1e6), "Pa·s", "dynamic viscosity");
  v("xsph", d.xsph, not_negative, "1/s", "rate at which a particle takes its neighbours' mean velocity");
  v("vorticity_confinement", d.vorticity_confinement, between(0, 1e6), "",
    "strength ε of the force that keeps swirls");
  v("cohesion", d.cohesion, between(0, 1e6), "N/m", "attraction on top of the surface tension");
  v("surface_tension", d.surface_tension, between(0, 1e6), "N/m", "by attraction and curvature");
  flat(v, "filter", d.filter);
  v("color", d.color, between(0, 1), "", "linear red, green and blue");
}

template <class V>
void fields(V& v, GranularDef& d) {
  v("name", d.name, not_empty, "", "what volumes call this material");
  v("density", d.density, between(1e-3, 1e6), "kg/m³", "a grain's mass over a spacing cubed");
  v("friction", d.friction, not_negative, "", "tangent of the angle at which a heap stands");
  flat(v, "filter", d.filter);
  v("color", d.color, between(0, 1), "", "linear red, green and blue");
}

template <class V>
void fields(V& v, BoxRegion& d) {
  v("lower", d.lower, any_value, "m", "least corner, before the pose");
  v("upper", d.upper, any_value, "m", "greatest corner, before the pose");
  v.check(d.lower.x <= d.upper.x && d.lower.y <= d.upper.y && d.lower.z <= d.upper.z,
          "lower must not be above upper in any component", "lower", d.lower);
}

template <class V>
void fields(V& v, BallRegion& d) {
  v("radius", d.radius, positive, "m", "radius");
}

template <class V>
void fields(V& v, MeshRegion& d) {
  mesh_fields(v, d);
}

template <class V>
void choices(V& v, Region& r) {
  v.choice("box", BoxRegion{}, r, "a box");
  v.choice("ball", BallRegion{}, r, "a ball about the origin");
  v.choice("mesh", MeshRegion{}, r, "the inside of a closed triangle mesh");
}

constexpr auto names_of(Seeding) {
  return std::array{Named{"lattice", Seeding::lattice}, Named{"disordered", Seeding::disordered}};
}

/// `names` has the name of the fluid, or its id.
template <class V, class Names>
void volume_fields(V& v, FluidVolumeDef& d, Names& names) {
  v("fluid", names.fluid, required(not_empty), "", "name of the fluid or granular material");
  v("region", d.region, required(any_value), "", "what to fill");
  v("pose", d.pose, any_value, "", "placement of the region");
  v("velocity", d.velocity, any_value, "m/s", "of every particle at the start");
  v("seeding", d.seeding, any_value, "", "how particles are placed; grains have a disorder of their own");
}

template <class V>
void fields(V& v, FluidVolumeDef& d) {
  volume_fields(v, d, d);
}

/// No scene has it: it is an argument of World::surface_mesh.
template <class V>
void fields(V& v, SurfaceMeshDef& d) {
  v("fluid", d.fluid, any_value, "", "fluid or granular material; left out, all fluids as one");
  v("cell_size", d.cell_size, between(0.1, 2), "spacings", "of marching cubes");
  v("level", d.level, between(0.2, 3), "",
    "of the field that the particles make: at 1 the surface keeps the fluid's volume; less is fatter");
}

}  // namespace meniscus
