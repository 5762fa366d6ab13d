// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Each sample goes on bit for bit after a restore, and from a file.
#include <algorithm>
#include <filesystem>

#include "sdk/scene/scene_file.h"
#include "tests/unit/sdk/world/snapshot/cases.h"

namespace meniscus::tests {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> samples() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(fs::path(MENISCUS_SAMPLES_DIR) / "scenes")) {
    if (entry.is_directory()) continue;  // meshes of a sample
    const std::string name = entry.path().stem().string();
    if (name == "armadillo_splash") continue;  // has no mesh of its own
    if (name == "dam_break_1m") continue;      // is dam_break with more particles
    names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

class SampleSnapshotTest : public testing::TestWithParam<std::string> {};

TEST_P(SampleSnapshotTest, GoesOnAsItDid) {
  const std::vector<std::string> overrides{"world.device=cpu"};
  const Scene scene =
      read_scene(std::string(MENISCUS_SAMPLES_DIR) + "/scenes/" + GetParam() + ".json", overrides);
  World world = std::move(build_scene(scene).world);
  run(world, 4, scene.frame_time);
  const Snapshot snapshot = world.snapshot();
  World clone = world.clone();
  const auto future = [&](World& w) {
    std::vector<std::vector<uint64_t>> states{state_of(w)};
    for (int k = 0; k < 2; ++k) {
      w.step(scene.frame_time);
      states.push_back(state_of(w));
    }
    return states;
  };
  const auto expected = future(world);
  world.restore(snapshot);
  EXPECT_TRUE(future(world) == expected);
  EXPECT_TRUE(future(clone) == expected);
}

INSTANTIATE_TEST_SUITE_P(Of, SampleSnapshotTest, testing::ValuesIn(samples()),
                         [](const auto& tested) { return tested.param; });

}  // namespace
}  // namespace meniscus::tests
