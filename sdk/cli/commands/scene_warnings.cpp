// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Implements the warnings about scenes.
#include "sdk/cli/commands/scene_warnings.h"

#include <spdlog/spdlog.h>

#include "sdk/io/plain_text.h"

namespace meniscus::cli {

std::vector<std::string> oddities_of(const BuiltScene& built) {
  std::vector<std::string> oddities;
  for (std::size_t i = 0; i < built.volumes.size(); ++i) {
    if (built.volumes[i] == 0) oddities.push_back(fmt::format("volumes[{}] makes no particles", i));
  }
  for (const MeshRepair& r : built.world.mesh_repairs()) {
    oddities.push_back(fmt::format(
        "mesh {} was repaired within {:.3g} m: it is off by at most {:.3g} m, and holds {:.4g} m³ "
        "where it held {:.4g} m³ ({:+.2f} %)",
        io::plain_text(r.file), r.cell_size, r.deviation, r.volume, r.volume_before,
        100 * (r.volume / r.volume_before - 1)));
  }
  if (built.world.particle_count() == 0 && built.bodies.empty() && built.cloths.empty() &&
      built.ropes.empty() && built.emitters.empty()) {
    oddities.push_back("the scene has no particles, emitters, bodies, cloth or ropes: nothing will happen");
  }
  const std::vector<std::string> warnings = built.world.warnings();
  oddities.insert(oddities.end(), warnings.begin(), warnings.end());
  return oddities;
}

void warn_of_oddities(const BuiltScene& built) {
  for (const std::string& oddity : oddities_of(built)) spdlog::warn("{}", oddity);
}

}  // namespace meniscus::cli
