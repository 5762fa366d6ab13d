// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What Python lends to a world: a stream, and functions that read files and take messages.
#pragma once

#include <meniscus/host.h>
#include <meniscus/snapshot.h>

#include <string>

#include "sdk/python/state/callable.h"
#include "sdk/python/values/describe.h"
#include "sdk/python/values/from_python.h"

namespace meniscus::python {

/// Members of WorldDef that are no plain values.
struct Lent {
  void* cuda_stream = nullptr;
  Callable read_file{};
  Callable log{};
  nb::object stream{};  ///< the object of cuda_stream
};

/// A function, or none. Anything else is an error at this place.
Callable function_of(nb::handle given, const Place& place);
/// Calls the function with a name. It returns bytes, or None if there is no such file.
FileReader reader_of(const Callable& read_file);
/// Calls the function with a level and a text. What it raises goes to sys.unraisablehook, since a call that
/// has changed the world must not end.
LogSink sink_of(const Callable& log);

/// Takes cuda_stream, read_file and log out of keyword arguments.
Lent lent_members(nb::dict& given, const std::string& owner);
/// Adds them to the description of a call.
Description with_lent_members(Description text);
/// Takes an argument out of keyword arguments; None where there is none.
nb::object taken(nb::dict& given, const char* key);

/// LoadDef as Python has it.
struct LoadOptions {
  LoadDef def;
  nb::object stream;  ///< the object of cuda_stream
  Callable read_file;
  Callable log;

  /// Takes them out of keyword arguments; any other argument is an error.
  LoadOptions(nb::dict given, const std::string& call);
  void take_files_by(Callable function);
  void take_messages_by(Callable function);
};

/// They as keyword arguments in a signature.
extern const char* const option_signature;

}  // namespace meniscus::python
