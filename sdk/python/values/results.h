// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Results of calls as objects of Python. meniscus/results.py has their classes.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "sdk/python/state/handle.h"

namespace meniscus::python {

/// Makes the classes StepReport, Overflows, Diagnostics, ClothState, DeviceInfo, MeshRepair, MemoryStats,
/// WorldStatus and BatchReport.
void bind_results(nb::module_& module);
/// Adds contacts and events to World.
void bind_events(nb::class_<PyWorld>& world);
/// Adds rays, overlaps, distances and samples to World.
void bind_queries(nb::class_<PyWorld>& world);
/// Adds the arrays of particles to World.
void bind_particles(nb::class_<PyWorld>& world);

/// Its place in the list of World, or -1.
template <class Id>
int64_t place_of(Id id, const std::vector<Id>& ids) {
  const auto at = std::find(ids.begin(), ids.end(), id);
  return at == ids.end() ? -1 : at - ids.begin();
}

/// The thing with this id, or None.
template <class Id>
nb::object thing(const PyWorld& self, Id id) {
  if (id == Id{}) return nb::none();
  return nb::cast(Handle<Id>{self.state, id});
}
template <class Id>
nb::list things(const PyWorld& self, const std::vector<Id>& ids) {
  nb::list list;
  for (const Id id : ids) list.append(thing(self, id));
  return list;
}

/// An object of a class in meniscus/results.py.
template <class... Values>
nb::object make_result(const char* name, Values&&... values) {
  return nb::module_::import_("meniscus.results").attr(name)(std::forward<Values>(values)...);
}

}  // namespace meniscus::python
