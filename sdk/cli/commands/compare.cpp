// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Implements `meniscus compare`: the density solvers at equal mean density error, and their stable steps.
#include "sdk/cli/commands/compare.h"

#include <meniscus/error.h>
#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <array>

#include "sdk/cli/commands/exit_code.h"
#include "sdk/cli/evidence/rivals.h"
#include "sdk/cli/output/frame_exporter.h"
#include "sdk/cli/record/json_text.h"
#include "sdk/fields/names.h"
#include "sdk/fields/world.h"
#include "sdk/io/report.h"

namespace meniscus::cli {
namespace {

using json = nlohmann::ordered_json;
using Cells = io::Report::Cells;

const Cells rival_columns{"solver",           "error asked for, %",   "error, %",        "ms for a second",
                          "substeps a frame", "iterations a substep", "bytes a particle"};
const Cells step_columns{"solver", "largest stable step, ms", "its substeps, ms", "breaks at, ms", "because",
                         "runs"};

Cells row(const Rival& r) {
  const std::string target = fmt::format("{}", r.target);
  if (!r.failure.empty()) return {r.solver, target, r.failure, "", "", "", ""};
  return {r.solver,
          target,
          fmt::format("{:.3g}", r.error),
          fmt::format("{:.4g}", r.ms),
          fmt::format("{:.1f}", r.substeps),
          fmt::format("{:.1f}", r.iterations),
          fmt::format("{:.0f}", r.bytes)};
}

std::string milliseconds(double seconds) {
  return seconds > 0 ? fmt::format("{:.3g}", 1000 * seconds) : "none";
}

Cells row(const std::string& solver, const StableStep& s) {
  return {solver,   milliseconds(s.asked),    milliseconds(s.made), milliseconds(s.broke),
          s.reason, fmt::format("{}", s.runs)};
}

json figures_of(const Rival& r) {
  json figures{{"solver", r.solver}, {"error_asked_percent", r.target}};
  if (!r.failure.empty()) {
    figures["failure"] = r.failure;
    return figures;
  }
  figures["error_percent"] = r.error;
  figures["ms_per_second"] = r.ms;
  figures["substeps"] = r.substeps;
  figures["iterations"] = r.iterations;
  figures["bytes_per_particle"] = r.bytes;
  return figures;
}

json figures_of(const std::string& solver, const StableStep& s) {
  return {{"solver", solver},   {"step_s", s.asked},  {"substep_s", s.made},
          {"broke_s", s.broke}, {"reason", s.reason}, {"runs", s.runs}};
}

/// The results of one solver side by side, and the smallest error first.
std::vector<Rival> by_solver(std::vector<Rival> rivals) {
  const auto place = [](const Rival& r) {
    const auto solvers = names_of(DensitySolver{});
    const auto found = std::find_if(solvers.begin(), solvers.end(),
                                    [&](const auto& solver) { return r.solver == solver.name; });
    return std::pair(found - solvers.begin(), r.target);
  };
  std::sort(rivals.begin(), rivals.end(),
            [&](const Rival& a, const Rival& b) { return place(a) < place(b); });
  return rivals;
}

/// Errors that were not run are gaps.
std::string chart_of(const std::string& title, const std::vector<double>& errors,
                     const std::vector<Rival>& rivals) {
  constexpr std::array colors{"#888888", "#1f77b4", "#17becf", "#d62728", "#ff7f0e", "#2ca02c"};
  constexpr double gap = std::numeric_limits<double>::quiet_NaN();
  io::LineChart chart{title, "mean density error asked for, %", errors, {{"ms for a second", {}}}};
  std::vector<io::ChartSeries>& series = chart.panels.front().series;
  for (const Rival& rival : by_solver(rivals)) {
    if (series.empty() || series.back().name != rival.solver)
      series.push_back(
          {rival.solver, colors[series.size() % colors.size()], std::vector<double>(errors.size(), gap)});
    const auto at = std::find(errors.begin(), errors.end(), rival.target) - errors.begin();
    series.back().y[static_cast<std::size_t>(at)] = rival.ms;
  }
  return io::to_svg(chart);
}

/// The page so far, in the folder, and its rows on the standard output as they come. Each is written at once,
/// so that a command that is killed leaves what it measured.
class Comparison {
 public:
  Comparison(const CompareOptions& options, const Scene& scene, std::filesystem::path folder)
      : options_(options),
        scene_(scene),
        folder_(std::move(folder)),
        errors_(options.errors),
        budget_(options.minutes) {
    std::sort(errors_.begin(), errors_.end());
    const DeviceInfo device = build_scene(rival_scene(scene_, DensitySolver::chebyshev, 0)).world.device();
    figures_ = {{"scene", scene_.name}, {"seconds", options_.seconds}, {"results", json::array()}};
    figures_["device"] = {{"kind", device.kind}, {"name", device.name}};
    title_ = fmt::format("# {} for {:.4g} s on {}\n\n", scene_.name, options_.seconds, device.name);
    print(title_);
  }

