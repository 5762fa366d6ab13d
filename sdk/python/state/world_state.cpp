// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Turns of threads, signals while a call runs, and what a scene brings into a world.
#include "sdk/python/state/world_state.h"

namespace meniscus::python {

namespace {

template <class Id, class Def, class Item>
void add_all(Registry<Id, Def>& registry, const std::vector<Id>& ids, const std::vector<Item>& items) {
  for (std::size_t i = 0; i < items.size(); ++i) {
    if constexpr (std::is_convertible_v<Item, Def>)
      registry.add(ids[i], items[i]);
    else
      registry.add(ids[i], items[i].def);
  }
}

}  // namespace

WorldState::WorldState(const WorldDef& def, nb::object stream) : stream_(std::move(stream)), world_(def) {
  listen();
}

WorldState::WorldState(World world, Things things, nb::object stream)
    : Things(std::move(things)), stream_(std::move(stream)), world_(std::move(world)) {
  listen();
}

WorldState::WorldState(BuiltScene built, const Scene& scene)
    : name(scene.name),
      frame_time(scene.frame_time),
      frames(scene.frames),
      camera(scene.camera),
      world_(std::move(built.world)) {
  for (std::size_t i = 0; i < scene.fluids.size(); ++i) fluids.add(built.fluids[i], scene.fluids[i]);
  for (std::size_t i = 0; i < scene.granulars.size(); ++i)
    fluids.add(built.fluids[scene.fluids.size() + i], scene.granulars[i]);
  add_all(shapes, built.shapes, scene.shapes);
  add_all(bodies, built.bodies, bodies_of(scene));
  add_all(joints, built.joints, scene.joints);
  add_all(cloths, built.cloths, scene.cloths);
  add_all(ropes, built.ropes, scene.ropes);
  add_all(attachments, built.attachments, scene.attachments);
  add_all(emitters, built.emitters, scene.emitters);
  add_all(sinks, built.sinks, scene.sinks);
  add_all(probes, built.probes, scene.probes);
  add_all(force_fields, built.force_fields, scene.force_fields);
  listen();
}

WorldState::Turn::Turn(WorldState& state) : state_(state) {
  if (state.caller_.load(std::memory_order_relaxed) == std::this_thread::get_id())
    throw Error(ErrorCode::invalid_argument,
                "a call of this world runs; what it calls may use cancel() of the world alone");
  if (!state.mutex_.try_lock()) {
    const nb::gil_scoped_release released;
    state.mutex_.lock();
  }
  state.caller_ = std::this_thread::get_id();
}

WorldState::Turn::~Turn() {
  state_.caller_ = std::thread::id();
  state_.mutex_.unlock();
}

void WorldState::listen() {
  world_.set_progress([this](const Progress& progress) { report(progress); });
}

void WorldState::report(const Progress& progress) noexcept {
  const nb::gil_scoped_acquire acquired;
  try {
    if (PyErr_CheckSignals() != 0) throw nb::python_error();
    const nb::object function = on_progress;  // it may set another one
    if (function.is_valid() && !function.is_none()) function(progress.what, progress.fraction);
  } catch (const nb::python_error& error) {
    raised_ = std::make_unique<nb::python_error>(error);
    world_.cancel();
  } catch (...) {
    world_.cancel();
  }
}

void WorldState::raise_if_asked() {
  if (const auto raised = std::move(raised_)) throw nb::python_error(*raised);
}

void WorldState::forget_functions() {
  // Moved out first: a function that goes may run code of Python's.
  const nb::object progress = std::exchange(on_progress, nb::object());
  auto calls = std::exchange(hooks, {});
  for (auto& [id, call] : calls) call.clear();
  std::exchange(read_file, {}).clear();
  std::exchange(log, {}).clear();
}

void WorldState::forget_arrays() {
  // Moved out first: an array that goes may run code of Python's.
  const auto gone = std::exchange(particle_arrays_, {});
  const auto gone_too = std::exchange(owned_arrays_, {});
}

}  // namespace meniscus::python
