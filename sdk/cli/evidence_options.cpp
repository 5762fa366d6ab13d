// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#include "sdk/cli/evidence_options.h"

namespace meniscus::cli {

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

}  // namespace meniscus::cli
