// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// How C++ errors become status codes: no exception leaves a function of the C interface.
#pragma once

#include <meniscus/c/base.h>
#include <meniscus/error.h>

#include <cstddef>
#include <string>

namespace meniscus::c {

/// Keeps the message of the exception that is being handled, and returns its status.
MeniscusStatus status_of_exception() noexcept;

/// Makes a call. What it throws becomes a status.
template <class Call>
MeniscusStatus guarded(const Call& call) noexcept {
  try {
    call();
    return MENISCUS_OK;
  } catch (...) {
    return status_of_exception();
  }
}

/// What a pointer of the caller points to. Throws Error(invalid_argument) if it is null.
template <class T>
T& required(T* pointer, const char* name) {
  if (!pointer) throw Error(ErrorCode::invalid_argument, std::string(name) + " is null");
  return *pointer;
}

/// An array of the caller. It may be null if it is empty.
template <class T>
T* required_array(T* values, std::size_t count, const char* name) {
  if (count > 0) required(values, name);
  return values;
}

}  // namespace meniscus::c
