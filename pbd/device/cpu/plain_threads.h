// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Replaces oneTBB in a build with the thread sanitizer. oneTBB is not instrumented, so the sanitizer would
// miss its synchronisation and report every loop as a race. Plain threads are instrumented.
#pragma once

#include <pthread.h>

#include <algorithm>
#include <cstdint>

#include <meniscus/error.h>

namespace meniscus::pbd {

template <class Body>
struct ThreadPiece {
  const Body* body;
  uint32_t begin, end;

  static void* run(void* piece) {
    const auto* p = static_cast<const ThreadPiece*>(piece);
    (*p->body)(p->begin, p->end);
    return nullptr;
  }
};

/// Calls body(begin, end) for one range of [0, count) for each thread, and waits for all. It avoids
/// std::thread, which allocates. If a thread cannot be started, it waits for those before it, which use the
/// caller's stack, and throws Error(out_of_memory).
template <class Body>
void run_on_plain_threads(uint32_t threads, uint32_t count, const Body& body) {
  constexpr uint32_t most = 64;
  ThreadPiece<Body> pieces[most];
  pthread_t handles[most];
  const uint32_t n = std::min({threads, most, count});
  uint32_t started = 0;
  for (; started < n; ++started) {
    const uint32_t k = started;
    const auto end_of = [&](uint32_t piece) { return static_cast<uint32_t>(uint64_t{count} * piece / n); };
    pieces[k] = {&body, end_of(k), end_of(k + 1)};
    if (pthread_create(&handles[k], nullptr, ThreadPiece<Body>::run, &pieces[k]) != 0) break;
  }
  for (uint32_t k = 0; k < started; ++k) pthread_join(handles[k], nullptr);
  if (started < n) throw Error(ErrorCode::out_of_memory, "a thread could not be started");
}

}  // namespace meniscus::pbd
