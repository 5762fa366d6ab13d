// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// `meniscus run --worlds`: a table of worlds that are as runs of their own.
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/unit/sdk/cli/program_fixture.h"

namespace meniscus::cli {
namespace {

class WorldsTest : public ProgramTest {
 protected:
  /// The rows of worlds.csv, by column.
  std::vector<std::map<std::string, std::string>> table() const {
    std::ifstream stream(fs::path(out()) / "worlds.csv");
    const auto fields = [](const std::string& line) {
      std::vector<std::string> all;
      std::istringstream parts(line);
      for (std::string field; std::getline(parts, field, ',');) all.push_back(field);
      return all;
    };
    std::string line;
    std::getline(stream, line);
    const std::vector<std::string> names = fields(line);
    std::vector<std::map<std::string, std::string>> rows;
    while (std::getline(stream, line)) {
      const std::vector<std::string> values = fields(line);
      rows.emplace_back();
      for (std::size_t k = 0; k < names.size(); ++k) rows.back()[names[k]] = values.at(k);
    }
    return rows;
  }
  nlohmann::json worlds(const char* scene, const char* count, std::vector<std::string> more = {}) const {
    std::vector<std::string> all{"run", scene,    "--device", "cpu",   "--worlds",
                                 count, "--json", "--quiet",  "--out", out()};
    all.insert(all.end(), more.begin(), more.end());
    return nlohmann::json::parse(printed(all));
  }
  /// The hash of a run of the scene alone.
  std::string alone(const char* scene, const std::vector<std::string>& settings) const {
    std::vector<std::string> all{"run",     scene,   "--device",       "cpu",   "--json",
                                 "--quiet", "--out", out() + "/alone", "--set", "world.sums=fixed"};
    for (const std::string& setting : settings) all.insert(all.end(), {"--set", setting});
    return nlohmann::json::parse(printed(all)).at("state_hash");
  }
  testing::AssertionResult refuses(std::vector<std::string> more, const char* what) const {
    std::vector<std::string> all{"run", "drop", "--device", "cpu", "--out", out()};
    all.insert(all.end(), more.begin(), more.end());
    EXPECT_EXIT(run(all), testing::ExitedWithCode(bad_input), what);
    return fs::exists(fs::path(out()) / "worlds.csv") ? testing::AssertionFailure() << "it has run"
                                                      : testing::AssertionSuccess();
  }
};

TEST_F(WorldsTest, ARowIsARunOfItsOwn) {
  const std::vector<std::string> vary{"--vary", "world.gravity[0]=-2:2"};
  const nlohmann::json figures = worlds("drop", "3", vary);
  EXPECT_EQ(figures.at("worlds"), 3);
  EXPECT_EQ(figures.at("failed"), 0);
  const auto rows = table();
  ASSERT_EQ(rows.size(), 3u);
  for (const auto& row : rows)
    EXPECT_EQ(row.at("state_hash"),
              alone("drop", {"world.gravity=[" + row.at("world.gravity[0]") + ",-9.81,0]"}));
  EXPECT_NE(rows[0].at("state_hash"), rows[1].at("state_hash"));
  EXPECT_EQ(rows[2].at("failed"), "0");
  worlds("drop", "2", vary);
  EXPECT_EQ(table()[1], rows[1]) << "the numbers do not depend on how many worlds there are";
  worlds("drop", "2", {"--vary", "world.gravity[0]=-2:2", "--seed", "2"});
  EXPECT_NE(table()[1].at("world.gravity[0]"), rows[1].at("world.gravity[0]"));
}

TEST_F(WorldsTest, BodiesAndFluidStartWhereTheyAreTold) {
  worlds("raft", "2", {"--vary", "bodies[0].pose.position[1]=1:2", "--vary", "volumes[0].velocity[2]=0:1"});
  const auto rows = table();
  ASSERT_EQ(rows.size(), 2u);
  for (const auto& row : rows)
    EXPECT_EQ(row.at("state_hash"),
              alone("raft", {"bodies[0].pose.position=[1," + row.at("bodies[0].pose.position[1]") + ",0]",
                             "volumes[0].velocity=[0,0," + row.at("volumes[0].velocity[2]") + "]"}));
  EXPECT_NE(rows[0].at("crate_y_m"), rows[1].at("crate_y_m"));
}

TEST_F(WorldsTest, ClothIsThatOfARunOfItsOwn) {
  const std::vector<std::string> small{"ropes=[]", "cloths[0].geometry.columns=13",
                                       "cloths[0].geometry.rows=9", "frames=4"};
  std::vector<std::string> more{"--vary", "world.gravity[0]=-2:2"};
  for (const std::string& setting : small) more.insert(more.end(), {"--set", setting});
  const nlohmann::json figures = worlds("flag", "2", more);
  EXPECT_EQ(figures.at("cloth_vertices"), 13 * 9);
  for (const auto& row : table()) {
    std::vector<std::string> own = small;
    own.push_back("world.gravity=[" + row.at("world.gravity[0]") + ",-9.81,0]");
    EXPECT_EQ(row.at("state_hash"), alone("flag", own));
    EXPECT_NEAR(std::stod(row.at("cloth_y_m")), 0, 0.1);
  }
}

TEST_F(WorldsTest, RefusesWhatIsTheSameInAllWorlds) {
  EXPECT_TRUE(
      refuses({"--worlds", "2", "--vary", "world.iterations=1:4"}, "world.iterations.*same in all worlds"));
  EXPECT_TRUE(refuses({"--worlds", "2", "--vary", "fluids[0].rest_density=1:4"}, "same in all worlds"));
  EXPECT_TRUE(refuses({"--worlds", "2", "--vary", "world.gravity=1:4"}, "no number there"));
  EXPECT_TRUE(refuses({"--worlds", "2", "--vary", "volumes[3].velocity[0]=1:4"}, "has 1 items"));
  EXPECT_TRUE(refuses({"--worlds", "2", "--vary", "world.gravity[0]=4:1"}, "low must not be above high"));
  EXPECT_TRUE(refuses({"--worlds", "2", "--vary", "world.gravity[0]=4"}, "path=low:high"));
  EXPECT_TRUE(refuses({"--worlds", "2", "--vary", "volumes[0].region.upper[1]=0.4:0.9"}, "particles"));
  EXPECT_TRUE(refuses({"--worlds", "2", "--set", "world.cfl_number=0.4"}, "cfl_number"));
  EXPECT_TRUE(refuses({"--vary", "world.gravity[0]=1:4"}, "--worlds"));
  EXPECT_TRUE(refuses({"--worlds", "2", "--export", "ply"}, "--export"));
}

}  // namespace
}  // namespace meniscus::cli
