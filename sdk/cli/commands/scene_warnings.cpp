// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Implements the warnings about scenes.
#include "sdk/cli/commands/scene_warnings.h"

#include <spdlog/spdlog.h>

namespace meniscus::cli {

void warn_of_oddities(const BuiltScene& built) {
  for (std::size_t i = 0; i < built.volumes.size(); ++i) {
    if (built.volumes[i] == 0) spdlog::warn("volumes[{}] makes no particles", i);
  }
  if (built.world.particle_count() == 0 && built.bodies.empty() && built.cloths.empty() &&
      built.ropes.empty() && built.emitters.empty()) {
    spdlog::warn("the scene has no particles, emitters, bodies, cloth or ropes: nothing will happen");
  }
  for (const std::string& warning : built.world.warnings()) spdlog::warn("{}", warning);
}

}  // namespace meniscus::cli
