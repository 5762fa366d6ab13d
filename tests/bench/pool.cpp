// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The benchmark of a pool at rest: how much its weight compresses it.
#include "tests/bench/pool.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace meniscus::bench {

namespace {

/// A square tank, filled to so many layers on the lattice, each particle a hundredth of a spacing out of
/// place.
World make_pool(const CommonOptions& common, const PoolOptions& o, int particles, int iterations) {
  WorldDef def = world_def(common);
  def.substeps = o.substeps;
  def.iterations = iterations;
  def.density.solver = solver_named(o.solver);
  World world(def);
  const float s = def.particle_spacing;
  const int across = std::max(4, int(std::lround(std::sqrt(double(particles) / o.layers))));
  const Vec3 half{0.5f * s * float(across), s * float(o.layers), 0.5f * s * float(across)};
  ShapeDef tank;
  tank.geometry = ContainerGeometry{half, {}};
  tank.pose.position = half;
  world.create_shape(tank);
  std::mt19937 random(1);
  std::uniform_real_distribution<float> noise(-0.01f * s, 0.01f * s);
  std::vector<Vec3> points;
  for (int y = 0; y < o.layers; ++y) {
    for (int z = 0; z < across; ++z) {
      for (int x = 0; x < across; ++x) {
        const float dx = noise(random), dy = noise(random), dz = noise(random);
        points.push_back(
            {s * (float(x) + 0.5f) + dx, s * (float(y) + 0.5f) + dy, s * (float(z) + 0.5f) + dz});
      }
    }
  }
  world.add_particles(world.create_fluid({}), points, {});
  return world;
}

/// ρ/ρ₀, averaged over frames: of all but the two top layers, and of the bottom fifth.
class Compression {
 public:
  explicit Compression(int layers) : layers_(layers) {}

  void add(const World& world) {
    const std::span<const Vec3> at = world.positions();
    const std::span<const float> error = world.density_errors();
    std::vector<size_t> order(at.size());
    std::iota(order.begin(), order.end(), size_t{0});
    std::sort(order.begin(), order.end(), [&](size_t a, size_t b) { return at[a].y < at[b].y; });
    const size_t layer = at.size() / size_t(layers_), inside = at.size() - 2 * layer, fifth = at.size() / 5;
    double sum = 0;
    for (size_t k = 0; k < inside; ++k) {
      sum += double(error[order[k]]);
      worst_ = std::max(worst_, 1 + double(error[order[k]]));
      if (k + 1 == fifth) bottom_ += 1 + sum / double(fifth);
    }
    mean_ += 1 + sum / double(inside);
    ++frames_;
  }

  double mean() const { return mean_ / frames_; }
  double bottom() const { return bottom_ / frames_; }
  double worst() const { return worst_; }

 private:
  int layers_;
  double mean_ = 0, bottom_ = 0, worst_ = 0, frames_ = 0;
};

Json run_case(const CommonOptions& common, const PoolOptions& o, int particles, int iterations) {
  World world = make_pool(common, o, particles, iterations);
  while (world.time() < o.settle_seconds) world.step(o.frame);
  StepTimes times;
  Compression compression(o.layers);
  double energy = 0, frames = 0;
  for (int k = 0; world.time() < o.settle_seconds + o.measure_seconds; ++k) {
    times.add(world.step(o.frame));
    energy += world.diagnostics().kinetic_energy;
    ++frames;
    if (k % 10 == 0) compression.add(world);
  }
  const Diagnostics d = world.diagnostics();
  const double s = double(world.def().particle_spacing), mass = 1000 * s * s * s * double(d.particles);
  return {{"particles", d.particles},
          {"layers", o.layers},
          {"substeps", o.substeps},
          {"iterations", iterations},
          {"solver", o.solver},
          {"frame_ms", 1e3 * double(o.frame)},
          {"neighbours", d.neighbours_mean},
          {"ms_per_frame", times.median_ms()},
          {"density_mean", compression.mean()},
          {"density_bottom_fifth", compression.bottom()},
          {"density_worst", compression.worst()},
          {"speed_rms", std::sqrt(2 * energy / frames / mass)},
          {"outside", d.outside},
          {"bytes_per_particle", double(world.device_bytes()) / double(d.particles)},
          {"stage_ms", times.stage_ms()}};
}

}  // namespace

CLI::App* add_pool(CLI::App& app, PoolOptions& o) {
  CLI::App* pool = app.add_subcommand("pool", "a pool at rest, with what its depth does to the density");
  pool->add_option("--particles", o.particles, "how many, one case each")->delimiter(',');
  pool->add_option("--iterations", o.iterations, "a substep, one case each")->delimiter(',');
  pool->add_option("--layers", o.layers, "of particles")->check(CLI::Range(4, 1000));
  pool->add_option("--substeps", o.substeps, "a frame");
  pool->add_option("--settle", o.settle_seconds, "seconds before the clock starts");
  pool->add_option("--measure", o.measure_seconds, "seconds over which time and density are averaged");
  pool->add_option("--solver", o.solver)->check(is_solver());
  return pool;
}

void run_pool(const CommonOptions& common, const PoolOptions& options, Results& results) {
  for (int particles : options.particles) {
    for (int iterations : options.iterations) results.add(run_case(common, options, particles, iterations));
  }
}

}  // namespace meniscus::bench
