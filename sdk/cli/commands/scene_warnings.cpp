// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Implements the warnings about scenes.
#include "sdk/cli/commands/scene_warnings.h"

#include <spdlog/spdlog.h>

#include <cmath>

#include "sdk/io/plain_text.h"

namespace meniscus::cli {
namespace {

/// Warns of a frame time that looks like one in milliseconds.
void warn_of_long_substeps(const Scene& scene, std::vector<std::string>& oddities) {
  constexpr double most_spacings = 4;
  const WorldDef& def = scene.world;
  const double substep = double{scene.frame_time} / (def.cfl_number > 0 ? def.max_substeps : def.substeps);
  const double fall = std::hypot(def.gravity.x, def.gravity.y, def.gravity.z) * substep * substep;
  if (fall > most_spacings * double{def.particle_spacing})
    oddities.push_back(fmt::format(
        "a substep has {:.3g} s, in which gravity moves things by {:.3g} m: particles are {:.3g} m "
        "apart. frame_time is in seconds",
        substep, fall, def.particle_spacing));
}

}  // namespace

std::vector<std::string> oddities_of(const Scene& scene, const BuiltScene& built) {
  std::vector<std::string> oddities;
  warn_of_long_substeps(scene, oddities);
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

void warn_of_oddities(const Scene& scene, const BuiltScene& built) {
  for (const std::string& oddity : oddities_of(scene, built)) spdlog::warn("{}", oddity);
}

}  // namespace meniscus::cli
