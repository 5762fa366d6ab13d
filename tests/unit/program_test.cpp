// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#include "sdk/cli/program.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "sdk/cli/interrupt.h"

namespace meniscus::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* scene = R"({
  "name": "drop", "frame_time": 0.01, "frames": 2,
  "world": { "particle_spacing": 0.1, "substeps": 2, "iterations": 2 },
  "fluids": [{ "name": "water" }],
  "shapes": [{ "name": "floor", "geometry": { "type": "plane" } }],
  "volumes": [{ "fluid": "water", "region": { "type": "box", "lower": [0, 0, 0], "upper": [0.4, 0.4, 0.4] } }]
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
    setenv("MENISCUS_SAMPLES_DIR", folder_.c_str(), 1);
  }
  void TearDown() override { fs::remove_all(folder_); }

  [[noreturn]] void run(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "meniscus");
    std::vector<char*> argv;
    for (std::string& argument : arguments) argv.push_back(argument.data());
    std::exit(run_program(static_cast<int>(argv.size()), argv.data()));
  }

  std::string out() const { return (folder_ / "out").string(); }

  fs::path folder_;
};

TEST_F(ProgramTest, ARunLeavesItsFiles) {
  EXPECT_EXIT(run({"run", "drop", "--device", "cpu", "--out", out(), "--export", "ply,vtp", "--quiet"}),
              testing::ExitedWithCode(success), "^$");
  for (const char* name : {"frames.csv", "summary.json", "density.svg", "preview.png", "particles.pvd",
                           "frames/frame_00001.ply", "frames/frame_00002.vtp"}) {
    EXPECT_TRUE(fs::exists(fs::path(out()) / name)) << name;
  }
  const auto figures = nlohmann::json::parse(std::ifstream(fs::path(out()) / "summary.json"));
  EXPECT_EQ(figures["particles"], 64);
  EXPECT_EQ(figures["frames"], 2);
  EXPECT_EQ(figures["device"]["kind"], "cpu");
}

TEST_F(ProgramTest, OptionsChangeTheScene) {
  EXPECT_EXIT(run({"run", (folder_ / "drop.json").string(), "--set", "world.iterations=5", "--frames", "3",
                   "--device", "cpu", "--out", out(), "--quiet"}),
              testing::ExitedWithCode(success), "^$");
  const auto figures = nlohmann::json::parse(std::ifstream(fs::path(out()) / "summary.json"));
  EXPECT_EQ(figures["iterations"], 5);
  EXPECT_EQ(figures["frames"], 3);
}

TEST_F(ProgramTest, BadInputIsOneLineAndCodeTwo) {
  EXPECT_EXIT(run({}), testing::ExitedWithCode(bad_input), "^meniscus: a command is required[^\n]*\n$");
  EXPECT_EXIT(run({"dance"}), testing::ExitedWithCode(bad_input), "^meniscus: [^\n]*dance[^\n]*\n$");
  EXPECT_EXIT(run({"run"}), testing::ExitedWithCode(bad_input), "^meniscus: scene is required[^\n]*\n$");
  EXPECT_EXIT(run({"run", "flood"}), testing::ExitedWithCode(bad_input),
              "^meniscus: [^\n]*'flood'; samples: drop\n$");
  EXPECT_EXIT(run({"run", "drop", "--device", "gpu"}), testing::ExitedWithCode(bad_input),
              "^meniscus: --device: gpu");
  EXPECT_EXIT(run({"check", "drop", "--set", "frames=none"}), testing::ExitedWithCode(bad_input),
              "^meniscus: [^\n]*frames[^\n]*\n$");
}

TEST_F(ProgramTest, AFolderThatCannotBeUsedStopsTheRunAtOnce) {
  const std::string file = (folder_ / "drop.json").string();
  EXPECT_EXIT(run({"run", "drop", "--device", "cpu", "--out", file}), testing::ExitedWithCode(bad_input),
              "^meniscus: cannot make the folder [^\n]*drop.json[^\n]*\n$");
}

TEST_F(ProgramTest, FailureInTheMiddleKeepsWhatWasDone) {
  // The second frame's file cannot take its place: a folder has its name, with something in it.
  fs::create_directories(fs::path(out()) / "frames" / "frame_00002.ply" / "in_the_way");
  EXPECT_EXIT(run({"run", "drop", "--device", "cpu", "--out", out(), "--export", "ply", "--quiet"}),
              testing::ExitedWithCode(run_failed), "^meniscus: cannot write [^\n]*frame_00002.ply[^\n]*\n$");
  const auto figures = nlohmann::json::parse(std::ifstream(fs::path(out()) / "summary.json"));
  EXPECT_NE(figures["error"].get<std::string>().find("frame_00002.ply"), std::string::npos);
  EXPECT_TRUE(fs::exists(fs::path(out()) / "preview.png"));
  EXPECT_TRUE(fs::exists(fs::path(out()) / "frames" / "frame_00001.ply"));
}

TEST(InterruptTest, ASignalRaisesTheFlagAndNothingElse) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const Interrupt interrupt;
    EXPECT_FALSE(interrupt.raised());
    std::raise(signal);
    EXPECT_TRUE(interrupt.raised());
  }
}

TEST(InterruptTest, TheSecondSignalEnds) {
  EXPECT_EXIT(
      {
        const Interrupt interrupt;
        std::raise(SIGINT);
        std::raise(SIGINT);
      },
      testing::KilledBySignal(SIGINT), "");
}

}  // namespace
}  // namespace meniscus::cli
