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
      Snapshot::Data{WorldTables(*impl_), {}, collision::RigidWorld::make_snapshot(), impl_->rigid.layout()});
  pbd::StateSaver saver(engine.device(), data->engine, pbd::SavedTo::device);
  engine.visit_state(saver);
  impl_->rigid.save(*data->rigid);
  impl_->snapshots.add(data);
  return Snapshot(std::move(data));
}

namespace {

/// What belongs to the running program, and to no state.
void keep_host(WorldDef& restored, const WorldDef& running) {
  restored.log = running.log;
  restored.parallel_for = running.parallel_for;
  restored.read_file = running.read_file;
  restored.cuda_stream = running.cuda_stream;
}

}  // namespace

void World::Calls::restore(const Snapshot& snapshot) {
  const std::shared_ptr<Snapshot::Data>& data = snapshot.data_;
  if (!data) throw Error(ErrorCode::invalid_argument, "restore got a snapshot of no world");
  if (!impl_->snapshots.has(data))
    throw Error(ErrorCode::invalid_argument, "restore got a snapshot of another world");
  WorldTables tables = data->tables;
  keep_host(tables.def, impl_->def);
  keep_host(tables.given, impl_->given);
  if (tables.solids_revision == impl_->solids_revision) {
    impl_->monitor().commit();
    impl_->restore(std::move(tables), *data);
  } else {
    collision::RigidWorld made(rigid_world_def(tables.def));
    Impl::make_rigid(made, tables, data->layout);
    impl_->monitor().commit();
    impl_->rigid.swap(made);
    tables.solids_are_on_device = false;
    impl_->restore(std::move(tables), *data);
  }
}

void World::Impl::make_rigid(collision::RigidWorld& made, const WorldTables& tables,
                             const collision::RigidLayout& layout) {
  for (size_t k = 0; k < layout.objects.size(); ++k) {
    const uint32_t index = layout.objects[k] / 2;
    const collision::RigidPlace place{index, layout.proxies[k]};
    if (layout.objects[k] % 2) {
      made.add_body(rigid_body(tables.bodies.get(tables.bodies.id(index))), place);
    } else {
      const ShapeEntry& shape = tables.shapes.get(tables.shapes.id(index));
      made.add_fixed(rigid_solid(shape.solid, shape.def.pose, shape.def.surface, shape.def.filter), place);
    }
  }
  for (size_t k = 0; k < layout.joints.size(); ++k) {
    const uint32_t n = layout.joints[k];
    made.add_joint(rigid_joint(tables.joints.get(tables.joints.id(n))), n, layout.joint_places[k]);
  }
  made.arrange(layout);
}

void World::Impl::restore(WorldTables&& tables, const Snapshot::Data& data) {
  const std::shared_ptr<const EngineCloth> on_device = cloth_is_on_device ? uploaded_cloth : nullptr;
  const bool had_cloth = uploaded_cloth != nullptr;
  engine->device().wait();  // for what reads the fields of solids that are dropped here
  static_cast<WorldTables&>(*this) = std::move(tables);
  forgotten.clear();
  const bool has_new_bodies = !solids_are_on_device;  // to which cloth may be attached
  upload_solids();
  const bool sets_cloth = on_device != uploaded_cloth || ((has_new_bodies || !on_device) && had_cloth);
  restore_engine(*data.rigid, sets_cloth, [&] {
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
  rigid.set_def(rigid_world_def(def));
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
