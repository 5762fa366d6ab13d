// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// World's snapshots in files: all definitions, from which a world is made again, and the state that is then
// put into it.
#include <meniscus/error.h>
#include <meniscus/version.h>
#include <meniscus/world.h>

#include <optional>
#include <string_view>
#include <utility>

#include "collision/mesh/hash.h"
#include "pbd/host_memory.h"
#include "pbd/math/hash.h"
#include "sdk/engine/particle_items.h"
#include "sdk/world/check/check.h"
#include "sdk/world/state/chunk_file.h"
#include "sdk/world/state/definitions.h"
#include "sdk/world/state/snapshot_data.h"
#include "sdk/world/state/visit_tables.h"
#include "sdk/world/world_boundary.h"
#include "sdk/world/world_calls.h"

namespace meniscus {

namespace {

/// Visits the generations of all tables.
template <class Visit>
void for_each_table(WorldTables& t, const Visit& visit) {
  visit("fluid", t.fluids);
  visit("shape", t.shapes);
  visit("body", t.bodies);
  visit("joint", t.joints);
  visit("emitter", t.emitters);
  visit("sink", t.sinks);
  visit("probe", t.probes);
  visit("force_field", t.force_fields);
  visit("cloth", t.cloths);
  visit("rope", t.ropes);
  visit("attachment", t.attachments);
}

void visit_generations(pbd::StateVisitor& v, WorldTables& tables) {
  v.group("generation", [&] {
    for_each_table(tables, [&](const char* name, auto& table) {
      std::vector<uint32_t> generations = table.generations();
      v.list(name, generations);
      if (v.restores()) table.set_generations(generations);
    });
  });
}

/// Tells whether a solid is made from the same meshes as before.
uint64_t digest_of(const SolidPieces& solid) {
  uint64_t digest = pbd::mixed(solid.pieces.size());
  for (const collision::RigidPart& part : solid.parts) {
    if (!part.mesh) continue;
    const collision::MeshHash mesh = collision::hash_of(*part.mesh);
    digest = pbd::mixed(digest ^ mesh.first) ^ mesh.second;
  }
  for (const SolidPieces::Piece& piece : solid.pieces) {
    const Aabb& box = piece.place.bounds;
    digest = pbd::element_hash(digest, box.lower, box.upper);
  }
  return digest;
}

/// By the order of the layout's objects.
std::vector<uint64_t> digests_of(const WorldTables& tables, const collision::RigidLayout& layout) {
  std::vector<uint64_t> digests;
  for (const uint32_t code : layout.objects) {
    const uint32_t index = code / 2;
    digests.push_back(code % 2 ? digest_of(tables.bodies.get(tables.bodies.id(index)).solid)
                               : digest_of(tables.shapes.get(tables.shapes.id(index)).solid));
  }
  return digests;
}

[[noreturn]] void refuse_file(const std::string& why) {
  throw Error(ErrorCode::io, "the snapshot is not usable: " + why);
}

/// Puts an entry that `make` makes from each definition into its place.
template <class Table, class Def, class Make>
void fill(Table& table, const char* what, const std::vector<std::optional<Def>>& defs, const Make& make) {
  if (table.generations().size() < defs.size())
    refuse_file(std::string("it lacks places of the kind ") + what);
  for (uint32_t index = 0; index < defs.size(); ++index) {
    if (defs[index]) table.put(index, make(*defs[index]));
  }
}

template <class Def>
const Def& def_at(const std::vector<std::optional<Def>>& defs, uint32_t index) {
  if (index >= defs.size() || !defs[index]) refuse_file("it lacks the definition of a solid or joint");
  return *defs[index];
}

}  // namespace

/// The items that need all contents to be there.
void World::Impl::visit_contents(pbd::StateVisitor& v, collision::RigidWorld::Snapshot& rigid_state,
                                 EngineCloth& cloth) {
  v.group("world", [&] { visit_tables(v, *this); });
  v.group("rigid", [&] { rigid.visit_snapshot(rigid_state, v); });
  v.group("model", [&] { visit_engine_cloth(v, cloth); });
}

void World::Calls::with_chunks(const std::function<void(const VisitChunks&)>& use) const {
  Engine& engine = impl_->with_all();
  impl_->read_reactions();
  impl_->fetch_cloth();
  collision::RigidLayout layout = impl_->rigid.layout();
  std::vector<uint64_t> digests = digests_of(*impl_, layout);
  const collision::RigidWorld::SnapshotPtr rigid = collision::RigidWorld::make_snapshot();
  impl_->rigid.save(*rigid);
  EngineCloth cloth = impl_->uploaded_cloth ? *impl_->uploaded_cloth : EngineCloth{};
  bool has_cloth = impl_->uploaded_cloth != nullptr;
  use([&](pbd::StateVisitor& v) {
    v.value("has_cloth", has_cloth);
    v.list("solid_digest", digests);
    visit_generations(v, *impl_);
    v.part("layout", layout);
    impl_->visit_contents(v, *rigid, cloth);
    v.group("engine", [&] { engine.visit_state(v); });
  });
}

pbd::SavedState World::Calls::chunks() const {
  pbd::SavedState chunks;
  with_chunks([&](const VisitChunks& visit) {
    pbd::StateSaver saver(impl_->engine->device(), chunks, pbd::SavedTo::host);
    visit(saver);
  });
  return chunks;
}

namespace {

/// Names of the engine's items, as the file has them.
template <class Test>
auto in_engine(const Test& test) {
  return [test](const std::string& chunk) {
    constexpr std::string_view engine = "engine/";
    return chunk.starts_with(engine) && test(std::string_view(chunk).substr(engine.size()));
  };
}

SharedChunks shared_chunks(Engine& engine) {
  return {engine.particles_by_rank(), in_engine(is_particle_item), in_engine(is_particle_count),
          [&engine](const std::string& file, std::span<const uint64_t> offsets) {
            return engine.write_particle_items(file, offsets);
          }};
}

}  // namespace

void World::Calls::save(const std::string& path) const {
  const ChunkFileHeader header{MENISCUS_VERSION_STRING, impl_->device.kind, impl_->time,
                               definitions_text(*impl_)};
  std::optional<SharedChunks> shared;
  if (impl_->shared_by) shared = shared_chunks(*impl_->engine);
  with_chunks([&](const VisitChunks& visit) {
    write_chunk_file(path, header, impl_->engine->device(), visit, shared ? &*shared : nullptr);
  });
}

/// Makes all contents of an empty world, and gives them their state.
void World::Impl::fill_from(const std::string& definitions, const pbd::SavedState& saved) {
  const Definitions defs = read_definitions(definitions, first_generation);
  pbd::StateRestorer v(engine->device(), saved);
  visit_generations(v, *this);
  fill(fluids, "fluid", defs.fluids, [](const ParticleMaterial& m) { return m; });
  collision::RigidLayout layout;
  v.part("layout", layout);
  make_solids(defs, layout);
  std::vector<uint64_t> digests;
  v.list("solid_digest", digests);
  if (digests != digests_of(*this, layout)) refuse_file("a mesh file of its solids has changed since");
  fill(emitters, "emitter", defs.emitters,
       [](const EmitterDef& d) { return EmitterEntry{d, {}, EmitterClock(0, 0, 0, 1, 0), {}, {}, {}, {}}; });
  fill(sinks, "sink", defs.sinks, [](const SinkDef& d) { return SinkEntry{d, {}}; });
  fill(probes, "probe", defs.probes, [](const ProbeDef& d) { return d; });
  fill(force_fields, "force_field", defs.force_fields, [](const ForceFieldDef& d) { return d; });
  fill(cloths, "cloth", defs.cloths, [](const ClothDef& d) {
    ClothEntry entry;
    entry.def = d;
    drop_keyframes(entry.def);  // an earlier version wrote them
    return entry;
  });
  fill(ropes, "rope", defs.ropes, [](const RopeDef& d) { return make_rope(d); });
  fill(attachments, "attachment", defs.attachments, [](const AttachmentDef& d) {
    AttachmentEntry entry;
    entry.def = d;
    return entry;
  });
  bool has_cloth = false;
  EngineCloth cloth;
  const collision::RigidWorld::SnapshotPtr rigid_state = collision::RigidWorld::make_snapshot();
  v.value("has_cloth", has_cloth);
  visit_contents(v, *rigid_state, cloth);
  cloth.driven = driven_pieces(cloths);
  if (has_cloth) uploaded_cloth = std::make_shared<const EngineCloth>(std::move(cloth));
  vertex_count = uploaded_cloth ? static_cast<uint32_t>(uploaded_cloth->position.size()) : 0;
  if (uploaded_cloth) held = uploaded_cloth->model.held;
  solids_changed();
  upload_solids();
  restore_engine(*rigid_state, uploaded_cloth != nullptr, [&] {
    v.group("engine", [&] { engine->visit_state(v); });
    v.expect_all_used();
  });
  if (awake.empty()) {  // a file of 0.2
    bodies.for_each([&](uint32_t number, const BodyEntry&) {
      awake.resize(number + 1, 1);
      awake[number] = rigid.awake(number);
    });
  }
  if (engine->particle_count() != ids.size()) refuse_file("its particles and their ids differ in number");
}

/// In the order of Bullet's lists. Joints come after their bodies.
void World::Impl::make_solids(const Definitions& defs, const collision::RigidLayout& layout) {
  if (layout.proxies.size() != layout.objects.size() || layout.joint_places.size() != layout.joints.size())
    refuse_file("its lists of solids differ in length");
  for (size_t k = 0; k < layout.objects.size(); ++k) {
    const uint32_t index = layout.objects[k] / 2;
    const collision::RigidPlace place{index, layout.proxies[k]};
    if (layout.proxies[k] == 0 || layout.proxies[k] >= layout.proxy_room) refuse_file("its places of solids");
    if (layout.objects[k] % 2) {
      const BodyDef& body = def_at(defs.bodies, index);
      check::def(body);
      bodies.put(index, make_body(body, place));
      note_repairs(bodies.get(bodies.id(index)).solid);
    } else {
      const ShapeDef& shape = def_at(defs.shapes, index);
      check::def(shape);
      shapes.put(index, make_shape(shape, place));
      note_repairs(shapes.get(shapes.id(index)).solid);
    }
  }
  for (size_t k = 0; k < layout.joints.size(); ++k) {
    const JointDef& joint = def_at(defs.joints, layout.joints[k]);
    check::def(joint);
    rigid.add_joint(rigid_joint(joint), layout.joints[k], layout.joint_places[k]);
    joints.put(layout.joints[k], joint);
  }
  rigid.arrange(layout);
}

World World::made_from(const std::string& definitions, const pbd::SavedState& saved, const LoadDef& def) {
  WorldDef world_def = read_world_def(definitions);
  if (def.device) world_def.device = *def.device;
  if (def.threads) world_def.threads = *def.threads;
  if (def.cuda_device) world_def.cuda_device = *def.cuda_device;
  if (world_def.device == DeviceChoice::cpu) world_def.cuda_device.reset();
  world_def.cuda_stream = def.cuda_stream;
  world_def.read_file = def.read_file;
  world_def.log = def.log;
  world_def.parallel_for = def.parallel_for;
  if (def.parallel_for && !def.threads) world_def.threads = 0;
  World world(world_def);
  world.impl_->run([&](auto) { world.impl_->fill_from(definitions, saved); });
  return world;
}

World World::load(const std::string& path, const LoadDef& def) {
  return pbd::with_host_memory([&] {
    ChunkFileHeader header;
    const pbd::SavedState saved = read_chunk_file(path, header);
    return made_from(header.definitions, saved, def);
  });
}

World World::clone(const LoadDef& def) const {
  LoadDef own = def;
  if (!own.read_file) own.read_file = this->def().read_file;
  if (!own.log) own.log = this->def().log;
  if (!own.parallel_for && !own.threads) own.parallel_for = this->def().parallel_for;
  return impl_->run([&](auto w) { return made_from(definitions_text(*impl_), w.chunks(), own); });
}

}  // namespace meniscus
