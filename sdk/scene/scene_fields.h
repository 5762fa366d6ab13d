// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The description of a scene file: that of all definitions (sdk/fields/fields.h), and what only a scene has,
// such as cameras and names in place of ids. A visitor reads a file by it (scene_reader.cpp) or writes the
// schema (scene_schema.cpp).
#pragma once

#include <meniscus/scene.h>
#include "pbd/math/vec.h"
#include "sdk/fields/fields.h"
#include "sdk/scene/liquids.h"
#include "sdk/scene/scene_fields_checks.h"

namespace meniscus {

/// The readable form of a rotation.
struct AxisAngle {
  Vec3 axis{0, 1, 0};
  float degrees = 0;
};

template <class V>
void fields(V& v, AxisAngle& d) {
  v("axis", d.axis, required(any_value), "",
    "direction to turn about, by the right hand; of a length from 1e-6 to 1e18");
  v("degrees", d.degrees, required(any_value), "degrees", "how far to turn");
  check_direction(v, "axis", d.axis);
}

template <class V>
void fields(V& v, SceneCopies& d) {
  constexpr double most = 100'000;
  v("count", d.count, exactly(3, between(1, most)), "", "how many along x, y and z");
  v("step", d.step, any_value, "m", "from one to the next along x, y and z");
  double all = 1;
  for (const int count : d.count) all *= count;
  v.check(all <= most, "there must be at most 100000 copies");
  const float steps[] = {d.step.x, d.step.y, d.step.z};
  for (size_t axis = 0; axis < 3; ++axis)
    v.check(d.count[axis] <= 1 || steps[axis] != 0, "step must not be 0 along an axis with several");
}

template <class V>
void fields(V& v, SceneBody& body) {
  body_fields(v, body.def);
  v("motion_file", body.motion_file, any_value, "", "of a kinematic body: a file with its keyframes");
  v("copies", body.copies, any_value, "",
    "a lattice of equal bodies, this one the first; their names end in _0, _1 and so on");
  check_keyframes(v, body.def.keyframes, body.def.loop && !body.motion_file);
  v.check(!body.motion_file || body.def.keyframes.empty(), "motion_file takes the place of keyframes");
  v.check(!body.motion_file || body.def.motion == BodyMotion::kinematic,
          "motion_file is for kinematic bodies alone");
  if (!body.def.keyframes.empty()) body.def.pose = body.def.keyframes.front().pose;
}

/// A joint as its kind alone describes it.
template <class Kind>
struct JointOf {
  SceneJoint joint;
  Kind kind;

  operator SceneJoint() const {
    SceneJoint result = joint;
    result.def.kind = kind;
    return result;
  }
};

template <class V, class Kind>
void fields(V& v, JointOf<Kind>& j) {
  joint_fields(v, j.joint.def, j.joint, j.kind);
}

template <class V>
void choices(V& v, SceneJoint& j) {
  joint_choices<JointOf>(v, j);
}

template <class V>
void fields(V& v, SceneAttachment& a) {
  attachment_fields(v, a.def, a);
}

template <class V>
void fields(V& v, SceneVolume& d) {
  volume_fields(v, d.def, d);
}

template <class V>
void fields(V& v, SceneEmitter& e) {
  emitter_fields(v, e.def, e);
}

template <class V>
void fields(V& v, SceneSink& s) {
  sink_fields(v, s.def, s);
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
  probe_fields<kind>(v, p.probe.def, p.probe);
}

template <class V>
void choices(V& v, SceneProbe& p) {
  v.choice("point_pressure", ProbeOf<ProbeKind::point_pressure>{}, p, "pressure at a point in the fluid, Pa");
  v.choice("wall_pressure", ProbeOf<ProbeKind::wall_pressure>{}, p,
           "mean normal stress on a patch of a shape, Pa");
  v.choice("wall_force", ProbeOf<ProbeKind::wall_force>{}, p, "the fluid's force on a shape, N");
  v.choice("wall_torque", ProbeOf<ProbeKind::wall_torque>{}, p,
           "the torque of the fluid's force on a shape, N·m");
  v.choice("point_velocity", ProbeOf<ProbeKind::point_velocity>{}, p,
           "velocity at a point in the fluid, m/s");
  v.choice("point_density", ProbeOf<ProbeKind::point_density>{}, p, "density at a point in the fluid, kg/m³");
  v.choice("flow", ProbeOf<ProbeKind::flow>{}, p, "flow through a disc, m³/s");
  v.choice("level", ProbeOf<ProbeKind::level>{}, p,
           "height of the free surface in a column, without spray, m");
  v.choice("fluid_momentum", ProbeOf<ProbeKind::fluid_momentum>{}, p, "momentum of a fluid, kg·m/s");
  v.choice("fluid_angular_momentum", ProbeOf<ProbeKind::fluid_angular_momentum>{}, p,
           "angular momentum of a fluid, kg·m²/s");
  v.choice("fluid_centre", ProbeOf<ProbeKind::fluid_centre>{}, p, "centre of mass of a fluid, m");
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
void fields(V& v, SceneLook& d) {
  v("fluid", d.fluid, required(not_empty), "", "name of the fluid");
  v("liquid", d.liquid, any_value, "", "whose absorption and scattering it has");
  v("absorption", d.absorption, between(0, 1e6), "1/m",
    "of red, green and blue light; left out, that of the liquid");
  v("scattering", d.scattering, between(0, 1e6), "1/m", "likewise");
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
  v("force_fields", d.force_fields, any_value, "", "forces beside gravity");
  v("checks", d.checks, any_value, "", "what must hold while the scene runs: else the run fails");
  v("looks", d.looks, any_value, "", "how pictures show fluids, in place of their color");
  v("camera", d.camera, any_value, "",
    "where pictures are taken from; left out, a view that holds everything");
  v("cameras", d.cameras, any_value, "", "more views, to be chosen by name");
}

}  // namespace meniscus
