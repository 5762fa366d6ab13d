// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Scenes that several validation tests share.
#pragma once

#include <cstdlib>
#include <string>

#include "tests/worlds.h"

namespace meniscus::tests {

constexpr float frame_time = 0.016f;  // s

/// A block of water of 2.5 × 2 × 2.5 m at rest density, at one end of a tank 2.5 times as long. All else as a
/// new world has it. 100,000 particles at a spacing of 0.05 m.
inline World large_dam_break(const WorldDef& def) {
  World world(def);
  world.create_shape(tank({0, 0, 0}, {6.25f, 5, 2.5f}));
  world.add_fluid(block(world.create_fluid({}), {0, 0, 0}, {2.5f, 2, 2.5f}));
  return world;
}

/// Like the command line's: where the environment says, else among the sources.
inline std::string sample_scene(const std::string& name) {
  const char* folder = std::getenv("MENISCUS_SAMPLES_DIR");
  return (folder ? std::string(folder) : MENISCUS_SAMPLES_DIR "/scenes") + "/" + name + ".json";
}

}  // namespace meniscus::tests
