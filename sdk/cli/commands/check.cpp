// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#include "sdk/cli/commands/check.h"

#include <spdlog/fmt/fmt.h>

#include "sdk/cli/program.h"
#include "sdk/cli/scene_lookup.h"

namespace meniscus::cli {

int check_scene(const CheckOptions& options) {
  Scene scene = find_scene(options.scene, options.overrides);
  scene.world.device = DeviceChoice::cpu;
  scene.relax_iterations = 0;
  const BuiltScene built = build_scene(scene);
  fmt::print("{}: valid\n", scene.name);
  if (!scene.description.empty()) fmt::print("  {}\n", scene.description);
  fmt::print("  fluids {}, shapes {}, bodies {}, joints {}, volumes {}, sinks {}, probes {}\n",
             scene.fluids.size(), scene.shapes.size(), built.bodies.size(), scene.joints.size(),
             scene.volumes.size(), scene.sinks.size(), scene.probes.size());
  fmt::print("  particles {}, {:.4g} m apart, support radius {:.4g} m\n", built.world.particle_count(),
             scene.world.particle_spacing, built.world.support_radius());
  fmt::print("  frames {} of {:.4g} s\n", scene.frames, scene.frame_time);
  return success;
}

}  // namespace meniscus::cli
