// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Artificial pressure: how evenly particles are spread with it and without, and with fewer neighbours.
#include <spdlog/fmt/fmt.h>

#include <algorithm>

#include "sdk/cli/evidence/particle_measures.h"
#include "sdk/cli/reproduce/parts.h"

namespace meniscus::cli::pbf {
namespace {

struct Setting {
  float support_ratio;
  bool pressure;
};

constexpr Setting settings[] = {{2.0f, true}, {2.0f, false}, {1.6f, true}, {1.6f, false}};

/// A particle is in a clump if another one is this near, in spacings.
constexpr float clumped = 0.6f;

struct Tried {
  Setting setting;
  RunFigures run;
  double neighbours = 0;  ///< mean, at the end
  double nearest = 0;     ///< spacings, mean at the end
  double clumps = 0;      ///< %, of particles at the end
};

void measure(const World& world, Tried& tried) {
  const float spacing = world.def().particle_spacing;
  double sum = 0;
  int near = 0;
  const std::vector<float> nearest = nearest_distances(world.positions(), world.support_radius());
  for (const float distance : nearest) {
    sum += double{distance};
    near += distance < clumped * spacing;
  }
  const double count = static_cast<double>(std::max<std::size_t>(nearest.size(), 1));
  tried.nearest = sum / count / double{spacing};
  tried.clumps = 100 * near / count;
  tried.neighbours = world.diagnostics().neighbours_mean;
}

Tried tried_with(const Context& context, Scene scene, const Setting& setting) {
  scene.world.support_ratio = setting.support_ratio;
  if (!setting.pressure) scene.world.density.artificial_pressure.strength = 0;
  Tried tried{setting, {}};
  const int last = frames_of(scene, context.options.seconds);
  tried.run = run_figures({.name = "",
                           .scene = scene,
                           .seconds = context.options.seconds,
                           .after =
                               [&](const World& world, int frame) {
                                 if (frame == last) measure(world, tried);
                               }},
                          context.budget);
  return tried;
}

io::Report::Cells row_of(const Tried& t) {
  return {fmt::format("{:g}", t.setting.support_ratio),
          t.setting.pressure ? "on" : "off",
          fmt::format("{:.1f}", t.neighbours),
          fmt::format("{:.3f}", t.nearest),
          fmt::format("{:.2f}", t.clumps),
          fmt::format("{:.3g}", 100 * mean_of(t.run.error_mean)),
          fmt::format("{:.3g}", median_of(t.run.ms)),
          t.run.failure};
}

}  // namespace

bool add_pressure(const Context& context) {
  const PaperScene found = context.scene("armadillo_splash");
  std::vector<Tried> tried;
  const bool done = for_each_until_stopped(
      settings, [&](const Setting& s) { tried.push_back(tried_with(context, found.scene, s)); });

  io::Report& report = context.report;
  report.heading("Artificial pressure, and fewer neighbours");
  report.paragraph(
      fmt::format("The armadillo splash after {:g} s. The paper's term keeps particles apart, and so lets a "
                  "smaller support do. "
                  "A particle counts as clumped if another one is nearer than {:g} spacings.",
                  context.options.seconds, clumped));
  if (!found.stand_in.empty()) report.paragraph(found.stand_in);
  std::vector<io::Report::Cells> rows;
  for (const Tried& t : tried) rows.push_back(row_of(t));
  report.table({"support, spacings", "artificial pressure", "neighbours, mean", "nearest particle, spacings",
                "clumped, %", "mean error, %", "ms a frame", "failure"},
               rows);
  for (const Tried& t : tried)
    report.figures["artificial_pressure"].push_back({{"support_ratio", t.setting.support_ratio},
                                                     {"artificial_pressure", t.setting.pressure},
                                                     {"neighbours", t.neighbours},
                                                     {"nearest_spacings", t.nearest},
                                                     {"clumped_percent", t.clumps},
                                                     {"error_mean", mean_of(t.run.error_mean)},
                                                     {"ms_frame", median_of(t.run.ms)},
                                                     {"failure", t.run.failure}});
  return done;
}

}  // namespace meniscus::cli::pbf
