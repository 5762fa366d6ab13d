// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Notices that a process of MPI hangs while others wait for it.
#include "sdk/ranks/watchdog.h"

#include <algorithm>

namespace meniscus {

namespace {

/// Messages of a rank within the limit.
constexpr int beats = 8;

std::string in_seconds(Watchdog::Clock::duration time) {
  return std::to_string(std::chrono::duration_cast<std::chrono::seconds>(time).count()) + " s";
}

}  // namespace

Watchdog::Watchdog(double limit)
    : limit_(std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(limit))) {
  if (!(limit > 0)) return;
  int count = 1;
  MPI_Comm_dup(MPI_COMM_WORLD, &comm_);
  MPI_Comm_rank(comm_, &rank_);
  MPI_Comm_size(comm_, &count);
  peers_ = std::vector<Peer>(static_cast<size_t>(count));
  for (Peer& peer : peers_) peer.heard = Clock::now().time_since_epoch().count();
  for (int r = 0; r < count; ++r) {
    if (r != rank_) hear(r);
  }
  thread_ = std::thread([this] { run(); });
}

Watchdog::~Watchdog() {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    stops_ = true;
  }
  stopped_.notify_all();
  thread_.join();
  MPI_Barrier(comm_);  // nobody sends any more
  for (Peer& peer : peers_) {
    if (peer.receiving != MPI_REQUEST_NULL) {
      MPI_Cancel(&peer.receiving);
      MPI_Wait(&peer.receiving, MPI_STATUS_IGNORE);
    }
    MPI_Wait(&peer.sending, MPI_STATUS_IGNORE);
  }
  MPI_Comm_free(&comm_);
}

void Watchdog::wait_for(std::span<MPI_Request> requests, const std::function<void(const char*)>& fail) {
  ++call_;
  const Clock::time_point start = Clock::now();
  constexpr int polls = 256;  // between two looks at the clock
  for (int k = 1;; ++k) {
    int done = 0;
    MPI_Testall(static_cast<int>(requests.size()), requests.data(), &done, MPI_STATUSES_IGNORE);
    if (done) return;
    std::this_thread::yield();
    if (k % polls || !thread_.joinable()) continue;
    const Clock::duration waited = Clock::now() - start;
    if (waited < limit_) continue;
    if (const std::string why = missing(waited); !why.empty()) return fail(why.c_str());
  }
}

/// What to say of the ranks that others wait for in vain; nothing if the wait may go on.
std::string Watchdog::missing(Clock::duration waited) const {
  std::string silent, late;
  const auto add = [](std::string& list, size_t r) {
    list += (list.empty() ? "rank " : ", rank ") + std::to_string(r);
  };
  for (size_t r = 0; r < peers_.size(); ++r) {
    if (static_cast<int>(r) == rank_) continue;
    if (silence(peers_[r]) >= limit_) add(silent, r);
    if (peers_[r].call < call_) add(late, r);
  }
  if (!silent.empty()) return silent + " did not arrive and has said nothing for " + in_seconds(limit_);
  if (waited < busy_limits * limit_) return {};
  return (late.empty() ? "another rank" : late) + " did not arrive for " + in_seconds(waited);
}

Watchdog::Clock::duration Watchdog::silence(const Peer& peer) const {
  return Clock::now() - Clock::time_point(Clock::duration(peer.heard));
}

void Watchdog::run() {
  std::unique_lock lock(mutex_);
  while (!stopped_.wait_for(lock, limit_ / beats, [&] { return stops_; })) tell_and_hear();
}

void Watchdog::tell_and_hear() {
  for (int r = 0; r < static_cast<int>(peers_.size()); ++r) {
    if (r == rank_) continue;
    Peer& peer = peers_[static_cast<size_t>(r)];
    int done = 0;
    for (MPI_Test(&peer.receiving, &done, MPI_STATUS_IGNORE); done;
         MPI_Test(&peer.receiving, &done, MPI_STATUS_IGNORE)) {
      peer.call = peer.received;
      peer.heard = Clock::now().time_since_epoch().count();
      hear(r);
    }
    MPI_Test(&peer.sending, &done, MPI_STATUS_IGNORE);
    if (!done) continue;
    peer.sent = call_;
    MPI_Isend(&peer.sent, 1, MPI_UINT64_T, r, 0, comm_, &peer.sending);
  }
}

void Watchdog::hear(int rank) {
  Peer& peer = peers_[static_cast<size_t>(rank)];
  MPI_Irecv(&peer.received, 1, MPI_UINT64_T, rank, 0, comm_, &peer.receiving);
}

}  // namespace meniscus
