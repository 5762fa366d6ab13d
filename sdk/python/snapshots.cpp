// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A snapshot holds what Python knows of the world as well: what was created in it.
#include "sdk/python/snapshots.h"

#include <nanobind/stl/string.h>

namespace meniscus::python {

namespace {

struct PySnapshot {
  Snapshot snapshot;
  Things things;
};

}  // namespace

void bind_snapshots(nb::module_& module, nb::class_<PyWorld>& world) {
  nb::class_<PySnapshot>(module, "Snapshot", "The state of a world at one moment, made by World.snapshot().")
      .def_prop_ro(
          "time", [](const PySnapshot& self) { return self.snapshot.time(); },
          "s, of the world at that moment.")
      .def_prop_ro(
          "device_bytes", [](const PySnapshot& self) { return self.snapshot.device_bytes(); },
          "Held on the device.");
  world.def(
      "snapshot",
      [](const PyWorld& self) {
        Things things = *self.state;  // before another thread may add to them
        return PySnapshot{self.state->measure([](World& w) { return w.snapshot(); }), std::move(things)};
      },
      "Copies the whole state within the memory of the device, to go back to.");
  world.def(
      "restore",
      [](const PyWorld& self, const PySnapshot& snapshot) {
        self.state->change([&](World& w) { w.restore(snapshot.snapshot); });
        static_cast<Things&>(*self.state) = snapshot.things;
      },
      nb::arg("snapshot"),
      "Goes back to a snapshot of this world, whatever was created, destroyed or set since. What follows is "
      "bit "
      "for bit what followed the snapshot. Raises InvalidArgumentError for a snapshot of another world.");
}

}  // namespace meniscus::python
