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
#include "sdk/cli/commands/compare.h"
#include "sdk/cli/commands/completion.h"
#include "sdk/cli/commands/devices.h"
#include "sdk/cli/commands/run.h"
#include "sdk/cli/commands/samples.h"
#include "sdk/cli/commands/schema.h"
#include "sdk/cli/commands/validate.h"
#include "sdk/cli/commands/view.h"
#include "sdk/cli/reproduce/reproduce.h"
#include "sdk/cli/usage/usage.h"
#include "sdk/io/plain_text.h"

namespace meniscus::cli {
namespace {

using Command = std::function<int()>;

CLI::Option* add_overrides(CLI::App& app, std::vector<std::string>& overrides) {
  return app
      .add_option("--set", overrides,
                  "Change a value of the scene, as in fluids[0].dynamic_viscosity=0.1; repeatable")
      ->type_name("PATH=VALUE")
      ->expected(1)
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

CLI::Option* add_device(CLI::App& app, std::string& device) {
  return app.add_option("--device", device, "Where to run; by default what the scene says")
      ->type_name("auto|cpu|cuda")
      ->check(CLI::IsMember({"auto", "cpu", "cuda"}).description(""));
}

void add_threads(CLI::App& app, std::optional<int>& threads) {
  app.add_option("--threads", threads, "Threads of the CPU device; 0 is one a core")
      ->type_name("N")
      ->check(CLI::Range(0, 1024).description(""));
}

void add_time_limit(CLI::App& app, double& minutes) {
  app.add_option("--time-limit", minutes, "End after this time, and write what there is; by default no limit")
      ->type_name("MINUTES")
      ->check(CLI::Range(0.0, 1e5).description(""));
}

CLI::Option* add_json(CLI::App& app, bool& json) {
  return app.add_flag("--json", json, "Print the results as JSON, for other programs");
}

void add_scene(CLI::App& app, std::string& scene, std::vector<std::string>& overrides) {
  app.add_option("scene", scene, "A scene file, or the name of a sample")->required()->type_name("SCENE");
  add_overrides(app, overrides);
}

void add_scene(CLI::App& app, SceneChoice& choice) {
  add_scene(app, choice.scene, choice.overrides);
  add_device(app, choice.device);
  add_threads(app, choice.threads);
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
      run.add_option("--export", options.formats,
                     "Write every frame's particles, bodies, cloth and ropes, as ply, vtp and/or obj")
          ->type_name("ply,vtp,obj")
          ->delimiter(',')
          ->allow_extra_args(false)
          ->check(CLI::IsMember({"ply", "vtp", "obj"}).description(""));
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
  run.add_option("--save-every", options.save_every,
                 "Save the whole state after every N frames, as snapshot_NUMBER.menisnap in the folder")
      ->type_name("N")
      ->check(CLI::Range(1, 100'000'000).description(""));
  run.add_option("--from", options.from, "Continue from a saved state of the same scene")->type_name("FILE");
  run.add_flag("--quiet", options.quiet, "Print errors alone, and with --json the results");
  add_json(run, options.json);
  run.callback([&options, &command] { command = [&options] { return run_scene(options); }; });
}

void add_view(CLI::App& app, ViewOptions& options, Command& command) {
  CLI::App& view =
      *app.add_subcommand("view", "Open a scene in a window, to watch it and to take hold of it");
  add_scene(view, options.scene);
  view.add_option("--out", options.out, "The folder for screenshots; by default out/<scene name>")
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

void add_compare(CLI::App& app, CompareOptions& options, Command& command) {
  CLI::App& compare = *app.add_subcommand(
      "compare", "Run a scene with each density solver at equal density errors, and write times and errors");
  add_scene(compare, options.scene);
  compare.add_option("--errors", options.errors, "Mean density errors; by default 0.05,0.1,0.5,1 percent")
      ->type_name("PERCENT,...")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::Range(1e-4, 100.0).description(""));
  compare
      .add_option("--substeps", options.substeps,
                  "Substeps to try; the fastest that reaches the error counts; by default the scene's")
      ->type_name("N,...")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::Range(1, 1000).description(""));
  compare.add_flag("!--no-stability", options.stability, "Leave out the search for the largest stable steps");
  add_time_limit(compare, options.minutes);
  compare.add_option("--seconds", options.seconds, "Simulated time; by default 1 s")
      ->type_name("S")
      ->check(CLI::Range(1e-6, 1e6).description(""));
  compare.add_option("--out", options.out, "The folder for the results; by default out/<scene name>")
      ->type_name("DIR");
  add_json(compare, options.json);
  compare.callback([&options, &command] { command = [&options] { return compare_solvers(options); }; });
}

void add_validate(CLI::App& app, ValidateOptions& options, Command& command) {
  CLI::App& validate = *app.add_subcommand(
      "validate", "Compare cases with theory and experiment, and write a page on their errors");
  validate.add_option("case", options.cases, "Names of cases; by default all of them")->type_name("CASE");
  validate.add_flag("--list", options.list, "List the cases alone");
  add_device(validate, options.device);
  validate.add_option("--threads", options.threads, "Threads of the CPU device; 0 is one a core")
      ->type_name("N")
      ->check(CLI::Range(0, 1024).description(""));
  validate
      .add_option("--resolution", options.resolution,
                  "How many particles: quick takes seconds a case on a CPU, medium minutes, full a GPU")
      ->type_name("quick|medium|full")
      ->check(CLI::IsMember({"quick", "medium", "full"}).description(""));
  validate.add_option("--output", options.output, "The folder for the results; by default out/validate")
      ->type_name("DIR");
  validate.add_option("--page", options.page, "Write the page here too, with a folder of its name beside it")
      ->type_name("FILE.md");
  validate.add_option("--commit", options.commit, "What the page says that the build is from")
      ->type_name("ID");
  validate.callback([&options, &command] { command = [&options] { return validate_cases(options); }; });
}

void add_reproduce(CLI::App& app, ReproduceOptions& options, Command& command) {
  CLI::App& reproduce =
      *app.add_subcommand("reproduce", "Repeat the measurements of a paper, and write a page on them");
  reproduce.add_option("paper", options.paper, "pbf: Macklin & Müller 2013, Position Based Fluids")
      ->required()
      ->type_name("PAPER")
      ->check(CLI::IsMember({"pbf"}).description(""));
  add_device(reproduce, options.device);
  add_threads(reproduce, options.threads);
  CLI::Option* scale =
      reproduce.add_option("--scale", options.scale, "Particles, as a fraction of the paper's; by default 1")
          ->type_name("S")
          ->check(CLI::Range(1e-3, 10.0).description(""));
  CLI::Option* seconds =
      reproduce.add_option("--seconds", options.seconds, "Simulated time of each run; by default 4 s")
          ->type_name("S")
          ->check(CLI::Range(1e-3, 1e3).description(""));
  reproduce.add_flag("--quick", options.quick, "The same as --scale 0.01 --seconds 1")
      ->excludes(scale)
      ->excludes(seconds);
  reproduce
      .add_option(
          "--parts", options.parts,
          "What to measure: times, density, substeps, pressure, vorticity and filters; by default all")
      ->type_name("NAME,...")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::IsMember(reproduce_parts()).description(""));
  reproduce
      .add_option(
          "--armadillo", options.armadillo,
          "The mesh of the armadillo, which samples/fetch_armadillo gets; without it a ball stands in")
      ->type_name("FILE");
  add_time_limit(reproduce, options.minutes);
  reproduce.add_option("--output", options.output, "The folder for the results; by default out/pbf")
      ->type_name("DIR");
  reproduce
      .add_option("--page", options.page, "Write the page here too, with a folder of its name beside it")
      ->type_name("FILE.md");
  reproduce.add_option("--commit", options.commit, "What the page says that the build is from")
      ->type_name("ID");
  reproduce.callback([&options, &command] { command = [&options] { return reproduce_paper(options); }; });
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
