// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Snapshots and files of C, and the objects that a world has.
#include <meniscus/c/state.h>

#include <memory>

#include "sdk/c/handles.h"
#include "sdk/c/host.h"
#include "sdk/fields/world.h"

struct MeniscusSnapshot {
  meniscus::Snapshot snapshot;
};

namespace meniscus::c {

LoadDef load_def_of(const MeniscusLoadDef* given) {
  LoadDef def;
  if (!given) return def;
  if (given->size != sizeof *given)
    throw Error(ErrorCode::invalid_argument, "size of the MeniscusLoadDef is " + std::to_string(given->size) +
                                                 "; meniscus_load_def_init() sets it");
  if (given->threads >= 0) def.threads = given->threads;
  if (given->cuda_device >= 0) def.cuda_device = given->cuda_device;
  def.cuda_stream = given->cuda_stream;
  def.read_file = reader_of(given->read_file, given->user);
  def.log = sink_of(given->log, given->user);
  def.parallel_for = loop_of(given->parallel_for, given->user);
  if (!given->device) return def;
  for (const Named<DeviceChoice>& choice : names_of(DeviceChoice{})) {
    if (choice.name == std::string(given->device)) def.device = choice.value;
  }
  if (!def.device)
    throw Error(ErrorCode::invalid_argument,
                "device is \"" + std::string(given->device) + "\"; it must be auto, cpu or cuda");
  return def;
}

namespace {

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

void meniscus_load_def_init(MeniscusLoadDef* def) {
  if (def) *def = {sizeof *def, -1, -1, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr};
}

MeniscusStatus meniscus_load(const char* path, const MeniscusLoadDef* def, MeniscusWorld** world) {
  return guarded([&] {
    MeniscusWorld*& out = required(world, "world");
    const LoadDef how = load_def_of(def);
    out = std::make_unique<MeniscusWorld>(MeniscusWorld{World::load(&required(path, "path"), how)}).release();
  });
}

MeniscusStatus meniscus_clone(const MeniscusWorld* world, const MeniscusLoadDef* def, MeniscusWorld** copy) {
  return guarded([&] {
    MeniscusWorld*& out = required(copy, "copy");
    const LoadDef how = load_def_of(def);
    out = std::make_unique<MeniscusWorld>(MeniscusWorld{world_of(world).clone(how)}).release();
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
