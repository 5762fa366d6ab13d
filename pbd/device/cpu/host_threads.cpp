// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Functions of HostThreads.
#include "pbd/device/cpu/host_threads.h"

#include <tbb/info.h>

#include <exception>
#include <mutex>
#include <utility>

#include "pbd/device/cpu/parallel_loop.h"

namespace meniscus::pbd {

struct HostThreads::Arena {
  tbb::task_arena threads;
};

HostThreads::HostThreads(int threads, ParallelFor loop)
    : arena_(new Arena{tbb::task_arena(threads > 0 ? threads : tbb::info::default_concurrency())}),
      loop_(std::move(loop)) {}

HostThreads::~HostThreads() = default;

void HostThreads::for_each(uint32_t count, const std::function<void(uint32_t)>& work) {
  std::mutex mutex;
  std::exception_ptr error;
  uint32_t failed = count;
  parallel_loop(loop_, arena_->threads, count, 1, [&](uint32_t begin, uint32_t end) {
    for (uint32_t i = begin; i < end; ++i) {
      try {
        work(i);
      } catch (...) {
        const std::lock_guard lock(mutex);
        if (i < failed) {
          failed = i;
          error = std::current_exception();
        }
      }
    }
  });
  if (error) std::rethrow_exception(error);
}

}  // namespace meniscus::pbd
