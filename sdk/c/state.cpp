// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Snapshots and files of C, and the objects that a world has.
#include <meniscus/c/state.h>

#include <memory>

#include "sdk/c/handles.h"
#include "sdk/fields/world.h"

struct MeniscusSnapshot {
  meniscus::Snapshot snapshot;
};

namespace meniscus::c {
namespace {

LoadDef load_def_of(const char* device, int threads) {
  LoadDef def;
  if (threads >= 0) def.threads = threads;
  if (!device) return def;
  for (const Named<DeviceChoice>& choice : names_of(DeviceChoice{})) {
    if (choice.name == std::string(device)) def.device = choice.value;
  }
  if (!def.device)
    throw Error(ErrorCode::invalid_argument,
                "device is \"" + std::string(device) + "\"; it must be auto, cpu or cuda");
  return def;
}

/// The calls of World for one kind of object.
struct KindCalls {
  std::vector<MeniscusId> (*list)(const World&);
  MeniscusId (*find)(const World&, const std::string&);
};

template <auto List, auto Find>
KindCalls calls() {
  return {[](const World& world) {
            std::vector<MeniscusId> ids;
            for (const auto id : (world.*List)()) ids.push_back(in_c(id));
            return ids;
          },
          [](const World& world, const std::string& name) { return in_c((world.*Find)(name)); }};
}

KindCalls calls_of(MeniscusKind kind) {
  switch (kind) {
    case MENISCUS_FLUID:
      return calls<&World::fluid_ids, &World::find_fluid>();
    case MENISCUS_SHAPE:
      return calls<&World::shape_ids, &World::find_shape>();
    case MENISCUS_BODY:
      return calls<&World::body_ids, &World::find_body>();
    case MENISCUS_JOINT:
      return calls<&World::joint_ids, &World::find_joint>();
    case MENISCUS_CLOTH:
      return calls<&World::cloth_ids, &World::find_cloth>();
    case MENISCUS_ROPE:
      return calls<&World::rope_ids, &World::find_rope>();
    case MENISCUS_ATTACHMENT:
      return calls<&World::attachment_ids, &World::find_attachment>();
    case MENISCUS_EMITTER:
      return calls<&World::emitter_ids, &World::find_emitter>();
    case MENISCUS_SINK:
      return calls<&World::sink_ids, &World::find_sink>();
    case MENISCUS_PROBE:
      return calls<&World::probe_ids, &World::find_probe>();
    case MENISCUS_FORCE_FIELD:
      return calls<&World::force_field_ids, &World::find_force_field>();
    default:
      throw Error(ErrorCode::invalid_argument, "kind is " + std::to_string(static_cast<int>(kind)));
  }
}

}  // namespace
}  // namespace meniscus::c

using namespace meniscus::c;
using namespace meniscus;

MeniscusStatus meniscus_snapshot(const MeniscusWorld* world, MeniscusSnapshot** snapshot) {
  return guarded([&] {
    MeniscusSnapshot*& out = required(snapshot, "snapshot");
    out = std::make_unique<MeniscusSnapshot>(MeniscusSnapshot{world_of(world).snapshot()}).release();
  });
}

void meniscus_snapshot_destroy(MeniscusSnapshot* snapshot) {
  delete snapshot;
}

MeniscusStatus meniscus_restore(MeniscusWorld* world, const MeniscusSnapshot* snapshot) {
  return guarded([&] { world_of(world).restore(required(snapshot, "snapshot").snapshot); });
}

MeniscusStatus meniscus_save(const MeniscusWorld* world, const char* path) {
  return guarded([&] { world_of(world).save(&required(path, "path")); });
}

MeniscusStatus meniscus_load(const char* path, const char* device, int threads, MeniscusWorld** world) {
  return guarded([&] {
    MeniscusWorld*& out = required(world, "world");
    const LoadDef def = load_def_of(device, threads);
    out = std::make_unique<MeniscusWorld>(MeniscusWorld{World::load(&required(path, "path"), def)}).release();
  });
}

MeniscusStatus meniscus_clone(const MeniscusWorld* world, const char* device, int threads,
                              MeniscusWorld** copy) {
  return guarded([&] {
    MeniscusWorld*& out = required(copy, "copy");
    const LoadDef def = load_def_of(device, threads);
    out = std::make_unique<MeniscusWorld>(MeniscusWorld{world_of(world).clone(def)}).release();
  });
}

MeniscusStatus meniscus_objects(MeniscusWorld* world, MeniscusKind kind, const MeniscusId** ids,
                                size_t* count) {
  return guarded([&] {
    const World& w = world_of(world);
    std::vector<MeniscusId> found = calls_of(kind).list(w);
    std::vector<MeniscusId>& kept = world->objects[kind];
    kept = std::move(found);
    write_array(ids, count, kept);
  });
}

MeniscusStatus meniscus_find(const MeniscusWorld* world, MeniscusKind kind, const char* name,
                             MeniscusId* id) {
  return guarded([&] {
    const World& w = world_of(world);
    const std::string wanted = &required(name, "name");
    required(id, "id") = calls_of(kind).find(w, wanted);
  });
}
