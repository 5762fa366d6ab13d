// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Files that C writes are those of the program's writers; bad paths leave nothing. Calls that report
// progress, cancel, and keep their messages by thread.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <thread>

#include "tests/unit/sdk/c/c_scenes.h"

namespace meniscus::tests {
namespace {

namespace fs = std::filesystem;

struct Destroy {
  void operator()(MeniscusWorld* world) const { meniscus_world_destroy(world); }
};

class CExport : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(folder_);
    MeniscusWorld* made = nullptr;
    ASSERT_EQ(c_tank_with_body("cpu", &made, &body_), MENISCUS_OK) << meniscus_last_error();
    world_.reset(made);
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  static std::string text_of(const std::string& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  const fs::path folder_ = fs::path(testing::TempDir()) / ("c_export_" + std::to_string(getpid()));
  std::unique_ptr<MeniscusWorld, Destroy> world_;
  MeniscusId body_{};
};

TEST_F(CExport, FilesHoldTheState) {
  std::size_t count = 0;
  ASSERT_EQ(meniscus_particle_count(world_.get(), &count), MENISCUS_OK);
  for (const char* name : {"a.ply", "a.vtp", "a.obj"})
    ASSERT_EQ(meniscus_export_particles(world_.get(), path(name).c_str()), MENISCUS_OK)
        << meniscus_last_error();
  EXPECT_NE(text_of(path("a.ply")).find("element vertex " + std::to_string(count)), std::string::npos);
  EXPECT_NE(text_of(path("a.vtp")).find("NumberOfPoints=\"" + std::to_string(count) + "\""),
            std::string::npos);
  EXPECT_NE(text_of(path("a.obj")).find("\nv "), std::string::npos);

  MeniscusWorld* made = nullptr;
  MeniscusId cloth{};
  ASSERT_EQ(c_cloth_over_ball("cpu", &made, &cloth), MENISCUS_OK);
  const std::unique_ptr<MeniscusWorld, Destroy> draped(made);
  ASSERT_EQ(meniscus_export_cloth(made, &cloth, 1, path("c.ply").c_str()), MENISCUS_OK)
      << meniscus_last_error();
  EXPECT_NE(text_of(path("c.ply")).find("element vertex 289"), std::string::npos);
  EXPECT_EQ(meniscus_export_diffuse(made, path("d.vtp").c_str()), MENISCUS_OK) << meniscus_last_error();
  EXPECT_EQ(meniscus_export_cloth(world_.get(), &cloth, 1, path("e.ply").c_str()), MENISCUS_NOT_FOUND);
  EXPECT_FALSE(fs::exists(path("e.ply")));
}

TEST_F(CExport, BadPathsAreRefused) {
  EXPECT_EQ(meniscus_export_particles(world_.get(), path("a.txt").c_str()), MENISCUS_INVALID_ARGUMENT);
  EXPECT_EQ(meniscus_export_particles(world_.get(), nullptr), MENISCUS_INVALID_ARGUMENT);
  EXPECT_EQ(meniscus_export_particles(nullptr, path("a.ply").c_str()), MENISCUS_INVALID_ARGUMENT);
  EXPECT_EQ(meniscus_export_surface(world_.get(), nullptr, 1, path("a.ply").c_str()),
            MENISCUS_INVALID_ARGUMENT);
  EXPECT_EQ(meniscus_export_surface(world_.get(), &body_, 1, path("a.ply").c_str()),
            MENISCUS_INVALID_ARGUMENT);
  EXPECT_EQ(meniscus_export_cloth(world_.get(), nullptr, 1, path("a.ply").c_str()),
            MENISCUS_INVALID_ARGUMENT);
  EXPECT_EQ(meniscus_export_diffuse(nullptr, path("a.ply").c_str()), MENISCUS_INVALID_ARGUMENT);
  EXPECT_EQ(meniscus_export_particles(world_.get(), path("no/such/folder/a.ply").c_str()), MENISCUS_IO);
  EXPECT_TRUE(fs::is_empty(folder_));
}

TEST_F(CExport, CancelEndsTheNextLongCall) {
  ASSERT_EQ(meniscus_cancel(world_.get()), MENISCUS_OK);
  EXPECT_EQ(meniscus_step(world_.get(), 0.02f, nullptr), MENISCUS_CANCELLED);
  EXPECT_EQ(meniscus_step(world_.get(), 0.02f, nullptr), MENISCUS_OK) << meniscus_last_error();
}

TEST_F(CExport, ProgressIsReported) {
  struct Seen {
    int reports = 0;
    bool in_range = true;
  } seen;
  const auto report = [](const char* what, double fraction, void* user) {
    auto& s = *static_cast<Seen*>(user);
    ++s.reports;
    s.in_range = s.in_range && *what && fraction >= 0 && fraction <= 1;
  };
  ASSERT_EQ(meniscus_set_progress(world_.get(), report, &seen), MENISCUS_OK);
  for (int k = 0; k < 200 && seen.reports == 0; ++k) ASSERT_EQ(meniscus_relax(world_.get(), 50), MENISCUS_OK);
  EXPECT_GT(seen.reports, 0);
  EXPECT_TRUE(seen.in_range);
}

TEST_F(CExport, EachThreadHasItsLastMessage) {
  EXPECT_EQ(meniscus_export_particles(world_.get(), nullptr), MENISCUS_INVALID_ARGUMENT);
  const std::string here = meniscus_last_error();
  std::string before = "unset", after;
  std::thread([&] {
    before = meniscus_last_error();
    meniscus_scene_check(nullptr);
    after = meniscus_last_error();
  }).join();
  EXPECT_EQ(before, "");
  EXPECT_EQ(after, "scene is null");
  EXPECT_EQ(here, "path is null");
  EXPECT_EQ(meniscus_last_error(), here);
}

}  // namespace
}  // namespace meniscus::tests
