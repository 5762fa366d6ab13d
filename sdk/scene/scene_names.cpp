// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Checks that the names in a scene are unique and exist.
#include "sdk/scene/scene_names.h"

#include <algorithm>
#include <map>

#include "sdk/scene/closest_name.h"
#include "sdk/scene/scene_place.h"

namespace meniscus {
namespace {

/// Names of which none may be there twice, with the places that bear them.
class UniqueNames {
 public:
  /// `place`: of what bears the name.
  void add(const std::string& name, const ScenePlace& place) {
    const auto [earlier, is_new] = owners_.emplace(name, place.path);
    if (!is_new) place.key("name").fail("\"" + name + "\" is the name of " + earlier->second + " already");
    names_.push_back(name);
  }

  const std::vector<std::string>& in_order() const { return names_; }

 private:
  std::vector<std::string> names_;
  std::map<std::string, std::string> owners_;
};

template <class List, class NameOf>
std::vector<std::string> unique_names(const List& list, const ScenePlace& place, NameOf name_of) {
  UniqueNames names;
  for (std::size_t i = 0; i < list.size(); ++i) names.add(name_of(list[i]), place.item(i));
  return names.in_order();
}

/// What particles are made of has one name: sand must not be called as a fluid is.
std::vector<std::string> check_materials(const Scene& scene, const ScenePlace& root) {
  UniqueNames names;
  for (std::size_t i = 0; i < scene.fluids.size(); ++i)
    names.add(scene.fluids[i].name, root.key("fluids").item(i));
  for (std::size_t i = 0; i < scene.granulars.size(); ++i)
    names.add(scene.granulars[i].name, root.key("granulars").item(i));
  return names.in_order();
}

/// A solid has one name: a body must not be called as a shape is.
void check_solids(const Scene& scene, const ScenePlace& root) {
  UniqueNames names;
  for (std::size_t i = 0; i < scene.shapes.size(); ++i)
    names.add(scene.shapes[i].name, root.key("shapes").item(i));
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    for (const BodyDef& body : copies_of(scene.bodies[i])) names.add(body.name, root.key("bodies").item(i));
  }
}

void check_reference(const std::string& name, const std::vector<std::string>& names, const ScenePlace& place,
                     const char* kind) {
  if (std::find(names.begin(), names.end(), name) != names.end()) return;
  place.fail("there is no " + std::string(kind) + " named \"" + name + "\"", name_hint(name, names));
}

std::vector<std::string> body_names(const Scene& scene) {
  std::vector<std::string> names;
  for (const BodyDef& body : bodies_of(scene)) names.push_back(body.name);
  return names;
}

void check_joints(const Scene& scene, const ScenePlace& place) {
  const std::vector<std::string> bodies = body_names(scene);
  for (std::size_t i = 0; i < scene.joints.size(); ++i) {
    check_reference(scene.joints[i].a, bodies, place.item(i).key("a"), "body");
    if (!scene.joints[i].b.empty())
      check_reference(scene.joints[i].b, bodies, place.item(i).key("b"), "body");
  }
}

void check_attachments(const Scene& scene, const std::vector<std::string>& cloths,
                       const std::vector<std::string>& ropes, const ScenePlace& place) {
  const std::vector<std::string> bodies = body_names(scene);
  for (std::size_t i = 0; i < scene.attachments.size(); ++i) {
    const auto check = [&](const char* key, const std::string& name, const std::vector<std::string>& names,
                           const char* kind) {
      if (!name.empty()) check_reference(name, names, place.item(i).key(key), kind);
    };
    const SceneAttachment& attachment = scene.attachments[i];
    check("cloth", attachment.cloth, cloths, "cloth");
    check("rope", attachment.rope, ropes, "rope");
    check("body", attachment.body, bodies, "body");
    check("other_cloth", attachment.other_cloth, cloths, "cloth");
    check("other_rope", attachment.other_rope, ropes, "rope");
  }
}

void check_flow(const Scene& scene, const std::vector<std::string>& fluids, const ScenePlace& root) {
  const std::vector<std::string> bodies = body_names(scene);
  for (std::size_t i = 0; i < scene.emitters.size(); ++i) {
    const ScenePlace place = root.key("emitters").item(i);
    const SceneEmitter& emitter = scene.emitters[i];
    check_reference(emitter.fluid, fluids, place.key("fluid"), "fluid");
    if (!emitter.body.empty()) check_reference(emitter.body, bodies, place.key("body"), "body");
  }
  for (std::size_t i = 0; i < scene.sinks.size(); ++i) {
    const std::string& body = scene.sinks[i].body;
    if (!body.empty()) check_reference(body, bodies, root.key("sinks").item(i).key("body"), "body");
  }
}

void check_looks(const Scene& scene, const ScenePlace& place) {
  std::vector<std::string> fluids;
  for (const FluidDef& fluid : scene.fluids) fluids.push_back(fluid.name);
  for (std::size_t i = 0; i < scene.looks.size(); ++i) {
    const ScenePlace own = place.item(i).key("fluid");
    const std::string& name = scene.looks[i].fluid;
    check_reference(name, fluids, own, "fluid");
    for (std::size_t k = 0; k < i; ++k) {
      if (scene.looks[k].fluid == name)
        own.fail("\"" + name + "\" has the look looks[" + std::to_string(k) + "] already");
    }
  }
}

/// What checks look at.
void check_checks(const Scene& scene, const std::vector<std::string>& cloths,
                  const std::vector<std::string>& probes, const ScenePlace& place) {
  const std::vector<std::string> bodies = body_names(scene);
  for (std::size_t i = 0; i < scene.checks.size(); ++i) {
    const auto check = [&](const char* key, const std::string& name, const std::vector<std::string>& names) {
      if (!name.empty()) check_reference(name, names, place.item(i).key(key), key);
    };
    check("body", scene.checks[i].body, bodies);
    check("cloth", scene.checks[i].cloth, cloths);
    check("probe", scene.checks[i].probe, probes);
  }
}

}  // namespace

