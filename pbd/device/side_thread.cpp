// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The queue and the loop of the side thread.
#include "pbd/device/side_thread.h"

#include <utility>

#include "pbd/device/start_thread.h"

namespace meniscus::pbd {

SideThread::~SideThread() {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
  }
  given_.notify_one();
  thread_.join();
}

void SideThread::run(std::function<void()> task) {
  // A task that no thread takes would be waited for without end. So the thread comes before its first task.
  if (!thread_.joinable()) thread_ = start_thread("the side thread of a step", [this] { work(); });
  {
    const std::lock_guard lock(mutex_);
    tasks_.push_back(std::move(task));
  }
  given_.notify_one();
}

void SideThread::wait() {
  std::unique_lock lock(mutex_);
  done_.wait(lock, [&] { return idle_ && next_ == tasks_.size(); });
  tasks_.clear();
  next_ = 0;
  if (error_) std::rethrow_exception(std::exchange(error_, nullptr));
}

void SideThread::work() {
  std::unique_lock lock(mutex_);
  for (;;) {
    given_.wait(lock, [&] { return ends_ || next_ < tasks_.size(); });
    if (next_ == tasks_.size()) return;
    const std::function<void()> task = std::move(tasks_[next_++]);
    if (!error_) {
      idle_ = false;
      lock.unlock();
      std::exception_ptr error;
      try {
        task();
      } catch (...) {
        error = std::current_exception();
      }
      lock.lock();
      idle_ = true;
      error_ = error;
    }
    if (next_ == tasks_.size()) done_.notify_one();
  }
}

}  // namespace meniscus::pbd
