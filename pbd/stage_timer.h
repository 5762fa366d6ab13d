// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Measures the device time of each stage of a step.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "pbd/device/device.h"

namespace meniscus::pbd {

enum class StageId { predict, neighbours, contacts, solve, velocity, exchange, finish };
inline constexpr size_t stage_ids = 7;

/// Divides the device's time among the stages of a step.
class StageTimer {
 public:
  explicit StageTimer(Device& device) : device_(device) {}

  void start_step() { marks_.clear(); }
  /// Later launches belong to `stage`.
  void enter(StageId stage) {
    device_.mark_time(static_cast<uint32_t>(marks_.size()));
    marks_.push_back(stage);
  }
  /// The same, if the host turns to other work before it launches anything. The first launch notes the second
  /// mark; with one mark alone, it would wait for a launch.
  void enter_now(StageId stage) {
    enter(stage);
    enter(stage);
    device_.send_off();
  }
  /// Ends the step; the device must be idle before read_ms() is called.
  void stop() { device_.mark_time(static_cast<uint32_t>(marks_.size())); }

  std::array<double, stage_ids> read_ms() const {
    std::array<double, stage_ids> total{};
    for (uint32_t i = 0; i < marks_.size(); ++i)
      total[static_cast<size_t>(marks_[i])] += device_.elapsed_ms(i, i + 1);
    return total;
  }

 private:
  Device& device_;
  std::vector<StageId> marks_;
};

}  // namespace meniscus::pbd
