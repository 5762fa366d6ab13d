// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Missing memory of the host as an Error.
#pragma once

#include <meniscus/error.h>

#include <new>

namespace meniscus::pbd {

/// Made when the program starts, since there may be no memory for it later. Its copies take none.
inline const Error no_host_memory(ErrorCode::out_of_memory,
                                  "no memory on the host for the call; nothing has changed");

/// Calls something that either succeeds or leaves no trace. Its std::bad_alloc becomes Error(out_of_memory).
template <class Call>
decltype(auto) with_host_memory(const Call& call) {
  try {
    return call();
  } catch (const std::bad_alloc&) {
    throw Error(no_host_memory);
  }
}

}  // namespace meniscus::pbd
