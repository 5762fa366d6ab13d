// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What C measures of a world: counts, probes, diagnostics, hashes and memory.
#include <meniscus/c/world.h>

#include "sdk/c/handles.h"

namespace meniscus::c {
namespace {

MeniscusDiagnostics diagnostics_of(const Diagnostics& d) {
  MeniscusDiagnostics c{};
  c.max_speed = d.max_speed;
  c.particles = d.particles;
  c.density_error_mean = d.density_error_mean;
  c.density_error_max = d.density_error_max;
  c.density_error_interior = d.density_error_interior;
  c.neighbours_mean = d.neighbours_mean;
  c.kinetic_energy = d.kinetic_energy;
  c.potential_energy = d.potential_energy;
  c.contacts = d.contacts;
  c.non_finite = d.non_finite;
  c.outside = d.outside;
  c.wall_overflows = d.wall_overflows;
  return c;
}

MeniscusMemoryUse use_of(const MemoryUse& use) {
  return {use.bytes, use.peak_bytes, use.allocations};
}

}  // namespace
}  // namespace meniscus::c

using namespace meniscus::c;
using namespace meniscus;

MeniscusStatus meniscus_flow_count(const MeniscusWorld* world, MeniscusId id, uint32_t* last_step,
                                   uint64_t* total) {
  return guarded([&] {
    uint32_t& last = required(last_step, "last_step");
    uint64_t& all = required(total, "total");
    const FlowCount count = id.kind == MENISCUS_SINK ? world_of(world).sink_count(in_cpp<SinkId>(id))
                                                     : world_of(world).emitter_count(in_cpp<EmitterId>(id));
    last = count.last_step;
    all = count.total;
  });
}

MeniscusStatus meniscus_emitter_pressure(const MeniscusWorld* world, MeniscusId id, double* pressure) {
  return guarded(
      [&] { required(pressure, "pressure") = world_of(world).emitter_pressure(in_cpp<EmitterId>(id)); });
}

MeniscusStatus meniscus_probe(const MeniscusWorld* world, MeniscusId id, double* value) {
  return guarded([&] { required(value, "value") = world_of(world).probe(in_cpp<ProbeId>(id)); });
}

MeniscusStatus meniscus_probe_vector(const MeniscusWorld* world, MeniscusId id, MeniscusVec3* value) {
  return guarded([&] { required(value, "value") = in_c(world_of(world).probe_vector(in_cpp<ProbeId>(id))); });
}

MeniscusStatus meniscus_diagnostics(const MeniscusWorld* world, MeniscusDiagnostics* diagnostics) {
  return guarded([&] { write_result(diagnostics, diagnostics_of(world_of(world).diagnostics())); });
}

MeniscusStatus meniscus_state_hash(const MeniscusWorld* world, uint64_t* hash) {
  return guarded([&] { required(hash, "hash") = world_of(world).state_hash(); });
}

MeniscusStatus meniscus_device_bytes(const MeniscusWorld* world, uint64_t* bytes) {
  return guarded([&] { required(bytes, "bytes") = world_of(world).device_bytes(); });
}

MeniscusStatus meniscus_memory_shares(MeniscusWorld* world, const MeniscusMemoryShare** shares,
                                      size_t* count) {
  return guarded([&] {
    MeniscusWorld& w = required(world, "world");
    w.memory = w.world.memory_shares();
    w.memory_shares.clear();
    for (const MemoryShare& share : w.memory) w.memory_shares.push_back({share.what.c_str(), share.bytes});
    write_array(shares, count, w.memory_shares);
  });
}

MeniscusStatus meniscus_memory_stats(const MeniscusWorld* world, MeniscusMemoryStats* stats) {
  return guarded([&] {
    const MemoryStats now = world_of(world).memory_stats();
    write_result(stats, {0, use_of(now.device), use_of(now.shared)});
  });
}
