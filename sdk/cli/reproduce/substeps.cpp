// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The paper's claim: PCISPH needs 10 substeps a frame, and PBF holds with fewer, down to one.
#include <spdlog/fmt/fmt.h>

#include "sdk/cli/evidence/stable_step.h"
#include "sdk/cli/reproduce/parts.h"

namespace meniscus::cli::pbf {
namespace {

struct Setting {
  bool pcisph;
  int substeps, iterations;
};

constexpr Setting settings[] = {{true, 10, 4},  {true, 6, 7},   {true, 4, 10},  {true, 2, 20}, {true, 1, 40},
                                {false, 4, 10}, {false, 2, 20}, {false, 1, 40}, {false, 1, 10}};

struct Tried {
  Setting setting;
  RunFigures run;
  std::string broken;
};

io::Report::Cells row_of(const Tried& t) {
  return {t.setting.pcisph ? "PCISPH" : "PBF",
          fmt::format("{} × {}", t.setting.substeps, t.setting.iterations),
          fmt::format("{:.1f}", mean_of(t.run.substeps)),
          fmt::format("{:.3g}", 100 * mean_of(t.run.error_mean)),
          fmt::format("{:.3g}", 100 * largest_of(t.run.error_max)),
          fmt::format("{:.2g}", 100 * t.run.gain),
          fmt::format("{:.3g}", median_of(t.run.ms)),
          t.broken.empty() ? "holds" : "breaks: " + t.broken};
}

/// Says what was found, and not what was expected.
std::string verdict(const std::vector<Tried>& tried, bool pcisph) {
  int fewest = 0;
  double made = 0;
  for (const Tried& t : tried) {
    if (t.setting.pcisph != pcisph || !t.broken.empty()) continue;
    if (fewest != 0 && fewest <= t.setting.substeps) continue;
    fewest = t.setting.substeps;
    made = mean_of(t.run.substeps);
  }
  const char* name = pcisph ? "PCISPH" : "PBF";
  if (fewest == 0) return fmt::format("{} holds with none of these settings.", name);
  return fmt::format("{} holds with {} substep{} a frame; it made {:.1f}.", name, fewest,
                     fewest == 1 ? "" : "s", made);
}

}  // namespace

bool add_substeps(const Context& context) {
  const PaperScene found = context.scene("bunny_drop");
  const StableBounds bounds;
  std::vector<Tried> tried;
  const bool done = for_each_until_stopped(settings, [&](const Setting& s) {
    const Scene scene = s.pcisph ? with_pcisph(found.scene, s.substeps, s.iterations)
                                 : with_setting(found.scene, s.substeps, s.iterations);
    RunFigures run = run_figures({.name = s.pcisph ? "PCISPH" : "PBF",
                                  .scene = scene,
                                  .seconds = context.options.seconds,
                                  .ends = [&](const RunFigures& so_far) { return is_lost(so_far, bounds); }},
                                 context.budget);
    const std::string broken = broken_by(run, bounds);
    tried.push_back({s, std::move(run), broken});
  });

  io::Report& report = context.report;
  report.heading("Substeps: how few each method holds with");
  report.paragraph(
      "The paper says that PCISPH needs 10 substeps a frame in the bunny drop, and that PBF stays stable "
      "with one. " +
      sentence_of(bounds) +
      " PCISPH has the fixed substeps of its paper here, without the bound on the fastest particle that it "
      "has "
      "by default.");
  if (!found.stand_in.empty()) report.paragraph(found.stand_in);
  std::vector<io::Report::Cells> rows;
  for (const Tried& t : tried) rows.push_back(row_of(t));
  report.table({"method", "substeps × iterations", "substeps made, mean", "mean error, %", "largest error, %",
                "energy gained, %", "ms a frame", "verdict"},
               rows);
  if (done) report.paragraph("What was found: " + verdict(tried, true) + " " + verdict(tried, false));
  for (const Tried& t : tried)
    report.figures["substeps"].push_back({{"method", t.setting.pcisph ? "pcisph" : "pbf"},
                                          {"substeps", t.setting.substeps},
                                          {"iterations", t.setting.iterations},
                                          {"substeps_made", mean_of(t.run.substeps)},
                                          {"error_mean", mean_of(t.run.error_mean)},
                                          {"error_max", largest_of(t.run.error_max)},
                                          {"energy_gain", t.run.gain},
                                          {"broken", t.broken}});
  return done;
}

}  // namespace meniscus::cli::pbf
