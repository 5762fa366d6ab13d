// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Worlds in files, and members of WorldDef that are no plain values.
#pragma once

#include "sdk/python/describe.h"
#include "sdk/python/handle.h"

namespace meniscus::python {

/// What Python lends to a world.
struct Lent {
  void* cuda_stream = nullptr;
  Callable read_file{};
  nb::object stream{};  ///< the object of cuda_stream
};

/// Calls the function with a name. It returns bytes, or None if there is no such file.
FileReader reader_of(const Callable& function);
/// Takes cuda_stream and read_file out of keyword arguments.
Lent lent_members(nb::dict& given, const std::string& owner);
/// Adds them to the description of a call.
Description with_lent_members(Description text);

/// Adds save(), load() and clone().
void bind_world_files(nb::class_<PyWorld>& world);

}  // namespace meniscus::python