  void run() {
    try {
      compare_times();
      if (options_.stability) compare_steps();
      figures_["complete"] = true;
    } catch (const Stopped&) {
      figures_["complete"] = false;
      add("\n" + budget_.reason() + "\n");
    }
    write();
    if (options_.json) print_json(figures_);
  }

  bool interrupted() const { return budget_.interrupted(); }

 private:
  /// The largest error first: it costs least, so that a limit of time leaves something of each solver.
  void compare_times() {
    print(io::table_head(rival_columns));
    for (auto error = errors_.rbegin(); error != errors_.rend(); ++error) {
      for (const auto& solver : names_of(DensitySolver{})) {
        rivals_.push_back(rival_at(scene_, solver, *error, options_.seconds, options_.substeps, budget_));
        print(io::table_row(row(rivals_.back())));
        write();
      }
    }
  }

  void compare_steps() {
    const StableBounds bounds;
    add(fmt::format(
        "\nThe largest stable step, at a mean density error of 1 % and at most {} iterations. {} PCISPH, "
        "WCSPH and DFSPH divide a step by their own bounds.\n\n{}",
        most_rival_iterations, sentence_of(bounds), io::table_head(step_columns)));
    for (const auto& solver : names_of(DensitySolver{})) {
      const StableStep step = stable_step_of(scene_, solver.value, options_.seconds, bounds, budget_);
      figures_["stable_steps"].push_back(figures_of(solver.name, step));
      add(io::table_row(row(solver.name, step)));
      write();
    }
  }

  void print(const std::string& text) const {
    if (!options_.json) fmt::print("{}", text);
    std::fflush(stdout);
  }

  /// Adds to what follows the table of times.
  void add(const std::string& text) {
    after_times_ += text;
    print(text);
  }

  void write() {
    std::string page = title_ + io::table_head(rival_columns);
    figures_["results"] = json::array();
    for (const Rival& rival : by_solver(rivals_)) {
      page += io::table_row(row(rival));
      figures_["results"].push_back(figures_of(rival));
    }
    io::write_text(folder_ / "compare.md", page + after_times_);
    io::write_text(folder_ / "compare.json", json_text(figures_));
    io::write_text(folder_ / "compare.svg", chart_of(scene_.name, errors_, rivals_));
  }

  const CompareOptions& options_;
  const Scene& scene_;
  std::filesystem::path folder_;
  std::vector<double> errors_;
  RunBudget budget_;
  json figures_;
  std::string title_, after_times_;
  std::vector<Rival> rivals_;
};

}  // namespace

int compare_solvers(const CompareOptions& options) {
  const Scene scene = chosen_scene(options.scene);
  if (scene.fluids.empty())
    throw Error(ErrorCode::invalid_argument,
                "compare needs a scene with a fluid; " + scene.name + " has none");
  const std::filesystem::path folder =
      options.out.empty() ? default_folder(scene) : std::filesystem::path(options.out);
  make_folder(folder);
  Comparison comparison(options, scene, folder);
  comparison.run();
  return comparison.interrupted() ? interrupted : success;
}

}  // namespace meniscus::cli
