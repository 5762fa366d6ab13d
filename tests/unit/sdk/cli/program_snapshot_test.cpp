// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A run that continues from a snapshot ends as the whole run does.
#include <nlohmann/json.hpp>

#include <sys/time.h>

#include <csignal>
#include <cstdio>
#include <tuple>

#include "tests/unit/sdk/cli/program_fixture.h"

namespace meniscus::cli {
namespace {

nlohmann::json figures_in(const fs::path& folder) {
  return nlohmann::json::parse(std::ifstream(folder / "summary.json"));
}

TEST_F(ProgramTest, ARunContinuesFromASnapshot) {
  for (const char* name : {"drop", "raft", "flag"}) {
    printed(
        {"run", name, "--device", "cpu", "--frames", "6", "--save-every", "2", "--quiet", "--out", out()});
    const fs::path saved = folder_ / "out/snapshot_00004.menisnap";
    EXPECT_TRUE(fs::exists(folder_ / "out/snapshot_00002.menisnap"));
    ASSERT_TRUE(fs::exists(saved));
    const std::string rest = (folder_ / "rest").string();
    printed({"run", name, "--device", "cpu", "--frames", "6", "--from", saved.string(), "--quiet", "--export",
             "obj", "--out", rest});
    EXPECT_EQ(figures_in(rest)["state_hash"], figures_in(out())["state_hash"]) << name;
    const std::string rows = bytes(folder_ / "rest/frames.csv");
    EXPECT_NE(rows.find("\n5,"), std::string::npos) << rows;
    EXPECT_EQ(rows.find("\n4,"), std::string::npos) << rows;
  }
}

TEST_F(ProgramTest, ARecordedRunIsReplayed) {
  const std::string file = (folder_ / "drop.menisrec").string();
  printed({"run", "drop", "--device", "cpu", "--frames", "4", "--record", file, "--quiet", "--out", out()});
  const std::string text = printed({"replay", file, "--threads", "2"});
  EXPECT_NE(text.find("4 steps"), std::string::npos) << text;
  EXPECT_NE(text.find("4 of them have the recorded hash"), std::string::npos) << text;
  const auto json = nlohmann::json::parse(printed({"replay", file, "--json"}));
  EXPECT_EQ(json["steps"], 4);
  EXPECT_EQ(json["equal"], 4);
  EXPECT_TRUE(json["first_difference"].is_null());
  EXPECT_EQ(json["complete"], true);
  EXPECT_EQ(json["recorded_on"], "cpu");
  fs::resize_file(file, fs::file_size(file) - 100);
  EXPECT_NE(printed({"replay", file}).find("has no end"), std::string::npos);
  EXPECT_EXIT(run({"replay", (folder_ / "drop.json").string()}), testing::ExitedWithCode(bad_input),
              "does not begin with MENISREC");
}

/// Steps of it last so long that a signal comes within one.
constexpr const char* slow = R"({
  "name": "slow", "frame_time": 0.01, "frames": 100000,
  "world": { "particle_spacing": 0.1, "substeps": 25, "iterations": 4, "threads": 1 },
  "fluids": [{ "name": "water" }],
  "shapes": [{ "name": "floor", "geometry": { "type": "plane" } }],
  "volumes": [{ "fluid": "water", "region": { "type": "box", "lower": [0, 0, 0], "upper": [0.6, 0.6, 0.6] } }]
})";

/// Once the process has used so much time of processors.
void interrupt_after(int milliseconds) {
  std::signal(SIGPROF, [](int) { std::raise(SIGINT); });
  const itimerval once{{0, 0}, {0, 1000 * milliseconds}};
  setitimer(ITIMER_PROF, &once, nullptr);
}

TEST_F(ProgramTest, AnInterruptedRunEndsItsRecordingAndAnInterruptedReplayTellsWhatItHas) {
  write("slow.json", slow);
  const std::string file = (folder_ / "slow.menisrec").string(), said = (folder_ / "said").string();
  const auto interrupted_run = [&] {
    interrupt_after(900);
    run({"run", "slow", "--device", "cpu", "--record", file, "--quiet", "--out", out()});
  };
  EXPECT_EXIT(interrupted_run(), testing::ExitedWithCode(interrupted), "");
  const auto interrupted_replay = [&] {
    interrupt_after(300);
    std::ignore = std::freopen(said.c_str(), "w", stdout);
    run({"replay", file, "--json"});
  };
  EXPECT_EXIT(interrupted_replay(), testing::ExitedWithCode(interrupted), "");
  const auto figures = nlohmann::json::parse(bytes(said));
  EXPECT_EQ(figures["interrupted"], true);
  EXPECT_TRUE(figures["complete"].is_null());
  EXPECT_EQ(figures["steps"], figures["equal"]);
  const auto recorded = nlohmann::json::parse(printed({"replay", file, "--json"}));
  EXPECT_EQ(recorded["complete"], true) << "the signal came within a step";
  EXPECT_EQ(recorded["interrupted"], false);
}

TEST_F(ProgramTest, ARecordingThatCannotBeWrittenLeavesTheFolderAsItWas) {
  fs::create_directories(out() + "/frames");
  write("out/summary.json", "of the run before");
  write("out/frames/frame_00002.ply", "likewise");
  const std::string nowhere = (folder_ / "nowhere/drop.menisrec").string();
  EXPECT_EXIT(run({"run", "drop", "--device", "cpu", "--record", nowhere, "--quiet", "--out", out()}),
              testing::ExitedWithCode(bad_input), "nowhere/drop.menisrec");
  EXPECT_EQ(bytes(out() + "/summary.json"), "of the run before");
  EXPECT_EQ(bytes(out() + "/frames/frame_00002.ply"), "likewise");
}

TEST_F(ProgramTest, ASnapshotOfAnotherSceneIsRefused) {
  printed({"run", "drop", "--device", "cpu", "--save-every", "2", "--quiet", "--out", out()});
  const std::string saved = (folder_ / "out/snapshot_00002.menisnap").string();
  EXPECT_EXIT(run({"run", "raft", "--device", "cpu", "--frames", "9", "--from", saved}),
              testing::ExitedWithCode(bad_input), "holds 0 bodies, and the scene has 3");
  EXPECT_EXIT(run({"run", "drop", "--device", "cpu", "--from", saved}), testing::ExitedWithCode(bad_input),
              "is of frame 2, and the run ends with frame 2");
  EXPECT_EXIT(run({"run", "drop", "--device", "cpu", "--from", (folder_ / "drop.json").string()}),
              testing::ExitedWithCode(bad_input), "does not begin with MENISNAP");
}

}  // namespace
}  // namespace meniscus::cli
