// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// World's calls that let others work with its device: arrays there, steps in two halves, and hooks.
#include <utility>

#include "sdk/world/check/check.h"
#include "sdk/world/world_boundary.h"

namespace meniscus {

namespace {

/// Makes room for an array, unless the memory of the last one serves and nobody else holds it.
void make_room(DeviceArray& array, Engine& engine, ElementType type, size_t count, int columns) {
  const size_t element = type == ElementType::uint64 ? 8 : 4, bytes = count * size_t(columns) * element;
  const bool fits = array.memory.use_count() == 1 && array.shape[0] == static_cast<int64_t>(count);
  if (!fits) {
    array.memory.reset();
    if (bytes) array.memory = engine.allocate_lasting(bytes);
  }
  array.data = array.memory.get();
  array.type = type;
  array.dimensions = columns > 1 ? 2 : 1;
  array.shape = {static_cast<int64_t>(count), columns};
  array.strides = {columns, 1};
  array.on_cuda = engine.device().kind() == pbd::DeviceKind::cuda;
  array.device = engine.ordinal();
}

}  // namespace

DeviceArrays World::Calls::device_arrays() const {
  Engine& engine = *impl_->engine;
  const size_t count = impl_->ids.size();
  DeviceArrays& arrays = impl_->shared_arrays;
  make_room(arrays.ids, engine, ElementType::uint64, count, 1);
  make_room(arrays.positions, engine, ElementType::float32, count, 3);
  make_room(arrays.velocities, engine, ElementType::float32, count, 3);
  make_room(arrays.phases, engine, ElementType::uint32, count, 1);
  if (count) {
    engine.write_arrays(
        {static_cast<Vec3*>(arrays.positions.data), static_cast<Vec3*>(arrays.velocities.data),
         static_cast<uint32_t*>(arrays.phases.data), static_cast<ParticleId*>(arrays.ids.data)},
        impl_->ids);
  }
  void* const stream = engine.stream();
  for (DeviceArray* array : {&arrays.ids, &arrays.positions, &arrays.velocities, &arrays.phases})
    array->stream = stream;
  return arrays;
}

void World::Calls::set_hook(Hook hook, SubstepCall call) {
  const auto number = static_cast<uint32_t>(hook);
  if (number >= hook_count)
    throw Error(ErrorCode::invalid_argument,
                "set_hook got the hook " + std::to_string(number) + "; there are 0 to 4");
  HookCalls calls = impl_->hooks;
  calls[number] = std::move(call);
  impl_->engine->set_hooks(calls);
  impl_->hooks = std::move(calls);
}

void World::Calls::step_begin(float dt) {
  begin(dt);
  impl_->engine->send_step();
  impl_->is_stepping = true;
}

StepReport World::Calls::step_end() {
  if (!impl_->is_stepping)
    throw Error(ErrorCode::invalid_argument, "step_end must follow step_begin, and no step was begun");
  impl_->is_stepping = false;
  return finish();
}

DeviceArrays World::device_arrays() const {
  return impl_->run([&](auto w) { return w.device_arrays(); });
}
void World::step_begin(float dt) {
  return impl_->run([&](auto w) { w.step_begin(dt); });
}
StepReport World::step_end() {
  return impl_->run_end_of_step([&](auto w) { return w.step_end(); });
}
void World::set_hook(Hook hook, SubstepCall call) {
  return impl_->run([&](auto w) { w.set_hook(hook, std::move(call)); });
}

}  // namespace meniscus
