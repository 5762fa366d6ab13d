// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Makes and steps worlds, and measures them.
#include "sdk/python/world.h"

#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <cmath>

#include "sdk/python/definitions.h"
#include "sdk/python/lent.h"
#include "sdk/python/values/describe.h"
#include "sdk/python/values/from_python.h"

namespace meniscus::python {

namespace {

void bind_construction(nb::class_<PyWorld>& world) {
  const Description text =
      with_lent_members(describe_call<WorldDef>("__init__", "None", "Makes an empty world."));
  world.def(
      "__init__",
      [](PyWorld* self, nb::kwargs given) {
        Lent lent = lent_members(given, "World");
        WorldDef def;
        read_members(def, given, "World");
        def.cuda_stream = lent.cuda_stream;
        def.read_file = reader_of(lent.read_file);
        def.log = sink_of(lent.log);
        auto state = std::make_shared<WorldState>(def, std::move(lent.stream));
        state->read_file = std::move(lent.read_file);
        state->log = std::move(lent.log);
        new (self) PyWorld(std::move(state));
      },
      nb::sig(text.signature.c_str()), text.doc.c_str());
  bind_world_members(world);
  const Description wind =
      describe_call<WindDef>("set_wind", "None", "From the next step on. Wind acts on cloth.");
  world.def(
      "set_wind",
      [](const PyWorld& self, const nb::kwargs& given) {
        WindDef def;
        read_members(def, given, "set_wind");
        self.state->change([&](World& w) { w.set_wind(def); });
      },
      nb::sig(wind.signature.c_str()), wind.doc.c_str());
}

void bind_steps(nb::class_<PyWorld>& world) {
  world.def(
      "step",
      [](const PyWorld& self, std::optional<float> dt, std::optional<int> iterations) {
        const float length = dt.value_or(self.state->frame_time);
        return self.state->change([&](World& w) { return w.step(length, iterations); });
      },
      nb::arg("dt") = nb::none(), nb::arg("iterations") = nb::none(),
      nb::sig("def step(self, dt: float | None = None, iterations: int | None = None) -> StepReport"),
      "Advances by dt seconds, by default by frame_time. `iterations`, 1 to 1000, replace those of the world "
      "and the choice of step_budget_ms in this step. Other threads run meanwhile. Ctrl-C ends it within "
      "about "
      "a second, and the world is as before.");
  world.def(
      "step_begin",
      [](const PyWorld& self, std::optional<float> dt, std::optional<int> iterations) {
        const float length = dt.value_or(self.state->frame_time);
        self.state->change([&](World& w) { w.step_begin(length, iterations); });
      },
      nb::arg("dt") = nb::none(), nb::arg("iterations") = nb::none(),
      nb::sig("def step_begin(self, dt: float | None = None, iterations: int | None = None) -> None"),
      "The first half of step(): a GPU then works while the caller does something else. Until step_end() "
      "only "
      "cancel() is allowed. On the CPU all substeps are done here.");
  world.def(
      "step_end",
      [](const PyWorld& self) { return self.state->change([](World& w) { return w.step_end(); }); },
      "Ends the step that step_begin() began. Raises what step() raises.");
  world.def(
      "relax",
      [](const PyWorld& self, int iterations) { self.state->change([&](World& w) { w.relax(iterations); }); },
      nb::arg("iterations") = 50, "Moves the particles to their rest density. 0 to 100,000 iterations.");
  world.def(
      "cancel", [](const PyWorld& self) { self.state->cancel(); },
      "Ends the long call that runs, or else the next one. Any thread may call it.");
  world.def(
      "run",
      [](nb::handle self, nb::handle frames, nb::handle dt, nb::handle progress) {
        return nb::module_::import_("meniscus.runs").attr("run")(self, frames, dt, progress);
      },
      nb::arg("frames") = nb::none(), nb::arg("dt") = nb::none(), nb::arg("progress") = false,
      nb::sig("def run(self, frames: int | None = None, dt: float | None = None, progress: bool = False) -> "
              "StepReport | None"),
      "Makes so many steps, by default the scene's, and returns the report of the last one. A bar shows the "
      "progress where tqdm is installed.");
  world.def_prop_rw(
      "frame_time", [](const PyWorld& self) { return plain_number(self.state->frame_time); },
      [](const PyWorld& self, float dt) {
        if (!(dt > 0 && std::isfinite(dt)))
          throw nb::value_error("frame_time must be a positive number of seconds");
        self.state->frame_time = dt;
      },
      "s, the length of a step that names none: that of the scene, or 1/60.");
  world.def_prop_ro(
      "frames", [](const PyWorld& self) { return self.state->frames; },
      "How many steps the scene runs; 250 without a scene.");
  world.def_prop_ro(
      "name", [](const PyWorld& self) { return self.state->name; }, "Of the scene; empty without one.");
  world.def_prop_rw(
      "on_progress",
      [](const PyWorld& self) {
        const nb::object& f = self.state->on_progress;
        return f.is_valid() ? f : nb::object(nb::none());
      },
      [](const PyWorld& self, nb::object f) {
        if (!f.is_none() && !PyCallable_Check(f.ptr()))
          throw nb::type_error("on_progress must be a function or None");
        self.state->on_progress = std::move(f);
      },
      nb::arg().none(),
      nb::for_getter(
          nb::sig("def on_progress(self) -> collections.abc.Callable[[str, float], object] | None")),
      nb::for_setter(nb::sig("def on_progress(self, value: collections.abc.Callable[[str, float], object] | "
                             "None, /) -> None")),
      "A function of the task and the fraction that is done. Long calls call it at most ten times a second. "
      "It may use cancel() of the world alone.");
}

/// A property that one call of the world answers.
template <class Ask>
void bind_value(nb::class_<PyWorld>& world, const char* name, const Ask& ask, const char* doc) {
  world.def_prop_ro(
      name, [ask](const PyWorld& self) { return self.state->look([&](World& w) { return ask(w); }); }, doc);
}

void bind_measurements(nb::class_<PyWorld>& world) {
  bind_value(
      world, "time", [](World& w) { return w.time(); }, "s.");
  bind_value(
      world, "particle_count", [](World& w) { return w.particle_count(); }, "Of fluids and grains.");
  bind_value(
      world, "support_radius", [](World& w) { return w.support_radius(); }, "m.");
  bind_value(
      world, "device_info", [](World& w) { return w.device(); },
      "Where the world runs, and the reason if it fell back to the CPU.");
  bind_value(
      world, "device_bytes", [](World& w) { return w.device_bytes(); }, "Held on the device.");
  world.def(
      "state_hash",
      [](const PyWorld& self) { return self.state->measure([](World& w) { return w.state_hash(); }); },
      "Of the bits of all particles, vertices and bodies. Equal states have equal hashes.");
  world.def(
      "diagnostics",
      [](const PyWorld& self) { return self.state->measure([](World& w) { return w.diagnostics(); }); },
      "Density errors, energies and faults, measured now.");
  world.def(
      "warnings",
      [](const PyWorld& self) { return self.state->measure([](World& w) { return w.warnings(); }); },
      "What is probably not intended, one sentence each.");
  world.def(
      "mesh_repairs",
      [](const PyWorld& self) {
        return self.state->look([](World& w) { return std::vector<MeshRepair>(w.mesh_repairs()); });
      },
      "Of shapes and bodies that were created so far.");
  world.def(
      "memory",
      [](const PyWorld& self) {
        nb::dict shares;
        for (const MemoryShare& share : self.state->change([](World& w) { return w.memory_shares(); }))
          shares[share.what.c_str()] = share.bytes;
        return shares;
      },
      nb::sig("def memory(self) -> dict[str, int]"), "Bytes on the device by purpose, the largest first.");
  world.def(
      "memory_stats",
      [](const PyWorld& self) { return self.state->look([](World& w) { return w.memory_stats(); }); },
      "What the world has taken from its allocators, and how often, without an upload.");
  world.def("__repr__", [](const PyWorld& self) {
    const auto [particles, time] =
        self.state->look([](World& w) { return std::pair(w.particle_count(), w.time()); });
    return "<World" + (self.state->name.empty() ? "" : " '" + self.state->name + "'") + ", " +
           std::to_string(particles) + " particles, " + std::to_string(time) + " s>";
  });
}

}  // namespace

void bind_world(nb::class_<PyWorld>& world) {
  bind_construction(world);
  bind_steps(world);
  bind_measurements(world);
}

}  // namespace meniscus::python
