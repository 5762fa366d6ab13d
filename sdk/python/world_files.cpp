// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Worlds in files, clones, and what Python lends to a world: a stream and a reader of files.
#include "sdk/python/world_files.h"

#include <nanobind/stl/string.h>

#include "sdk/python/describe.h"
#include "sdk/python/from_python.h"
#include "sdk/world/state/chunk_file.h"
#include "sdk/world/state/definitions.h"

namespace meniscus::python {

namespace {

Callable function_of(nb::handle given, const std::string& owner) {
  if (given.is_none()) return {};
  if (!PyCallable_Check(given.ptr())) refuse({owner, "read_file"}, "a function or None", given);
  return Callable(nb::borrow(given));
}

/// A cudaStream_t: its number, or an object of PyTorch, CuPy or CUDA Python.
void* stream_of(nb::handle given, const std::string& owner) {
  if (given.is_none()) return nullptr;
  nb::object handle = nb::borrow(given);
  if (nb::hasattr(given, "__cuda_stream__"))
    handle = nb::object(given.attr("__cuda_stream__")()[1]);
  else if (nb::hasattr(given, "cuda_stream"))
    handle = given.attr("cuda_stream");
  else if (nb::hasattr(given, "ptr"))
    handle = given.attr("ptr");
  uintptr_t number = 0;
  if (!nb::try_cast(handle, number)) refuse({owner, "cuda_stream"}, "a stream or the number of one", given);
  return reinterpret_cast<void*>(number);
}

nb::object taken(nb::dict& given, const char* key) {
  if (!given.contains(key)) return nb::none();
  return nb::steal(PyObject_CallMethod(given.ptr(), "pop", "s", key));
}

/// LoadDef as Python has it.
struct LoadOptions {
  LoadDef def;
  nb::object stream;
  Callable read_file;

