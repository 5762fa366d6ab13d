// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Results of calls as objects of Python. meniscus/results.py has their classes.
#pragma once

#include "sdk/python/handle.h"

namespace meniscus::python {

/// Makes the classes StepReport, Overflows, Diagnostics, ClothState, DeviceInfo and MeshRepair.
void bind_results(nb::module_& module);
/// Adds contacts, events, rays and overlaps to World.
void bind_queries(nb::class_<PyWorld>& world);
/// Adds the arrays of particles to World.
void bind_particles(nb::class_<PyWorld>& world);

/// An object of a class in meniscus/results.py.
template <class... Values>
nb::object make_result(const char* name, Values&&... values) {
  return nb::module_::import_("meniscus.results").attr(name)(std::forward<Values>(values)...);
}

}  // namespace meniscus::python
