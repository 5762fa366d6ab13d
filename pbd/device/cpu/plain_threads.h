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

/// Calls body(begin, end) for one range of [0, count) for each thread, of which the caller is the first, and
/// waits for all. It avoids std::thread, which allocates. If a thread cannot be started, it waits for those
/// before it, which use the caller's stack, and throws Error(out_of_memory).
template <class Body>
void run_on_plain_threads(uint32_t threads, uint32_t count, const Body& body) {
  constexpr uint32_t most = 64;
  ThreadPiece<Body> pieces[most];
  pthread_t handles[most];
  const uint32_t n = std::min({threads, most, count});
  if (n == 0) return;
  for (uint32_t k = 0; k < n; ++k)
    pieces[k] = {&body, static_cast<uint32_t>(uint64_t{count} * k / n),
                 static_cast<uint32_t>(uint64_t{count} * (k + 1) / n)};
  uint32_t started = 1;
  while (started < n &&
         pthread_create(&handles[started], nullptr, ThreadPiece<Body>::run, &pieces[started]) == 0)
    ++started;
  if (started == n) ThreadPiece<Body>::run(&pieces[0]);
  for (uint32_t k = 1; k < started; ++k) pthread_join(handles[k], nullptr);
  if (started < n) throw Error(ErrorCode::out_of_memory, "a thread could not be started");
}

}  // namespace meniscus::pbd
