// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Times of render passes on the GPU.
#pragma once

#include <epoxy/gl.h>

#include <cstddef>
#include <vector>

namespace meniscus::render {

struct PassTime {
  const char* name;
  double ms;
};

/// Times at which OpenGL reached the marks between passes. Off until it is switched on.
class PassTimer {
 public:
  PassTimer() = default;
  ~PassTimer();
  PassTimer(const PassTimer&) = delete;
  PassTimer& operator=(const PassTimer&) = delete;

  void switch_on(bool on) { is_on_ = on; }
  /// A frame begins.
  void start();
  /// `pass` covers all commands since the last call.
  void mark(const char* pass);
  /// The times of the last frame; waits for it.
  std::vector<PassTime> times() const;

 private:
  void note(const char* pass);

  bool is_on_ = false;
  std::size_t used_ = 0;
  std::vector<GLuint> queries_;
  std::vector<const char*> names_;
};

}  // namespace meniscus::render
