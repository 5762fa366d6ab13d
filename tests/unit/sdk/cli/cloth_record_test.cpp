// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tests of the tables of cloth that a run writes.
#include "sdk/cli/record/cloth_record.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <nlohmann/json.hpp>

namespace meniscus::cli {
namespace {

namespace fs = std::filesystem;

class ClothRecordTest : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("meniscus_cloth_record_" + std::to_string(getpid()) + "_" +
                                           testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::create_directories(folder_);
    scene_.cloths.resize(2);
    scene_.cloths[0].name = "flag";
    scene_.cloths[1].name = "rag, old";
    scene_.ropes.resize(1);
    scene_.ropes[0].name = "line";
    scene_.attachments.resize(1);
    scene_.attachments[0].def.name = "hoist";
  }
  void TearDown() override { fs::remove_all(folder_); }

  /// Of a flag that is stretched so much, torn in the frame by so many vertices, and pulls so hard.
  static FrameSample sample(int frame, float stretch, std::size_t tears, float pull) {
    FrameSample s;
    s.frame = frame;
    s.particles.time = 0.01 * frame;
    s.cloths.resize(2);
    s.cloths[0] = {.mass = 2,
                   .area = 4,
                   .mean_stretch = 0.01f,
                   .max_stretch = stretch,
                   .centre = {1, 2, 3},
                   .momentum = {4, 5, 6},
                   .kinetic_energy = 7.5f};
    s.cloths[1].volume = 0.5f;
    s.cloths[1].pressure = 300;
    s.cloth.names = {"flag", "rag, old"};
    s.cloth.vertex_pieces = {0, 0, 0, 1, 1, 1, 1};
    s.cloth.pieces = {0, 1, 1};
    s.welded = {7, 0};
    s.bending = {0.5f, 1};
    s.tears = {tears, 0};
    s.ropes.vertices = {{0, 0, 0}, {static_cast<float>(frame), 0, 0}, {static_cast<float>(frame), 2, 0}};
    s.ropes.lines = {{0, 1, 2}};
    s.attachment_forces = {{0, -pull, 0}};
    return s;
  }

  std::vector<std::string> csv(const char* name) const {
    std::ifstream stream(folder_ / name);
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
  }

  fs::path folder_;
  Scene scene_;
};

TEST_F(ClothRecordTest, ARowAFrameAndPiece) {
  ClothRecord record(folder_, scene_);
  record.start(sample(0, 1, 0, 0));
  record.add(sample(1, 1.25f, 3, 9));
  const std::vector<std::string> rows = csv("cloths.csv");
  ASSERT_EQ(rows.size(), 3u) << "the state before the first step has none";
  EXPECT_EQ(
      rows[0],
      "frame,time_s,name,mean_stretch,max_stretch,kinetic_j,volume_m3,pressure_pa,x,y,z,px,py,pz,tears");
  EXPECT_EQ(rows[1], "1,0.01,flag,0.01,1.25,7.5,0,0,1,2,3,4,5,6,3");
  EXPECT_EQ(rows[2], "1,0.01,\"rag, old\",0,0,0,0.5,300,0,0,0,0,0,0,0");
  EXPECT_EQ(csv("attachments.csv"),
            (std::vector<std::string>{"frame,time_s,name,fx,fy,fz", "1,0.01,hoist,0,-9,0"}));
}

TEST_F(ClothRecordTest, TheSummaryHasTheLastStateAndTheWorstOfTheRun) {
  ClothRecord record(folder_, scene_);
  record.start(sample(1, 1, 0, 0));
  record.add(sample(2, 1.5f, 3, 9));
  record.add(sample(3, 1.25f, 2, 4));
  const auto cloths = record.cloths();
  ASSERT_EQ(cloths.size(), 2u);
  EXPECT_EQ(cloths[0]["name"], "flag");
  EXPECT_EQ(cloths[0]["vertices"], 3);
  EXPECT_EQ(cloths[0]["triangles"], 1);
  EXPECT_EQ(cloths[1]["triangles"], 2);
  EXPECT_EQ(cloths[0]["welded_vertices"], 7);
  EXPECT_EQ(cloths[0]["bending_fraction"], 0.5);
  EXPECT_EQ(cloths[0]["max_stretch"], 1.25);
  EXPECT_EQ(cloths[0]["max_stretch_of_run"], 1.5);
  EXPECT_EQ(cloths[0]["tears"], 5);
  EXPECT_EQ(cloths[1]["pressure_pa"], 300);
  EXPECT_EQ(record.ropes()[0]["start_m"], 3);
  EXPECT_EQ(record.ropes()[0]["length_m"], 5);
  EXPECT_EQ(record.attachments()[0]["force_n"][1], -4);
  EXPECT_EQ(record.attachments()[0]["max_force_n"], 9);
}

TEST_F(ClothRecordTest, ASceneWithoutClothLeavesNoFiles) {
  ClothRecord record(folder_, Scene{});
  record.start({});
  record.add({});
  EXPECT_TRUE(fs::is_empty(folder_));
  EXPECT_TRUE(record.cloths().empty());
  EXPECT_TRUE(record.attachments().empty());
}

}  // namespace
}  // namespace meniscus::cli
