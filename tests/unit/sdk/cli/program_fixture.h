// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Runs the command line program on small scenes, each command in a process of its own.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "sdk/cli/commands/exit_code.h"
#include "sdk/cli/program.h"

namespace meniscus::cli {

namespace fs = std::filesystem;

inline constexpr const char* scene = R"({
  "name": "drop", "frame_time": 0.01, "frames": 2,
  "world": { "particle_spacing": 0.1, "substeps": 2, "iterations": 2 },
  "fluids": [{ "name": "water" }],
  "shapes": [{ "name": "floor", "geometry": { "type": "plane" } }],
  "volumes": [{ "fluid": "water", "region": { "type": "box", "lower": [0, 0, 0], "upper": [0.4, 0.4, 0.4] } }],
  "cameras": [{ "name": "close", "position": [1, 1, 1], "target": [0.2, 0.2, 0.2] },
              { "name": "above", "position": [0.2, 3, 0.2], "target": [0.2, 0, 0.1] }]
})";

inline constexpr const char* scene_with_bodies = R"({
  "name": "raft", "frame_time": 0.01, "frames": 2,
  "world": { "particle_spacing": 0.1, "substeps": 2, "iterations": 2 },
  "fluids": [{ "name": "water" }],
  "shapes": [{ "name": "floor", "geometry": { "type": "plane" } }],
  "bodies": [
    { "name": "crate", "geometry": { "type": "box", "half_extents": [0.1, 0.2, 0.3] }, "pose": { "position": [1, 2, 0] } },
    { "name": "lever", "geometry": { "type": "hull", "points": [[0, 0, 0], [1, 0, 0], [0, 0.1, 0], [0, 0, 0.1]] },
      "pose": { "position": [3, 2, 0] } },
    { "name": "lift", "motion": "kinematic", "geometry": { "type": "box" }, "pose": { "position": [-3, 0, 0] },
      "keyframes": [{ "time": 0, "position": [-3, 0, 0] }, { "time": 1, "position": [-3, 10, 0] }] }
  ],
  "joints": [{ "type": "hinge", "name": "axle", "a": "lever", 
               "frame": { "position": [3, 2, 0], "rotation": { "axis": [1, 0, 0], "degrees": 90 } } }],
  "volumes": [{ "fluid": "water", "region": { "type": "box", "lower": [0, 0, 0], "upper": [0.4, 0.4, 0.4] } }]
})";

inline constexpr const char* scene_with_cloth = R"({
  "name": "flag", "frame_time": 0.01, "frames": 2, "world": { "substeps": 4, "iterations": 1 },
  "cloths": [{ "name": "sheet", "geometry": { "type": "sheet", "columns": 5, "rows": 4 } }],
  "ropes": [{ "name": "line", "points": [[2, 0, 0], [3, 0, 0]], "segments": 10 }],
  "attachments": [{ "name": "corner", "cloth": "sheet", "vertices": [0] }]
})";

/// Each command line runs in a process of its own, and the folder stands for the samples of the source tree.
class ProgramTest : public testing::Test {
 protected:
  void SetUp() override {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    // The child of a threadsafe death test comes by here again, and must find the same folder.
    folder_ = fs::temp_directory_path() / (std::string("meniscus_program_") +
                                           testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::create_directories(folder_);
    std::ofstream(folder_ / "drop.json") << scene;
    std::ofstream(folder_ / "raft.json") << scene_with_bodies;
    std::ofstream(folder_ / "flag.json") << scene_with_cloth;
    setenv("MENISCUS_SAMPLES_DIR", folder_.c_str(), 1);
  }
  void TearDown() override { fs::remove_all(folder_); }

  /// What a command line that succeeds prints.
  static std::string printed(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "meniscus");
    std::vector<char*> argv;
    for (std::string& argument : arguments) argv.push_back(argument.data());
    testing::internal::CaptureStdout();
    EXPECT_EQ(run_program(static_cast<int>(argv.size()), argv.data()), success);
    return testing::internal::GetCapturedStdout();
  }

  [[noreturn]] void run(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "meniscus");
    std::vector<char*> argv;
    for (std::string& argument : arguments) argv.push_back(argument.data());
    std::exit(run_program(static_cast<int>(argv.size()), argv.data()));
  }

  static std::string bytes(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  /// Of a PNG, as in 64x48.
  static std::string pixels(const std::string& png) {
    if (png.size() < 24) return "none";
    const auto number = [&](std::size_t at) {
      return (static_cast<unsigned char>(png[at + 2]) << 8) + static_cast<unsigned char>(png[at + 3]);
    };
    return std::to_string(number(16)) + "x" + std::to_string(number(20));
  }

  void write(const char* name, const char* text) const { std::ofstream(folder_ / name) << text; }

  std::string out() const { return (folder_ / "out").string(); }

  fs::path folder_;
};

}  // namespace meniscus::cli
