// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Declares the options and subcommands, parses the command line, and maps errors to exit codes.
#include "sdk/cli/program.h"

#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

#include <meniscus/error.h>
#include <meniscus/version.h>
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <functional>
#include <iostream>
#include <optional>
#include <string>
#include <string_view>

#include "sdk/cli/commands/check.h"
#include "sdk/cli/commands/completion.h"
#include "sdk/cli/commands/devices.h"
#include "sdk/cli/commands/replay.h"
#include "sdk/cli/commands/run.h"
#include "sdk/cli/commands/run_worlds.h"
#include "sdk/cli/commands/samples.h"
#include "sdk/cli/commands/schema.h"
#include "sdk/cli/commands/view.h"
#include "sdk/cli/evidence_options.h"
#include "sdk/cli/shared_options.h"
#include "sdk/cli/usage/usage.h"
#include "sdk/io/plain_text.h"

namespace meniscus::cli {
namespace {

void add_worlds(CLI::App& run, RunOptions& options) {
  CLI::Option* worlds =
      run.add_option("--worlds", options.worlds,
                     "Run so many copies of the scene at once, and write a table with a row for each")
          ->type_name("N")
          ->check(CLI::Range(1, 65536).description(""));
  for (const char* frames :
       {"--export", "--render", "--video", "--save-every", "--from", "--record", "--cuts"})
    worlds->excludes(frames);
  run.add_option("--vary", options.vary,
                 "With --worlds: a number of the scene that differs among the copies, as in "
                 "world.gravity[0]=-1:1; repeatable")
      ->type_name("PATH=LOW:HIGH")
      ->expected(1)
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->needs(worlds);
  run.add_option("--seed", options.seed, "With --vary: which random numbers; by default 1")
      ->check(CLI::NonNegativeNumber)
      ->type_name("N")
      ->needs(worlds);
}

void add_run(CLI::App& app, RunOptions& options, Command& command) {
  CLI::App& run = *app.add_subcommand("run", "Run a scene and write measurements, a picture and frames");
  add_scene(run, options.scene);
  run.add_option("--frames", options.frames, "How many frames, in place of the scene's own number")
      ->type_name("N")
      ->check(CLI::Range(1, 100'000'000).description(""));
  run.add_option("--out", options.out, "The folder for the results; by default out/<scene name>")
      ->type_name("DIR");
  CLI::Option* formats =
      run.add_option(
             "--export", options.formats,
             "Write every frame's particles, bodies, cloth and ropes, and the shapes, as ply, vtp, obj, "
             "usd and/or abc; fluids as volumes, as vdb")
          ->type_name("ply,vtp,obj,usd,abc,vdb")
          ->delimiter(',')
          ->allow_extra_args(false)
          ->check(CLI::IsMember({"ply", "vtp", "obj", "usd", "abc", "vdb"}).description(""));
  run.add_flag("--surface", options.surface, "With --export: the fluids' surfaces as meshes, too")
      ->needs(formats);
  run.add_flag(
         "--render{frames}", options.picture.render,
         "Draw by OpenGL: every frame and a contact sheet; or the last frame alone; auto: that one and the "
         "sheet where OpenGL is at hand")
      ->type_name("=frames|last|auto")
      ->check(CLI::IsMember({"frames", "last", "auto"}).description(""));
  run.add_option("--video", options.picture.video, "Draw every frame by OpenGL into a video, through ffmpeg")
      ->type_name("FILE.mp4");
  run.add_option("--filter", options.picture.filter, "What OpenGL smoothes the fluid's surface by")
      ->type_name("narrow-range|bilateral|curvature-flow|none")
      ->check(CLI::IsMember({"narrow-range", "bilateral", "curvature-flow", "none"}).description(""));
  run.add_flag("!--no-anisotropy", options.picture.anisotropic,
               "Have OpenGL draw particles of fluid as balls, not as ellipsoids along its surface");
  run.add_option("--size", options.picture.size, "Pixels of pictures; by default 1280x720")
      ->type_name("WIDTHxHEIGHT");
  run.add_option("--view", options.picture.views,
                 "Show what is measured: speed, density, phase or pressure of particles; contacts; normals; "
                 "strain of "
                 "cloth; distances to solids")
      ->type_name("NAME,...")
      ->delimiter(',')
      ->allow_extra_args(false);
  run.add_option("--camera", options.picture.camera, "One of the scene's named cameras")->type_name("NAME");
  run.add_option("--samples", options.picture.samples,
                 "Pictures whose mean is taken, for the two below; by default 1")
      ->type_name("N")
      ->check(CLI::Range(1, 4096).description(""));
  run.add_option("--aperture", options.picture.aperture,
                 "Diameter of the camera's lens, in m: what is not as far away as its target is blurred")
      ->type_name("METRES")
      ->check(CLI::NonNegativeNumber.description(""));
  run.add_option("--shutter", options.picture.shutter,
                 "How long the shutter is open, in s: what moves is blurred")
      ->type_name("SECONDS")
      ->check(CLI::NonNegativeNumber.description(""));
  run.add_flag("--caustics", options.picture.caustics,
               "Have water gather the light of the sun on what lies beneath it");
  run.add_option("--save-every", options.save_every,
                 "Save the whole state after every N frames, as snapshot_NUMBER.menisnap in the folder")
      ->type_name("N")
      ->check(CLI::Range(1, 100'000'000).description(""));
  run.add_option("--from", options.from, "Continue from a saved state of the same scene")->type_name("FILE");
  run.add_option("--record", options.record, "Record all steps with their hashes, for the command replay")
      ->type_name("FILE");
  run.add_option("--cuts", options.cuts,
                 "With mpirun: how the ranks divide the world; auto: as the busiest rank has less to do")
      ->type_name("auto|slabs|pencils")
      ->check(CLI::IsMember({"auto", "slabs", "pencils"}).description(""));
  add_worlds(run, options);
  run.add_flag("--quiet", options.quiet, "Print errors alone, and with --json the results");
  add_json(run, options.json);
  run.callback([&options, &command] {
    command = [&options] { return options.worlds ? run_worlds(options) : run_scene(options); };
  });
}

void add_view(CLI::App& app, ViewOptions& options, Command& command) {
  CLI::App& view =
      *app.add_subcommand("view", "Open a scene in a window, to watch it and to take hold of it");
  add_scene(view, options.scene);
  view.add_option("--out", options.out, "The folder for screenshots and videos; by default out/<scene name>")
      ->type_name("DIR");
  view.add_option("--size", options.size, "Pixels of the window; by default 1280x720")
      ->type_name("WIDTHxHEIGHT");
  view.add_option("--camera", options.camera, "One of the scene's named cameras")->type_name("NAME");
  view.add_flag("--check-opengl", options.check_opengl,
                "Have OpenGL look for mistakes, and fail where it finds any");
  view.callback([&options, &command] { command = [&options] { return view_scene(options); }; });
}

void add_check(CLI::App& app, CheckOptions& options, Command& command) {
  CLI::App& check = *app.add_subcommand("check", "Read a scene, build it on the CPU and say what is in it");
  add_scene(check, options.scene, options.overrides);
  add_json(check, options.json);
  check.callback([&options, &command] { command = [&options] { return check_scene(options); }; });
}

void add_devices(CLI::App& app, SceneChoice& choice, bool& json, Command& command) {
  CLI::App& devices = *app.add_subcommand(
      "devices", "List the devices, and which one auto takes; or what memory a scene takes there");
  CLI::Option* memory =
      devices.add_option("--memory", choice.scene, "Say what memory the scene takes, array by array")
          ->type_name("SCENE");
  add_overrides(devices, choice.overrides)->needs(memory);
  add_device(devices, choice.device)->needs(memory);
  add_json(devices, json);
  devices.callback([&choice, &json, &command, memory] {
    command = [&choice, &json, of_scene = memory->count() > 0] {
      return of_scene ? show_memory(choice, json) : show_devices(json);
    };
  });
}

void add_replay(CLI::App& app, ReplayOptions& options, Command& command) {
  CLI::App& replay = *app.add_subcommand("replay", "Repeat a recording, and compare the hash of each step");
  replay.add_option("file", options.file, "The recording")->required()->type_name("FILE");
  add_device(replay, options.device)->description("Where to run; by default as recorded");
  add_threads(replay, options.threads);
  add_json(replay, options.json);
  replay.callback([&options, &command] { command = [&options] { return replay_recording(options); }; });
}

void add_samples(CLI::App& app, bool& json, Command& command) {
  CLI::App& samples = *app.add_subcommand("samples", "List the samples by name; as JSON, what they are, too");
  add_json(samples, json);
  samples.callback([&json, &command] { command = [&json] { return list_samples(json); }; });
}

void add_completion(CLI::App& app, std::string& shell, Command& command) {
  CLI::App& completion =
      *app.add_subcommand("completion", "Print the script by which a shell completes the command line");
  completion.add_option("shell", shell, "The shell")
      ->required()
      ->type_name("bash|zsh|fish")
      ->check(CLI::IsMember({"bash", "zsh", "fish"}).description(""));
  completion.callback(
      [&app, &shell, &command] { command = [&] { return print_completion(usage_of(app), shell); }; });
}

/// The message about the first word that was not understood, if there is one. It goes before all other
/// mistakes, which often follow from it.
std::optional<std::string> unknown_word(const CLI::App& app, const Usage& usage) {
  const std::vector<std::string> words = app.remaining(true);
  if (words.empty()) return std::nullopt;
  const std::vector<CLI::App*> verbs = app.get_subcommands();
  return unknown_argument(usage, verbs.empty() ? "" : verbs.front()->get_name(), words.front());
}

/// Writes messages as plain text: names and paths in them come from files.
class PlainSink : public spdlog::sinks::stderr_sink_st {
 public:
  void log(const spdlog::details::log_msg& message) override {
    const std::string text = io::plain_text({message.payload.data(), message.payload.size()});
    spdlog::details::log_msg plain = message;
    plain.payload = text;
    spdlog::sinks::stderr_sink_st::log(plain);
  }
};

/// Errors and progress go to stderr as `meniscus: ...`; stdout is for results.
void start_log() {
  // Not a named logger of spdlog's registry: a program that runs twice in one process would find that name
  // taken.
  spdlog::set_default_logger(std::make_shared<spdlog::logger>("meniscus", std::make_shared<PlainSink>()));
  spdlog::set_pattern("%n: %v");
}

int report(std::string_view message, ExitCode code) noexcept {
  try {
    std::string line(message);
    std::replace(line.begin(), line.end(), '\n', ' ');
    spdlog::error(line);
  } catch (...) {  // without memory for the log
    std::fputs("meniscus: there is no memory to say what went wrong\n", stderr);
  }
  return code;
}

ExitCode exit_code_of(ErrorCode code) {
  switch (code) {
    case ErrorCode::invalid_argument:
    case ErrorCode::not_found:
    case ErrorCode::io:
    case ErrorCode::parse:
    case ErrorCode::mesh:
      return bad_input;
    case ErrorCode::capacity:
    case ErrorCode::non_finite:
    case ErrorCode::device:
    case ErrorCode::out_of_memory:
    case ErrorCode::lost:
      return run_failed;
    case ErrorCode::cancelled:
      return interrupted;
  }
  return run_failed;
}

int parse_and_run(int argc, char** argv) try {
  start_log();
  RunOptions run;
  ViewOptions view;
  CheckOptions check;
  CompareOptions compare;
  ValidateOptions validate;
  ReproduceOptions reproduce;
  ReplayOptions replay;
  SceneChoice budget;
  bool json = false;
  std::string shell;
  Command command;
  CLI::App app("Position-based liquid, cloth and rigid bodies on the GPU and on the CPU", "meniscus");
  app.set_version_flag("--version", "meniscus " MENISCUS_VERSION_STRING);
  app.require_subcommand(0, 1);
  add_run(app, run, command);
  add_view(app, view, command);
  add_check(app, check, command);
  add_compare(app, compare, command);
  add_validate(app, validate, command);
  add_reproduce(app, reproduce, command);
  add_replay(app, replay, command);
  add_devices(app, budget, json, command);
  add_samples(app, json, command);
  app.add_subcommand("schema", "Print the JSON Schema of scene files")->callback([&] {
    command = print_schema;
  });
  add_completion(app, shell, command);
  const Usage usage = usage_of(app);
  try {
    std::vector<std::string> words = verb_first(usage, {argv + std::min(argc, 1), argv + argc});
    std::reverse(words.begin(), words.end());  // as CLI11 takes them
    app.parse(words);
    return command ? command() : report("a command is required (meniscus --help lists them)", bad_input);
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::Error& error) {
    return report(unknown_word(app, usage).value_or(error.what()) + " (meniscus --help tells more)",
                  bad_input);
  }
} catch (const Error& error) {
  return report(error.what(), exit_code_of(error.code()));
} catch (const std::exception& error) {
  return report(error.what(), run_failed);
}

}  // namespace

int run_program(int argc, char** argv) {
  const int code = parse_and_run(argc, argv);
  const bool written = std::fflush(stdout) == 0 && !std::ferror(stdout) && std::cout.flush();
  if (written || code != success) return code;
  return report("cannot write to standard output", run_failed);
}

}  // namespace meniscus::cli