void check_names(const Scene& scene, const std::string& source) {
  const ScenePlace root{source, ""};
  const auto own_name = [](const auto& def) -> const std::string& { return def.name; };
  const auto name_of_def = [](const auto& thing) -> const std::string& { return thing.def.name; };
  const auto fluids = check_materials(scene, root);
  const auto shapes = unique_names(scene.shapes, root.key("shapes"), own_name);
  check_solids(scene, root);
  unique_names(scene.joints, root.key("joints"), name_of_def);
  const auto cloths = unique_names(scene.cloths, root.key("cloths"), own_name);
  const auto ropes = unique_names(scene.ropes, root.key("ropes"), own_name);
  unique_names(scene.attachments, root.key("attachments"), name_of_def);
  unique_names(scene.cameras, root.key("cameras"), own_name);
  unique_names(scene.emitters, root.key("emitters"), name_of_def);
  unique_names(scene.sinks, root.key("sinks"), name_of_def);
  const auto probes = unique_names(scene.probes, root.key("probes"), name_of_def);
  unique_names(scene.force_fields, root.key("force_fields"), own_name);
  unique_names(scene.checks, root.key("checks"), own_name);

  check_joints(scene, root.key("joints"));
  check_attachments(scene, cloths, ropes, root.key("attachments"));
  check_flow(scene, fluids, root);
  check_looks(scene, root.key("looks"));
  check_checks(scene, cloths, probes, root.key("checks"));
  for (std::size_t i = 0; i < scene.volumes.size(); ++i) {
    check_reference(scene.volumes[i].fluid, fluids, root.key("volumes").item(i).key("fluid"), "fluid");
  }
  for (std::size_t i = 0; i < scene.probes.size(); ++i) {
    const SceneProbe& probe = scene.probes[i];
    const ScenePlace place = root.key("probes").item(i);
    if (!probe.shape.empty()) check_reference(probe.shape, shapes, place.key("shape"), "shape");
    if (!probe.fluid.empty()) check_reference(probe.fluid, fluids, place.key("fluid"), "fluid");
  }
}

}  // namespace meniscus
