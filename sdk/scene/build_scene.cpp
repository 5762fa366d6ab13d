// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Builds a World from a Scene.
#include "sdk/scene/build_scene.h"

#include <algorithm>

#include "pbd/host_memory.h"
#include "sdk/scene/scene_items.h"

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

/// Granular materials come behind the fluids.
FluidId material_of(const std::string& name, const Scene& scene, const std::vector<FluidId>& ids) {
  const auto granular = std::find_if(scene.granulars.begin(), scene.granulars.end(),
                                     [&](const GranularDef& def) { return def.name == name; });
  if (granular == scene.granulars.end()) return id_of(name, scene.fluids, ids, "fluid");
  return ids[scene.fluids.size() + std::size_t(granular - scene.granulars.begin())];
}

ProbeDef with_ids(const SceneProbe& probe, const Scene& scene, const BuiltScene& built) {
  ProbeDef def = probe.def;
  if (!probe.shape.empty()) def.shape = id_of(probe.shape, scene.shapes, built.shapes, "shape");
  if (!probe.fluid.empty()) def.fluid = material_of(probe.fluid, scene, built.fluids);
  return def;
}

JointDef with_bodies(const SceneJoint& joint, const std::vector<BodyDef>& defs,
                     const std::vector<BodyId>& ids) {
  JointDef def = joint.def;
  def.a = id_of(joint.a, defs, ids, "body");
  if (!joint.b.empty()) def.b = id_of(joint.b, defs, ids, "body");
  return def;
}

AttachmentDef with_ids(const SceneAttachment& attachment, const Scene& scene,
                       const std::vector<BodyDef>& bodies, const BuiltScene& built) {
  AttachmentDef def = attachment.def;
  const auto cloth = [&](const std::string& name) {
    return id_of(name, scene.cloths, built.cloths, "cloth");
  };
  const auto rope = [&](const std::string& name) { return id_of(name, scene.ropes, built.ropes, "rope"); };
  if (!attachment.cloth.empty()) def.cloth = cloth(attachment.cloth);
  if (!attachment.rope.empty()) def.rope = rope(attachment.rope);
  if (!attachment.body.empty()) def.body = id_of(attachment.body, bodies, built.bodies, "body");
  if (!attachment.other_cloth.empty()) def.other_cloth = cloth(attachment.other_cloth);
  if (!attachment.other_rope.empty()) def.other_rope = rope(attachment.other_rope);
  return def;
}

void add_solids(const Scene& scene, const std::vector<BodyDef>& bodies, BuiltScene& built) {
  for_each_item("shapes", scene.shapes,
                [&](const ShapeDef& def) { built.shapes.push_back(built.world.create_shape(def)); });
  for_each_item("bodies", scene.bodies, [&](const SceneBody& body) {
    for (const BodyDef& def : copies_of(body)) built.bodies.push_back(built.world.create_body(def));
  });
  for_each_item("joints", scene.joints, [&](const SceneJoint& joint) {
    built.joints.push_back(built.world.create_joint(with_bodies(joint, bodies, built.bodies)));
  });
}

void add_cloth(const Scene& scene, const std::vector<BodyDef>& bodies, BuiltScene& built) {
  for_each_item("cloths", scene.cloths,
                [&](const ClothDef& def) { built.cloths.push_back(built.world.create_cloth(def)); });
  for_each_item("ropes", scene.ropes,
                [&](const RopeDef& def) { built.ropes.push_back(built.world.create_rope(def)); });
  for_each_item("attachments", scene.attachments, [&](const SceneAttachment& attachment) {
    built.attachments.push_back(built.world.create_attachment(with_ids(attachment, scene, bodies, built)));
  });
  if (scene.wind) built.world.set_wind(*scene.wind);
}

void fill_volumes(const Scene& scene, BuiltScene& built) {
  for_each_item("volumes", scene.volumes, [&](const SceneVolume& volume) {
    FluidVolumeDef def = volume.def;
    def.fluid = material_of(volume.fluid, scene, built.fluids);
    built.volumes.push_back(built.world.add_fluid(def));
  });
}

void add_flow(const Scene& scene, const std::vector<BodyDef>& bodies, BuiltScene& built) {
  for_each_item("emitters", scene.emitters, [&](const SceneEmitter& emitter) {
    EmitterDef def = emitter.def;
    def.fluid = material_of(emitter.fluid, scene, built.fluids);
    if (!emitter.body.empty()) def.body = id_of(emitter.body, bodies, built.bodies, "body");
    built.emitters.push_back(built.world.create_emitter(def));
  });
  for_each_item("sinks", scene.sinks, [&](const SceneSink& sink) {
    SinkDef def = sink.def;
    if (!sink.body.empty()) def.body = id_of(sink.body, bodies, built.bodies, "body");
    built.sinks.push_back(built.world.create_sink(def));
  });
}

void expect_closed(const SceneCheck& check, const Scene& scene, const BuiltScene& built) {
  if (check.kind != CheckKind::cloth_volume) return;
  const ClothId cloth = id_of(check.cloth, scene.cloths, built.cloths, "cloth");
  if (!built.world.cloth_state(cloth).closed)
    throw Error(ErrorCode::invalid_argument,
                "cloth_volume is of closed pieces, and \"" + check.cloth + "\" has a border");
}

BuiltScene build(const Scene& scene, const std::function<void(World&)>& prepare) {
  check_scene(scene);
  BuiltScene built{World(scene.world), {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}};
  prepare(built.world);
  for_each_item("fluids", scene.fluids,
                [&](const FluidDef& def) { built.fluids.push_back(built.world.create_fluid(def)); });
  for_each_item("granulars", scene.granulars,
                [&](const GranularDef& def) { built.fluids.push_back(built.world.create_granular(def)); });
  const std::vector<BodyDef> bodies = bodies_of(scene);
  // Solids before volumes: filling a region leaves out what would stand inside one.
  add_solids(scene, bodies, built);
  add_cloth(scene, bodies, built);
  fill_volumes(scene, built);
  add_flow(scene, bodies, built);
  for_each_item("probes", scene.probes, [&](const SceneProbe& probe) {
    built.probes.push_back(built.world.create_probe(with_ids(probe, scene, built)));
  });
  for_each_item("force_fields", scene.force_fields, [&](const ForceFieldDef& def) {
    built.force_fields.push_back(built.world.create_force_field(def));
  });
  for_each_item("checks", scene.checks, [&](const SceneCheck& check) { expect_closed(check, scene, built); });
  if (scene.relax_iterations > 0) built.world.relax(scene.relax_iterations);
  return built;
}

}  // namespace

BuiltScene build_scene(const Scene& scene) {
  return pbd::with_host_memory([&] { return build(scene, [](World&) {}); });
}

BuiltScene build_scene(const Scene& scene, const std::function<void(World&)>& prepare) {
  return pbd::with_host_memory([&] { return build(scene, prepare); });
}

}  // namespace meniscus
