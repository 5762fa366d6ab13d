// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Times steps of a dam break and says what the solve was worth: a speed without its density error says
// nothing.
//   bench --device cuda --particles 100000,1000000 --iterations 4 --out FILE
//   bench --device cuda --particles 100000 --iterations 4 --boxes 1000 --out FILE
#include <meniscus/meniscus.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>

namespace {

using meniscus::Vec3;
using Json = nlohmann::ordered_json;

struct Options {
  std::string device = "auto";
  std::vector<int> particles{100000};
  std::vector<int> iterations{4};
  int substeps = 1;
  int threads = 0;
  int boxes = 0;
  int warm_steps = 200;
  int timed_steps = 200;
  float step_in_h =
      0.2f;  // how far, in support radii, a particle falling from the dam's top may move in a substep
  std::string solver = "chebyshev";
  std::string commit, date, out;
};

meniscus::DeviceChoice choice(const std::string& name) {
  if (name == "cpu") return meniscus::DeviceChoice::cpu;
  return name == "cuda" ? meniscus::DeviceChoice::cuda : meniscus::DeviceChoice::automatic;
}

/// A block of water, a third of its tank, with edges as 5 to 4 to 5; support radius of two spacings.
struct Dam {
  meniscus::World world;
  float dt;

  static meniscus::WorldDef def(const Options& o, int iterations) {
    meniscus::WorldDef d;
    d.device = choice(o.device);
    d.threads = o.threads;
    d.substeps = o.substeps;
    d.iterations = iterations;
    d.density.solver =
        o.solver == "jacobi" ? meniscus::DensitySolver::jacobi : meniscus::DensitySolver::chebyshev;
    return d;
  }

  Dam(const Options& o, int particles, int iterations) : world(def(o, iterations)) {
    const float s = world.def().particle_spacing;
    const double unit = std::cbrt(particles / 100.0);
    const Vec3 block{s * std::round(float(5 * unit)), s * std::round(float(4 * unit)),
                     s * std::round(float(5 * unit))};
    meniscus::FluidDef water;
    water.vorticity_confinement = 0.1f;
    const meniscus::FluidId fluid = world.create_fluid(water);
    const Vec3 half{1.5f * block.x, block.y, 0.5f * block.z};
    meniscus::ShapeDef tank;
    tank.geometry = meniscus::ContainerGeometry{half, {{meniscus::Face::y_high}}};
    tank.pose.position = half;
    world.create_shape(tank);
    meniscus::FluidVolumeDef volume;
    volume.fluid = fluid;
    volume.region = meniscus::BoxRegion{{0, 0, 0}, block};
    world.add_fluid(volume);
    add_boxes(o.boxes, block);
    dt = float(o.substeps) * o.step_in_h * world.support_radius() / std::sqrt(2 * 9.81f * block.y);
  }

  /// Boxes of three spacings, half as dense as water, in layers over the dry part of the floor.
  void add_boxes(int count, Vec3 block) {
    const float edge = 3 * world.def().particle_spacing, pitch = 4 * world.def().particle_spacing;
    const int along = int(2 * block.x / pitch), across = int(block.z / pitch);
    meniscus::BodyDef box;
    box.geometry = meniscus::BoxGeometry{{edge / 2, edge / 2, edge / 2}};
    for (int k = 0; k < count; ++k) {
      const int layer = k / (along * across), row = k / along % across, column = k % along;
      box.pose.position = {block.x + (float(column) + 0.5f) * pitch, (float(layer) + 0.5f) * pitch,
                           (float(row) + 0.5f) * pitch};
      world.create_body(box);
    }
  }
};

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + long(values.size() / 2), values.end());
  return values[values.size() / 2];
}

