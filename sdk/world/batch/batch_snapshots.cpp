// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Snapshots of a batch, in memory and in files.
#include <meniscus/error.h>
#include <meniscus/version.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "sdk/world/batch/batch_impl.h"
#include "sdk/world/state/chunk_file.h"
#include "sdk/world/state/definitions.h"

namespace meniscus {

std::size_t BatchSnapshot::device_bytes() const {
  return data_ ? data_->state.device_bytes() : 0;
}

/// A batch that restores the items has as many worlds of the same archetype.
void WorldBatch::Impl::visit_state(pbd::StateVisitor& v) {
  uint32_t count = worlds;
  v.value("worlds", count);
  if (count != worlds) throw Error(ErrorCode::io, "the snapshot is of " + std::to_string(count) + " worlds");
  std::vector<double> times;
  std::vector<uint8_t> active, failed;
  for (const WorldStatus& s : status) {
    times.push_back(s.time);
    active.push_back(s.active);
    failed.push_back(s.failed);
  }
  v.value("step", dt);
  v.values("time", std::span(times));
  v.values("active", std::span(active));
  v.values("failed", std::span(failed));
  v.values("gravity", std::span(gravities));
  v.values("placed", std::span(placed));
  v.values("last_substeps", std::span(last));
  v.group("engine", [&] { engine().visit_worlds(v); });
  for (uint32_t w = 0; w < worlds && bodies_each > 0; ++w) {
    collision::RigidWorld& rigid = engine().rigid_worlds().world(w);
    const collision::RigidWorld::SnapshotPtr state = collision::RigidWorld::make_snapshot();
    if (!v.restores()) rigid.save(*state);
    v.group("rigid" + std::to_string(w), [&] { rigid.visit_snapshot(*state, v); });
    if (!v.restores()) continue;
    rigid.restore(*state);
    engine().rigid_worlds().renew(w);
  }
  for (uint32_t w = 0; w < worlds; ++w) status[w] = {active[w] != 0, failed[w] != 0, times[w]};
}

/// Gravity comes last: where it differs from that before, it wakes bodies, which the state of bodies undoes.
void WorldBatch::Impl::restore(const pbd::SavedState& saved) {
  std::vector<Vec3> then = gravities;
  {
    pbd::StateRestorer look(engine().device(), saved);
    look.values("gravity", std::span(then));
  }
  set_gravities(then);
  pbd::StateRestorer v(engine().device(), saved);
  visit_state(v);
  v.expect_all_used();
  engine().place_worlds(std::vector<uint32_t>(worlds, 0));
  changed();
}

void WorldBatch::Impl::restore_or_lose(const pbd::SavedState& saved) {
  try {
    restore(saved);
  } catch (const pbd::StateLost&) {
    throw;
  } catch (const Error& error) {
    throw pbd::StateLost(error);
  } catch (...) {
    throw pbd::StateLost();
  }
}

// ---- in memory ----

/// What is in the memory of the batch's device goes before the device.
WorldBatch::Impl::~Impl() {
  for (const auto& known : snapshots) {
    if (const auto data = known.lock()) data->state = {};
  }
}

void WorldBatch::Impl::note(const std::shared_ptr<BatchSnapshot::Data>& data) {
  std::erase_if(snapshots, [](const auto& known) { return known.expired(); });
  snapshots.push_back(data);
}

bool WorldBatch::Impl::has(const std::shared_ptr<BatchSnapshot::Data>& data) const {
  return std::any_of(snapshots.begin(), snapshots.end(),
                     [&](const auto& known) { return known.lock() == data; });
}

BatchSnapshot WorldBatch::snapshot() const {
  return impl_->run(
      [&] {
        auto data = std::make_shared<BatchSnapshot::Data>();
        pbd::StateSaver saver(impl_->engine().device(), data->state, pbd::SavedTo::device);
        impl_->visit_state(saver);
        impl_->note(data);
        return BatchSnapshot(std::move(data));
      },
      "snapshot");
}

void WorldBatch::restore(const BatchSnapshot& snapshot) {
  if (snapshot.empty())
    throw Error(ErrorCode::invalid_argument, "WorldBatch::restore got a snapshot of no batch");
  if (!impl_->has(snapshot.data_))
    throw Error(ErrorCode::invalid_argument, "WorldBatch::restore got a snapshot of another batch");
  impl_->run([&] { impl_->restore_or_lose(snapshot.data_->state); }, "restore");
}

// ---- files ----

namespace {

constexpr const char* group_name = "batch";

/// The items whose paths begin with the group of a batch, without it; or all others.
pbd::SavedState items_of(const pbd::SavedState& all, bool of_batch) {
  const std::string prefix = std::string(group_name) + "/";
  pbd::SavedState some;
  for (const std::string& path : all.paths()) {
    if (path.starts_with(prefix) != of_batch) continue;
    const pbd::StateItem& item = *all.find(path);
    some.add(of_batch ? path.substr(prefix.size()) : path,
             {item.form, item.element_bytes, item.count, item.required, item.host, {}});
  }
  return some;
}

}  // namespace

void WorldBatch::save(const std::string& path) const {
  impl_->run(
      [&] {
        World::Impl& one = *impl_->archetype.impl_;
        const ChunkFileHeader header{MENISCUS_VERSION_STRING, one.device.kind, one.time,
                                     definitions_text(one)};
        one.run([&](World::Calls calls) {
          calls.with_chunks([&](const World::Calls::VisitChunks& visit) {
            write_chunk_file(path, header, one.engine->device(), [&](pbd::StateVisitor& v) {
              visit(v);
              v.group(group_name, [&] { impl_->visit_state(v); });
            });
          });
        });
      },
      "save");
}

WorldBatch WorldBatch::load(const std::string& path, const LoadDef& def) {
  return pbd::with_host_memory([&] {
    ChunkFileHeader header;
    const pbd::SavedState saved = read_chunk_file(path, header);
    const pbd::SavedState of_batch = items_of(saved, true);
    if (of_batch.paths().empty())
      throw Error(ErrorCode::io, path + " is a snapshot of a world, not of a batch; World::load reads it");
    const World archetype = World::made_from(header.definitions, items_of(saved, false), def);
    BatchDef batch;
    Engine& engine = *archetype.impl_->engine;
    pbd::StateRestorer(engine.device(), of_batch).value("worlds", batch.worlds);
    auto impl = std::make_unique<Impl>(archetype, batch);
    impl->run([&] { impl->restore(of_batch); }, "load");
    return WorldBatch(std::move(impl));
  });
}

}  // namespace meniscus
