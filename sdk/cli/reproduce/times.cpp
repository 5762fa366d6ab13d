// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tables 1 and 2: times of a step, and the shares of its stages.
#include <spdlog/fmt/fmt.h>

#include "sdk/cli/reproduce/paper_figures.h"
#include "sdk/cli/reproduce/parts.h"

namespace meniscus::cli::pbf {
namespace {

struct Timed {
  const PaperTime* paper;
  RunFigures chebyshev, jacobi;
};

/// ms of a substep, the median over the frames.
double substep_ms(const RunFigures& run) {
  std::vector<double> ms;
  for (std::size_t k = 0; k < run.ms.size(); ++k) ms.push_back(run.ms[k] / run.substeps[k]);
  return median_of(ms);
}

/// "predict" to "velocity" as percent of their sum; contacts apart from them.
struct Shares {
  double predict, neighbours, contacts, solve, velocity;
};

Shares shares_of(const RunFigures& run) {
  const auto ms = [&](Stage s) { return run.stage_ms[static_cast<std::size_t>(s)]; };
  double sum = 0;
  for (const double stage : run.stage_ms) sum += stage;
  const double percent = sum > 0 ? 100 / sum : 0;
  return {percent * ms(Stage::predict), percent * ms(Stage::neighbours), percent * ms(Stage::contacts),
          percent * ms(Stage::solve), percent * ms(Stage::velocity)};
}

std::string number(double value) {
  return fmt::format("{:.3g}", value);
}

io::Report::Cells row_of(const Timed& t) {
  const PaperTime& p = *t.paper;
  return {p.label,
          fmt::format("{}", t.chebyshev.particles),
          fmt::format("{} × {}", p.substeps, p.iterations),
          number(p.ms),
          number(substep_ms(t.jacobi)),
          number(substep_ms(t.chebyshev)),
          number(median_of(t.jacobi.ms)),
          number(median_of(t.chebyshev.ms)),
          number(100 * mean_of(t.jacobi.error_mean)),
          number(100 * mean_of(t.chebyshev.error_mean))};
}

nlohmann::ordered_json json_of(const RunFigures& run) {
  nlohmann::ordered_json stages;
  for (std::size_t s = 0; s < stage_count; ++s) stages[stage_name(Stage(s))] = run.stage_ms[s];
  return {{"ms_frame_median", median_of(run.ms)},
          {"ms_substep_median", substep_ms(run)},
          {"error_mean_at_end", mean_of(run.error_mean)},
          {"stage_ms", stages}};
}

void report_shares(io::Report& report, const std::vector<Timed>& timed) {
  report.heading("Table 2: where the time goes");
  report.paragraph(
      "Percent of the device's time, from the timers of a step's stages, with the paper's solver. Here the "
      "prediction is a part of the kernels that sort particles by cell, so \"integrate\" and \"grid\" are "
      "one "
      "figure. Contacts with the tank are a stage of their own on a CPU, and count as neighbours on a GPU.");
  std::vector<io::Report::Cells> rows;
  for (const PaperShares& p : paper_shares) {
    for (const Timed& t : timed) {
      if (t.paper->sample != std::string(p.sample)) continue;
      const Shares ours = shares_of(t.jacobi);
      rows.push_back({t.paper->label, fmt::format("paper, {}", paper_card),
                      number(p.integrate + p.grid) + fmt::format(" ({:g} + {:g})", p.integrate, p.grid),
                      number(p.neighbours), "", number(p.solve), number(p.velocity)});
      rows.push_back({"", "here", number(ours.predict), number(ours.neighbours), number(ours.contacts),
                      number(ours.solve), number(ours.velocity)});
    }
  }
  report.table({"scene", "", "integrate + grid", "neighbours", "contacts", "solve", "velocity"}, rows);
}

}  // namespace

bool add_times(const Context& context) {
  std::vector<Timed> timed;
  std::vector<std::string> stand_ins;
  const bool done = for_each_until_stopped(paper_times, [&](const PaperTime& paper) {
    const PaperScene found = context.scene(paper.sample);
    if (!found.stand_in.empty()) stand_ins.push_back(found.stand_in);
    Scene scene = with_setting(found.scene, paper.substeps, paper.iterations);
    Timed t{&paper, context.run("chebyshev", scene, false), {}};
    scene.world.density.solver = DensitySolver::jacobi;
    t.jacobi = context.run("jacobi", scene, false);
    timed.push_back(std::move(t));
  });

  io::Report& report = context.report;
  report.heading("Table 1: time of a step");
  report.paragraph(fmt::format(
      "A frame lasts 16 ms. The table has the median over {:g} s. The paper's figures are milliseconds a "
      "step on "
      "its {}. This page takes a step there for a substep here, and shows frames as well. Jacobi is the "
      "paper's solver, and Chebyshev is the default.",
      context.options.seconds, paper_card));
  for (const std::string& sentence : stand_ins) report.paragraph(sentence);
  std::vector<io::Report::Cells> rows;
  for (const Timed& t : timed) rows.push_back(row_of(t));
  report.table({"scene", "particles", "substeps × iterations", "paper, ms a step", "Jacobi, ms a substep",
                "Chebyshev, ms a substep", "Jacobi, ms a frame", "Chebyshev, ms a frame",
                "Jacobi, error at the end, %", "Chebyshev, error at the end, %"},
               rows);
  report_shares(report, timed);
  for (const Timed& t : timed)
    report.figures["times"][t.paper->sample] = {{"particles", t.chebyshev.particles},
                                                {"paper_particles", t.paper->particles},
                                                {"paper_ms", t.paper->ms},
                                                {"jacobi", json_of(t.jacobi)},
                                                {"chebyshev", json_of(t.chebyshev)}};
  return done;
}

}  // namespace meniscus::cli::pbf
