// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Notices that a process of MPI hangs while others wait for it.
#pragma once

#include <mpi.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <span>
#include <string>
#include <thread>
#include <vector>

namespace meniscus {

/// Each rank counts its calls. A thread of each tells the others several times within a time limit how far it
/// is. A wait ends in a failure if it has lasted for the limit, and
///   - a rank has said nothing for that long: its process has stopped, or
///   - it has lasted `busy_limits` limits: a rank lives, but does not arrive. Rank 0 may be busy for long, as
///     when it writes pictures.
class Watchdog {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr int busy_limits = 30;

  /// `limit` in s; 0: none. MPI must allow calls of several threads at once. All ranks make it together.
  explicit Watchdog(double limit);
  ~Watchdog();
  Watchdog(const Watchdog&) = delete;
  Watchdog& operator=(const Watchdog&) = delete;

  /// Waits for the requests of one call. It calls fail(why) if a rank does not arrive.
  void wait_for(std::span<MPI_Request> requests, const std::function<void(const char*)>& fail);

 private:
  struct Peer {
    uint64_t sent = 0, received = 0;  // numbers of calls, in messages
    MPI_Request sending = MPI_REQUEST_NULL, receiving = MPI_REQUEST_NULL;
    std::atomic<uint64_t> call{0};
    std::atomic<Clock::rep> heard{0};
  };
  void run();
  void tell_and_hear();
  void hear(int rank);
  std::string missing(Clock::duration waited) const;
  Clock::duration silence(const Peer& peer) const;

  Clock::duration limit_;
  int rank_ = 0;
  MPI_Comm comm_ = MPI_COMM_NULL;
  std::vector<Peer> peers_;
  std::atomic<uint64_t> call_{0};
  std::mutex mutex_;
  std::condition_variable stopped_;
  bool stops_ = false;
  std::thread thread_;  // last: it uses the others
};

}  // namespace meniscus
