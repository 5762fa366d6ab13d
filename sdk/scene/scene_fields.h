// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The one description of a scene file. fields() lists what an object may hold: key, member, what is allowed,
// unit, meaning. choices() lists what an object may be, told apart by its "type". A visitor V reads a file by
// them (scene_reader.cpp) or writes the schema (scene_schema.cpp); its check() holds what one field alone
// cannot say.
#pragma once

#include "pbd/math/vec.h"
#include "sdk/scene/scene.h"
#include "sdk/scene/scene_field_rule.h"
#include "sdk/scene/scene_fields_bodies.h"
#include "sdk/scene/scene_fields_checks.h"
#include "sdk/scene/scene_fields_cloth.h"
#include "sdk/scene/scene_fields_flow.h"
#include "sdk/scene/scene_fields_shapes.h"

namespace meniscus {

constexpr auto names_of(DeviceChoice) {
  return std::array{Named{"auto", DeviceChoice::automatic}, Named{"cpu", DeviceChoice::cpu},
                    Named{"cuda", DeviceChoice::cuda}};
}
constexpr auto names_of(DensitySolver) {
  return std::array{Named{"jacobi", DensitySolver::jacobi}, Named{"chebyshev", DensitySolver::chebyshev},
                    Named{"grid", DensitySolver::grid}};
}

template <class V>
void fields(V& v, ArtificialPressureDef& d) {
  v("strength", d.strength, between(0, 1e6), "",
    "k of Macklin & Müller 2013, eq. 13; about 0.1 for their look");
  v("exponent", d.exponent, between(1, 16), "", "n");
  v("distance", d.distance, between(0, 0.9), "", "Δq, as a fraction of the support radius");
}

template <class V>
void fields(V& v, DensitySolverDef& d) {
  v("solver", d.solver, any_value, "", "how the density multipliers are found");
  v("relaxation", d.relaxation, between(0.01, 0.44), "", "damping ω of the Jacobi solver");
  v("warm_start", d.warm_start, between(0, 0.5), "", "share of the last substep's multipliers to start from");
  v("spectral_bound", d.spectral_bound, between(3, 20), "",
    "largest eigenvalue that Chebyshev's weights expect");
  v("tolerance", d.tolerance, not_negative, "",
    "mean of max(ρ/ρ₀ − 1, 0) at which a substep's density solve ends; 0: after all iterations");
  v("compressibility", d.compressibility, not_negative, "1/Pa", "inverse bulk modulus; 0 is incompressible");
  v("correction_limit", d.correction_limit, positive, "spacings", "largest correction of one iteration");
  v("artificial_pressure", d.artificial_pressure, any_value, "", "repulsion against clumping at the surface");
}

template <class V>
void fields(V& v, RigidSolverDef& d) {
  v("substeps", d.substeps, between(1, 1000), "", "steps of the bodies in a substep");
  v("iterations", d.iterations, between(1, 10000), "", "solver iterations of each");
}

template <class V>
void fields(V& v, Range& d) {
  v("low", d.low, not_negative, "", "where it begins");
  v("high", d.high, not_negative, "", "where it is in full");
  v.check(d.low < d.high, "low must be below high");
}

template <class V>
void fields(V& v, DiffuseDef& d) {
  v("capacity", d.capacity, between(1, 1 << 26), "", "most at once");
  v("air_rate", d.air_rate, not_negative, "1/s", "that a particle of fluid makes where air is trapped");
  v("crest_rate", d.crest_rate, not_negative, "1/s", "that a particle of fluid makes where waves break");
  v("air", d.air, any_value, "m/s", "mean speed at which neighbours meet");
  v("crest", d.crest, any_value, "", "mean bend of the surface");
  v("energy", d.energy, any_value, "J/kg", "half of the speed squared");
  v("lifetime", d.lifetime, any_value, "s", "of each, at random");
  v("spread", d.spread, not_negative, "", "of speed, sideways, when they are made");
  v("drag", d.drag, not_negative, "1/s", "rate at which a bubble takes the fluid's velocity");
  v("buoyancy", d.buoyancy, not_negative, "gravities", "of a bubble");
  v("spray_below", d.spray_below, between(0, 1), "", "spray is among less fluid than this share");
  v("bubbles_above", d.bubbles_above, between(0, 1), "", "bubbles are among more; foam is in between");
  v.check(d.spray_below <= d.bubbles_above, "spray_below must not be above bubbles_above");
}

template <class V>
void fields(V& v, WorldDef& d) {
  v("device", d.device, any_value, "", "where to run; auto takes a usable GPU, else the CPU");
  v("threads", d.threads, between(0, 1024), "", "of the CPU device; 0 is one a core");
  v("gravity", d.gravity, any_value, "m/s²", "acceleration of everything");
  v("particle_spacing", d.particle_spacing, between(1e-4, 1e3), "m", "rest distance between fluid particles");
  v("support_ratio", d.support_ratio, between(1.5, 3), "", "support radius over spacing");
  v("substeps", d.substeps, between(1, 1000), "", "substeps of a frame, where cfl_number is 0");
  v("iterations", d.iterations, between(1, 1000), "", "solver iterations of a substep");
  v("cfl_number", d.cfl_number, not_negative, "support radii",
    "when above 0, substeps are chosen so that nothing moves further than this in one");
  v("min_substeps", d.min_substeps, between(1, 1000), "", "fewest substeps that cfl_number may choose");
  v("max_substeps", d.max_substeps, between(1, 1000), "", "most substeps that cfl_number may choose");
  v("contact_radius", d.contact_radius, between(0.01, 1), "spacings",
    "distance from a surface at which a particle's centre stops");
  v("density", d.density, any_value, "", "the density constraint");
  v("rigid", d.rigid, any_value, "", "how contacts and joints among solids are solved");
  v("cloth", d.cloth, any_value, "", "how cloth is solved");
  v("diffuse", d.diffuse, any_value, "", "spray, foam and bubbles; left out, there are none");
  v.check(d.min_substeps <= d.max_substeps, "min_substeps must not be above max_substeps");
}

template <class V>
void fields(V& v, FluidDef& d) {
  v("name", d.name, not_empty, "", "what volumes call this fluid");
  v("rest_density", d.rest_density, between(1e-3, 1e6), "kg/m³", "density at rest");
  v("viscosity", d.viscosity, not_negative, "m²/s", "kinematic viscosity");
  v("xsph", d.xsph, not_negative, "1/s", "rate at which a particle takes its neighbours' mean velocity");
  v("vorticity_confinement", d.vorticity_confinement, between(0, 1e6), "",
    "strength ε of the force that keeps swirls");
  v("cohesion", d.cohesion, between(0, 1e6), "N/m", "attraction on top of the surface tension");
  v("surface_tension", d.surface_tension, between(0, 1e6), "N/m", "by attraction and curvature");
  filter_fields(v, d.filter);
  v("color", d.color, between(0, 1), "", "linear red, green and blue");
}

template <class V>
void fields(V& v, GranularDef& d) {
  v("name", d.name, not_empty, "", "what volumes call this material");
  v("density", d.density, between(1e-3, 1e6), "kg/m³", "a grain's mass over a spacing cubed");
  v("friction", d.friction, not_negative, "", "tangent of the angle at which a heap stands");
  filter_fields(v, d.filter);
  v("color", d.color, between(0, 1), "", "linear red, green and blue");
}

template <class V>
void fields(V& v, SceneVolume& d) {
  v("fluid", d.fluid, required(not_empty), "", "name of the fluid or granular material");
  v("region", d.def.region, required(any_value), "", "what to fill");
  v("pose", d.def.pose, any_value, "", "placement of the region");
  v("velocity", d.def.velocity, any_value, "m/s", "of every particle at the start");
}

/// A probe as its kind alone describes it.
template <ProbeKind kind>
struct ProbeOf {
  SceneProbe probe;

