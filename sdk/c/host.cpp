// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Files, logs, loops and streams of a program in C.
#include "sdk/c/host.h"

#include "sdk/c/handles.h"

namespace meniscus::c {

FileReader reader_of(MeniscusReadFile read, void* user) {
  if (!read) return {};
  return [read, user](const std::string& name) -> std::optional<std::string> {
    MeniscusFileBytes file;
    if (!read(name.c_str(), &file, user)) return std::nullopt;
    return std::move(file.bytes);
  };
}

LogSink sink_of(MeniscusLog log, void* user) {
  if (!log) return {};
  return [log, user](LogLevel level, const std::string& text) {
    log(level == LogLevel::warning ? MENISCUS_WARNING : MENISCUS_NOTE, text.c_str(), user);
  };
}

ParallelFor loop_of(MeniscusParallelFor loop, void* user) {
  if (!loop) return {};
  return [loop, user](uint32_t count, uint32_t grain, const LoopBody& body) {
    const MeniscusLoopBody in_c{body};
    loop(count, grain, &in_c, user);
  };
}

namespace {

WorldDef& world_def_of(MeniscusDef* def) {
  auto* const held = std::get_if<WorldDef>(&required(def, "def").def);
  if (held) return *held;
  throw Error(ErrorCode::invalid_argument, "def is a definition of another kind; it must be of a world");
}

}  // namespace
}  // namespace meniscus::c

using namespace meniscus::c;
using namespace meniscus;

MeniscusStatus meniscus_file_bytes(MeniscusFileBytes* file, const void* bytes, size_t size) {
  return guarded([&] {
    const auto* const from = required_array(static_cast<const char*>(bytes), size, "bytes");
    required(file, "file").bytes = size ? std::string(from, size) : std::string();
  });
}

MeniscusStatus meniscus_def_set_read_file(MeniscusDef* def, MeniscusReadFile read, void* user) {
  return guarded([&] { world_def_of(def).read_file = reader_of(read, user); });
}

MeniscusStatus meniscus_def_set_log(MeniscusDef* def, MeniscusLog log, void* user) {
  return guarded([&] { world_def_of(def).log = sink_of(log, user); });
}

void meniscus_loop_run(const MeniscusLoopBody* body, uint32_t begin, uint32_t end) {
  if (body && begin < end) body->body(begin, end);
}

MeniscusStatus meniscus_def_set_parallel_for(MeniscusDef* def, MeniscusParallelFor loop, void* user) {
  return guarded([&] { world_def_of(def).parallel_for = loop_of(loop, user); });
}

MeniscusStatus meniscus_def_set_cuda_stream(MeniscusDef* def, void* stream) {
  return guarded([&] { world_def_of(def).cuda_stream = stream; });
}
