// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Batches of worlds. Arrays that are read belong to the moment of the call.
#include "sdk/python/batch.h"
#include "sdk/python/py_batch.h"

#include <nanobind/ndarray.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/vector.h>

#include "sdk/python/device_arrays.h"
#include "sdk/python/values/arrays.h"
#include "sdk/python/values/results.h"

namespace meniscus::python {

namespace {

using Mask = nb::ndarray<const bool, nb::ndim<1>, nb::c_contig, nb::device::cpu>;
using Vectors = nb::ndarray<const float, nb::shape<-1, 3>, nb::c_contig, nb::device::cpu>;

struct PyBatchSnapshot {
  BatchSnapshot state;
};

std::vector<uint8_t> bytes_of(const Mask& mask) {
  return {mask.data(), mask.data() + mask.shape(0)};
}

/// worlds × particles × 3.
nb::object vectors(const PyBatch& self, std::span<const Vec3> (WorldBatch::*read)() const) {
  const auto [values, worlds] = self.run([&](WorldBatch& b) {
    const std::span<const Vec3> all = (b.*read)();
    return std::pair(std::make_shared<const std::vector<Vec3>>(all.begin(), all.end()), b.worlds());
  });
  const std::size_t shape[] = {worlds, values->size() / worlds, 3};
  const auto* const first = reinterpret_cast<const float*>(values->data());
  return nb::cast(nb::ndarray<nb::numpy, const float>(first, 3, shape, kept(values)));
}

void bind_changes(nb::class_<PyBatch>& batch) {
  batch.def(nb::init<const PyWorld&, uint32_t, int>(), nb::arg("archetype"), nb::arg("worlds"),
            nb::arg("rigid_threads") = 0,
            "So many copies of a world in its present state, which is not changed. Host threads step the "
            "bodies, by default one for each core.");
  batch.def(
      "step",
      [](const PyBatch& self, float dt) { return self.run([&](WorldBatch& b) { return b.step(dt); }); },
      nb::arg("dt"), "Advances the active worlds by dt seconds.");
  batch.def(
      "reset",
      [](const PyBatch& self, std::optional<Mask> mask) {
        const std::vector<uint8_t> chosen = mask ? bytes_of(*mask) : std::vector<uint8_t>{};
        if (mask && chosen.empty()) throw nb::value_error("reset(): the mask has no elements");
        self.run([&](WorldBatch& b) { b.reset(chosen); });
      },
      nb::arg("mask").noconvert() = nb::none(),
      "Gives the archetype's state to the worlds where mask is True, or to all.");
  batch.def(
      "set_active",
      [](const PyBatch& self, const Mask& mask) {
        self.run([&, chosen = bytes_of(mask)](WorldBatch& b) { b.set_active(chosen); });
      },
      nb::arg("mask").noconvert(), "Worlds where mask is False stay as they are.");
  batch.def(
      "set_gravities",
      [](const PyBatch& self, const Vectors& gravities) {
        const auto* const first = reinterpret_cast<const Vec3*>(gravities.data());
        self.run([&](WorldBatch& b) { b.set_gravities({first, gravities.shape(0)}); });
      },
      nb::arg("gravities"), "m/s², a row for each world, from the next step on.");
}

void bind_readouts(nb::class_<PyBatch>& batch) {
  batch.def_prop_ro(
      "worlds", [](const PyBatch& self) { return self.run([](WorldBatch& b) { return b.worlds(); }); },
      "Their number.");
  batch.def_prop_ro(
      "particle_count",
      [](const PyBatch& self) { return self.run([](WorldBatch& b) { return b.particle_count(); }); },
      "Of each world.");
  batch.def_prop_ro(
      "positions", [](const PyBatch& self) { return vectors(self, &WorldBatch::positions); },
      "m, worlds × particles × 3, local to each world.");
  batch.def_prop_ro(
      "velocities", [](const PyBatch& self) { return vectors(self, &WorldBatch::velocities); },
      "m/s, worlds × particles × 3.");
  batch.def_prop_ro(
      "vertex_count",
      [](const PyBatch& self) { return self.run([](WorldBatch& b) { return b.vertex_count(); }); },
      "Of the cloth of each world.");
  batch.def_prop_ro(
      "cloth_positions", [](const PyBatch& self) { return vectors(self, &WorldBatch::cloth_positions); },
      "m, worlds × vertices × 3, those of a world piece by piece in the order of their creation.");
  batch.def_prop_ro(
      "cloth_velocities", [](const PyBatch& self) { return vectors(self, &WorldBatch::cloth_velocities); },
      "m/s, worlds × vertices × 3.");
  batch.def_prop_ro(
      "state_hashes",
      [](const PyBatch& self) {
        return array_of(self.run([](WorldBatch& b) {
          return std::vector<uint64_t>(b.state_hashes().begin(), b.state_hashes().end());
        }));
      },
      "By world, what state_hash of it alone is.");
  batch.def_prop_ro(
      "status",
      [](const PyBatch& self) {
        return self.run(
            [](WorldBatch& b) { return std::vector<WorldStatus>(b.status().begin(), b.status().end()); });
      },
      "By world.");
  batch.def(
      "device_arrays",
      [](const PyBatch& self) {
        const BatchArrays all = self.run([](WorldBatch& b) { return b.device_arrays(); });
        const auto wrap = [&](const DeviceArray& array) {
          return array.data ? nb::cast(PyDeviceArray{array, false, self.owner()}) : nb::none();
        };
        return make_result("BatchArrays", wrap(all.positions), wrap(all.velocities),
                           wrap(all.cloth_positions), wrap(all.cloth_velocities));
      },
      nb::sig("def device_arrays(self) -> meniscus.results.BatchArrays"),
      "Positions and velocities in the memory of the device, worlds × particles × 3, and those of the "
      "vertices "
      "of cloth, worlds × vertices × 3.");
  batch.def(
      "insert",
      [](const PyBatch& self, uint32_t number, const PyWorld& state) {
        state.state->measure(
            [&](World& w) { self.run_released([&](WorldBatch& b) { b.insert(number, w); }); });
      },
      nb::arg("world"), nb::arg("state"),
      "Replaces one world by another that was built as the archetype was, with other places, velocities or "
      "gravity.");
  batch.def(
      "snapshot",
      [](const PyBatch& self) {
        return PyBatchSnapshot{self.run([](WorldBatch& b) { return b.snapshot(); })};
      },
      "Copies the state of all worlds within the memory of the device, to go back to.");
  batch.def(
      "restore",
      [](const PyBatch& self, const PyBatchSnapshot& snapshot) {
        self.run([&](WorldBatch& b) { b.restore(snapshot.state); });
      },
      nb::arg("snapshot"), "Goes back to a snapshot of this batch.");
  batch.def("extract", &PyBatch::extract, nb::arg("world"),
            "A world of its own that continues with the same bits.");
}

}  // namespace

void bind_batch(nb::module_& module) {
  nb::class_<PyBatchSnapshot>(module, "BatchSnapshot",
                              "The state of all worlds of a batch, made by WorldBatch.snapshot().")
      .def_prop_ro(
          "device_bytes", [](const PyBatchSnapshot& self) { return self.state.device_bytes(); },
          "Held on the device.");
  nb::class_<PyBatch> batch(
      module, "WorldBatch",
      "Many copies of one world, stepped in the same launches. Each has the bits of the "
      "world alone, which must have sums=\"fixed\".");
  bind_changes(batch);
  bind_readouts(batch);
  bind_batch_bodies(batch);
  bind_batch_events(batch);
}

}  // namespace meniscus::python
