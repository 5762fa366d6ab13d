// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The boundary of World. Every public call passes Impl::run, where failures for lack of memory become errors.
#pragma once

#include <meniscus/error.h>

#include <new>
#include <string>
#include <utility>

#include "pbd/device/choose.h"
#include "pbd/host_memory.h"
#include "sdk/world/check/shared.h"
#include "sdk/world/world_calls.h"

namespace meniscus {

namespace world_errors {

// Made when the program starts, since there may be no memory for them later. Their copies take none.

inline const Error lost_now(
    ErrorCode::out_of_memory,
    "memory ran out on the host while the world changed; the world is lost, and only its "
    "destruction is possible");
inline const Error lost_before(
    ErrorCode::lost, "the world was lost when an earlier call failed; only its destruction is possible");

}  // namespace world_errors

/// Runs a call on the world without what was removed before. An exception leaves the world as it was, or
/// lost.
template <class Call>
decltype(auto) World::Impl::run(const Call& call, const char* name) {
  return run_removal(
      [&](Calls calls) -> decltype(auto) {
        settle();
        return call(calls);
      },
      name);
}

/// Runs the call that ends a step: nothing was removed since it began.
template <class Call>
decltype(auto) World::Impl::run_end_of_step(const Call& call) {
  const bool was_stepping = std::exchange(is_stepping, false);
  return run_removal([&](Calls calls) -> decltype(auto) {
    is_stepping = was_stepping;
    return call(calls);
  });
}

/// Runs a call that may find removals that are still to be carried out.
template <class Call>
decltype(auto) World::Impl::run_removal(const Call& call, const char* name) {
  if (lost) throw Error(world_errors::lost_before);
  if (shared_by) check::allowed_when_shared(name, shared_by);
  if (is_stepping)
    throw Error(ErrorCode::invalid_argument,
                std::string(name) +
                    " was called between step_begin and step_end, where only cancel and "
                    "set_progress are allowed");
  const pbd::CudaScope scope(device.kind == "cuda" ? engine->ordinal() : -1);
  pbd::CallMonitor& monitor = engine->device().monitor();
  struct Running {
    explicit Running(pbd::CallMonitor& begun) : monitor(begun) { monitor.begin(); }
    ~Running() { monitor.end(); }
    pbd::CallMonitor& monitor;
  } const running(monitor);
  try {
    if (holds_back && !check::needs_no_particles(name)) {
      engine->release();
      holds_back = false;
    }
    return call(Calls{this});
  } catch (const pbd::StateLost& loss) {
    lost = true;
    if (loss.code() == ErrorCode::out_of_memory) throw Error(world_errors::lost_now);
    throw Error(loss.code(),
                "the world is lost, and only its destruction is possible: " + std::string(loss.what()));
  } catch (const std::bad_alloc&) {
    lost = monitor.committed() || rigid.is_broken();
    throw Error(lost ? world_errors::lost_now : pbd::no_host_memory);
  } catch (...) {
    lost = monitor.committed() || rigid.is_broken();
    throw;
  }
}

}  // namespace meniscus
