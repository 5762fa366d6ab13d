// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Memory that runs out while a scene is read and built is an error.
#include <gtest/gtest.h>

#include <meniscus/scene.h>
#include "sdk/scene/scene_file.h"
#include "tests/faults/fail_everywhere.h"

namespace meniscus::tests {
namespace {

TEST(SceneFaults, ReadingAndBuildingASample) {
  const std::string path = MENISCUS_SAMPLES_DIR "/scenes/dam_break.json";
  Scene scene = read_scene(path);
  scene.world.device = DeviceChoice::cpu;
  scene.world.threads = 2;
  scene.world.particle_spacing *= 3;
  forget_stacks();
  const std::vector<std::string> overrides{"frames=3", "probes=[]", "name=x"};
  EXPECT_GT(fail_everywhere([&] { read_scene(path, overrides); }), 100);
  EXPECT_GT(fail_everywhere([&] { build_scene(scene); }), 30);
}

}  // namespace
}  // namespace meniscus::tests
