// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The benchmark of water on a sheet of cloth.
#include "tests/bench/sheet.h"

#include <algorithm>
#include <cmath>

#include "tests/bench/edge_stretch.h"
#include "tests/sheet_crossings.h"

namespace meniscus::bench {

namespace {

struct Case {
  float density;
  int substeps, iterations;
};

struct WaterOnSheet {
  World world;
  ClothId cloth;
};

WaterOnSheet make_world(const CommonOptions& common, const SheetOptions& o, const Case& c) {
  WorldDef def = world_def(common);
  def.particle_spacing = 1 / static_cast<float>(o.layers);
  def.substeps = c.substeps;
  def.iterations = c.iterations;
  def.density.solver = solver_named(o.solver);
  World world(def);
  const FluidId water = world.create_fluid({});
  ShapeDef tank;
  tank.geometry = ContainerGeometry{{0.5f, 2, 0.5f}, {{.face = Face::y_high}}};
  tank.pose.position = {0, 1, 0};
  world.create_shape(tank);
  ClothDef sheet;
  sheet.geometry = SheetGeometry{1, 1, o.n, o.n};
  sheet.fabric.density = c.density;
  sheet.fabric.warp_stiffness = sheet.fabric.weft_stiffness = 2e5f;
  sheet.self_collision = o.self_collision;
  const ClothId cloth = world.create_cloth(sheet);
  AttachmentDef pins;
  pins.cloth = cloth;
  for (int v = 0; v < o.n * o.n; ++v) {
    if (v / o.n % (o.n - 1) == 0 || v % o.n % (o.n - 1) == 0) pins.vertices.push_back(uint32_t(v));
  }
  world.create_attachment(pins);
  FluidVolumeDef block;
  block.fluid = water;
  const float gap = 0.92f * def.particle_spacing;
  block.region = BoxRegion{{-0.5f, gap, -0.5f}, {0.5f, gap + 1.0001f, 0.5f}};
  world.add_fluid(block);
  return {std::move(world), cloth};
}

/// Behind the warm-up: the worst stretch of all steps, and the density error of every sixth.
struct Quality {
  double stretch_worst = 0, density_error = 0, density_error_worst = 0, looks = 0;
};

/// The number of particles that pass through the sheet, in a separate run. Displacements are straight only
/// from substep to substep, so each substep is a step here.
size_t count_crossings(const CommonOptions& common, const SheetOptions& o, const Case& c) {
  WaterOnSheet w = make_world(common, o, {c.density, 1, c.iterations});
  World& world = w.world;
  tests::SheetCrossings crossings(world.cloth_positions(w.cloth), world.cloth_triangles(w.cloth));
  const float substep = o.frame / static_cast<float>(c.substeps);
  size_t crossed = crossings.advance(world.cloth_positions(w.cloth), world.positions());
  while (world.time() < o.seconds - 0.5 * double{substep}) {
    world.step(substep);
    crossed += crossings.advance(world.cloth_positions(w.cloth), world.positions());
  }
  return crossed;
}

Json run_case(const CommonOptions& common, const SheetOptions& o, const Case& c) {
  WaterOnSheet w = make_world(common, o, c);
  World& world = w.world;
  const auto vertices = [&] { return world.cloth_positions(w.cloth); };
  const EdgeStretch stretch(vertices(), world.cloth_triangles(w.cloth), uint32_t(o.n));
  StepTimes times;
  Quality q;
  int steps = 0;
  while (world.time() < o.seconds - 0.5 * double{o.frame}) {
    const StepReport report = world.step(o.frame);
    if (world.time() < o.warm) continue;
    times.add(report);
    q.stretch_worst = std::max(q.stretch_worst, stretch.of_chains(vertices()).mean);
    if (++steps % 6) continue;
    const double error = world.diagnostics().density_error_mean;
    q.density_error += error;
    q.density_error_worst = std::max(q.density_error_worst, error);
    ++q.looks;
  }
  const Stretch end = stretch.of_chains(vertices());
  const Diagnostics d = world.diagnostics();
  return {{"n", o.n},
          {"particles", d.particles},
          {"fabric_density", c.density},
          {"substeps", c.substeps},
          {"iterations", c.iterations},
          {"solver", o.solver},
          {"self_collision", o.self_collision},
          {"frame_ms", 1e3 * double{o.frame}},
          {"seconds", o.seconds},
          {"ms_per_frame", times.median_ms()},
          {"ms_per_frame_p99", times.p99_ms()},
          {"crossings", count_crossings(common, o, c)},
          {"stretch_mean", end.mean},
          {"stretch_mean_worst", q.stretch_worst},
          {"stretch_p99", end.p99},
          {"stretch_max", end.max},
          {"density_error_mean_percent", 100 * q.density_error / q.looks},
          {"density_error_worst_percent", 100 * q.density_error_worst},
          {"max_speed", d.max_speed},
          {"outside", d.outside},
          {"contacts", d.contacts},
          {"stage_ms", times.stage_ms()}};
}

}  // namespace

CLI::App* add_sheet(CLI::App& app, SheetOptions& o) {
  CLI::App* sheet =
      app.add_subcommand("sheet", "water on a pinned sheet, with its stretch and what got through");
  sheet->add_option("--fabric-density", o.densities, "kg/m², one case each")->delimiter(',');
  sheet->add_option("--substeps", o.substeps, "a frame, one case each")->delimiter(',');
  sheet->add_option("--iterations", o.iterations, "a substep, one case each")->delimiter(',');
  sheet->add_option("--solver", o.solver)->check(is_solver());
  sheet->add_flag("--self-collision,!--no-self-collision", o.self_collision);
  sheet->add_option("-n,--n", o.n, "vertices along each side")->check(CLI::Range(2, 2000));
  sheet->add_option("--layers", o.layers, "of particles")->check(CLI::Range(4, 1000));
  sheet->add_option("--warm", o.warm, "s before the clock starts");
  sheet->add_option("--seconds", o.seconds, "s in all")->check(CLI::PositiveNumber);
  return sheet;
}

void run_sheet(const CommonOptions& common, const SheetOptions& o, Results& results) {
  for (float density : o.densities) {
    for (int substeps : o.substeps) {
      for (int iterations : o.iterations) results.add(run_case(common, o, {density, substeps, iterations}));
    }
  }
}

}  // namespace meniscus::bench
