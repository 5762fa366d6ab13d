// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The only calls of oneTBB, and those of a loop of the user's.
#pragma once

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <meniscus/host.h>

#include <cstdint>

#ifdef __SANITIZE_THREAD__
#include "pbd/device/cpu/plain_threads.h"
#endif

namespace meniscus::pbd {

/// Calls body(begin, end) for ranges of [0, count) of about `grain` elements, concurrently, and waits for
/// all. It runs in the user's loop, if there is one.
template <class Body>
void parallel_loop(const ParallelFor& of_user, tbb::task_arena& arena, uint32_t count, uint32_t grain,
                   const Body& body) {
  if (of_user) return of_user(count, grain, LoopBody(body));
#ifdef __SANITIZE_THREAD__
  run_on_plain_threads(static_cast<uint32_t>(arena.max_concurrency()), count, body);
#else
  arena.execute([&] {
    tbb::parallel_for(tbb::blocked_range<uint32_t>(0, count, grain),
                      [&](const tbb::blocked_range<uint32_t>& range) { body(range.begin(), range.end()); });
  });
#endif
}

}  // namespace meniscus::pbd
