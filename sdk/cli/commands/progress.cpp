// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Prints the progress of a run.
#include "sdk/cli/commands/progress.h"

#include <spdlog/spdlog.h>
#include <unistd.h>

#include <cstdio>

namespace meniscus::cli {
namespace {

std::string clock_text(double seconds) {
  const auto s = static_cast<long>(seconds + 0.5);
  if (s < 3600) return fmt::format("{}:{:02}", s / 60, s % 60);
  return fmt::format("{}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60);
}

std::string bar_text(double done) {
  constexpr int width = 20;
  const int full = static_cast<int>(done * width);
  return std::string(static_cast<std::size_t>(full), '#') +
         std::string(static_cast<std::size_t>(width - full), '.');
}

}  // namespace

Progress::Progress(int frames, bool quiet)
    : frames_(frames), quiet_(quiet), terminal_(isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
  if (drawn_) fmt::print(stderr, "\n");
}

void Progress::show(int frame, double step_ms, std::optional<double> density_error_mean) {
  if (quiet_) return;
  const std::chrono::duration<double> elapsed = Clock::now() - start_;
  std::string facts = fmt::format("{}/{}  {:.1f} ms/step  {} left", frame, frames_, step_ms,
                                  clock_text(elapsed.count() / frame * (frames_ - frame)));
  if (density_error_mean) facts += fmt::format("  density error {:.2f} %", 100 * *density_error_mean);
  terminal_ ? show_bar(frame, facts) : show_line(frame, facts);
}

void Progress::show_bar(int frame, const std::string& facts) {
  const auto now = Clock::now();
  if (frame < frames_ && drawn_ && now - last_ < std::chrono::milliseconds(50)) return;
  last_ = now;
  drawn_ = true;
  fmt::print(stderr, "\r[{}] {}\033[K", bar_text(static_cast<double>(frame) / frames_), facts);
  std::fflush(stderr);
}

void Progress::show_line(int frame, const std::string& facts) {
  const auto now = Clock::now();
  const int tenths = static_cast<int>(10.0 * frame / frames_);
  if (tenths == lines_ && now - last_ < std::chrono::seconds(10)) return;
  lines_ = tenths;
  last_ = now;
  spdlog::info("frame {}", facts);
}

}  // namespace meniscus::cli
