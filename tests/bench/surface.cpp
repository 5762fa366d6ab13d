// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The benchmark of the surface mesh of a ball of fluid.
#include "tests/bench/surface.h"

#include <chrono>
#include <cmath>
#include <numbers>

#include "tests/unit/fluid/surfaces.h"

namespace meniscus::bench {

namespace {

Json run_case(const CommonOptions& common, const SurfaceOptions& o, int particles) {
  WorldDef def = world_def(common);
  def.gravity = {0, 0, 0};
  World world(def);
  const float s = def.particle_spacing;
  FluidVolumeDef ball;
  ball.fluid = world.create_fluid({});
  ball.region = BallRegion{s * static_cast<float>(std::cbrt(0.75 * particles / std::numbers::pi))};
  world.add_fluid(ball);
  SurfaceMeshDef surface;
  surface.cell_size = o.cell_size;
  SurfaceMesh mesh = world.surface_mesh(surface);  // finds out how much memory it takes
  std::vector<double> ms;
  for (int k = 0; k < o.times; ++k) {
    const auto begin = std::chrono::steady_clock::now();
    mesh = world.surface_mesh(surface);
    ms.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count());
  }
  const double volume = static_cast<double>(world.particle_count()) * std::pow(double{s}, 3);
  return {{"particles", world.particle_count()},
          {"cell_size", o.cell_size},
          {"surface_ms", quantile(ms, 0.5)},
          {"triangles", mesh.triangles.size()},
          {"open_edges", tests::open_edges(mesh.triangles)},
          {"volume_error_percent", 100 * (tests::volume_inside(mesh.vertices, mesh.triangles) / volume - 1)},
          {"bytes_per_particle", double(world.device_bytes()) / double(world.particle_count())}};
}

}  // namespace

CLI::App* add_surface(CLI::App& app, SurfaceOptions& o) {
  CLI::App* surface = app.add_subcommand("surface", "the surface mesh of a ball, read-out included");
  surface->add_option("--particles", o.particles, "about how many, one case each")->delimiter(',');
  surface->add_option("--cell", o.cell_size, "spacings");
  surface->add_option("--times", o.times, "how often")->check(CLI::PositiveNumber);
  return surface;
}

void run_surface(const CommonOptions& common, const SurfaceOptions& options, Results& results) {
  for (int particles : options.particles) results.add(run_case(common, options, particles));
}

}  // namespace meniscus::bench
