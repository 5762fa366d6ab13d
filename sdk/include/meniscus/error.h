// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The exception that every failing call throws, and its codes.
#pragma once

#include <stdexcept>
#include <string>

namespace meniscus {

/// Why a call failed.
enum class ErrorCode {
  invalid_argument,  ///< a value that the call does not allow
  not_found,         ///< an id or a name that does not exist
  io,                ///< a file that cannot be read or written
  parse,             ///< a scene file with a wrong, missing or unknown key; a motion file that is wrong
  mesh,              ///< an unusable mesh: not valid, empty, degenerate or without an inside
  capacity,          ///< a fixed limit was reached; the message names it and the remedy
  non_finite,  ///< the step met NaN, infinity or more than 1.7·10¹⁹ m/s; the state before it is restored
  device,      ///< CUDA or the driver failed, or the requested device does not exist
  out_of_memory,
  cancelled,  ///< the call was cancelled by World::cancel
  lost,       ///< memory or the device failed in an earlier call that changed the world: nothing is usable
};

/// Every failing call of the library throws this. The message names the argument, its value and the allowed
/// values. A call that throws has added nothing.
class Error : public std::runtime_error {
 public:
  Error(ErrorCode code, const std::string& message) : std::runtime_error(message), code_(code) {}

  ErrorCode code() const noexcept { return code_; }  ///< why the call failed

 private:
  ErrorCode code_;
};

}  // namespace meniscus
