// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The benchmark of a dam break, with or without floating boxes.
#include "tests/bench/dam.h"

#include <chrono>
#include <cmath>
#include <optional>

#include "sdk/world/shared/shared_world.h"

namespace meniscus::bench {

namespace {

WorldDef dam_def(const CommonOptions& common, const DamOptions& o, int iterations) {
  WorldDef d = world_def(common);
  d.substeps = o.substeps;
  d.iterations = iterations;
  d.density.solver = solver_named(o.solver);
  d.density.tolerance = o.tolerance;
  if (o.fixed_sums) d.sums = Sums::fixed;
  if (o.device_contacts) d.rigid.solver = RigidSolver::device;
  if (o.diffuse) d.diffuse.emplace();
  return d;
}

/// Boxes of three spacings, half as dense as water, in layers over the dry part of the floor.
void add_boxes(World& world, int count, Vec3 block) {
  const float edge = 3 * world.def().particle_spacing, pitch = 4 * world.def().particle_spacing;
  const int along = int(2 * block.x / pitch), across = int(block.z / pitch);
  BodyDef box;
  box.geometry = BoxGeometry{{edge / 2, edge / 2, edge / 2}};
  for (int k = 0; k < count; ++k) {
    const int layer = k / (along * across), row = k / along % across, column = k % along;
    box.pose.position = {block.x + (float(column) + 0.5f) * pitch, (float(layer) + 0.5f) * pitch,
                         (float(row) + 0.5f) * pitch};
    world.create_body(box);
  }
}

Json run_case(const CommonOptions& common, const DamOptions& o, int particles, int iterations) {
  Dam dam(common, o, particles, iterations);
  std::optional<SharedWorld> shared;
  if (common.ranks) shared.emplace(dam.world, *common.ranks);
  if (!common.leads()) {
    shared->follow();
    return {};
  }
  for (int k = 0; k < o.warm_steps; ++k) dam.world.step(dam.dt);
  const double warm_speed = dam.world.diagnostics().max_speed;
  StepTimes times;
  const auto begin = std::chrono::steady_clock::now();
  for (int k = 0; k < o.timed_steps; ++k) times.add(dam.world.step(dam.dt));
  const double wall =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count() /
      o.timed_steps;
  const Diagnostics d = dam.world.diagnostics();
  return {{"particles", d.particles},
          {"substeps", o.substeps},
          {"iterations", iterations},
          {"solver", o.solver},
          {"tolerance", o.tolerance},
          {"fixed_sums", o.fixed_sums},
          {"ranks", common.ranks ? common.ranks->count() : 1},
          {"density_iterations", times.density_iterations()},
          {"dt_ms", 1e3 * dam.dt},
          {"h_moved_per_substep", d.max_speed * dam.dt / float(o.substeps) / dam.world.support_radius()},
          {"warm_max_speed", warm_speed},
          {"neighbours", d.neighbours_mean},
          {"ms_per_step", times.median_ms()},
          {"ms_per_step_mean_wall", wall},
          {"boxes", o.boxes},
          {"device_contacts", o.device_contacts},
          {"rigid_ms", times.rigid_ms()},
          {"diffuse", o.diffuse ? dam.world.diffuse().size() : 0},
          {"contacts", d.contacts},
          {"density_error_mean_percent", 100 * d.density_error_mean},
          {"density_error_max_percent", 100 * d.density_error_max},
          {"density_error_interior_percent", 100 * d.density_error_interior},
          {"outside", d.outside},
          {"non_finite", d.non_finite},
          {"bytes_per_particle", double(dam.world.device_bytes()) / double(d.particles)},
          {"stage_ms", times.stage_ms()}};
}

}  // namespace

Dam::Dam(const CommonOptions& common, const DamOptions& o, int particles, int iterations)
    : world(dam_def(common, o, iterations)) {
  const float s = world.def().particle_spacing;
  const double unit = std::cbrt(particles / 100.0);
  const Vec3 block{s * std::round(float(5 * unit)), s * std::round(float(4 * unit)),
                   s * std::round(float(5 * unit))};
  FluidDef water;
  water.vorticity_confinement = 0.1f;
  const FluidId fluid = world.create_fluid(water);
  const Vec3 half{1.5f * block.x, block.y, 0.5f * block.z};
  tank.geometry = ContainerGeometry{half, {{Face::y_high}}};
  tank.pose.position = half;
  world.create_shape(tank);
  FluidVolumeDef volume;
  volume.fluid = fluid;
  volume.region = BoxRegion{{0, 0, 0}, block};
  world.add_fluid(volume);
  add_boxes(world, o.boxes, block);
  dt = float(o.substeps) * o.step_in_h * world.support_radius() / std::sqrt(2 * 9.81f * block.y);
}

CLI::App* add_dam(CLI::App& app, DamOptions& o) {
  CLI::App* dam = app.add_subcommand("dam", "a dam break, with its density error");
  dam->add_option("--particles", o.particles, "how many, one case each")->delimiter(',');
  dam->add_option("--iterations", o.iterations, "a substep, one case each")->delimiter(',');
  dam->add_option("--substeps", o.substeps, "a step");
  dam->add_option("--boxes", o.boxes, "rigid bodies in the water's way");
  dam->add_flag("--device-contacts", o.device_contacts, "with RigidSolver::device");
  dam->add_flag("--diffuse", o.diffuse, "with spray, foam and bubbles");
  dam->add_flag("--fixed-sums", o.fixed_sums, "with WorldDef::sums fixed");
  dam->add_option("--warm", o.warm_steps, "steps before the clock starts");
  dam->add_option("--steps", o.timed_steps, "steps that are timed")->check(CLI::PositiveNumber);
  dam->add_option("--step-in-h", o.step_in_h,
                  "motion a substep, in support radii, that the time step is chosen for");
  dam->add_option("--tolerance", o.tolerance, "mean density error that ends the iterations");
  dam->add_option("--solver", o.solver)->check(is_solver());
  return dam;
}

void run_dam(const CommonOptions& common, const DamOptions& options, Results& results) {
  for (int particles : options.particles) {
    for (int iterations : options.iterations) results.add(run_case(common, options, particles, iterations));
  }
}

}  // namespace meniscus::bench
