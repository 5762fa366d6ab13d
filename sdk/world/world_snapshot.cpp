// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// World's snapshots in memory.
#include <meniscus/error.h>
#include <meniscus/world.h>

#include <utility>

#include "sdk/world/state/snapshot_data.h"
#include "sdk/world/world_calls.h"

namespace meniscus {

double Snapshot::time() const {
  return data_ ? data_->tables.time : 0;
}

std::size_t Snapshot::device_bytes() const {
  return data_ ? data_->engine.device_bytes() : 0;
}

Snapshot World::Calls::snapshot() const {
  Engine& engine = impl_->with_all();
  impl_->read_reactions();  // of the last step
  impl_->forget_touches();
  auto data = std::make_shared<Snapshot::Data>(
      Snapshot::Data{WorldTables(*impl_), {}, collision::RigidWorld::make_snapshot()});
  pbd::StateSaver saver(engine.device(), data->engine, pbd::SavedTo::device);
  engine.visit_state(saver);
  impl_->rigid.save(*data->rigid);
  impl_->snapshots.add(data);
  return Snapshot(std::move(data));
}

void World::Calls::restore(const Snapshot& snapshot) {
  const std::shared_ptr<Snapshot::Data>& data = snapshot.data_;
  if (!data) throw Error(ErrorCode::invalid_argument, "restore got a snapshot of no world");
  if (!impl_->snapshots.has(data))
    throw Error(ErrorCode::invalid_argument, "restore got a snapshot of another world");
  if (!impl_->has_solids_of(data->tables)) {
    throw Error(ErrorCode::invalid_argument,
                "restore got a snapshot from before a shape, body or joint was created or destroyed, and "
                "cannot bring that back");
  }
  WorldTables tables = data->tables;
  impl_->monitor().commit();
  impl_->restore(std::move(tables), *data);
}

bool World::Impl::has_solids_of(const WorldTables& tables) const {
  return shapes.has_ids_of(tables.shapes) && bodies.has_ids_of(tables.bodies) &&
         joints.has_ids_of(tables.joints);
}

void World::Impl::restore(WorldTables&& tables, const Snapshot::Data& data) {
  const std::shared_ptr<const EngineCloth> on_device = cloth_is_on_device ? uploaded_cloth : nullptr;
  const bool had_cloth = uploaded_cloth != nullptr;
  static_cast<WorldTables&>(*this) = std::move(tables);
  restore_engine(*data.rigid, on_device != uploaded_cloth || (had_cloth && !on_device), [&] {
    pbd::StateRestorer restorer(engine->device(), data.engine);
    engine->visit_state(restorer);
    restorer.expect_all_used();
  });
}

/// Models come first, as they reset what the state then fills in.
void World::Impl::restore_engine(const collision::RigidWorld::Snapshot& rigid_state, bool sets_cloth,
                                 const std::function<void()>& visit_engine) {
  engine->device().wait();
  engine->set_solvers(engine_def());
  set_materials();
  if (sets_cloth) set_engine_cloth();
  rigid.set_def({def.gravity, def.rigid.substeps, def.rigid.iterations});
  rigid.restore(rigid_state);
  engine->place_bodies();
  probes_changed();
  upload_probes();
  sinks_changed();
  upload_sinks();
  forces_changed();
  upload_forces();
  visit_engine();
  state_changed();
}

}  // namespace meniscus
