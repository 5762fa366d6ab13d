// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Vorticity confinement: motion and rotation of a dam break with it and without.
#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "pbd/math/vec.h"
#include "sdk/cli/evidence/particle_measures.h"
#include "sdk/cli/reproduce/parts.h"

namespace meniscus::cli::pbf {
namespace {

/// Curls are measured on the host, in about this many frames of a run.
constexpr int measured_frames = 50;

constexpr float confinements[] = {0.0f, 0.5f};
constexpr const char* colors[] = {"#8a93a0", "#1f6fb4"};

struct Tried {
  float confinement;
  RunFigures run;
  std::vector<double> time, kinetic, curl;  ///< s, J, and 1/s as RMS over the particles: of some frames
};

double rms_curl(const World& world) {
  double sum = 0;
  const auto curls = vorticity_of(world.positions(), world.velocities(), world.support_radius());
  for (const Vec3 curl : curls) sum += double{dot(curl, curl)};
  return std::sqrt(sum / static_cast<double>(std::max<std::size_t>(curls.size(), 1)));
}

Tried tried_with(const Context& context, Scene scene, float confinement) {
  for (FluidDef& fluid : scene.fluids) fluid.vorticity_confinement = confinement;
  Tried tried{confinement, {}, {}, {}, {}};
  const int stride = std::max(1, frames_of(scene, context.options.seconds) / measured_frames);
  const auto measure = [&](const World& world, int frame) {
    if (frame % stride != 0) return;
    tried.time.push_back(world.time());
    tried.kinetic.push_back(world.diagnostics().kinetic_energy);
    tried.curl.push_back(rms_curl(world));
  };
  tried.run = run_figures({.name = fmt::format("ε = {:g}", confinement),
                           .scene = scene,
                           .seconds = context.options.seconds,
                           .measured = false,
                           .after = measure},
                          context.budget);
  return tried;
}

std::vector<double> padded(std::vector<double> values, std::size_t length, double factor = 1) {
  for (double& value : values) value *= factor;
  values.resize(length, std::numeric_limits<double>::quiet_NaN());
  return values;
}

io::LineChart chart_of(const std::vector<Tried>& tried) {
  io::LineChart chart{"Dam break: vorticity confinement", "time (s)", tried.front().time, {}};
  chart.panels = {{"kinetic energy (kJ)", {}}, {"RMS vorticity (1/s)", {}}};
  for (std::size_t k = 0; k < tried.size(); ++k) {
    const std::string& name = tried[k].run.name;
    chart.panels[0].series.push_back({name, colors[k], padded(tried[k].kinetic, chart.x.size(), 1e-3)});
    chart.panels[1].series.push_back({name, colors[k], padded(tried[k].curl, chart.x.size())});
  }
  return chart;
}

}  // namespace

bool add_vorticity(const Context& context) {
  const PaperScene found = context.scene("dam_break");
  std::vector<Tried> tried;
  const bool done = for_each_until_stopped(
      confinements, [&](float strength) { tried.push_back(tried_with(context, found.scene, strength)); });

  io::Report& report = context.report;
  report.heading("Vorticity confinement");
  report.paragraph(
      "The dam break with the confinement of the samples, and without. Vorticity is measured from the "
      "positions and "
      "velocities of neighbours.");
  if (!tried.empty() && !tried.front().time.empty()) report.chart("vorticity", chart_of(tried));
  std::vector<io::Report::Cells> rows;
  for (const Tried& t : tried) {
    const double last = t.kinetic.empty() ? 0 : t.kinetic.back();
    rows.push_back({fmt::format("{:g}", t.confinement), fmt::format("{:.4g}", mean_of(t.kinetic)),
                    fmt::format("{:.4g}", last), fmt::format("{:.3g}", mean_of(t.curl)),
                    fmt::format("{:.3g}", t.curl.empty() ? 0 : t.curl.back()), t.run.failure});
    report.figures["vorticity"].push_back({{"confinement", t.confinement},
                                           {"time_s", t.time},
                                           {"kinetic_J", t.kinetic},
                                           {"rms_vorticity", t.curl},
                                           {"failure", t.run.failure}});
  }
  report.table({"ε", "kinetic energy, mean, J", "at the end, J", "RMS vorticity, mean, 1/s",
                "at the end, 1/s", "failure"},
               rows);
  return done;
}

}  // namespace meniscus::cli::pbf