  LoadOptions(nb::handle device, nb::handle threads, nb::handle cuda_device, nb::handle cuda_stream,
              nb::handle read_file_or_none, const char* call)
      : stream(nb::borrow(cuda_stream)) {
    read(device, {call, "device"}, def.device);
    read(threads, {call, "threads"}, def.threads);
    read(cuda_device, {call, "cuda_device"}, def.cuda_device);
    def.cuda_stream = stream_of(cuda_stream, call);
    take_files_by(function_of(read_file_or_none, call));
  }
  void take_files_by(Callable function) {
    def.read_file = reader_of(function);
    read_file = std::move(function);
  }
};

template <class Id, class Def>
void take(Registry<Id, Def>& registry, const std::vector<Id>& ids,
          const std::vector<std::optional<Def>>& defs) {
  for (const Id id : ids) registry.add(id, defs.at(id.index).value());
}

/// Colours of materials are in no file.
std::variant<FluidDef, GranularDef> def_of(const ParticleMaterial& m) {
  if (m.grain.is_grain) {
    GranularDef def;
    def.name = m.name;
    def.density = m.fluid.rest_density;
    def.filter = m.filter;
    return def;
  }
  FluidDef def;
  def.name = m.name;
  def.rest_density = m.fluid.rest_density;
  def.dynamic_viscosity = m.fluid.dynamic_viscosity;
  def.xsph = m.fluid.xsph;
  def.vorticity_confinement = m.fluid.vorticity_confinement;
  def.cohesion = m.fluid.cohesion;
  def.surface_tension = m.fluid.surface_tension;
  def.filter = m.filter;
  return def;
}

/// What exists in a world that was read from a file. Ids within these definitions count from 0.
Things things_of(const World& w, const Definitions& defs) {
  Things all;
  for (const FluidId id : w.fluid_ids()) all.fluids.add(id, def_of(defs.fluids.at(id.index).value()));
  take(all.shapes, w.shape_ids(), defs.shapes);
  take(all.bodies, w.body_ids(), defs.bodies);
  take(all.joints, w.joint_ids(), defs.joints);
  take(all.cloths, w.cloth_ids(), defs.cloths);
  take(all.ropes, w.rope_ids(), defs.ropes);
  take(all.attachments, w.attachment_ids(), defs.attachments);
  take(all.emitters, w.emitter_ids(), defs.emitters);
  take(all.sinks, w.sink_ids(), defs.sinks);
  take(all.probes, w.probe_ids(), defs.probes);
  take(all.force_fields, w.force_field_ids(), defs.force_fields);
  return all;
}

template <class Id, class Def>
void renumber(Registry<Id, Def>& registry, const std::vector<Id>& ids) {
  for (Id& id : registry.ids) {
    const auto same = std::find_if(ids.begin(), ids.end(), [&](Id other) { return other.index == id.index; });
    if (same != ids.end()) id = *same;
  }
}

/// The same things with the ids of a clone.
Things things_of(const World& w, Things all) {
  renumber(all.fluids, w.fluid_ids());
  renumber(all.shapes, w.shape_ids());
  renumber(all.bodies, w.body_ids());
  renumber(all.joints, w.joint_ids());
  renumber(all.cloths, w.cloth_ids());
  renumber(all.ropes, w.rope_ids());
  renumber(all.attachments, w.attachment_ids());
  renumber(all.emitters, w.emitter_ids());
  renumber(all.sinks, w.sink_ids());
  renumber(all.probes, w.probe_ids());
  renumber(all.force_fields, w.force_field_ids());
  return all;
}

PyWorld load(const std::string& path, const LoadOptions& options) {
  std::string definitions;
  std::optional<World> world;
  {
    const nb::gil_scoped_release released;
    definitions = read_chunk_file_header(path).definitions;
    world = World::load(path, options.def);
    if (read_chunk_file_header(path).definitions != definitions)
      throw Error(ErrorCode::io, path + " was written anew while it was read");
  }
  Things things = things_of(*world, read_definitions(definitions, 0));
  const auto state = std::make_shared<WorldState>(std::move(*world), std::move(things), options.stream);
  state->read_file = options.read_file;
  return {state};
}

PyWorld clone(const PyWorld& self, LoadOptions options) {
  if (!options.read_file.get()) options.take_files_by(self.state->read_file.again());
  Things things = *self.state;
  World world = self.state->measure([&](World& w) { return w.clone(options.def); });
  things = things_of(world, std::move(things));
  const auto state = std::make_shared<WorldState>(std::move(world), std::move(things), options.stream);
  state->read_file = options.read_file;
  state->name = self.state->name;
  state->frame_time = self.state->frame_time;
  state->frames = self.state->frames;
  state->camera = self.state->camera;
  return {state};
}

constexpr const char* option_signature =
    "device: typing.Literal['auto', 'cpu', 'cuda'] | None = None, threads: int | None = None, cuda_device: "
    "int | None "
    "= None, cuda_stream: typing.Any = None, read_file: collections.abc.Callable[[str], bytes | None] | None "
    "= None)";

}  // namespace

FileReader reader_of(const Callable& function) {
  if (!function.get()) return {};
  return [function](const std::string& name) {
    return function([&](nb::handle call) -> std::optional<std::string> {
      if (!call.is_valid()) throw Error(ErrorCode::invalid_argument, "read_file has gone with its World");
      const nb::object contents = call(name);
      if (contents.is_none()) return {};
      if (!PyBytes_Check(contents.ptr())) refuse({"read_file", "result"}, "bytes or None", contents);
      const nb::bytes bytes = nb::borrow<nb::bytes>(contents);
      return std::string(bytes.c_str(), bytes.size());
    });
  };
}

Lent lent_members(nb::dict& given, const std::string& owner) {
  const nb::object stream = taken(given, "cuda_stream");
  return {stream_of(stream, owner), function_of(taken(given, "read_file"), owner), stream};
}

Description with_lent_members(Description text) {
  text.signature.insert(
      text.signature.rfind(") -> "),
      ", cuda_stream: typing.Any = None, read_file: collections.abc.Callable[[str], bytes | None] | "
      "None = None");
  text.doc +=
      "\n    cuda_stream: a stream of PyTorch, CuPy or CUDA Python, or its number, with which all work of "
      "the world "
      "is ordered; not the legacy default stream; default None, a stream of the world's own"
      "\n    read_file: a function of the name of a mesh file that returns its bytes, or None if there is no "
      "such "
      "file; default None, the file system";
  return text;
}

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
      [](nb::handle given, nb::handle device, nb::handle threads, nb::handle cuda_device,
         nb::handle cuda_stream, nb::handle read_file) {
        std::string path;
        read(given, {"load", "path"}, path);
        return load(path, LoadOptions(device, threads, cuda_device, cuda_stream, read_file, "load"));
      },
      nb::arg("path"), nb::kw_only(), nb::arg("device") = nb::none(), nb::arg("threads") = nb::none(),
      nb::arg("cuda_device") = nb::none(), nb::arg("cuda_stream") = nb::none(),
      nb::arg("read_file") = nb::none(),
      nb::sig((std::string("def load(path: str | os.PathLike[str], *, ") + option_signature + " -> World")
                  .c_str()),
      "A new world with the state of a file. On the same kind of device it continues bit for bit. What is "
      "left out is "
      "as in the saved world. Colours of materials and the scene's name are in no file. Raises FileError.");
  world.def(
      "clone",
      [](const PyWorld& self, nb::handle device, nb::handle threads, nb::handle cuda_device,
         nb::handle cuda_stream, nb::handle read_file) {
        return clone(self, LoadOptions(device, threads, cuda_device, cuda_stream, read_file, "clone"));
      },
      nb::kw_only(), nb::arg("device") = nb::none(), nb::arg("threads") = nb::none(),
      nb::arg("cuda_device") = nb::none(), nb::arg("cuda_stream") = nb::none(),
      nb::arg("read_file") = nb::none(),
      nb::sig((std::string("def clone(self, *, ") + option_signature + " -> World").c_str()),
      "A new world with the same state, without hooks.");
}

}  // namespace meniscus::python
