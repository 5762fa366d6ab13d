// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A host thread that runs tasks in order beside the caller.
#pragma once

#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace meniscus::pbd {

/// An additional host thread for work beside the caller's. Tasks run one by one, in the order of the calls.
class SideThread {
 public:
  SideThread() = default;
  ~SideThread();
  SideThread(const SideThread&) = delete;
  SideThread& operator=(const SideThread&) = delete;

  /// Returns at once. The caller must wait() before it accesses data that the task uses. Throws
  /// Error(out_of_memory) if the thread cannot be started. The task then never runs, and wait() returns.
  void run(std::function<void()> task);
  /// Returns when all tasks are done. Rethrows the exception of a task; the tasks after that one do not run.
  void wait();

 private:
  void work();

  std::mutex mutex_;
  std::condition_variable given_, done_;
  std::vector<std::function<void()>> tasks_;  // since the last wait()
  size_t next_ = 0;                           // of these
  bool idle_ = true, ends_ = false;
  std::exception_ptr error_;
  std::thread thread_;  // from the first task on
};

}  // namespace meniscus::pbd
