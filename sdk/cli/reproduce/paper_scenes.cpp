// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Reads the scenes of the paper, and scales them.
#include "sdk/cli/reproduce/paper_scenes.h"

#include <meniscus/error.h>
#include <spdlog/fmt/fmt.h>

#include <cmath>

#include "sdk/cli/commands/scene_lookup.h"

namespace meniscus::cli::pbf {
namespace {

/// A mesh of water, and the ball of the same volume. The radii are those of the counts that the samples
/// state.
struct MeshOfWater {
  const char* sample;
  const char* region;  ///< in the scene
  double volume;       ///< m³
  const char* what;
};

constexpr MeshOfWater meshes[] = {{"armadillo_splash", "volumes[0].region", 48, "armadillo"},
                                  {"bunny_drop", "volumes[1].region", 41.6, "bunny"}};

const MeshOfWater* mesh_of(const std::string& sample) {
  for (const MeshOfWater& mesh : meshes) {
    if (sample == mesh.sample) return &mesh;
  }
  return nullptr;
}

double ball_radius(double volume) {
  return std::cbrt(volume * 3 / (4 * 3.14159265358979));
}

SceneChoice choice_of(const std::string& sample, const ReproduceOptions& options) {
  return {sample, {}, options.device, options.threads};
}

PaperScene with_ball(const MeshOfWater& mesh, SceneChoice choice) {
  choice.overrides.push_back(
      fmt::format("{}={{\"type\":\"ball\",\"radius\":{:.4f}}}", mesh.region, ball_radius(mesh.volume)));
  return {
      chosen_scene(choice),
      fmt::format("The mesh of the {0} is not here. A ball of {1:g} m³, the volume of the {0}, stands in.",
                  mesh.what, mesh.volume)};
}

PaperScene full_scene(const std::string& sample, const ReproduceOptions& options) {
  SceneChoice choice = choice_of(sample, options);
  const MeshOfWater* mesh = mesh_of(sample);
  const bool is_armadillo = sample == "armadillo_splash";
  if (is_armadillo && options.armadillo.empty()) return with_ball(*mesh, choice);
  if (is_armadillo) choice.overrides.push_back("volumes[0].region.file=" + options.armadillo);
  try {
    return {chosen_scene(choice), ""};
  } catch (const Error& error) {
    if (is_armadillo || !mesh || error.code() != ErrorCode::io) throw;
    return with_ball(*mesh, choice_of(sample, options));
  }
}

}  // namespace

PaperScene Context::scene(const std::string& sample) const {
  PaperScene found = full_scene(sample, options);
  found.scene.world.diffuse.reset();
  found.scene.world.particle_spacing *= static_cast<float>(std::cbrt(1 / options.scale));
  return found;
}

RunFigures Context::run(const std::string& name, const Scene& scene, bool measured) const {
  return run_figures({.name = name, .scene = scene, .seconds = options.seconds, .measured = measured},
                     budget);
}

std::string setting_of(const Scene& scene) {
  return fmt::format("{} × {}", scene.world.substeps, scene.world.iterations);
}

Scene with_setting(Scene scene, int substeps, int iterations) {
  scene.world.substeps = substeps;
  scene.world.iterations = iterations;
  return scene;
}

Scene with_pcisph(Scene scene, int substeps, int iterations) {
  scene.world.density.solver = DensitySolver::pcisph;
  scene.world.density.artificial_pressure = {};
  scene.world.density.courant_number = 0;
  return with_setting(std::move(scene), substeps, iterations);
}

}  // namespace meniscus::cli::pbf
