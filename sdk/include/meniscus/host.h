// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What a program that contains worlds gives them: its files, its log and its threads.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace meniscus {

/// Reads a file from where a program keeps its files, such as an archive. It returns the bytes, or none if
/// there is no file of that name. The extension of the name tells the format. It is called within the call
/// that needs the file, on the same thread. What it throws passes through that call.
using FileReader = std::function<std::optional<std::string>(const std::string& name)>;

/// How much a message of the log matters.
enum class LogLevel {
  note,     ///< what a user may want to know, such as the device of a world
  warning,  ///< what a user probably does not intend, or what a result lacks
};

/// Takes a message of a world, one sentence without a line end. It is called within the call that has
/// something to say, on the same thread. It must use no call of that world but cancel(). What it throws is
/// dropped.
using LogSink = std::function<void(LogLevel level, const std::string& text)>;

/// The body of a loop, for as long as the loop runs. It throws nothing.
class LoopBody {
 public:
  /// Refers to a function of (begin, end), which must outlive this.
  template <class Body>
  explicit LoopBody(const Body& body)
      : body_(&body), run_([](const void* of, uint32_t begin, uint32_t end) {
          (*static_cast<const Body*>(of))(begin, end);
        }) {}
  /// Works on [begin, end). Any thread may call this.
  void operator()(uint32_t begin, uint32_t end) const { run_(body_, begin, end); }

 private:
  const void* body_;
  void (*run_)(const void* of, uint32_t begin, uint32_t end);
};

/// A loop on the threads of a program, such as a task arena or the job system of an engine. It calls
/// body(begin, end) for ranges that cover [0, count) once, on any threads and in any order. It returns when
/// all are done. A range has about `grain` elements or more. A world runs one loop at a time, on the thread
/// of the call. Results do not depend on the ranges. It must not throw.
using ParallelFor = std::function<void(uint32_t count, uint32_t grain, const LoopBody& body)>;

}  // namespace meniscus
