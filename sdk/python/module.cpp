// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The extension module meniscus._core.
#include <meniscus/meniscus.h>
#include <nanobind/nanobind.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include "sdk/python/batch.h"
#include "sdk/python/collected.h"
#include "sdk/python/definitions.h"
#include "sdk/python/device_arrays.h"
#include "sdk/python/errors.h"
#include "sdk/python/motion.h"
#include "sdk/python/replay.h"
#include "sdk/python/snapshots.h"
#include "sdk/python/things.h"
#include "sdk/python/values/results.h"
#include "sdk/python/world.h"
#include "sdk/python/world_files.h"

NB_MODULE(_core, module) {
  using namespace meniscus;
  using namespace meniscus::python;
  module.doc() = "The compiled part of meniscus.";
  module.attr("version") = MENISCUS_VERSION_STRING;
  translate_errors();
  bind_definitions(module);
  bind_results(module);
  nb::class_<PyWorld> world(module, "World", nb::type_slots(world_slots()),
                            "One simulated world on one device.");
  bind_things(module, world);
  bind_body(module, world);
  bind_cloth(module, world);
  bind_world(world);
  bind_particles(world);
  bind_events(world);
  bind_queries(world);
  bind_scenes(module, world);
  bind_snapshots(module, world);
  bind_world_files(world);
  bind_replay(module);
  bind_motion(module);
  bind_device_arrays(module, world);
  bind_hooks(module, world);
  bind_batch(module);
  module.def("list_devices", list_devices, "The devices, and which of them are usable.");
}
