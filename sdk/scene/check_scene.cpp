// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Checks the names and the definitions of a scene.
#include "pbd/host_memory.h"
#include "sdk/scene/scene_items.h"
#include "sdk/scene/scene_names.h"
#include "sdk/world/check/check.h"

namespace meniscus {
namespace {

/// Stands for the id of what a name refers to. The checks of definitions ask whether an id is given, and
/// check_names asks whether the name exists.
template <class Id>
void give(std::optional<Id>& id, const std::string& name) {
  if (!name.empty()) id.emplace();
}

ProbeDef with_ids(const SceneProbe& probe) {
  ProbeDef def = probe.def;
  give(def.fluid, probe.fluid);
  return def;
}

JointDef with_ids(const SceneJoint& joint) {
  JointDef def = joint.def;
  def.a = {0, 0};
  if (!joint.b.empty()) def.b = joint.b == joint.a ? def.a : BodyId{1, 0};
  return def;
}

AttachmentDef with_ids(const SceneAttachment& attachment) {
  AttachmentDef def = attachment.def;
  give(def.cloth, attachment.cloth);
  give(def.rope, attachment.rope);
  give(def.body, attachment.body);
  give(def.other_cloth, attachment.other_cloth);
  give(def.other_rope, attachment.other_rope);
  return def;
}

void check_definitions(const Scene& scene) {
  const auto check = [](const auto& def) { check::def(def); };
  const auto check_def = [](const auto& item) { check::def(item.def); };
  const auto check_with_ids = [](const auto& item) { check::def(with_ids(item)); };
  check::def(scene.world);
  for_each_item("fluids", scene.fluids, check);
  for_each_item("granulars", scene.granulars, check);
  for_each_item("shapes", scene.shapes, check);
  for_each_item("bodies", scene.bodies, check_def);
  for_each_item("joints", scene.joints, check_with_ids);
  for_each_item("cloths", scene.cloths, check);
  for_each_item("ropes", scene.ropes, check);
  for_each_item("attachments", scene.attachments, check_with_ids);
  if (scene.wind) check::def(*scene.wind);
  for_each_item("volumes", scene.volumes, check_def);
  for_each_item("emitters", scene.emitters, check_def);
  for_each_item("sinks", scene.sinks, check_def);
  for_each_item("probes", scene.probes, check_with_ids);
  for_each_item("force_fields", scene.force_fields, check);
}

}  // namespace

void check_scene(const Scene& scene) {
  pbd::with_host_memory([&] {
    check_names(scene, "");
    check_definitions(scene);
  });
}

}  // namespace meniscus
