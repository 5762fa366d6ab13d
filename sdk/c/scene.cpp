// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Scenes of C.
#include <meniscus/c/scene.h>

#include <memory>

#include "sdk/c/handles.h"

namespace meniscus::c {
namespace {

const std::string& name_of(const auto& item) {
  if constexpr (requires { item.def.name; })
    return item.def.name;
  else
    return item.name;
}

template <class List, class IdType>
void add_items(SceneItems& items, const List& list, const std::vector<IdType>& ids, std::size_t first = 0) {
  for (std::size_t i = 0; i < list.size(); ++i)
    items.of_kind[kind_of<IdType>].push_back({in_c(ids.at(first + i)), name_of(list[i])});
}

SceneItems items_of(const Scene& scene, const BuiltScene& built) {
  SceneItems items;
  add_items(items, scene.fluids, built.fluids);
  add_items(items, scene.granulars, built.fluids, scene.fluids.size());
  add_items(items, scene.shapes, built.shapes);
  add_items(items, bodies_of(scene), built.bodies);
  add_items(items, scene.joints, built.joints);
  add_items(items, scene.cloths, built.cloths);
  add_items(items, scene.ropes, built.ropes);
  add_items(items, scene.attachments, built.attachments);
  add_items(items, scene.emitters, built.emitters);
  add_items(items, scene.sinks, built.sinks);
  add_items(items, scene.probes, built.probes);
  add_items(items, scene.force_fields, built.force_fields);
  return items;
}

}  // namespace
}  // namespace meniscus::c

using namespace meniscus::c;
using namespace meniscus;

MeniscusStatus meniscus_scene_read(const char* path, const char* const* overrides, size_t override_count,
                                   MeniscusScene** scene) {
  return guarded([&] {
    MeniscusScene*& out = required(scene, "scene");
    const std::string file = &required(path, "path");
    std::vector<std::string> texts;
    required_array(overrides, override_count, "overrides");
    for (std::size_t i = 0; i < override_count; ++i) texts.emplace_back(&required(overrides[i], "override"));
    out = std::make_unique<MeniscusScene>(MeniscusScene{read_scene(file, texts)}).release();
  });
}

MeniscusStatus meniscus_scene_read_text(const char* text, const char* folder, MeniscusScene** scene) {
  return guarded([&] {
    MeniscusScene*& out = required(scene, "scene");
    const Scene read = read_scene_text(&required(text, "text"), folder ? folder : "");
    out = std::make_unique<MeniscusScene>(MeniscusScene{read}).release();
  });
}

void meniscus_scene_destroy(MeniscusScene* scene) {
  delete scene;
}

MeniscusStatus meniscus_scene_info(const MeniscusScene* scene, MeniscusSceneInfo* info) {
  return guarded([&] {
    const Scene& s = required(scene, "scene").scene;
    write_result(info, {0, s.frames, s.frame_time, s.name.c_str(), s.description.c_str()});
  });
}

MeniscusStatus meniscus_scene_check(const MeniscusScene* scene) {
  return guarded([&] { check_scene(required(scene, "scene").scene); });
}

MeniscusStatus meniscus_scene_build(const MeniscusScene* scene, MeniscusWorld** world) {
  return guarded([&] {
    MeniscusWorld*& out = required(world, "world");
    const Scene& s = required(scene, "scene").scene;
    BuiltScene built = build_scene(s);
    SceneItems items = items_of(s, built);
    out = std::make_unique<MeniscusWorld>(MeniscusWorld{std::move(built.world), std::move(items)}).release();
  });
}

MeniscusStatus meniscus_scene_item(const MeniscusWorld* world, MeniscusKind kind, size_t number,
                                   MeniscusId* id, const char** name) {
  return guarded([&] {
    const SceneItems& items = required(world, "world").items;
    if (kind <= MENISCUS_NONE || kind > MENISCUS_FORCE_FIELD)
      throw Error(ErrorCode::invalid_argument, "kind is " + std::to_string(static_cast<int>(kind)));
    const std::vector<SceneItems::Item>& list = items.of_kind[kind];
    if (number >= list.size())
      throw Error(ErrorCode::not_found, "the scene has " + std::to_string(list.size()) +
                                            " of this kind: " + kind_name(static_cast<uint32_t>(kind)));
    if (id) *id = list[number].id;
    if (name) *name = list[number].name.c_str();
  });
}

MeniscusStatus meniscus_scene_schema(const char** schema) {
  return guarded([&] {
    static const std::string text = scene_schema();
    required(schema, "schema") = text.c_str();
  });
}
