// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The log of a world.
#pragma once

#include <meniscus/host.h>

#include <set>
#include <string>
#include <utility>

namespace meniscus {

/// Hands messages to the user's sink, if there is one.
class Log {
 public:
  explicit Log(LogSink sink) : sink_(std::move(sink)) {}

  bool is_read() const { return sink_ != nullptr; }
  void note(const std::string& text) const { say(LogLevel::note, text); }
  void warn(const std::string& text) const { say(LogLevel::warning, text); }
  /// Warns of the same matter once.
  void warn_once(const char* matter, const std::string& text) {
    if (is_read() && warned_.insert(matter).second) warn(text);
  }

  void set_sink(LogSink sink) { sink_ = std::move(sink); }

 private:
  /// What a sink throws must not end a call that has changed the world.
  void say(LogLevel level, const std::string& text) const {
    if (!sink_) return;
    try {
      sink_(level, text);
    } catch (...) {
    }
  }

  LogSink sink_;
  std::set<std::string> warned_;
};

}  // namespace meniscus
