// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The commands reproduce and compare at reduced size, complete and cut short.
#include <unistd.h>

#include <csignal>
#include <nlohmann/json.hpp>

#include "tests/unit/sdk/cli/program_fixture.h"

namespace meniscus::cli {
namespace {

class ReproduceTest : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    setenv("MENISCUS_SAMPLES_DIR", MENISCUS_SAMPLES_DIR "/scenes", 1);
  }
  std::vector<std::string> small(const std::string& parts, std::vector<std::string> more = {}) const {
    std::vector<std::string> line{"reproduce", "pbf",   "--device", "cpu", "--scale",  "0.004",
                                  "--seconds", "0.064", "--parts",  parts, "--output", out()};
    line.insert(line.end(), more.begin(), more.end());
    return line;
  }
  nlohmann::json figures() const {
    return nlohmann::json::parse(std::ifstream(fs::path(out()) / "pbf/figures.json"));
  }
};

TEST_F(ReproduceTest, WritesTablesAndFigures) {
  const std::string page = (folder_ / "docs/paper.md").string();
  fs::create_directories(folder_ / "docs");
  const std::string text =
      printed(small("times,density,pressure,vorticity", {"--page", page, "--commit", "abc1234"}));
  EXPECT_NE(text.find("at commit `abc1234`"), std::string::npos);
  EXPECT_NE(text.find("| Bunny drop |"), std::string::npos) << text;
  EXPECT_NE(text.find("](pbf/density.svg)"), std::string::npos) << text;
  EXPECT_NE(bytes(page).find("](paper/density.svg)"), std::string::npos) << "links follow the page";
  for (const char* name :
       {"out/pbf.md", "out/pbf/density.svg", "out/pbf/vorticity.svg", "docs/paper/density.svg"})
    EXPECT_TRUE(fs::exists(folder_ / name)) << name;

  const nlohmann::json all = figures();
  EXPECT_EQ(all["complete"], true);
  EXPECT_EQ(all["device"]["kind"], "cpu");
  ASSERT_EQ(all["times"].size(), 3);
  for (const auto& [scene, row] : all["times"].items()) {
    const double expected = 0.004 * row["paper_particles"].get<double>();
    EXPECT_GT(row["particles"], 0.4 * expected) << scene << ": a shallow pool has few layers";
    EXPECT_LT(row["particles"], 1.6 * expected) << scene;
    EXPECT_GT(row["jacobi"]["ms_substep_median"], 0);
    EXPECT_GT(row["jacobi"]["stage_ms"]["solve"], 0);
  }
  ASSERT_EQ(all["density"].size(), 2);
  EXPECT_EQ(all["density"][1]["substeps"][0], 10) << "PCISPH makes the paper's 10";
  EXPECT_EQ(all["density"][0]["time_s"].size(), 4);
  ASSERT_EQ(all["artificial_pressure"].size(), 4);
  EXPECT_LT(all["artificial_pressure"][2]["neighbours"], all["artificial_pressure"][0]["neighbours"])
      << "a smaller support has fewer";
  ASSERT_EQ(all["vorticity"].size(), 2);
  EXPECT_NE(all["vorticity"][0]["rms_vorticity"], all["vorticity"][1]["rms_vorticity"]);
}

TEST_F(ReproduceTest, SaysWhichSubstepsHold) {
  const std::string text = printed(small("substeps"));
  EXPECT_NE(text.find("PBF holds with 1 substep a frame"), std::string::npos) << text;
  EXPECT_EQ(figures()["substeps"].size(), 9);
}

TEST_F(ReproduceTest, DrawsTheFiltersOrSaysWhyNot) {
  const std::string text = printed(small("filters"));
  const bool drawn = fs::exists(fs::path(out()) / "pbf/filters.png");
  EXPECT_EQ(drawn, text.find("Not reproduced here") == std::string::npos) << text;
  if (!drawn) return;
  EXPECT_EQ(pixels(bytes(fs::path(out()) / "pbf/normals.png")), "1920x480");
  EXPECT_EQ(figures()["filters"].size(), 3);
}

TEST_F(ReproduceTest, EndsAtItsTimeLimitWithAPage) {
  const std::string text = printed(small("times,density", {"--time-limit", "1e-9"}));
  EXPECT_NE(text.find("The limit of 1e-09 minutes ended the command"), std::string::npos) << text;
  EXPECT_NE(text.find("Nothing was measured"), std::string::npos) << text;
  EXPECT_EQ(figures()["complete"], false);
  EXPECT_EQ(text.find("Figure 4"), std::string::npos) << "parts after it are left out";
}

TEST_F(ReproduceTest, RefusesBadInput) {
  EXPECT_EXIT(run({"reproduce"}), testing::ExitedWithCode(bad_input),
              "^meniscus: paper is required[^\n]*\n$");
  EXPECT_EXIT(run({"reproduce", "sph"}), testing::ExitedWithCode(bad_input), "paper: sph");
  EXPECT_EXIT(run(small("tables")), testing::ExitedWithCode(bad_input), "--parts: tables");
  EXPECT_EXIT(run({"reproduce", "pbf", "--scale", "0"}), testing::ExitedWithCode(bad_input), "--scale");
  EXPECT_EXIT(run({"reproduce", "pbf", "--quick", "--seconds", "1"}), testing::ExitedWithCode(bad_input),
              "--quick");
  EXPECT_EXIT(run(small("times", {"--armadillo", "none.ply"})), testing::ExitedWithCode(bad_input),
              "^meniscus: --armadillo is 'none.ply', but there is no such file\n$");
  std::ofstream(folder_ / "file") << "";
  EXPECT_EXIT(
      run({"reproduce", "pbf", "--quick", "--device", "cpu", "--output", (folder_ / "file").string()}),
      testing::ExitedWithCode(bad_input), "cannot make the folder");
}

TEST_F(ProgramTest, CompareFindsStableSteps) {
  const std::string table = printed({"compare", "drop", "--device", "cpu", "--seconds", "0.1", "--errors",
                                     "1", "--substeps", "1,2", "--out", out()});
  EXPECT_NE(table.find("The largest stable step"), std::string::npos);
  const auto figures = nlohmann::json::parse(std::ifstream(fs::path(out()) / "compare.json"));
  EXPECT_EQ(figures["complete"], true);
  ASSERT_EQ(figures["stable_steps"].size(), 6);
  for (const auto& step : figures["stable_steps"]) {
    EXPECT_GT(step["runs"], 0);
    EXPECT_LE(step["substep_s"], step["step_s"]);
  }
}

TEST_F(ProgramTest, CompareWritesWhatItHasWhenItEnds) {
  const std::string table = printed(
      {"compare", "drop", "--device", "cpu", "--seconds", "0.05", "--time-limit", "1e-9", "--out", out()});
  EXPECT_NE(table.find("The limit of"), std::string::npos);
  const auto figures = nlohmann::json::parse(std::ifstream(fs::path(out()) / "compare.json"));
  EXPECT_EQ(figures["complete"], false);
  EXPECT_TRUE(fs::exists(fs::path(out()) / "compare.svg"));

  const auto interrupted_run = [&] {
    std::signal(SIGALRM, [](int) { std::raise(SIGINT); });
    alarm(1);
    run({"compare", "drop", "--device", "cpu", "--seconds", "1000", "--out", out()});
  };
  fs::remove_all(out());
  EXPECT_EXIT(interrupted_run(), testing::ExitedWithCode(interrupted), "");
  EXPECT_NE(bytes(fs::path(out()) / "compare.md").find("A signal ended the command"), std::string::npos);
}

}  // namespace
}  // namespace meniscus::cli
