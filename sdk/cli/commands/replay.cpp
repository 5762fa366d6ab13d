// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Implements `meniscus replay`: repeats a recording and compares the hash of each step.
#include "sdk/cli/commands/replay.h"

#include <meniscus/error.h>
#include <meniscus/recording.h>
#include <meniscus/version.h>
#include <meniscus/world.h>
#include <spdlog/spdlog.h>

#include <nlohmann/json.hpp>

#include "sdk/cli/commands/exit_code.h"
#include "sdk/cli/record/json_text.h"
#include "sdk/cli/stop/interrupt.h"
#include "sdk/fields/world.h"

namespace meniscus::cli {
namespace {

/// What the steps of a replay had.
struct Comparison {
  int steps = 0, equal = 0;
  std::optional<int> first_difference{};  // from 1
  double time = 0;                        // s

  void add(const ReplayStep& step) {
    ++steps;
    time = step.time;
    if (step.hash == step.recorded_hash)
      ++equal;
    else if (!first_difference)
      first_difference = steps;
  }
};

LoadDef load_def_of(const ReplayOptions& options) {
  LoadDef def;
  def.threads = options.threads;
  for (const Named<DeviceChoice>& choice : names_of(DeviceChoice{})) {
    if (choice.name == options.device) def.device = choice.value;
  }
  def.log = [](LogLevel level, const std::string& text) {
    if (level == LogLevel::warning) spdlog::warn("{}", text);
  };
  return def;
}

/// The next step; none at the end, and where a signal cancels it.
std::optional<ReplayStep> next_step(Replay& replay, World& world) {
  try {
    return replay.next(world);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::cancelled) throw;
    return std::nullopt;
  }
}

nlohmann::ordered_json json_of(const Comparison& all, const Replay& replay, const std::string& device,
                               bool is_interrupted) {
  nlohmann::ordered_json first, complete;
  if (all.first_difference) first = *all.first_difference;
  if (!is_interrupted) complete = replay.is_complete();  // else its end was not reached
  return {{"recorded_by", replay.program()},
          {"recorded_on", replay.device()},
          {"device", device},
          {"steps", all.steps},
          {"equal", all.equal},
          {"first_difference", first},
          {"simulated_s", without_noise(all.time)},
          {"interrupted", is_interrupted},
          {"complete", complete}};
}

std::string text_of(const Comparison& all, const Replay& replay, const std::string& device,
                    bool is_interrupted) {
  std::string text = fmt::format("{} steps, to {} s; {} of them have the recorded hash\n", all.steps,
                                 without_noise(all.time), all.equal);
  if (all.first_difference) text += fmt::format("step {} is the first that differs\n", *all.first_difference);
  if (device != replay.device())
    text += fmt::format("it was recorded on {} and ran on {}, which round differently\n", replay.device(),
                        device);
  if (is_interrupted)
    text += "a signal ended the replay: the recording may have more steps\n";
  else if (!replay.is_complete())
    text += "the recording has no end: its program ended before\n";
  return text;
}

}  // namespace

int replay_recording(const ReplayOptions& options) {
  Replay replay(options.file);
  if (replay.program() != MENISCUS_VERSION_STRING)
    spdlog::warn("it was recorded by {}, and this is {}", replay.program(), MENISCUS_VERSION_STRING);
  World world = replay.start(load_def_of(options));
  const Interrupt interrupt(world);
  Comparison all;
  while (!interrupt.raised()) {
    const std::optional<ReplayStep> step = next_step(replay, world);
    if (!step) break;
    all.add(*step);
  }
  const std::string device = world.device().kind;
  const bool is_interrupted = interrupt.raised() && !replay.is_complete();
  if (options.json)
    print_json(json_of(all, replay, device, is_interrupted));
  else
    fmt::print("{}", text_of(all, replay, device, is_interrupted));
  if (is_interrupted) return interrupted;
  return all.first_difference && device == replay.device() ? check_broken : success;
}

}  // namespace meniscus::cli
