// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Functions of CallMonitor.
#include "pbd/device/call_monitor.h"

#include <meniscus/error.h>

namespace meniscus::pbd {

namespace {

constexpr std::chrono::milliseconds between_reports{100};

}  // namespace

void CallMonitor::poll(const char* what, double fraction) {
  poll();
  if (!report_) return;
  const auto now = std::chrono::steady_clock::now();
  if (now - last_report_ < between_reports) return;
  last_report_ = now;
  report_({what, fraction});
  poll();  // the report may have cancelled the call
}

void CallMonitor::refuse() {
  cancelled_.store(false, std::memory_order_relaxed);
  throw Error(ErrorCode::cancelled, "the call was cancelled; the world is as before");
}

}  // namespace meniscus::pbd
