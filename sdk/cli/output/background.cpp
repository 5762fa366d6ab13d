// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The thread that does tasks beside the run.
#include "sdk/cli/output/background.h"

#include <system_error>
#include <utility>

namespace meniscus::cli {

Background::~Background() {
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
  }
  changed_.notify_all();
  if (thread_.joinable()) thread_.join();
}

void Background::add(std::function<void()> task) {
  if (!has_thread()) return do_here(task);
  {
    const std::lock_guard lock(mutex_);
    tasks_.push_back(std::move(task));
  }
  changed_.notify_all();
}

bool Background::has_thread() {
  if (thread_.joinable()) return true;
  try {
    thread_ = std::thread([this] { work(); });
  } catch (const std::system_error&) {
    return false;
  }
  return true;
}

void Background::do_here(const std::function<void()>& task) {
  if (failure_) return;
  try {
    task();
  } catch (...) {
    failure_ = std::current_exception();
  }
}

void Background::wait_until_fewer_than(std::size_t tasks) {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return tasks_.size() < tasks || failure_; });
  if (failure_) std::rethrow_exception(failure_);
}

void Background::work() {
  std::unique_lock lock(mutex_);
  for (;;) {
    changed_.wait(lock, [&] { return !tasks_.empty() || ends_; });
    if (tasks_.empty() || failure_) return;
    const std::function<void()>& task = tasks_.front();  // a deque moves no element when another is added
    lock.unlock();
    std::exception_ptr failure;
    try {
      task();
    } catch (...) {
      failure = std::current_exception();
    }
    lock.lock();
    if (failure) {
      failure_ = failure;
      tasks_.clear();
    } else {
      tasks_.pop_front();
    }
    changed_.notify_all();
  }
}

}  // namespace meniscus::cli
