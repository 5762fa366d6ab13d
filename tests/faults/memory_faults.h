// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Runs the coupled scene while its allocations fail, and compares it with a run without failures.
#pragma once

#include <gtest/gtest.h>
#include <meniscus/meniscus.h>

#include <map>
#include <memory>
#include <string>
#include <typeinfo>
#include <vector>

#include "tests/faults/coupled_scene.h"
#include "tests/faults/failing_memory.h"

namespace meniscus::tests {

struct FaultCounts {
  int failures = 0, losses = 0;
};

/// Makes the calls of a scene one after another. Each is repeated, with one failure each time, until none is
/// left.
class FaultRun {
 public:
  FaultRun(pbd::DeviceKind device, int steps) : device_(device), calls_(coupled_calls(steps)) { restart(0); }

  /// The hash of a world without failures after each call.
  void run_without_failures() {
    hashes_.clear();
    for (const SceneCall& call : calls_) {
      call.make(*world_, ids_);
      hashes_.push_back(world_->state_hash());
    }
  }

  /// `stride` = 0: each call stack fails once. Else every stride-th allocation of a call does. The scene is
  /// run again and again, as a call that succeeds in spite of a failure is over, until all have failed.
  void run(uint64_t stride, bool and_all_after) {
    std::vector<uint64_t> next(calls_.size(), stride);
    for (bool any = true; any && !testing::Test::HasFailure();) {
      any = false;
      restart(0);
      for (size_t k = 0; k < calls_.size() && !testing::Test::HasFailure(); ++k) {
        Outcome outcome{};
        do {
          outcome = attempt(k, {next[k], and_all_after});
          if (outcome != Outcome::without_failure) next[k] += stride;
        } while (outcome == Outcome::error && !testing::Test::HasFailure());
        any |= outcome == Outcome::in_spite_of_failure;
        EXPECT_EQ(world_->state_hash(), hashes_[k]) << "after " << calls_[k].name;
        if (testing::Test::HasFailure()) print_last_stack();
      }
    }
  }

  const FaultCounts& counts() const { return counts_; }
  /// How often each call lost the world.
  const std::map<std::string, int>& losses() const { return losses_; }

 private:
  enum class Outcome { error, in_spite_of_failure, without_failure };

  Outcome attempt(size_t k, const FailureChoice& choice) {
    const uint64_t before = world_->state_hash();
    const size_t particles = world_->particle_count();
    const SceneIds ids = ids_;
    bool fails = false, succeeds = true;
    std::string other;
    const std::function<void()> call = calls_[k].prepare(*world_, ids_);
    {
      const FailingMemory failing(choice);
      try {
        call();
      } catch (const Error& error) {
        succeeds = false;
        caught_ = error;
      } catch (const std::exception& error) {
        succeeds = false;
        caught_ = Error(ErrorCode::io, "");
        other = typeid(error).name();
      }
      fails = failing.has_failed();
    }
    EXPECT_TRUE(fails || succeeds) << calls_[k].name << ": " << caught_.what() << other;
    counts_.failures += fails;
    if (succeeds) return fails ? Outcome::in_spite_of_failure : Outcome::without_failure;
    ids_ = ids;
    EXPECT_EQ(static_cast<int>(caught_.code()), static_cast<int>(ErrorCode::out_of_memory))
        << calls_[k].name << ": " << caught_.what() << " " << other;
    if (is_lost()) {
      ++counts_.losses;
      losses_[calls_[k].name] += 1;
      restart(k);
    } else {
      EXPECT_EQ(world_->state_hash(), before) << calls_[k].name;
      EXPECT_EQ(world_->particle_count(), particles) << calls_[k].name;
    }
    if (testing::Test::HasFailure()) print_last_stack();
    return Outcome::error;
  }

  bool is_lost() {
    try {
      world_->time();
    } catch (const Error& error) {
      EXPECT_EQ(static_cast<int>(error.code()), static_cast<int>(ErrorCode::lost)) << error.what();
      return true;
    }
    return false;
  }

  /// Makes the world anew, with the calls before the k-th.
  void restart(size_t k) {
    world_.reset();
    world_ = std::make_unique<World>(coupled_world(device_));
    ids_ = {};
    for (size_t call = 0; call < k; ++call) calls_[call].make(*world_, ids_);
  }

  pbd::DeviceKind device_;
  std::vector<SceneCall> calls_;
  std::unique_ptr<World> world_;
  SceneIds ids_;
  std::vector<uint64_t> hashes_;
  FaultCounts counts_;
  std::map<std::string, int> losses_;
  Error caught_{ErrorCode::lost, ""};
};

}  // namespace meniscus::tests
