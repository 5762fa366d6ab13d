// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Ranks of which one does something at one of its calls.
#pragma once

#include <functional>
#include <utility>

#include "pbd/ranks/ranks.h"

namespace meniscus::tests {

/// Passes all calls on to others. Before call number `at` of this rank, from 1 on, it calls act(); or before
/// it writes to a file.
class FailingRanks final : public pbd::Ranks {
 public:
  static constexpr int in_file = -1;

  FailingRanks(pbd::Ranks& ranks, int at, std::function<void()> act)
      : ranks_(ranks), left_(at), act_(std::move(act)) {}

  int rank() const override { return ranks_.rank(); }
  int count() const override { return ranks_.count(); }
  void exchange(std::span<const pbd::Sent> sent, std::span<const pbd::Received> received) override {
    note_call();
    ranks_.exchange(sent, received);
  }
  void exchange_on_gpu(std::span<const pbd::Sent> sent, std::span<const pbd::Received> received,
                       void* stream) override {
    note_call();
    ranks_.exchange_on_gpu(sent, received, stream);
  }
  void use_gpu(int ordinal) override { ranks_.use_gpu(ordinal); }
  void gather_everywhere(std::span<const std::byte> own, std::span<std::byte> all) override {
    note_call();
    ranks_.gather_everywhere(own, all);
  }
  void transpose(std::span<const uint32_t> out, std::span<uint32_t> in) override {
    note_call();
    ranks_.transpose(out, in);
  }
  void add_up(std::span<uint64_t> values) override {
    note_call();
    ranks_.add_up(values);
  }
  bool write_to_file(const char* path, std::span<const pbd::FilePart> parts) override {
    if (left_ < 0) act_();
    return ranks_.write_to_file(path, parts);
  }
  void fail(const char* why) override { ranks_.fail(why); }

 private:
  void note_call() {
    if (left_ > 0 && --left_ == 0) act_();
  }

  pbd::Ranks& ranks_;
  int left_;
  std::function<void()> act_;
};

}  // namespace meniscus::tests
