// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Implements `meniscus check`: reads a scene, builds its world on the CPU, and prints its contents.
#include "sdk/cli/commands/check.h"

#include <spdlog/fmt/fmt.h>

#include "sdk/cli/commands/exit_code.h"
#include "sdk/cli/commands/scene_lookup.h"
#include "sdk/cli/commands/scene_mesh_report.h"
#include "sdk/cli/commands/scene_warnings.h"
#include "sdk/cli/record/scene_checks.h"
#include "sdk/io/plain_text.h"

namespace meniscus::cli {

namespace {

void print_cloth(const Scene& scene, const BuiltScene& built) {
  std::size_t vertices = 0, triangles = 0, points = 0;
  for (const ClothId id : built.cloths) {
    vertices += built.world.cloth_positions(id).size();
    triangles += built.world.cloth_triangles(id).size() / 3;
  }
  for (const RopeId id : built.ropes) points += built.world.rope_positions(id).size();
  fmt::print("  cloths {} of {} vertices and {} triangles, ropes {} of {} vertices, attachments {}\n",
             scene.cloths.size(), vertices, triangles, scene.ropes.size(), points, scene.attachments.size());
}

}  // namespace

int check_scene(const CheckOptions& options) {
  Scene scene = find_scene(options.scene, options.overrides);
  scene.world.device = DeviceChoice::cpu;
  scene.relax_iterations = 0;
  const BuiltScene built = build_scene(scene);
  expect_floor(scene);
  warn_of_oddities(built);
  fmt::print("{}: valid\n", io::plain_text(scene.name));
  if (!scene.description.empty()) fmt::print("  {}\n", io::plain_text(scene.description, "\n"));
  fmt::print("  fluids {}, shapes {}, bodies {}, joints {}, volumes {}, emitters {}, sinks {}, probes {}\n",
             scene.fluids.size(), scene.shapes.size(), built.bodies.size(), scene.joints.size(),
             scene.volumes.size(), scene.emitters.size(), scene.sinks.size(), scene.probes.size());
  if (!scene.cloths.empty() || !scene.ropes.empty()) print_cloth(scene, built);
  fmt::print("  particles {}, {:.4g} m apart, support radius {:.4g} m\n", built.world.particle_count(),
             scene.world.particle_spacing, built.world.support_radius());
  print_meshes(scene);
  fmt::print("  frames {} of {:.4g} s, checks {}\n", scene.frames, scene.frame_time, scene.checks.size());
  return success;
}

}  // namespace meniscus::cli
