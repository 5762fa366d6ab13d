// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The command `meniscus replay`.
#pragma once

#include <optional>
#include <string>

namespace meniscus::cli {

struct ReplayOptions {
  std::string file;
  std::string device;          ///< auto, cpu or cuda; empty: as recorded
  std::optional<int> threads;  ///< of the CPU device; left out, as recorded
  bool json = false;           ///< prints JSON
};

/// Repeats a recording, and prints how many steps have the recorded hash. Returns check_broken if a step on
/// the recorded kind of device has another one. Throws Error for bad input.
int replay_recording(const ReplayOptions& options);

}  // namespace meniscus::cli
