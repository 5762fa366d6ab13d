// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The benchmark of a batch: many small dam breaks in the same launches, with different gravities.
#include "tests/bench/batch.h"

#include <array>
#include <chrono>
#include <cmath>
#include <functional>
#include <future>

namespace meniscus::bench {

namespace {

/// Boxes that float in the water.
void add_bodies(World& world, float side, int count) {
  for (int k = 0; k < count; ++k) {
    BodyDef body;
    body.geometry = BoxGeometry{{0.1f * side, 0.1f * side, 0.1f * side}};
    body.density = 500;
    body.pose.position = {side * (0.2f + 0.3f * static_cast<float>(k % 3)),
                          side * (1.2f + 0.3f * static_cast<float>(k / 9)),
                          side * (0.2f + 0.3f * static_cast<float>(k / 3 % 3))};
    world.create_body(body);
  }
}

/// A square sheet of so many vertices a side, held at its corners above the right half, where the water goes.
void add_cloth(World& world, float side, int vertices) {
  if (vertices == 0) return;
  ClothDef cloth;
  cloth.geometry = SheetGeometry{0.8f * side, 0.8f * side, vertices, vertices};
  cloth.pose.position = {1.5f * side, 0.4f * side, 0.5f * side};
  AttachmentDef corners;
  corners.cloth = world.create_cloth(cloth);
  const auto n = static_cast<uint32_t>(vertices);
  corners.vertices = {0, n - 1, n * (n - 1), n * n - 1};
  world.create_attachment(corners);
}

/// A box with a column of water in its left half.
World small_dam(const CommonOptions& common, const BatchOptions& o) {
  WorldDef def = world_def(common);
  def.sums = Sums::fixed;
  def.substeps = o.substeps;
  def.iterations = o.iterations;
  World world(def);
  const float side = def.particle_spacing * std::round(std::cbrt(static_cast<float>(o.particles)));
  ShapeDef tank;
  tank.geometry = ContainerGeometry{{side, side, 0.5f * side}, {}};
  tank.pose.position = {side, side, 0.5f * side};
  world.create_shape(tank);
  FluidVolumeDef column;
  column.fluid = world.create_fluid({});
  column.region = BoxRegion{{0, 0, 0}, {side, side, side}};
  world.add_fluid(column);
  add_bodies(world, side, o.bodies);
  add_cloth(world, side, o.cloth);
  return world;
}

/// A step's reset: each `share`-th world, another one each time.
std::vector<uint8_t> some_worlds(uint32_t worlds, double share, int step) {
  std::vector<uint8_t> mask(worlds, 0);
  const double count = share * worlds;
  for (int k = 0; k < static_cast<int>(count); ++k)
    mask[(static_cast<uint32_t>(step) * 7919u + static_cast<uint32_t>(k / share)) % worlds] = 1;
  return mask;
}

/// The worlds of a case, in one or several batches that step at once, each on a host thread.
class Batches {
 public:
  Batches(const CommonOptions& common, const BatchOptions& o, uint32_t worlds) {
    const World archetype = small_dam(common, o);
    const auto count = static_cast<uint32_t>(o.batches);
    for (uint32_t k = 0; k < count; ++k) {
      const uint32_t first = worlds * k / count, end = worlds * (k + 1) / count;
      batches_.emplace_back(archetype, BatchDef{end - first, o.rigid_threads});
      std::vector<Vec3> gravities;
      for (uint32_t w = first; w < end; ++w)
        gravities.push_back({0.01f * static_cast<float>(w % 100), -9.81f, 0});
      batches_.back().set_gravities(gravities);
    }
  }
  /// Resets a share of the worlds, and steps all.
  BatchReport step(const BatchOptions& o, int number) {
    const auto step_one = [&](WorldBatch& batch) {
      if (o.reset > 0) batch.reset(some_worlds(batch.worlds(), o.reset, number));
      return batch.step(o.frame);
    };
    std::vector<std::future<BatchReport>> others;
    for (size_t k = 1; k < batches_.size(); ++k)
      others.push_back(std::async(std::launch::async, step_one, std::ref(batches_[k])));
    BatchReport report = step_one(batches_[0]);
    for (auto& other : others) report.failed += other.get().failed;
    return report;
  }
  MemoryUse memory() const {
    MemoryUse sum;
    for (const WorldBatch& batch : batches_) {
      sum.bytes += batch.memory_stats().device.bytes;
      sum.allocations += batch.memory_stats().device.allocations;
    }
    return sum;
  }
  const WorldBatch& first() const { return batches_[0]; }

