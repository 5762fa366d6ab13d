// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Watches the call that runs on a device: whether it is to end early, how far it is, and whether it can still
// fail without a trace.
#pragma once

#include <meniscus/error.h>
#include <meniscus/outputs.h>

#include <atomic>
#include <chrono>
#include <cstring>
#include <exception>
#include <functional>

namespace meniscus::pbd {

/// Thrown where a state could neither be changed nor restored. It needs no memory: a long reason is cut.
class StateLost final : public std::exception {
 public:
  StateLost() = default;
  explicit StateLost(const Error& reason) noexcept : code_(reason.code()) {
    std::strncpy(reason_, reason.what(), sizeof reason_ - 1);
  }

  ErrorCode code() const noexcept { return code_; }
  /// Why it could not be restored.
  const char* what() const noexcept override { return reason_; }

 private:
  ErrorCode code_ = ErrorCode::out_of_memory;
  char reason_[256] = "memory ran out on the host";
};

/// A call has two parts. In the first it may fail or be cancelled, and nothing has changed. commit() begins
/// the second, which must not fail: a failure there loses the state.
class CallMonitor {
 public:
  /// Begins a call.
  void begin() noexcept { committed_ = can_be_cancelled_ = false; }
  /// Ends a call. A wish to cancel that came too late is forgotten, if the call could have been cancelled.
  void end() noexcept {
    if (can_be_cancelled_) cancelled_.store(false, std::memory_order_relaxed);
  }

  void commit() noexcept { committed_ = true; }
  /// Takes commit() back, once the state is restored.
  void restored() noexcept { committed_ = false; }
  bool committed() const noexcept { return committed_; }

  /// May be called by any thread and by signal handlers.
  void cancel() noexcept { cancelled_.store(true, std::memory_order_relaxed); }
  /// Whether loops may leave out the rest of their work, because poll() will throw.
  bool stops() const noexcept { return cancellable_ && cancelled_.load(std::memory_order_relaxed); }
  /// Throws Error(cancelled) if the call is to end and its caller can undo what it did.
  void poll() {
    if (stops()) refuse();
  }
  /// The same, and tells the user what is done, and which fraction of it.
  void poll(const char* what, double fraction);
  void set_progress(std::function<void(const Progress&)> report) { report_ = std::move(report); }

  /// While this lives, the call can be cancelled: whoever made it restores the state after an exception.
  class Cancellable {
   public:
    explicit Cancellable(CallMonitor& monitor) noexcept : monitor_(monitor), before_(monitor.cancellable_) {
      monitor_.cancellable_ = monitor_.can_be_cancelled_ = true;
    }
    ~Cancellable() { monitor_.cancellable_ = before_; }
    Cancellable(const Cancellable&) = delete;
    Cancellable& operator=(const Cancellable&) = delete;

   private:
    CallMonitor& monitor_;
    bool before_;
  };

 private:
  [[noreturn]] void refuse();

  std::atomic<bool> cancelled_ = false;
  bool cancellable_ = false, can_be_cancelled_ = false, committed_ = false;
  std::function<void(const Progress&)> report_;
  std::chrono::steady_clock::time_point last_report_{};
};

}  // namespace meniscus::pbd
