// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Starts host threads, and says which one could not be started.
#pragma once

#include <meniscus/error.h>

#include <string>
#include <system_error>
#include <thread>
#include <utility>

namespace meniscus::pbd {

/// A thread that runs `body`. Throws Error(out_of_memory) if the system has no room for it. `what` names it
/// in the message, as in "the thread of the rigid bodies".
template <class F>
std::thread start_thread(const std::string& what, F&& body) {
  try {
    return std::thread(std::forward<F>(body));
  } catch (const std::system_error& error) {
    throw Error(ErrorCode::out_of_memory, what + " could not be started: " + error.code().message());
  }
}

}  // namespace meniscus::pbd
