// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Repeats recordings: a table of World's calls by their names, and the reader that makes them.
#include <meniscus/error.h>
#include <meniscus/recording.h>
#include <meniscus/world.h>

#include <map>
#include <sstream>
#include <string_view>
#include <tuple>
#include <utility>

#include "pbd/host_memory.h"
#include "sdk/world/recording/call_text.h"
#include "sdk/world/recording/check_cbor.h"
#include "sdk/world/recording/record_file.h"
#include "sdk/world/recording/replayed_calls.h"
#include "sdk/world/state/chunk_file.h"
#include "sdk/world/world_impl.h"

namespace meniscus {

using call_text::Ids;
using call_text::Json;

struct Replay::Reader {
  explicit Reader(const std::string& path) : file(path) {}

  RecordReader file;
  LoadDef def{};
  bool started = false, complete = false;

  [[noreturn]] void refuse(const std::string& why) const {
    throw Error(ErrorCode::io, file.path() + " is no usable recording: " + why);
  }
  World world_of(const Record& record) const {
    std::istringstream stream(std::string(record.bytes.begin(), record.bytes.end()));
    ChunkFileHeader header;
    const pbd::SavedState saved = read_chunks(stream, record.bytes.size(), file.path(), header);
    return World::made_from(header.definitions, saved, def);
  }
  Json call_of(const Record& record) const {
    call_text::check_cbor(record.bytes);
    Json call = Json::from_cbor(record.bytes, true, false);
    if (!call.is_array() || call.empty() || !call[0].is_string()) refuse("a call of it is not valid");
    return call;
  }
  ReplayStep step(World& world, const Json& call) const {
    if (call.size() != 4) refuse("a step of it is not valid");
    const Ids ids{world.impl_->first_generation};
    const auto dt = call_text::decode<float>(call[1], ids);
    const auto iterations = call_text::decode<int>(call[2], ids);
    ReplayStep made;
    made.report = world.step(dt, iterations);
    made.time = world.time();
    made.hash = world.state_hash();
    made.recorded_hash = call_text::decode<uint64_t>(call[3], ids);
    return made;
  }
  void make(World& world, const Json& call) const {
    const auto name = call[0].get<std::string>();
    const auto found = replayed_calls().find(name);
    if (found == replayed_calls().end()) refuse("it has the call \"" + name + "\", which is not known");
    found->second(world, call, Ids{world.impl_->first_generation});
  }
  /// Makes a call. Returns what a step has made.
  std::optional<ReplayStep> repeat(World& world, const Record& record) const try {
    const Json call = call_of(record);
    if (call[0] == "step") return step(world, call);
    make(world, call);
    return std::nullopt;
  } catch (const Json::exception& wrong) {
    refuse(std::string("a call of it is not valid: ") + wrong.what());
  }
};

Replay::Replay(const std::string& path)
    : reader_(pbd::with_host_memory([&] { return std::make_unique<Reader>(path); })) {}
Replay::~Replay() = default;
Replay::Replay(Replay&&) noexcept = default;
Replay& Replay::operator=(Replay&&) noexcept = default;

World Replay::start(const LoadDef& def) {
  return pbd::with_host_memory([&] {
    if (reader_->started) throw Error(ErrorCode::invalid_argument, "start was called before");
    const std::optional<Record> first = reader_->file.next();
    if (!first || first->kind != RecordKind::state) reader_->refuse("it does not begin with a state");
    reader_->def = def;
    World world = reader_->world_of(*first);
    reader_->started = true;
    return world;
  });
}

std::optional<ReplayStep> Replay::next(World& world) {
  return pbd::with_host_memory([&]() -> std::optional<ReplayStep> {
    if (!reader_->started) throw Error(ErrorCode::invalid_argument, "next was called before start");
    while (const std::optional<Record> record = reader_->file.next()) {
      if (record->kind == RecordKind::end) {
        reader_->complete = true;
        return std::nullopt;
      }
      if (record->kind == RecordKind::state) {
        World restored = reader_->world_of(*record);
        restored.impl_->take_callbacks(*world.impl_);
        world = std::move(restored);
        continue;
      }
      if (std::optional<ReplayStep> step = reader_->repeat(world, *record)) return step;
    }
    return std::nullopt;
  });
}

bool Replay::is_complete() const {
  return reader_->complete;
}
const std::string& Replay::device() const {
  return reader_->file.header().device;
}
const std::string& Replay::program() const {
  return reader_->file.header().program;
}

}  // namespace meniscus
