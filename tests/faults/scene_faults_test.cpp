// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Memory that runs out while a scene is read and built is an error.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "sdk/scene/scene.h"
#include "sdk/scene/scene_file.h"
#include "tests/faults/failing_memory.h"

namespace meniscus::tests {
namespace {

/// Calls until no new call stack is left that fails. Returns the number of failures.
template <class Call>
int fail_everywhere(const Call& call) {
  for (int failures = 0;; ++failures) {
    bool fails = false;
    try {
      const FailingMemory failing({});
      try {
        call();
      } catch (...) {
        fails = failing.has_failed();
        throw;
      }
      fails = failing.has_failed();
    } catch (const Error& error) {
      EXPECT_EQ(static_cast<int>(error.code()), static_cast<int>(ErrorCode::out_of_memory)) << error.what();
    } catch (const std::exception& error) {
      ADD_FAILURE() << error.what();
    }
    if (testing::Test::HasFailure()) print_last_stack();
    if (!fails || testing::Test::HasFailure()) return failures;
  }
}

TEST(SceneFaults, ReadingAndBuildingASample) {
  const std::string path = std::string(MENISCUS_SAMPLES_DIR) + "/scenes/dam_break.json";
  Scene scene = read_scene(path);
  scene.world.device = DeviceChoice::cpu;
  scene.world.threads = 2;
  scene.world.particle_spacing *= 3;
  forget_stacks();
  EXPECT_GT(fail_everywhere([&] { read_scene(path, std::vector<std::string>{"frames=3"}); }), 100);
  EXPECT_GT(fail_everywhere([&] { build_scene(scene); }), 30);
}

}  // namespace
}  // namespace meniscus::tests
