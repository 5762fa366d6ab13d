// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace meniscus::pbd {

/// One more thread of the host, for what can go on while the caller does something else: tasks are done one
/// by one, in the order in which they were given.
class SideThread {
 public:
  SideThread() = default;
  ~SideThread();
  SideThread(const SideThread&) = delete;
  SideThread& operator=(const SideThread&) = delete;

  /// Returns at once. Whoever gives a task must wait() for it before it touches what the task does.
  void run(std::function<void()> task);
  /// Returns when all tasks are done. Throws what one of them threw; those behind that one are left out.
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
