// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tests of the order of words and of the messages about unknown ones.
#include "sdk/cli/usage/usage.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/unit/sdk/cli/program_fixture.h"

namespace meniscus::cli {
namespace {

using Words = std::vector<std::string>;

Usage usage() {
  Usage usage;
  usage.options = {{.names = {"-h", "--help"}}};
  usage.verbs = {{"run", "", {{.names = {"--out"}, .kind = ValueKind::folder}, {.names = {"--quiet"}}}, {}},
                 {"view", "", {{.names = {"--size"}, .kind = ValueKind::other}}, {}}};
  return usage;
}

TEST(VerbFirst, MovesTheCommandBeforeOptions) {
  EXPECT_EQ(verb_first(usage(), {"--quiet", "run", "drop"}), (Words{"run", "--quiet", "drop"}));
  EXPECT_EQ(verb_first(usage(), {"--out", "run", "run", "drop"}), (Words{"run", "--out", "run", "drop"}))
      << "the first is a folder";
  EXPECT_EQ(verb_first(usage(), {"--size=2x2", "view", "drop"}), (Words{"view", "--size=2x2", "drop"}));
}

TEST(VerbFirst, LeavesOtherLinesAlone) {
  for (const Words& words :
       {Words{}, Words{"--help"}, Words{"run", "--quiet", "view"}, Words{"drop", "run"}, Words{"--out"}}) {
    EXPECT_EQ(verb_first(usage(), words), words);
  }
}

TEST(UnknownArgument, NamesTheNearest) {
  EXPECT_EQ(unknown_argument(usage(), "", "rnu"), "there is no command 'rnu'; did you mean \"run\"?");
  EXPECT_EQ(unknown_argument(usage(), "", "dance"),
            "there is no command 'dance'; allowed: \"run\", \"view\"");
  EXPECT_EQ(unknown_argument(usage(), "run", "--quite"),
            "meniscus run has no option '--quite'; did you mean \"--quiet\"?");
  EXPECT_EQ(unknown_argument(usage(), "view", "--sise=2x2"),
            "meniscus view has no option '--sise'; did you mean \"--size\"?");
  EXPECT_EQ(unknown_argument(usage(), "run", "more"), "meniscus run does not expect 'more'");
}

TEST_F(ProgramTest, AMistypedWordIsTheFirstThingThatIsSaid) {
  EXPECT_EXIT(run({"rum", "drop"}), testing::ExitedWithCode(bad_input),
              "^meniscus: there is no command 'rum'; did you mean \"run\"\\?[^\n]*\n$");
  EXPECT_EXIT(run({"run", "--fraems", "5"}), testing::ExitedWithCode(bad_input),
              "^meniscus: meniscus run has no option '--fraems'; did you mean \"--frames\"\\?[^\n]*\n$");
  EXPECT_EXIT(run({"run", "--sruface", "--export", "obj"}), testing::ExitedWithCode(bad_input),
              "did you mean \"--surface\"")
      << "though the scene is missing, too";
  EXPECT_EXIT(run({"check", "drop", "raft"}), testing::ExitedWithCode(bad_input),
              "^meniscus: meniscus check does not expect 'raft'");
}

TEST_F(ProgramTest, OptionsMayStandBeforeTheCommandAndTheScene) {
  const std::string usual = printed({"devices", "--memory", "drop", "--device", "cpu"});
  EXPECT_EQ(printed({"--device", "cpu", "devices", "--memory", "drop"}), usual);
  EXPECT_EQ(printed({"--memory=drop", "devices", "--device=cpu"}), usual);
  printed({"--quiet", "--out", out(), "run", "--frames", "1", "--device", "cpu", "drop"});
  EXPECT_TRUE(fs::exists(fs::path(out()) / "summary.json"));
}

nlohmann::json json_of(const std::string& text) {
  return nlohmann::json::parse(text, nullptr, false);
}

TEST_F(ProgramTest, ResultsAreJsonForOtherPrograms) {
  const auto check = json_of(printed({"check", "flag", "--json"}));
  EXPECT_EQ(check["scene"], "flag");
  EXPECT_EQ(check["counts"]["cloth_vertices"], 20);
  EXPECT_EQ(check["counts"]["attachments"], 1);
  EXPECT_TRUE(check["warnings"].is_array());
  const auto devices = json_of(printed({"devices", "--json"}));
  EXPECT_EQ(devices["devices"].back()["kind"], "cpu");
  EXPECT_TRUE(devices["devices"].back()["usable"]);
  EXPECT_TRUE(devices["auto"] == "cpu" || devices["auto"] == "cuda");
  const auto memory = json_of(printed({"devices", "--memory", "drop", "--device", "cpu", "--json"}));
  EXPECT_EQ(memory["particles"], 64);
  EXPECT_GT(memory["shares"].size(), 1u);
  const auto samples = json_of(printed({"samples", "--json"}));
  ASSERT_EQ(samples.size(), 3u);
  EXPECT_EQ(samples.at(0)["name"], "drop");
  EXPECT_EQ(samples.at(0)["file"], (folder_ / "drop.json").string());
}

TEST_F(ProgramTest, ARunPrintsItsSummaryAsJson) {
  const std::string text = printed({"run", "drop", "--device", "cpu", "--out", out(), "--quiet", "--json"});
  auto figures = json_of(text);
  EXPECT_EQ(figures["folder"], out());
  figures.erase("folder");
  EXPECT_EQ(figures, nlohmann::json::parse(std::ifstream(fs::path(out()) / "summary.json")));
}

TEST_F(ProgramTest, CompareAndMeshesAreJsonToo) {
  const auto compare = json_of(printed({"compare", "drop", "--device", "cpu", "--seconds", "0.01", "--errors",
                                        "1", "--out", out(), "--json"}));
  EXPECT_EQ(compare, nlohmann::json::parse(std::ifstream(fs::path(out()) / "compare.json")));
  write("tetra.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  write("tetra.json", R"({ "name": "tetra", "world": { "particle_spacing": 0.6 }, "bodies": [
    { "name": "it", "geometry": { "type": "mesh", "file": "tetra.obj" } }] })");
  const auto check = json_of(printed({"check", "tetra", "--json"}));
  const auto& mesh = check["meshes"].at(0);
  EXPECT_EQ(mesh["triangles"], 4);
  EXPECT_EQ(mesh["size_m"], (nlohmann::json{1.0, 1.0, 1.0}));
  EXPECT_NE(mesh["warning"].get<std::string>().find("tiny"), std::string::npos);
}

}  // namespace
}  // namespace meniscus::cli
