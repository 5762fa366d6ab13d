// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// World's calls that let others work with its device: arrays there, steps in two halves, and hooks.
#include <atomic>
#include <utility>

#include "sdk/world/check/check.h"
#include "sdk/world/world_boundary.h"

namespace meniscus {

namespace {

/// Makes room for an array, unless the memory of the last one serves and nobody else holds it.
void make_room(DeviceArray& array, Engine& engine, ElementType type, size_t count, int columns) {
  const size_t element = type == ElementType::uint64 ? 8 : 4, bytes = count * size_t(columns) * element;
  const bool fits = array.memory.use_count() == 1 && array.shape[0] == static_cast<int64_t>(count);
  std::atomic_thread_fence(std::memory_order_acquire);  // the last holder may have been on another thread
  if (!fits) {
    array.memory.reset();
    if (bytes) array.memory = engine.allocate_lasting(bytes);
  }
  array.data = array.memory.get();
  array.type = type;
  array.dimensions = columns > 1 ? 2 : 1;
  array.shape = {static_cast<int64_t>(count), columns, 1};
  array.strides = {columns, 1, 1};
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

/// Gives the engine one call for each hook, which makes those of the user in order.
void World::Impl::set_hooks(std::vector<HookEntry> all) {
  HookCalls calls;
  for (uint32_t k = 0; k < hook_count; ++k) {
    std::vector<SubstepCall> of_hook;
    for (const HookEntry& entry : all) {
      if (entry.hook == static_cast<Hook>(k)) of_hook.push_back(entry.call);
    }
    if (of_hook.empty()) continue;
    calls[k] = [of_hook = std::move(of_hook)](const SubstepView& view) {
      for (const SubstepCall& call : of_hook) call(view);
    };
  }
  engine->set_hooks(calls);
  hooks = std::move(all);
}

void World::Impl::take_callbacks(const Impl& other) {
  run([&](auto) {
    set_hooks(other.hooks);
    progress = other.progress;
    monitor().set_progress(progress);
  });
}

HookId World::Calls::add_hook(Hook hook, SubstepCall call) {
  const auto number = static_cast<uint32_t>(hook);
  if (number >= hook_count)
    throw Error(ErrorCode::invalid_argument,
                "add_hook got the hook " + std::to_string(number) + "; there are 0 to 4");
  if (!call) throw Error(ErrorCode::invalid_argument, "add_hook got an empty call");
  std::vector<HookEntry> all = impl_->hooks;
  const auto id = static_cast<HookId>(impl_->next_hook);
  all.push_back({id, hook, std::move(call), impl_->world_number});
  impl_->set_hooks(std::move(all));
  ++impl_->next_hook;
  if (impl_->recorder) impl_->warn_of_hooks();
  return id;
}

void World::Calls::remove_hook(HookId id) {
  std::vector<HookEntry> all = impl_->hooks;
  if (std::erase_if(all, [&](const HookEntry& entry) { return entry.id == id; }) == 0)
    throw Error(ErrorCode::not_found, "no hook has the id " + std::to_string(static_cast<uint64_t>(id)));
  impl_->set_hooks(std::move(all));
}

void World::Calls::step_begin(float dt, std::optional<int> iterations) {
  begin(dt, iterations);
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
void World::step_begin(float dt, std::optional<int> iterations) {
  return impl_->run([&](auto w) { w.step_begin(dt, iterations); });
}
StepReport World::step_end() {
  const StepReport report = impl_->run_end_of_step([&](auto w) { return w.step_end(); });
  impl_->note_step(impl_->begun_step, report);
  return report;
}
HookId World::add_hook(Hook hook, SubstepCall call) {
  return impl_->run([&](auto w) { return w.add_hook(hook, std::move(call)); });
}
void World::remove_hook(HookId id) {
  return impl_->run([&](auto w) { w.remove_hook(id); });
}

}  // namespace meniscus
