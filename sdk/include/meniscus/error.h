// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>

namespace meniscus {

enum class ErrorCode {
  invalid_argument,  ///< a value outside what the call allows
  not_found,         ///< an id or a name that is not there
  io,                ///< a file that cannot be read or written
  parse,             ///< a scene file with a wrong, missing or unknown key
  mesh,              ///< a mesh that cannot be used: empty, degenerate, no inside
  capacity,          ///< a final limit was reached; the message names it and the remedy
  non_finite,  ///< the step met NaN, infinity or more than 1.7·10¹⁹ m/s; the state is the one before
  device,      ///< CUDA or the driver failed, or the asked device is not there
  out_of_memory,
};

/// What every failing call of the library throws. The message names the argument, its value and what is
/// allowed. A call that throws has added nothing.
class Error : public std::runtime_error {
 public:
  Error(ErrorCode code, const std::string& message) : std::runtime_error(message), code_(code) {}

  ErrorCode code() const noexcept { return code_; }

 private:
  ErrorCode code_;
};

}  // namespace meniscus
