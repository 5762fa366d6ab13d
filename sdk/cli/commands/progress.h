// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The progress of a run, on stderr.
#pragma once

#include <chrono>
#include <optional>
#include <string>

namespace meniscus::cli {

/// Prints the progress of a run on stderr: one line that is redrawn on a terminal, otherwise a line now and
/// then.
class Progress {
 public:
  Progress(int frames, bool quiet);
  /// Ends the line on a terminal.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Call it after each frame. The density error is a fraction; without fluid there is none.
  void show(int frame, double step_ms, std::optional<double> density_error_mean);

 private:
  using Clock = std::chrono::steady_clock;

  void show_bar(int frame, const std::string& facts);
  void show_line(int frame, const std::string& facts);

  int frames_;
  bool quiet_, terminal_;
  bool drawn_ = false;
  int lines_ = 0;  // tenths of the run that have been printed
  Clock::time_point start_ = Clock::now(), last_ = start_;
};

}  // namespace meniscus::cli