 private:
  std::vector<WorldBatch> batches_;
};

Json run_case(const CommonOptions& common, const BatchOptions& o, int worlds) {
  using Clock = std::chrono::steady_clock;
  Batches batches(common, o, static_cast<uint32_t>(worlds));
  BatchOptions warm = o;
  warm.reset = 0;
  for (int k = 0; k < o.steps; ++k) batches.step(warm, k);
  const uint64_t allocations = batches.memory().allocations;
  std::vector<double> ms;
  uint32_t failed = 0, neighbours = 0;
  double rigid_ms = 0, turns = 0;
  std::array<double, stage_count> stage_ms{};
  for (int k = 0; k < o.steps; ++k) {
    const auto start = Clock::now();
    const BatchReport report = batches.step(o, k);
    ms.push_back(std::chrono::duration<double, std::milli>(Clock::now() - start).count());
    failed += report.failed;
    neighbours = report.max_neighbours;
    rigid_ms += report.rigid_ms / o.steps;
    turns += double(report.turns) / o.steps;
    for (size_t s = 0; s < stage_count; ++s) stage_ms[s] += report.stage_ms[s] / o.steps;
  }
  Json stages;
  for (size_t s = 0; s < stage_count; ++s) stages[stage_name(static_cast<Stage>(s))] = stage_ms[s];
  const WorldBatch& batch = batches.first();
  const double median = quantile(ms, 0.5), all = double(worlds) * double(batch.particle_count());
  const MemoryUse memory = batches.memory();
  return {{"worlds", worlds},
          {"batches", o.batches},
          {"particles_each", batch.particle_count()},
          {"bodies_each", batch.body_count()},
          {"cloth_vertices_each", batch.vertex_count()},
          {"substeps", o.substeps},
          {"iterations", o.iterations},
          {"reset", o.reset},
          {"ms_per_step", median},
          {"ms_per_substep", median / o.substeps},
          {"p99_ms", quantile(ms, 0.99)},
          {"world_steps_per_second", 1e3 * double(worlds) / median},
          {"us_per_world", 1e3 * median / worlds},
          {"turns", turns},
          {"rigid_ms", rigid_ms},
          {"stage_ms", stages},
          {"failed", failed},
          {"max_neighbours", neighbours},
          {"allocations", memory.allocations - allocations},
          {"bytes_per_particle", double(memory.bytes) / all},
          {"bytes_per_world", double(memory.bytes) / worlds}};
}

}  // namespace

CLI::App* add_batch(CLI::App& app, BatchOptions& o) {
  CLI::App* batch = app.add_subcommand("batch", "many small dam breaks in the same launches");
  batch->add_option("--worlds", o.worlds, "how many, one case each")
      ->delimiter(',')
      ->check(CLI::Range(1, 65536));
  batch->add_option("--particles", o.particles, "of each world, about")->check(CLI::Range(8, 1000000));
  batch->add_option("--bodies", o.bodies, "of each world")->check(CLI::Range(0, 1000));
  batch->add_option("--cloth", o.cloth, "vertices along each side of a sheet in each world; 0: none")
      ->check(CLI::IsMember({0}) | CLI::Range(2, 1000));
  batch->add_option("--batches", o.batches, "that have the worlds, and step at once on host threads")
      ->check(CLI::Range(1, 64));
  batch->add_option("--rigid-threads", o.rigid_threads, "that step bodies; 0: one a core")
      ->check(CLI::Range(0, 1024));
  batch->add_option("--substeps", o.substeps, "a step");
  batch->add_option("--iterations", o.iterations, "a substep");
  batch->add_option("--steps", o.steps, "that are timed, after as many")->check(CLI::Range(1, 100000));
  batch->add_option("--reset", o.reset, "share of the worlds that each step resets")
      ->check(CLI::Range(0.0, 1.0));
  return batch;
}

void run_batch(const CommonOptions& common, const BatchOptions& options, Results& results) {
  for (int worlds : options.worlds) results.add(run_case(common, options, worlds));
}

}  // namespace meniscus::bench
