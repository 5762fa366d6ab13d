// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Writes the calls of a world to a recording.
#pragma once

#include <exception>
#include <string>

#include "pbd/device/call_monitor.h"
#include "sdk/world/host/log.h"
#include "sdk/world/recording/record_file.h"

namespace meniscus {

/// The name of a call in recordings, where overloads have names of their own, and in errors.
struct RecordedAs {
  RecordedAs(const char* recorded_name, const char* function = __builtin_FUNCTION())
      : name(recorded_name), call(function) {}
  const char* name;
  const char* call;
};

/// A recording that is being written. A failure ends it: the calls have changed the world already, so they do
/// not fail. stop() throws the reason.
class Recorder {
 public:
  /// `log` must outlive it.
  Recorder(const std::string& path, const RecordingHeader& header, const Log& log)
      : path_(path), file_(path, header), log_(log) {}

  const std::string& path() const { return path_; }
  void write(RecordKind kind, std::span<const uint8_t> bytes) {
    guard([&] { file_.write(kind, bytes); });
  }
  /// Runs what writes or prepares a record.
  template <class Work>
  void guard(const Work& work) {
    if (failure_) return;
    try {
      work();
    } catch (const pbd::StateLost&) {
      throw;
    } catch (const std::exception& error) {
      failure_ = std::current_exception();
      log_.warn("the recording " + path_ + " ends: " + error.what());
    }
  }
  bool failed() const { return failure_ != nullptr; }
  void stop() {
    write(RecordKind::end, {});
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  std::string path_;
  RecordWriter file_;
  const Log& log_;
  std::exception_ptr failure_;
};

}  // namespace meniscus