  operator SceneProbe() const {
    SceneProbe result = probe;
    result.def.kind = kind;
    return result;
  }
};

template <class V, ProbeKind kind>
void fields(V& v, ProbeOf<kind>& p) {
  ProbeDef& d = p.probe.def;
  v("name", d.name, required(not_empty), "", "what outputs call this probe");
  if constexpr (kind == ProbeKind::point_pressure) {
    v("point", d.point, required(any_value), "m", "where to measure");
  } else {
    v("shape", p.probe.shape, required(not_empty), "", "name of the shape");
  }
  if constexpr (kind == ProbeKind::wall_pressure) {
    v("patch", d.patch, required(any_value), "", "contacts inside this box count");
    v("area", d.area, required(positive), "m²", "area of the surface inside the patch");
  }
  if constexpr (kind == ProbeKind::wall_force) {
    v("patch", d.patch, any_value, "", "contacts inside this box count; left out, all of the shape's do");
  }
}

template <class V>
void choices(V& v, SceneProbe& p) {
  v.choice("point_pressure", ProbeOf<ProbeKind::point_pressure>{}, p, "pressure at a point in the fluid, Pa");
  v.choice("wall_pressure", ProbeOf<ProbeKind::wall_pressure>{}, p,
           "mean normal stress on a patch of a shape, Pa");
  v.choice("wall_force", ProbeOf<ProbeKind::wall_force>{}, p, "magnitude of the fluid's force on a shape, N");
}

template <class V>
void fields(V& v, SceneCamera& d) {
  v("position", d.position, any_value, "m", "where the eye is");
  v("target", d.target, any_value, "m", "what it looks at");
  v("field_of_view", d.field_of_view, inside(0, 180), "degrees", "vertical opening angle");
  v.check(length(d.target - d.position) > 0, "position and target must differ");
}

template <class V>
void fields(V& v, SceneNamedCamera& d) {
  v("name", d.name, required(not_empty), "", "what --camera calls it");
  fields(v, d.view);
}

template <class V>
void fields(V& v, Scene& d) {
  std::string schema;
  v("$schema", schema, any_value, "", "address of this schema, for editors; not read");
  v("name", d.name, required(not_empty), "", "short name of the scene");
  v("description", d.description, any_value, "", "what there is to see");
  v("frame_time", d.frame_time, at_least(1e-12), "s", "length of a frame");
  v("frames", d.frames, at_least(1), "", "how many frames to run, unless told otherwise");
  v("relax_iterations", d.relax_iterations, between(0, 100000), "",
    "rounds of settling the particles before the first frame");
  v("world", d.world, any_value, "", "gravity, resolution and solver");
  v("fluids", d.fluids, any_value, "", "kinds of liquid");
  v("granulars", d.granulars, any_value, "", "kinds of sand, gravel and the like");
  v("shapes", d.shapes, any_value, "", "solids that do not move");
  v("bodies", d.bodies, any_value, "", "solids that move");
  v("joints", d.joints, any_value, "", "what holds bodies together, or to the world");
  v("cloths", d.cloths, any_value, "", "pieces of cloth");
  v("ropes", d.ropes, any_value, "", "ropes and rods");
  v("attachments", d.attachments, any_value, "",
    "what holds cloth and ropes to the world, to bodies or to one another");
  v("wind", d.wind, any_value, "", "air that cloth moves in; left out, it is at rest");
  v("volumes", d.volumes, any_value, "", "regions filled with fluid at the start");
  v("emitters", d.emitters, any_value, "", "openings that make particles");
  v("sinks", d.sinks, any_value, "", "regions that remove particles");
  v("probes", d.probes, any_value, "", "measurements");
  v("checks", d.checks, any_value, "", "what must hold while the scene runs: else the run fails");
  v("camera", d.camera, any_value, "",
    "where pictures are taken from; left out, a view that holds everything");
  v("cameras", d.cameras, any_value, "", "more views, to be chosen by name");
}

}  // namespace meniscus
