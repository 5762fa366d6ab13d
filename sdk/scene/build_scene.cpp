// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "sdk/scene/scene.h"

namespace meniscus {
namespace {

/// The id of the thing with this name; ids stand in the order of the definitions.
template <class Def, class Id>
Id id_of(const std::string& name, const std::vector<Def>& defs, const std::vector<Id>& ids,
         const char* kind) {
  const auto found = std::find_if(defs.begin(), defs.end(), [&](const Def& def) { return def.name == name; });
  if (found != defs.end()) return ids[std::size_t(found - defs.begin())];
  throw Error(ErrorCode::not_found, "the scene has no " + std::string(kind) + " named \"" + name + "\"");
}

ProbeDef with_shape(const SceneProbe& probe, const Scene& scene, const std::vector<ShapeId>& shapes) {
  ProbeDef def = probe.def;
  if (def.kind != ProbeKind::point_pressure) def.shape = id_of(probe.shape, scene.shapes, shapes, "shape");
  return def;
}

JointDef with_bodies(const SceneJoint& joint, const std::vector<BodyDef>& defs,
                     const std::vector<BodyId>& ids) {
  JointDef def = joint.def;
  def.a = id_of(joint.a, defs, ids, "body");
  if (!joint.b.empty()) def.b = id_of(joint.b, defs, ids, "body");
  return def;
}

}  // namespace

BuiltScene build_scene(const Scene& scene) {
  BuiltScene built{World(scene.world), {}, {}, {}, {}, {}};
  for (const FluidDef& def : scene.fluids) built.fluids.push_back(built.world.create_fluid(def));
  // Solids before volumes: filling a region leaves out what would stand inside one.
  for (const ShapeDef& def : scene.shapes) built.shapes.push_back(built.world.create_shape(def));
  const std::vector<BodyDef> bodies = bodies_of(scene);
  for (const BodyDef& def : bodies) built.bodies.push_back(built.world.create_body(def));
  for (const SceneJoint& joint : scene.joints) {
    built.joints.push_back(built.world.create_joint(with_bodies(joint, bodies, built.bodies)));
  }
  for (const SceneVolume& volume : scene.volumes) {
    FluidVolumeDef def = volume.def;
    def.fluid = id_of(volume.fluid, scene.fluids, built.fluids, "fluid");
    built.world.add_fluid(def);
  }
  for (const SinkDef& def : scene.sinks) built.world.create_sink(def);
  for (const SceneProbe& probe : scene.probes) {
    built.probes.push_back(built.world.create_probe(with_shape(probe, scene, built.shapes)));
  }
  if (scene.relax_iterations > 0) built.world.relax(scene.relax_iterations);
  return built;
}

}  // namespace meniscus
