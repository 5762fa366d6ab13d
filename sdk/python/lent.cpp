// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Reads what Python lends to a world.
#include "sdk/python/lent.h"

namespace meniscus::python {

Callable function_of(nb::handle given, const Place& place) {
  if (given.is_none()) return {};
  if (!PyCallable_Check(given.ptr())) refuse(place, "a function or None", given);
  return Callable(nb::borrow(given));
}

FileReader reader_of(const Callable& read_file) {
  if (!read_file.get()) return {};
  return [read_file](const std::string& name) {
    return read_file([&](nb::handle function) -> std::optional<std::string> {
      if (!function.is_valid()) throw Error(ErrorCode::invalid_argument, "read_file has gone with its World");
      const nb::object contents = function(name);
      if (contents.is_none()) return {};
      if (!PyBytes_Check(contents.ptr())) refuse({"read_file", "result"}, "bytes or None", contents);
      const nb::bytes bytes = nb::borrow<nb::bytes>(contents);
      return std::string(bytes.c_str(), bytes.size());
    });
  };
}

LogSink sink_of(const Callable& log) {
  if (!log.get()) return {};
  return [log](LogLevel level, const std::string& text) {
    log([&](nb::handle function) {
      if (!function.is_valid()) return;  // it has gone with its World
      try {
        function(level == LogLevel::warning ? "warning" : "note", text);
      } catch (nb::python_error& error) {
        error.discard_as_unraisable("the log of a world");
      }
    });
  };
}

namespace {

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

}  // namespace

nb::object taken(nb::dict& given, const char* key) {
  if (!given.contains(key)) return nb::none();
  return nb::steal(PyObject_CallMethod(given.ptr(), "pop", "s", key));
}

Lent lent_members(nb::dict& given, const std::string& owner) {
  const nb::object stream = taken(given, "cuda_stream");
  return {stream_of(stream, owner), function_of(taken(given, "read_file"), {owner, "read_file"}),
          function_of(taken(given, "log"), {owner, "log"}), stream};
}

Description with_lent_members(Description text) {
  text.signature.insert(
      text.signature.rfind(") -> "),
      ", cuda_stream: typing.Any = None, read_file: collections.abc.Callable[[str], bytes | None] | None = "
      "None, "
      "log: collections.abc.Callable[[typing.Literal['note', 'warning'], str], object] | None = None");
  text.doc +=
      "\n    cuda_stream: a stream of PyTorch, CuPy or CUDA Python, or its number, with which all work of "
      "the world "
      "is ordered; not the legacy default stream; default None, a stream of the world's own"
      "\n    read_file: a function of the name of a mesh file that returns its bytes, or None if there is no "
      "such "
      "file; default None, the file system"
      "\n    log: a function of 'note' or 'warning' and a sentence, for the device, repairs of meshes, what "
      "warnings() finds before the first step, and what a step leaves out; default None";
  return text;
}

LoadOptions::LoadOptions(nb::dict given, const std::string& call) {
  for (const auto& [key, ignored] : given) {
    static const std::vector<std::string> known{"device",      "threads",   "cuda_device",
                                                "cuda_stream", "read_file", "log"};
    const std::string name = nb::cast<std::string>(key);
    if (std::find(known.begin(), known.end(), name) == known.end()) refuse_key(call, name, known);
  }
  Lent lent = lent_members(given, call);
  read(taken(given, "device"), {call, "device"}, def.device);
  read(taken(given, "threads"), {call, "threads"}, def.threads);
  read(taken(given, "cuda_device"), {call, "cuda_device"}, def.cuda_device);
  def.cuda_stream = lent.cuda_stream;
  stream = std::move(lent.stream);
  take_files_by(std::move(lent.read_file));
  take_messages_by(std::move(lent.log));
}

void LoadOptions::take_files_by(Callable function) {
  def.read_file = reader_of(function);
  read_file = std::move(function);
}

void LoadOptions::take_messages_by(Callable function) {
  def.log = sink_of(function);
  log = std::move(function);
}

const char* const option_signature =
    "device: typing.Literal['auto', 'cpu', 'cuda'] | None = None, threads: int | None = None, cuda_device: "
    "int | None = None, cuda_stream: typing.Any = None, read_file: collections.abc.Callable[[str], bytes | "
    "None] | None = None, log: collections.abc.Callable[[typing.Literal['note', 'warning'], str], object] | "
    "None = None)";

}  // namespace meniscus::python
