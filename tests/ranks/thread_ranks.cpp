// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Messages between threads: a queue for each ordered pair of ranks.
#include "tests/ranks/thread_ranks.h"

#include <meniscus/error.h>

#include <condition_variable>
#include <cstring>
#include <deque>
#include <fstream>
#include <map>
#include <mutex>
#include <utility>

#include "tests/ranks/gpu_copies.h"

namespace meniscus::tests {

namespace {

using pbd::Ranks;
using pbd::Received;
using pbd::Sent;

class PostOffice {
 public:
  void post(int from, int to, const void* data, size_t bytes) {
    const auto* first = static_cast<const std::byte*>(data);
    const std::lock_guard lock(mutex_);
    queues_[{from, to}].emplace_back(first, first + bytes);
    changed_.notify_all();
  }
  std::vector<std::byte> take(int from, int to) {
    std::unique_lock lock(mutex_);
    auto& queue = queues_[{from, to}];
    changed_.wait(lock, [&] { return !queue.empty() || !failure_.empty(); });
    if (!failure_.empty()) throw Error(ErrorCode::lost, failure_);
    std::vector<std::byte> message = std::move(queue.front());
    queue.pop_front();
    return message;
  }
  void fail(int rank, const std::string& why) {
    const std::lock_guard lock(mutex_);
    if (failure_.empty()) failure_ = "rank " + std::to_string(rank) + " failed: " + why;
    changed_.notify_all();
  }
  void expect_no_failure() {
    const std::lock_guard lock(mutex_);
    if (!failure_.empty()) throw Error(ErrorCode::lost, failure_);
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::map<std::pair<int, int>, std::deque<std::vector<std::byte>>> queues_;
  std::string failure_;
};

class ThreadRank final : public Ranks {
 public:
  ThreadRank(std::shared_ptr<PostOffice> office, int rank, int count)
      : office_(std::move(office)), rank_(rank), count_(count) {}

  int rank() const override { return rank_; }
  int count() const override { return count_; }
  void exchange(std::span<const Sent> sent, std::span<const Received> received) override {
    office_->expect_no_failure();
    for (const Sent& s : sent) {
      if (s.bytes) office_->post(rank_, s.to, s.data, s.bytes);
    }
    for (const Received& r : received) {
      if (r.bytes == 0) continue;
      const std::vector<std::byte> message = office_->take(r.from, rank_);
      if (message.size() != r.bytes) {
        const std::string why = "it got " + std::to_string(message.size()) + " bytes from rank " +
                                std::to_string(r.from) + ", and expected " + std::to_string(r.bytes);
        fail(why.c_str());
        office_->expect_no_failure();
      }
      std::memcpy(r.data, message.data(), r.bytes);
    }
  }
  void exchange_on_gpu(std::span<const Sent> sent, std::span<const Received> received, void* stream) override;
  void use_gpu(int) override {}
  void gather_everywhere(std::span<const std::byte> own, std::span<std::byte> all) override;
  void transpose(std::span<const uint32_t> out, std::span<uint32_t> in) override;
  void add_up(std::span<uint64_t> values) override;
  bool write_to_file(const char* path, std::span<const pbd::FilePart> parts) override;
  void fail(const char* why) override { office_->fail(rank_, why); }

 private:
  std::shared_ptr<PostOffice> office_;
  int rank_, count_;
};

void ThreadRank::exchange_on_gpu(std::span<const Sent> sent, std::span<const Received> received,
                                 void* stream) {
  std::deque<std::vector<std::byte>> memory;
  std::vector<Sent> from_host;
  std::vector<Received> to_host;
  for (const Sent& s : sent) {
    memory.emplace_back(s.bytes);
    if (s.bytes) copy_from_gpu(memory.back().data(), s.data, s.bytes, stream);
    from_host.push_back({s.to, memory.back().data(), s.bytes});
  }
  for (const Received& r : received) {
    memory.emplace_back(r.bytes);
    to_host.push_back({r.from, memory.back().data(), r.bytes});
  }
  exchange(from_host, to_host);
  for (size_t k = 0; k < received.size(); ++k) {
    if (received[k].bytes) copy_to_gpu(received[k].data, to_host[k].data, received[k].bytes, stream);
  }
}

// Calls of all ranks are made of messages between two.

void ThreadRank::gather_everywhere(std::span<const std::byte> own, std::span<std::byte> all) {
  std::vector<Sent> sent;
  std::vector<Received> received;
  for (int r = 0; r < count_; ++r) {
    std::byte* const place = all.data() + static_cast<size_t>(r) * own.size();
    if (r == rank_) {
      std::memcpy(place, own.data(), own.size());
    } else {
      sent.push_back({r, own.data(), own.size()});
      received.push_back({r, place, own.size()});
    }
  }
  exchange(sent, received);
}

void ThreadRank::transpose(std::span<const uint32_t> out, std::span<uint32_t> in) {
  std::vector<Sent> sent;
  std::vector<Received> received;
  for (int r = 0; r < count_; ++r) {
    const auto k = static_cast<size_t>(r);
    if (r == rank_) {
      in[k] = out[k];
    } else {
      sent.push_back({r, &out[k], sizeof(uint32_t)});
      received.push_back({r, &in[k], sizeof(uint32_t)});
    }
  }
  exchange(sent, received);
}

void ThreadRank::add_up(std::span<uint64_t> values) {
  std::vector<uint64_t> all(values.size() * static_cast<size_t>(count_));
  gather_everywhere(std::as_bytes(values), std::as_writable_bytes(std::span(all)));
  for (size_t k = 0; k < values.size(); ++k) {
    values[k] = 0;
    for (size_t r = 0; r < static_cast<size_t>(count_); ++r) values[k] += all[r * values.size() + k];
  }
}

bool ThreadRank::write_to_file(const char* path, std::span<const pbd::FilePart> parts) {
  std::fstream file(path, std::ios::binary | std::ios::in | std::ios::out);
  for (const pbd::FilePart& part : parts) {
    file.seekp(static_cast<std::streamoff>(part.offset));
    file.write(static_cast<const char*>(part.data), static_cast<std::streamsize>(part.bytes));
  }
  file.close();
  pbd::is_on_any(*this, false);  // all have written
  return !file.fail();
}

}  // namespace

std::vector<std::unique_ptr<Ranks>> make_thread_ranks(int count) {
  const auto office = std::make_shared<PostOffice>();
  std::vector<std::unique_ptr<Ranks>> ranks;
  for (int r = 0; r < count; ++r) ranks.push_back(std::make_unique<ThreadRank>(office, r, count));
  return ranks;
}

}  // namespace meniscus::tests
