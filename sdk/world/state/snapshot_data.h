// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What a Snapshot holds.
#pragma once

#include <meniscus/snapshot.h>

#include <memory>
#include <vector>

#include "collision/rigid/rigid_world.h"
#include "pbd/state/saved_state.h"
#include "sdk/world/state/world_tables.h"

namespace meniscus {

/// The state of a world, apart from it. Its arrays are in the memory of the world's device.
struct Snapshot::Data {
  WorldTables tables;
  pbd::SavedState engine;
  collision::RigidWorld::SnapshotPtr rigid;
  collision::RigidLayout layout;  ///< of the solids and joints of the tables
  bool is_of_living_world = true;

  /// Frees what is in the memory of the world's device, before the device is gone.
  void drop() {
    is_of_living_world = false;
    engine = {};
    rigid.reset();
    tables.shapes.clear();  // their fields are in the engine
    tables.bodies.clear();
  }
};

/// The snapshots of a world that still exist.
class SnapshotList {
 public:
  SnapshotList() = default;
  SnapshotList(const SnapshotList&) = delete;
  SnapshotList& operator=(const SnapshotList&) = delete;
  ~SnapshotList() {
    for (const auto& known : list_) {
      if (const auto data = known.lock()) data->drop();
    }
  }

  void add(const std::shared_ptr<Snapshot::Data>& data) {
    std::erase_if(list_, [](const auto& known) { return known.expired(); });
    list_.push_back(data);
  }
  bool has(const std::shared_ptr<Snapshot::Data>& data) const {
    for (const auto& known : list_) {
      if (known.lock() == data) return true;
    }
    return false;
  }

 private:
  std::vector<std::weak_ptr<Snapshot::Data>> list_;
};

}  // namespace meniscus
