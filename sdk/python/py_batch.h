// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A batch of worlds as Python holds it.
#pragma once

#include <memory>
#include <mutex>
#include <utility>

#include "sdk/python/batch.h"
#include "sdk/python/state/known_things.h"

namespace meniscus::python {

/// One thread at a time calls the batch. Others of Python go on.
class PyBatch {
 public:
  PyBatch(const PyWorld& archetype, uint32_t worlds, int rigid_threads)
      : things_(*archetype.state), batch_(archetype.state->measure([&](World& w) {
          return std::make_shared<WorldBatch>(w, BatchDef{worlds, rigid_threads});
        })) {}

  template <class Call>
  decltype(auto) run(const Call& call) const {
    const nb::gil_scoped_release released;
    return run_released(call);
  }
  /// The same for a caller that has let others of Python go on.
  template <class Call>
  decltype(auto) run_released(const Call& call) const {
    const std::lock_guard lock(*mutex_);
    return call(*batch_);
  }
  std::shared_ptr<void> owner() const { return batch_; }
  /// Of the archetype.
  const Things& things() const { return things_; }

  PyWorld extract(uint32_t number) const {
    World world = run([&](WorldBatch& b) { return b.extract(number); });
    Things things = things_of(world, things_);
    return {std::make_shared<WorldState>(std::move(world), std::move(things), nb::object())};
  }

 private:
  Things things_;
  std::shared_ptr<WorldBatch> batch_;
  std::shared_ptr<std::mutex> mutex_ = std::make_shared<std::mutex>();
};

/// Adds what is about bodies.
void bind_batch_bodies(nb::class_<PyBatch>& batch);
/// Adds contacts and events.
void bind_batch_events(nb::class_<PyBatch>& batch);

}  // namespace meniscus::python
