// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <epoxy/gl.h>

#include <cstddef>
#include <vector>

namespace meniscus::render {

struct PassTime {
  const char* name;
  double ms;
};

/// When OpenGL came to each place among what it was told to do. Off until it is switched on.
class PassTimer {
 public:
  PassTimer() = default;
  ~PassTimer();
  PassTimer(const PassTimer&) = delete;
  PassTimer& operator=(const PassTimer&) = delete;

  void switch_on(bool on) { is_on_ = on; }
  /// A frame begins.
  void start();
  /// `pass` is all that came since the last call.
  void mark(const char* pass);
  /// Of the last frame; waits for it.
  std::vector<PassTime> times() const;

 private:
  void note(const char* pass);

  bool is_on_ = false;
  std::size_t used_ = 0;
  std::vector<GLuint> queries_;
  std::vector<const char*> names_;
};

}  // namespace meniscus::render
