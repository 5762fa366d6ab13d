// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#include "sdk/scene/scene_names.h"

#include <algorithm>
#include <map>

#include "sdk/scene/closest_name.h"
#include "sdk/scene/scene_place.h"

namespace meniscus {
namespace {

/// The names of a list, in its order; no name stands there twice.
template <class List, class NameOf>
std::vector<std::string> unique_names(const List& list, const ScenePlace& place, NameOf name_of) {
  std::vector<std::string> names;
  std::map<std::string, std::size_t> first;
  for (const auto& element : list) {
    const std::string& name = name_of(element);
    const auto [earlier, is_new] = first.emplace(name, names.size());
    if (!is_new) {
      const std::string owner = place.path + "[" + std::to_string(earlier->second) + "]";
      place.item(names.size()).key("name").fail("\"" + name + "\" is the name of " + owner + " already");
    }
    names.push_back(name);
  }
  return names;
}

void check_reference(const std::string& name, const std::vector<std::string>& names, const ScenePlace& place,
                     const char* kind) {
  if (std::find(names.begin(), names.end(), name) != names.end()) return;
  place.fail("there is no " + std::string(kind) + " named \"" + name + "\"" + name_hint(name, names));
}

}  // namespace

void check_names(const Scene& scene, const std::string& source) {
  const ScenePlace root{source, ""};
  const auto own_name = [](const auto& def) -> const std::string& { return def.name; };
  const auto fluids = unique_names(scene.fluids, root.key("fluids"), own_name);
  const auto shapes = unique_names(scene.shapes, root.key("shapes"), own_name);
  unique_names(scene.sinks, root.key("sinks"), own_name);
  unique_names(scene.probes, root.key("probes"),
               [](const SceneProbe& probe) -> const std::string& { return probe.def.name; });

  for (std::size_t i = 0; i < scene.volumes.size(); ++i) {
    check_reference(scene.volumes[i].fluid, fluids, root.key("volumes").item(i).key("fluid"), "fluid");
  }
  for (std::size_t i = 0; i < scene.probes.size(); ++i) {
    if (scene.probes[i].def.kind == ProbeKind::point_pressure) continue;
    check_reference(scene.probes[i].shape, shapes, root.key("probes").item(i).key("shape"), "shape");
  }
}

}  // namespace meniscus
