// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Implements `meniscus reproduce`.
#include "sdk/cli/reproduce/reproduce.h"

#include <meniscus/error.h>
#include <meniscus/version.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <filesystem>

#include "sdk/cli/commands/exit_code.h"
#include "sdk/cli/reproduce/parts.h"

namespace meniscus::cli {
namespace {

namespace fs = std::filesystem;

struct Part {
  const char* name;
  bool (*add)(const pbf::Context&);
};

constexpr Part parts[] = {{"times", pbf::add_times},         {"density", pbf::add_density},
                          {"substeps", pbf::add_substeps},   {"pressure", pbf::add_pressure},
                          {"vorticity", pbf::add_vorticity}, {"filters", pbf::add_filters}};

/// What --quick stands for.
constexpr double quick_scale = 0.01, quick_seconds = 1;

ReproduceOptions checked(ReproduceOptions options) {
  if (!options.armadillo.empty() && !fs::is_regular_file(options.armadillo))
    throw Error(ErrorCode::io, "--armadillo is '" + options.armadillo + "', but there is no such file");
  if (options.quick) {
    options.scale = quick_scale;
    options.seconds = quick_seconds;
  }
  return options;
}

bool is_wanted(const Part& part, const std::vector<std::string>& names) {
  return names.empty() || std::find(names.begin(), names.end(), part.name) != names.end();
}

void add_head(io::Report& report, const ReproduceOptions& options, const DeviceInfo& device) {
  report.paragraph(fmt::format(
      "`meniscus reproduce pbf` measured this page with Meniscus {}{} on {}. It repeats the tables and "
      "figure 4 of "
      "Macklin & Müller 2013, *Position Based Fluids*, and tests claims of the paper. Each run has {:g} s of "
      "simulated time.",
      MENISCUS_VERSION_STRING, options.commit.empty() ? "" : " at commit `" + options.commit + "`",
      device.name, options.seconds));
  if (options.scale != 1)
    report.paragraph(fmt::format(
        "The scenes have {:g} % of the paper's particles. So the times cannot be compared with the paper's.",
        100 * options.scale));
  report.figures = {
      {"paper", "Macklin & Müller 2013"}, {"version", MENISCUS_VERSION_STRING},
      {"commit", options.commit},         {"device", {{"kind", device.kind}, {"name", device.name}}},
      {"scale", options.scale},           {"seconds", options.seconds}};
}

DeviceInfo device_of(const pbf::Context& context) {
  Scene scene = context.scene("dam_break").scene;
  WorldDef def;
  def.device = scene.world.device;
  def.threads = scene.world.threads;
  return World(def).device();
}

void write(const io::Report& report, const fs::path& folder, const ReproduceOptions& options) {
  report.write(folder / "pbf.md");
  if (!options.page.empty()) report.write(options.page);
}

}  // namespace

std::vector<std::string> reproduce_parts() {
  std::vector<std::string> names;
  for (const Part& part : parts) names.emplace_back(part.name);
  return names;
}

int reproduce_paper(const ReproduceOptions& given) {
  const ReproduceOptions options = checked(given);
  const fs::path folder = options.output.empty() ? fs::path("out/pbf") : fs::path(options.output);
  RunBudget budget(options.minutes);
  io::Report report("Position Based Fluids, measured again");
  const pbf::Context context{options, budget, report};
  add_head(report, options, device_of(context));
  write(report, folder, options);  // before anything long: a folder that cannot be used ends the command here
  bool done = true;
  for (const Part& part : parts) {
    if (!is_wanted(part, options.parts)) continue;
    spdlog::info("measuring {}", part.name);
    done = part.add(context);
    if (!done) report.paragraph(budget.reason());
    report.figures["complete"] = done;
    write(report, folder, options);
    if (!done) break;
  }
  fmt::print("{}", report.text("pbf"));
  std::fflush(stdout);
  spdlog::info("the page is {}", (folder / "pbf.md").string());
  if (budget.interrupted()) return interrupted;
  return success;
}

}  // namespace meniscus::cli
