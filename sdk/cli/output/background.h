// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Work that is done beside the run, in order, on a thread of its own.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>

namespace meniscus::cli {

/// Does tasks one after another on a thread of its own. At most `room` are unfinished: a caller waits, and no
/// task is left out. What a task throws is thrown to the caller at its next call, and the tasks after it are
/// not done. All calls are from one thread. Where the system has no thread to give, add() does the task
/// itself.
class Background {
 public:
  explicit Background(std::size_t room) : room_(room) {}
  /// Does what is left. What it throws is lost: call finish() before.
  ~Background();
  Background(const Background&) = delete;
  Background& operator=(const Background&) = delete;

  /// Waits until another task may be added. Throws what a task has thrown.
  void wait_for_room() { wait_until_fewer_than(room_); }
  /// Call wait_for_room() before.
  void add(std::function<void()> task);
  /// Waits for all tasks. Throws what a task has thrown.
  void finish() { wait_until_fewer_than(1); }

 private:
  void wait_until_fewer_than(std::size_t tasks);
  /// Starts the thread if there is none. Returns whether there is one.
  bool has_thread();
  void do_here(const std::function<void()>& task);
  void work();

  std::size_t room_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::function<void()>> tasks_;  // the first one may be running
  std::exception_ptr failure_;
  bool ends_ = false;
  std::thread thread_;  // from the first task on
};

}  // namespace meniscus::cli
