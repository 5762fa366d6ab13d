// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The public calls of WorldBatch, and its read-outs.
#include <meniscus/batch.h>

#include <algorithm>
#include <atomic>
#include <string>
#include <utility>

#include "sdk/world/batch/batch_impl.h"
#include "sdk/world/check/check.h"

namespace meniscus {

namespace {

/// Makes room for vectors, unless the memory of the last ones serves and nobody else holds it.
void make_room(DeviceArray& array, Engine& engine, int64_t worlds, int64_t each) {
  if (array.memory.use_count() != 1)
    array.memory = engine.allocate_lasting(static_cast<size_t>(worlds * each) * sizeof(Vec3));
  std::atomic_thread_fence(std::memory_order_acquire);  // the last holder may have been on another thread
  array.data = array.memory.get();
  array.dimensions = 3;
  array.shape = {worlds, each, 3};
  array.strides = {3 * each, 3, 1};
  array.on_cuda = engine.device().kind() == pbd::DeviceKind::cuda;
  array.device = engine.ordinal();
  array.stream = engine.stream();
}

}  // namespace

BatchArrays WorldBatch::Impl::device_arrays() {
  for (DeviceArray* array : {&arrays.positions, &arrays.velocities})
    make_room(*array, engine(), worlds, each);
  engine().write_vectors(static_cast<Vec3*>(arrays.positions.data),
                         static_cast<Vec3*>(arrays.velocities.data));
  if (vertices_each == 0) return arrays;
  for (DeviceArray* array : {&arrays.cloth_positions, &arrays.cloth_velocities})
    make_room(*array, engine(), worlds, vertices_each);
  engine().write_vertices(static_cast<Vec3*>(arrays.cloth_positions.data),
                          static_cast<Vec3*>(arrays.cloth_velocities.data));
  return arrays;
}

void WorldBatch::Impl::read_vertices() {
  if (vertex_positions.valid) return;
  const size_t count = size_t{worlds} * vertices_each;
  vertex_velocities.get(count, [&](std::span<Vec3> velocity_out) {
    vertex_positions.get(count, [&](std::span<Vec3> out) {
      engine().read_vertices(out, velocity_out);
      for (Vec3& p : out) p = host().origin.outward(p);
    });
  });
}

// ---- the public calls ----

WorldBatch::WorldBatch(const World& archetype, const BatchDef& def)
    : impl_(std::make_unique<Impl>(archetype, def)) {}
WorldBatch::WorldBatch(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
WorldBatch::~WorldBatch() = default;
WorldBatch::WorldBatch(WorldBatch&&) noexcept = default;
WorldBatch& WorldBatch::operator=(WorldBatch&&) noexcept = default;

uint32_t WorldBatch::worlds() const {
  return impl_->worlds;
}
std::size_t WorldBatch::particle_count() const {
  return impl_->each;
}
std::size_t WorldBatch::vertex_count() const {
  return impl_->vertices_each;
}
const WorldDef& WorldBatch::def() const {
  return impl_->archetype.def();
}
DeviceInfo WorldBatch::device() const {
  return impl_->running.device();
}

BatchReport WorldBatch::step(float dt) {
  check::value("WorldBatch::step's dt", dt, at_least(1e-12), "s");
  return impl_->run([&] { return impl_->step(dt); }, "step");
}

void WorldBatch::reset(std::span<const uint8_t> mask) {
  if (!mask.empty()) impl_->check_mask("reset", mask);
  impl_->run([&] { impl_->reset(mask); }, "reset");
}

void WorldBatch::set_active(std::span<const uint8_t> mask) {
  impl_->check_mask("set_active", mask);
  for (uint32_t w = 0; w < impl_->worlds; ++w) impl_->status[w].active = mask[w] != 0;
}

void WorldBatch::set_gravity(uint32_t world, Vec3 gravity) {
  impl_->check_world("set_gravity", world);
  check::value("set_gravity's gravity", gravity);
  std::vector<Vec3> all = impl_->gravities;
  all[world] = gravity;
  impl_->set_gravities(all);
}

void WorldBatch::set_gravities(std::span<const Vec3> gravities) {
  if (gravities.size() != impl_->worlds)
    check::refuse("set_gravities", std::to_string(gravities.size()) + " vectors",
                  "one for each of " + std::to_string(impl_->worlds) + " worlds");
  for (const Vec3 g : gravities) check::value("a gravity of set_gravities", g);
  impl_->set_gravities(gravities);
}

std::span<const WorldStatus> WorldBatch::status() const {
  return impl_->status;
}

namespace {

template <class Read>
std::span<const Vec3> in_users_frame(const Origin& origin, CachedReadout<Vec3>& kept, size_t count,
                                     const Read& read) {
  return kept.get(count, [&](std::span<Vec3> out) {
    read(out);
    if (origin.is_zero()) return;
    for (Vec3& p : out) p = origin.outward(p);
  });
}

}  // namespace

std::span<const Vec3> WorldBatch::positions() const {
  return impl_->run(
      [&] {
        return in_users_frame(impl_->host().origin, impl_->positions, size_t{impl_->worlds} * impl_->each,
                              [&](std::span<Vec3> out) { impl_->engine().read_positions(out); });
      },
      "positions");
}

std::span<const Vec3> WorldBatch::velocities() const {
  return impl_->run(
      [&] {
        return impl_->velocities.get(size_t{impl_->worlds} * impl_->each,
                                     [&](std::span<Vec3> out) { impl_->engine().read_velocities(out); });
      },
      "velocities");
}

std::span<const Vec3> WorldBatch::cloth_positions() const {
  return impl_->run(
      [&] {
        impl_->read_vertices();
        return std::span<const Vec3>(impl_->vertex_positions.array->values);
      },
      "cloth_positions");
}

std::span<const Vec3> WorldBatch::cloth_velocities() const {
  return impl_->run(
      [&] {
        impl_->read_vertices();
        return std::span<const Vec3>(impl_->vertex_velocities.array->values);
      },
      "cloth_velocities");
}

std::span<const uint64_t> WorldBatch::state_hashes() const {
  return impl_->run(
      [&] {
        return impl_->hashes.get(impl_->worlds, [&](std::span<uint64_t> out) { impl_->hash_worlds(out); });
      },
      "state_hashes");
}

BatchArrays WorldBatch::device_arrays() const {
  return impl_->run([&] { return impl_->device_arrays(); }, "device_arrays");
}

World WorldBatch::extract(uint32_t world) const {
  impl_->check_world("extract", world);
  return impl_->extract(world);
}

MemoryStats WorldBatch::memory_stats() const {
  return impl_->running.memory_stats();
}

}  // namespace meniscus
