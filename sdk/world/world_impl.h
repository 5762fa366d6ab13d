// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <meniscus/world.h>

#include <memory>
#include <vector>

#include "sdk/engine/engine.h"
#include "sdk/world/id_table.h"
#include "sdk/world/world_shapes.h"

namespace meniscus {

/// A read-out that is fetched from the device when it is first asked for after a change.
template <class T>
struct CachedReadout {
  std::vector<T> values;
  bool valid = false;

  template <class Fetch>
  std::span<const T> get(size_t count, const Fetch& fetch) {
    if (!valid) {
      values.resize(count);
      if (count) fetch(std::span<T>(values));
      valid = true;
    }
    return values;
  }
};

struct World::Impl {
  explicit Impl(const WorldDef& world_def);

  /// Far from that of any other world of this process.
  static uint32_t next_first_generation();

  void add(FluidId fluid, std::span<const Vec3> positions, std::span<const Vec3> velocities, Vec3 velocity);
  void shapes_changed();
  void sinks_changed();
  void probes_changed();
  void read_probes();
  void state_changed();
  void remove(const std::vector<bool>& removed);  // by slot; the engine has done so already

  WorldDef def;
  DeviceInfo device;
  std::unique_ptr<Engine> engine;
  fluid::Kernel kernel{};
  double time = 0;
  float last_substep = 0;

  const uint32_t first_generation = next_first_generation();
  IdTable<FluidId, FluidDef> fluids{"fluid", first_generation};
  IdTable<ShapeId, ShapeParts> shapes{"shape", first_generation};
  IdTable<SinkId, SinkDef> sinks{"sink", first_generation};
  IdTable<ProbeId, ProbeDef> probes{"probe", first_generation};
  std::vector<fluid::ProbeSum> probe_sums;    // in the order of the probes
  std::vector<fluid::ProbeSum> probe_values;  // by the index of their ids

  ParticleId next_id = 0;
  std::vector<ParticleId> ids;  // by slot, ascending

  CachedReadout<Vec3> positions, velocities;
  CachedReadout<uint32_t> fluid_indices;
  CachedReadout<float> density_errors, full_support, pressures;
  EngineMeasure measured;  // with density_errors
};

/// The engine for a choice of device, and what it runs on.
std::unique_ptr<Engine> make_engine(const EngineDef& def, DeviceChoice choice, int threads, DeviceInfo& info);

}  // namespace meniscus
