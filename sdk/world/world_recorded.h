// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The boundary for calls that recordings contain.
#pragma once

#include "sdk/world/recording/call_text.h"
#include "sdk/world/world_boundary.h"

namespace meniscus {

namespace recording {

/// Calls run(), and notes the call where it succeeds. Arguments are encoded before, since the call may change
/// what they refer to.
template <class Run, class... Args>
auto noted(Recorder* recorder, uint32_t first_generation, const char* name, const Run& run,
           const Args&... args) {
  if (!recorder) return run();
  const std::vector<uint8_t> call = pbd::with_host_memory(
      [&] { return call_text::encoded(name, call_text::Ids{first_generation}, args...); });
  if constexpr (std::is_void_v<decltype(run())>) {
    run();
    recorder->write(RecordKind::call, call);
  } else {
    auto result = run();
    recorder->write(RecordKind::call, call);
    return result;
  }
}

}  // namespace recording

template <class Call, class... Args>
auto World::Impl::recorded(const RecordedAs& as, const Call& call, const Args&... args) {
  return recording::noted(
      recorder.get(), first_generation, as.name, [&] { return run(call, as.call); }, args...);
}

template <class Call, class... Args>
auto World::Impl::recorded_removal(const RecordedAs& as, const Call& call, const Args&... args) {
  return recording::noted(
      recorder.get(), first_generation, as.name, [&] { return run_removal(call, as.call); }, args...);
}

}  // namespace meniscus
