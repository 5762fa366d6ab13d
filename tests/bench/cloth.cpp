// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The benchmark of cloth: a hanging sheet, and a sheet that falls onto a ball.
#include "tests/bench/cloth.h"

#include <cmath>
#include <numbers>

#include "tests/bench/edge_stretch.h"
#include "tests/triangle_intersections.h"

namespace meniscus::bench {

namespace {

constexpr float size = 2;  // m, of the sheet

struct Case {
  int n, substeps, iterations;
};

struct Sheet {
  World world;
  ClothId cloth;
  EdgeStretch stretch;

  Sheet(World&& w, ClothId id, int n)
      : world(std::move(w)),
        cloth(id),
        stretch(world.cloth_positions(id), world.cloth_triangles(id), uint32_t(n)) {}
};

World make_world(const CommonOptions& common, const ClothOptions& o, const Case& c) {
  WorldDef def = world_def(common);
  def.substeps = c.substeps;
  def.iterations = c.iterations;
  def.cloth = o.solver;
  return World(def);
}

ClothDef sheet_def(const ClothOptions& o, int n) {
  ClothDef def;
  def.geometry = SheetGeometry{size, size, n, n};
  def.fabric = o.fabric;
  def.fabric.stretch_model = o.stretch == "triangles" ? StretchModel::triangles : StretchModel::edges;
  def.tethers = o.tethers;
  def.self_collision = o.self_collision;
  return def;
}

/// In the plane z = 0, the first row on top and held.
Sheet hanging_sheet(const CommonOptions& common, const ClothOptions& o, const Case& c) {
  World world = make_world(common, o, c);
  ClothDef def = sheet_def(o, c.n);
  const float half_turn = std::numbers::sqrt2_v<float> / 2;
  def.pose.rotation = {half_turn, 0, 0, half_turn};
  const ClothId cloth = world.create_cloth(def);
  AttachmentDef rail;
  rail.cloth = cloth;
  for (int k = 0; k < c.n; ++k) rail.vertices.push_back(uint32_t(k));
  world.create_attachment(rail);
  return {std::move(world), cloth, c.n};
}

/// Level, above a ball, which is so near to the floor that the corners come to lie on it.
Sheet dropped_sheet(const CommonOptions& common, const ClothOptions& o, const Case& c) {
  World world = make_world(common, o, c);
  ShapeDef solid;
  solid.surface.friction = 0.3f;
  world.create_shape(solid);
  solid.geometry = SphereGeometry{0.5f};
  solid.pose.position = {0, 0.6f, 0};
  world.create_shape(solid);
  ClothDef def = sheet_def(o, c.n);
  def.pose.position = {0, 1.3f, 0};
  const ClothId cloth = world.create_cloth(def);
  return {std::move(world), cloth, c.n};
}

/// The longest of the columns, along its edges and straight from end to end, over what it is at rest. Buckled
/// cloth has the two differ.
void write_lengths(Json& result, const Sheet& sheet, int n) {
  const auto x = sheet.world.cloth_positions(sheet.cloth);
  const auto columns = size_t(n), last = columns * (columns - 1);
  double longest = 0, straight = 0;
  for (size_t column = 0; column < columns; ++column) {
    double length = 0;
    for (size_t v = column; v < last; v += columns) length += distance(x[v], x[v + columns]);
    longest = std::max(longest, length);
    straight = std::max(straight, distance(x[column], x[last + column]));
  }
  result["length_ratio"] = longest / size;
  result["straight_ratio"] = straight / size;
}

size_t intersections(const Sheet& sheet) {
  const auto numbers = sheet.world.cloth_triangles(sheet.cloth);
  std::vector<tests::TriangleIntersections::Triangle> triangles;
  for (size_t t = 0; t < numbers.size(); t += 3)
    triangles.push_back({numbers[t], numbers[t + 1], numbers[t + 2]});
  return tests::TriangleIntersections(sheet.world.cloth_positions(sheet.cloth), triangles).count();
}

void write(Json& result, const std::string& name, const Stretch& stretch) {
  result[name + "_mean"] = stretch.mean;
  result[name + "_p99"] = stretch.p99;
  result[name + "_max"] = stretch.max;
}

/// Of the end, but for yarn_stretch_p99_worst: that of all moments that were looked at, from `warm` on.
Json run_case(Sheet& sheet, const ClothOptions& o, const Case& c) {
  const auto frames_of = [&](double seconds) { return int(std::lround(seconds / o.dt)); };
  const int warm = frames_of(o.warm), frames = frames_of(o.seconds),
            look_every = std::max(1, frames_of(0.25));
  StepTimes times;
  StepReport last;
  double worst = 0;
  for (int k = 0; k < frames; ++k) {
    last = sheet.world.step(float(o.dt));
    if (k < warm) continue;
    times.add(last);
    if (k % look_every == 0)
      worst = std::max(worst, sheet.stretch.of_chains(sheet.world.cloth_positions(sheet.cloth)).p99);
  }
  const auto positions = sheet.world.cloth_positions(sheet.cloth);
  const ClothState state = sheet.world.cloth_state(sheet.cloth);
  Json r{{"n", c.n},
         {"vertices", positions.size()},
         {"substeps", c.substeps},
         {"iterations", c.iterations},
         {"tethers", o.tethers},
         {"self_collision", o.self_collision},
         {"dt_ms", 1e3 * o.dt},
         {"seconds", o.seconds},
         {"ms_per_step", times.median_ms()},
         {"ms_per_step_p99", times.p99_ms()}};
  write(r, "edge_stretch", sheet.stretch.of_all(positions));
  write(r, "yarn_stretch", sheet.stretch.of_chains(positions));
  r["yarn_stretch_p99_worst"] = worst;
  r["rms_speed"] = std::sqrt(2 * double(state.kinetic_energy) / state.mass);
  r["max_speed"] = last.max_speed;
  r["contacts"] = last.contacts;
  r["bytes_per_vertex"] = double(sheet.world.device_bytes()) / double(positions.size());
  if (o.count_intersections) r["intersections"] = intersections(sheet);
  r["stage_ms"] = times.stage_ms();
  return r;
}

CLI::App* add_cloth(CLI::App* app, ClothOptions& o) {
  app->add_option("-n,--n", o.n, "vertices along each side; one case for each n, substeps and iterations")
      ->delimiter(',');
  app->add_option("--substeps", o.substeps, "a step")->delimiter(',');
  app->add_option("--iterations", o.iterations, "a substep")->delimiter(',');
  app->add_option("--dt", o.dt, "of a step, s")->check(CLI::PositiveNumber);
  app->add_option("--warm", o.warm, "s before the clock starts");
  app->add_option("--seconds", o.seconds, "s in all")->check(CLI::PositiveNumber);
  app->add_flag("--tethers,!--no-tethers", o.tethers);
  app->add_flag("--self-collision,!--no-self-collision", o.self_collision);
  app->add_flag("--intersections,!--no-intersections", o.count_intersections,
                "count the triangles that pass through one another in the end");
  app->add_option("--stretch", o.stretch, "model")->check(CLI::IsMember({"edges", "triangles"}));
  app->add_option("--stiffness", o.fabric.warp_stiffness, "of warp and weft, N/m");
  app->add_option("--shear-stiffness", o.fabric.shear_stiffness, "N/m");
  app->add_option("--bending-stiffness", o.fabric.bending_stiffness, "N·m");
  app->add_option("--stretch-damping", o.fabric.stretch_damping, "s");
  app->add_option("--bending-damping", o.fabric.bending_damping, "s");
  app->add_option("--friction", o.fabric.friction, "of cloth on cloth");
  app->add_option("--thickness", o.fabric.thickness, "m; 0: a quarter of an edge");
  app->add_option("--over-relaxation", o.solver.over_relaxation);
  app->add_option("--warm-start", o.solver.warm_start);
  app->add_option("--stretch-rounds", o.solver.stretch_rounds, "of stretch in a substep's last iteration");
  return app;
}

void run_cloth(const CommonOptions& common, ClothOptions o, Results& results, bool hangs) {
  o.fabric.weft_stiffness = o.fabric.warp_stiffness;
  const auto run = [&](const Case& c) {
    Sheet sheet = hangs ? hanging_sheet(common, o, c) : dropped_sheet(common, o, c);
    Json result = run_case(sheet, o, c);
    if (hangs) write_lengths(result, sheet, c.n);
    results.add(result);
  };
  for (int n : o.n) {
    for (int substeps : o.substeps) {
      for (int iterations : o.iterations) run({n, substeps, iterations});
    }
  }
}

}  // namespace

CLI::App* add_hanging(CLI::App& app, ClothOptions& o) {
  return add_cloth(app.add_subcommand("hanging", "a sheet that hangs by its top row, with its stretch"), o);
}

CLI::App* add_drape(CLI::App& app, ClothOptions& o) {
  o.self_collision = o.count_intersections = true;
  o.seconds = 4;
  return add_cloth(app.add_subcommand("drape", "a sheet dropped on a ball, with its stretch"), o);
}

void run_hanging(const CommonOptions& common, const ClothOptions& options, Results& results) {
  run_cloth(common, options, results, true);
}

void run_drape(const CommonOptions& common, const ClothOptions& options, Results& results) {
  run_cloth(common, options, results, false);
}

}  // namespace meniscus::bench
