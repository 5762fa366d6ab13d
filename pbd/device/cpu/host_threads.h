// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Host threads for work that is on no device, such as that of many rigid worlds.
#pragma once

#include <meniscus/host.h>

#include <cstdint>
#include <functional>
#include <memory>

namespace meniscus::pbd {

class HostThreads {
 public:
  /// So many threads, or one for each core; or those of the user's loop, if there is one.
  explicit HostThreads(int threads = 0, ParallelFor loop = {});
  ~HostThreads();
  HostThreads(const HostThreads&) = delete;
  HostThreads& operator=(const HostThreads&) = delete;

  /// Calls work(i) for each i below `count`, concurrently, and waits for all. Then rethrows the exception of
  /// the lowest i that threw.
  void for_each(uint32_t count, const std::function<void(uint32_t)>& work);

 private:
  struct Arena;
  std::unique_ptr<Arena> arena_;
  ParallelFor loop_;
};

}  // namespace meniscus::pbd
