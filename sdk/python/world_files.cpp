// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Worlds in files, clones, and recordings of worlds.
#include "sdk/python/world_files.h"

#include <nanobind/stl/string.h>

#include "sdk/python/lent.h"
#include "sdk/python/state/known_things.h"
#include "sdk/python/values/from_python.h"
#include "sdk/world/state/chunk_file.h"

namespace meniscus::python {

namespace {

PyWorld load(const std::string& path, const LoadOptions& options) {
  std::string definitions;
  std::optional<World> world;
  Things things;
  {
    const nb::gil_scoped_release released;
    definitions = read_chunk_file_header(path).definitions;
    world = World::load(path, options.def);
    if (read_chunk_file_header(path).definitions != definitions)
      throw Error(ErrorCode::io, path + " was written anew while it was read");
    things = things_of(*world, definitions);
  }
  const auto state = std::make_shared<WorldState>(std::move(*world), std::move(things), options.stream);
  state->read_file = options.read_file;
  state->log = options.log;
  return {state};
}

/// The garbage collector must find a reference for each world, so a clone does not share those of functions.
PyWorld clone(const PyWorld& self, LoadOptions options) {
  if (!options.read_file.get()) options.take_files_by(self.state->read_file.again());
  if (!options.log.get()) options.take_messages_by(self.state->log.again());
  Things things = *self.state;
  World world = self.state->measure([&](World& w) { return w.clone(options.def); });
  things = things_of(world, std::move(things));
  const auto state = std::make_shared<WorldState>(std::move(world), std::move(things), options.stream);
  state->read_file = options.read_file;
  state->log = options.log;
  state->name = self.state->name;
  state->frame_time = self.state->frame_time;
  state->frames = self.state->frames;
  state->camera = self.state->camera;
  return {state};
}

}  // namespace

void bind_world_files(nb::class_<PyWorld>& world) {
  world.def(
      "save",
      [](const PyWorld& self, nb::handle given) {
        std::string path;
        read(given, {"save", "path"}, path);
        self.state->measure([&](World& w) { w.save(path); });
      },
      nb::arg("path"), nb::sig("def save(self, path: str | os.PathLike[str]) -> None"),
      "Writes the whole state to a file, which appears complete or not at all. Of mesh files it has the "
      "names.");
  world.def_static(
      "load",
      [](nb::handle given, const nb::kwargs& options) {
        std::string path;
        read(given, {"load", "path"}, path);
        return load(path, LoadOptions(options, "load"));
      },
      nb::arg("path"), nb::arg("options"),
      nb::sig((std::string("def load(path: str | os.PathLike[str], *, ") + option_signature + " -> World")
                  .c_str()),
      "A new world with the state of a file. On the same kind of device it continues bit for bit. What is "
      "left out is as in the saved world. The scene's name is in no file. Raises FileError.");
  world.def(
      "clone",
      [](const PyWorld& self, const nb::kwargs& options) {
        return clone(self, LoadOptions(options, "clone"));
      },
      nb::sig((std::string("def clone(self, *, ") + option_signature + " -> World").c_str()),
      "A new world with the same state, without hooks.");
  world.def(
      "start_recording",
      [](const PyWorld& self, nb::handle given) {
        std::string path;
        read(given, {"start_recording", "path"}, path);
        self.state->measure([&](World& w) { w.start_recording(path); });
      },
      nb::arg("path"), nb::sig("def start_recording(self, path: str | os.PathLike[str]) -> None"),
      "Writes the state and all further calls that change the world to a file, for Replay. If a write fails, "
      "the recording ends there, and stop_recording() raises the reason. Hooks are not in it. Raises "
      "FileError.");
  world.def(
      "stop_recording",
      [](const PyWorld& self) { self.state->measure([](World& w) { w.stop_recording(); }); },
      "Ends the recording. Raises FileError if not all could be written.");
}

}  // namespace meniscus::python