Json run_case(const Options& o, int particles, int iterations) {
  Dam dam(o, particles, iterations);
  for (int k = 0; k < o.warm_steps; ++k) dam.world.step(dam.dt);
  const double warm_speed = dam.world.diagnostics().max_speed;
  std::vector<double> ms;
  std::vector<double> rigid_ms;
  std::array<std::vector<double>, meniscus::stage_count> stages;
  const auto begin = std::chrono::steady_clock::now();
  for (int k = 0; k < o.timed_steps; ++k) {
    const meniscus::StepReport report = dam.world.step(dam.dt);
    ms.push_back(report.ms);
    rigid_ms.push_back(report.rigid_ms);
    for (size_t s = 0; s < stages.size(); ++s) stages[s].push_back(report.stage_ms[s]);
  }
  const double wall =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count() /
      o.timed_steps;
  const meniscus::Diagnostics d = dam.world.diagnostics();
  const double n = double(d.particles);
  Json r{{"particles", d.particles},
         {"substeps", o.substeps},
         {"iterations", iterations},
         {"solver", o.solver},
         {"dt_ms", 1e3 * dam.dt},
         {"h_moved_per_substep", d.max_speed * dam.dt / float(o.substeps) / dam.world.support_radius()},
         {"warm_max_speed", warm_speed},
         {"neighbours", d.neighbours_mean},
         {"ms_per_step", median(ms)},
         {"ms_per_step_mean_wall", wall},
         {"boxes", o.boxes},
         {"rigid_ms", median(rigid_ms)},
         {"contacts", d.contacts},
         {"density_error_mean_percent", 100 * d.density_error_mean},
         {"density_error_max_percent", 100 * d.density_error_max},
         {"density_error_interior_percent", 100 * d.density_error_interior},
         {"outside", d.outside},
         {"non_finite", d.non_finite},
         {"bytes_per_particle", double(dam.world.device_bytes()) / n}};
  for (size_t s = 0; s < stages.size(); ++s) {
    r["stage_ms"][meniscus::stage_name(meniscus::Stage(s))] = median(stages[s]);
  }
  return r;
}

}  // namespace

int main(int argc, char** argv) {
  Options o;
  CLI::App app("Times the steps of a dam break");
  app.add_option("--device", o.device, "auto, cpu or cuda");
  app.add_option("--particles", o.particles, "how many, one case each")->delimiter(',');
  app.add_option("--iterations", o.iterations, "a substep, one case each")->delimiter(',');
  app.add_option("--substeps", o.substeps, "a step");
  app.add_option("--boxes", o.boxes, "rigid bodies in the water's way");
  app.add_option("--threads", o.threads, "of the CPU; 0: one a core");
  app.add_option("--warm", o.warm_steps, "steps before the clock starts");
  app.add_option("--steps", o.timed_steps, "steps that are timed");
  app.add_option("--step-in-h", o.step_in_h,
                 "motion a substep, in support radii, that the time step is chosen for");
  app.add_option("--solver", o.solver, "jacobi or chebyshev");
  app.add_option("--commit", o.commit, "noted in the results");
  app.add_option("--date", o.date, "noted in the results");
  app.add_option("--out", o.out, "write the results here as well");
  CLI11_PARSE(app, argc, argv);
  try {
    Json all{
        {"command", ""}, {"date", o.date}, {"commit", o.commit}, {"device", ""}, {"results", Json::array()}};
    std::string command = "bench";
    for (int i = 1; i < argc; ++i) {
      if (argv[i] == std::string("--out")) {
        ++i;  // where the file went says nothing about what is in it
      } else {
        command += std::string(" ") + argv[i];
      }
    }
    all["command"] = command;
    all["device"] = meniscus::World(Dam::def(o, 1)).device().name;
    for (int particles : o.particles) {
      for (int iterations : o.iterations) {
        all["results"].push_back(run_case(o, particles, iterations));
        std::cout << all["results"].back().dump() << std::endl;
      }
    }
    if (!o.out.empty()) std::ofstream(o.out) << all.dump(2) << "\n";
  } catch (const meniscus::Error& error) {
    std::cerr << "bench: " << error.what() << "\n";
    return 1;
  }
}
