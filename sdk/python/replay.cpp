// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Repeats recordings, and follows what they create, destroy and set.
#include "sdk/python/replay.h"

#include <meniscus/recording.h>
#include <nanobind/stl/string.h>

#include <optional>

#include "sdk/python/lent.h"
#include "sdk/python/state/known_things.h"
#include "sdk/python/values/from_python.h"
#include "sdk/python/values/results.h"
#include "sdk/world/recording/replayed_calls.h"

namespace meniscus::python {

namespace {

/// What the calls up to the end of a step do.
struct Ahead {
  bool replaces = false;  ///< the world becomes a new one
  bool defines = false;   ///< something is created, destroyed or set
};

struct PyReplay {
  explicit PyReplay(const std::string& path) : replay(path), records(path) {}

  Replay replay;
  RecordReader records;  ///< the same file, read ahead
  bool is_started = false, has_failed = false;
  std::weak_ptr<WorldState> state{};  ///< of the world that start() made

  /// Once a call has failed, the two readers may be at different places, and anything may happen.
  Ahead look_ahead() {
    if (has_failed) return {true, true};
    Ahead ahead;
    while (const std::optional<Record> record = records.next()) {
      if (record->kind == RecordKind::end || is_step(*record)) break;
      ahead.replaces |= record->kind == RecordKind::state;
      ahead.defines |= changes_definitions(*record);
    }
    return ahead;
  }
};

PyWorld start(PyReplay& self, const LoadOptions& options) {
  if (std::exchange(self.is_started, true))
    throw Error(ErrorCode::invalid_argument, "start was called before");
  std::optional<World> world;
  Things things;
  {
    const nb::gil_scoped_release released;
    world = self.replay.start(options.def);
    self.records.next();
    things = saved_things(*world);
  }
  const auto state = std::make_shared<WorldState>(std::move(*world), std::move(things), options.stream);
  state->read_file = options.read_file;
  state->log = options.log;
  self.state = state;
  return {state};
}

/// What next() has found out besides the step.
struct Followed {
  std::optional<ReplayStep> step;
  std::optional<Things> things;
};

Followed follow(PyReplay& self, World& world) {
  const Ahead ahead = self.look_ahead();
  // Another thread may cancel() the world, but not while it becomes a new one.
  std::optional<nb::gil_scoped_acquire> acquired;
  if (ahead.replaces) acquired.emplace();
  Followed result{self.replay.next(world), {}};
  if (ahead.replaces || ahead.defines) result.things = saved_things(world);
  return result;
}

nb::object next(PyReplay& self, const PyWorld& world) {
  if (self.state.lock() != world.state)
    throw Error(ErrorCode::invalid_argument, "next takes the world that start has made");
  WorldState& state = *world.state;
  Followed followed;
  try {
    followed = state.change([&](World& w) { return follow(self, w); });
  } catch (...) {
    self.has_failed = true;
    throw;
  }
  if (followed.things) static_cast<Things&>(state) = std::move(*followed.things);
  if (!followed.step) return nb::none();
  const ReplayStep& step = *followed.step;
  return make_result("ReplayStep", step.report, step.time, step.hash, step.recorded_hash);
}

}  // namespace

void bind_replay(nb::module_& module) {
  nb::class_<PyReplay> type(module, "Replay",
                            "A recording that is read: see World.start_recording(). start() makes the world, "
                            "and each next() repeats "
                            "the calls up to the end of the next step. On the same kind of device all hashes "
                            "are equal, whatever the "
                            "number of threads.");
  type.def(
      "__init__",
      [](PyReplay* self, nb::handle given) {
        std::string path;
        read(given, {"Replay", "path"}, path);
        new (self) PyReplay(path);
      },
      nb::arg("path"), nb::sig("def __init__(self, path: str | os.PathLike[str]) -> None"),
      "Opens a file. Raises FileError if it is no recording.");
  type.def(
      "start",
      [](PyReplay& self, const nb::kwargs& options) { return start(self, LoadOptions(options, "start")); },
      nb::sig((std::string("def start(self, *, ") + option_signature + " -> World").c_str()),
      "The world at the beginning of the recording, once. What is left out is as in the recorded world. "
      "Hooks "
      "are in no recording: add them before the first next().");
  type.def("next", next, nb::arg("world"),
           nb::sig("def next(self, world: World) -> meniscus.results.ReplayStep | None"),
           "Repeats calls on the world of start(), to the end of the next step. None at the end of the "
           "recording. Where the recorded world went back to a snapshot, the world has new things: find them "
           "again. It keeps its hooks. Raises FileError for a damaged file, and what a call raises.");
  type.def_prop_ro(
      "is_complete", [](const PyReplay& self) { return self.replay.is_complete(); },
      "Whether next() has found the end that stop_recording() wrote. Without it the recording is good up to "
      "where it ends.");
  type.def_prop_ro(
      "device", [](const PyReplay& self) { return self.replay.device(); },
      "'cpu' or 'cuda', of the recorded world.");
  type.def_prop_ro(
      "program", [](const PyReplay& self) { return self.replay.program(); }, "The version that recorded it.");
}

}  // namespace meniscus::python
