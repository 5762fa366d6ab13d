// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tests of the export of particles.
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <gtest/gtest.h>
#include <meniscus/error.h>
#include <sys/resource.h>

#include <assimp/Importer.hpp>
#include <csignal>
#include <cstring>
#include <fstream>

#include "sdk/files/output_file.h"
#include "sdk/io/obj.h"
#include "sdk/io/ply.h"
#include "sdk/io/pvd.h"
#include "sdk/io/vtp.h"
#include "tests/unit/sdk/io/export_files.h"

namespace meniscus::io {
namespace {

namespace fs = std::filesystem;

class ExportTest : public ExportFolder {
 protected:
  ParticleFrame frame() const { return {0.25, positions_, velocities_, ids_, fluids_, errors_, pressures_}; }

  std::size_t files() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }

  std::vector<Vec3> positions_{{1, 2, 3}, {-4, 5.5f, 6}, {0.125f, 0, -7}};
  std::vector<Vec3> velocities_{{0, 0, 0}, {1, -2, 3}, {9, 8, 7}};
  std::vector<ParticleId> ids_{0, 7, 4'000'000'000u};
  std::vector<uint32_t> fluids_{0, 1, 0};
  std::vector<float> errors_{0, -0.5f, 0.03125f};
  std::vector<float> pressures_{0, 101.5f, 9810};
};

TEST_F(ExportTest, PlyHasAHeaderAndPackedRecords) {
  write_ply(folder_ / "a.ply", frame());
  const std::string file = contents(folder_ / "a.ply");
  const std::size_t data = file.find("end_header\n") + std::strlen("end_header\n");
  EXPECT_EQ(file.rfind("ply\nformat binary_little_endian 1.0\n", 0), 0u);
  EXPECT_NE(file.find("element vertex 3\n"), std::string::npos);
  ASSERT_EQ(file.size(), data + 3 * 36);
  const std::size_t third = data + 2 * 36;
  EXPECT_EQ(value_at<float>(file, third), 0.125f);
  EXPECT_EQ(value_at<float>(file, third + 20), 7.0f);
  EXPECT_EQ(value_at<uint32_t>(file, data + 36 + 24), 1u);
  EXPECT_EQ(value_at<uint32_t>(file, third + 28), 4'000'000'000u);
  EXPECT_EQ(value_at<float>(file, third + 32), 0.03125f);
}

TEST_F(ExportTest, AnotherProgramReadsThePly) {
  write_ply(folder_ / "a.ply", frame());
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile((folder_ / "a.ply").string(), 0);
  ASSERT_NE(scene, nullptr) << importer.GetErrorString();
  ASSERT_EQ(scene->mNumMeshes, 1u);
  ASSERT_EQ(scene->mMeshes[0]->mNumVertices, 3u);
  EXPECT_EQ(scene->mMeshes[0]->mVertices[1], aiVector3D(-4, 5.5f, 6));
}

TEST_F(ExportTest, PlyRefusesAnIdBeyondItsIntegers) {
  ids_[1] = ParticleId{1} << 32;
  try {
    write_ply(folder_ / "a.ply", frame());
    FAIL() << "an id of 33 bits was written";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::capacity);
    EXPECT_NE(std::string(error.what()).find("4294967296"), std::string::npos);
  }
  EXPECT_EQ(files(), 0u);
}

TEST_F(ExportTest, VtpOffsetsPointToTheArrays) {
  write_vtp(folder_ / "a.vtp", frame());
  const std::string file = contents(folder_ / "a.vtp");
  EXPECT_NE(file.find("NumberOfPoints=\"3\" NumberOfVerts=\"3\""), std::string::npos);
  EXPECT_EQ(value_at<float>(appended(file, "Points", 36), 16), 5.5f);
  EXPECT_EQ(value_at<float>(appended(file, "velocity", 36), 24), 9.0f);
  EXPECT_EQ(value_at<uint32_t>(appended(file, "fluid", 12), 4), 1u);
  EXPECT_EQ(value_at<uint64_t>(appended(file, "id", 24), 16), 4'000'000'000u);
  EXPECT_EQ(value_at<float>(appended(file, "density_error", 12), 4), -0.5f);
  EXPECT_EQ(value_at<float>(appended(file, "pressure", 12), 8), 9810.0f);
  EXPECT_EQ(value_at<int64_t>(appended(file, "connectivity", 24), 16), 2);
  EXPECT_EQ(value_at<int64_t>(appended(file, "offsets", 24), 16), 3);
  const std::string end = "\n</AppendedData>\n</VTKFile>\n";
  EXPECT_EQ(file.substr(file.size() - end.size()), end);
}

TEST_F(ExportTest, AnotherProgramReadsTheObj) {
  write_obj(folder_ / "a.obj", frame());
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile((folder_ / "a.obj").string(), 0);
  ASSERT_NE(scene, nullptr) << importer.GetErrorString();
  ASSERT_EQ(scene->mNumMeshes, 1u);
  const aiMesh& mesh = *scene->mMeshes[0];
  EXPECT_EQ(mesh.mPrimitiveTypes, unsigned(aiPrimitiveType_POINT));
  ASSERT_EQ(mesh.mNumFaces, 3u);
  EXPECT_EQ(mesh.mVertices[mesh.mFaces[1].mIndices[0]], aiVector3D(-4, 5.5f, 6));
}

TEST_F(ExportTest, NoParticlesAreAFileToo) {
  write_ply(folder_ / "a.ply", ParticleFrame{});
  write_vtp(folder_ / "a.vtp", ParticleFrame{});
  EXPECT_NE(contents(folder_ / "a.ply").find("element vertex 0\n"), std::string::npos);
  write_obj(folder_ / "a.obj", ParticleFrame{});
  EXPECT_NE(contents(folder_ / "a.vtp").find("NumberOfPoints=\"0\""), std::string::npos);
  EXPECT_NE(contents(folder_ / "a.obj").find("# Meniscus particles"), std::string::npos);
}

TEST_F(ExportTest, CollectionIsWholeAfterEachFrame) {
  PvdFile collection(folder_ / "run.pvd");
  const std::string end = "</Collection>\n</VTKFile>\n";
  for (int k = 0; k < 3; ++k) {
    collection.add(0.5 * k, fs::path("frames") / ("a&" + std::to_string(k) + ".vtp"));
    const std::string file = contents(folder_ / "run.pvd");
    ASSERT_EQ(file.substr(file.size() - end.size()), end);
    EXPECT_EQ(file.find(end), file.size() - end.size()) << "the closing tags are there once";
  }
  EXPECT_NE(contents(folder_ / "run.pvd").find("timestep=\"0.5\" part=\"0\" file=\"frames/a&amp;1.vtp\""),
            std::string::npos);
}

TEST_F(ExportTest, ArraysOfUnequalLengthAreRefused) {
  fluids_.pop_back();
  try {
    write_vtp(folder_ / "a.vtp", frame());
    FAIL() << "a short array was accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::invalid_argument);
    EXPECT_NE(std::string(error.what()).find("fluids has 2"), std::string::npos);
  }
}

TEST_F(ExportTest, AFileThatCannotBeMadeIsNamed) {
  const fs::path path = folder_ / "missing" / "a.ply";
  try {
    write_ply(path, frame());
    FAIL() << "a file appeared in a folder that is not there";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::io);
    EXPECT_NE(std::string(error.what()).find(path.string()), std::string::npos);
  }
}

TEST_F(ExportTest, AFullDiskIsReported) {
  // A disk that is full, but for this process and as long as the limit holds.
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const rlimit full{10, before.rlim_max};
  const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
  setrlimit(RLIMIT_FSIZE, &full);
  std::string why;
  try {
    write_vtp(folder_ / "a.vtp", frame());
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::io);
    why = error.what();
  }
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, old_handler);
  EXPECT_NE(why.find("File too large"), std::string::npos) << why;
  EXPECT_EQ(files(), 0u);
}

TEST_F(ExportTest, TwoWritersOfOneFileDoNotMix) {
  OutputFile first(folder_ / "a.txt"), second(folder_ / "a.txt");
  first.write("first");
  second.write("second");
  second.commit();
  EXPECT_EQ(contents(folder_ / "a.txt"), "second");
  first.commit();
  EXPECT_EQ(contents(folder_ / "a.txt"), "first");
  EXPECT_EQ(files(), 1u);
}

TEST_F(ExportTest, WithoutACommitTheOldFileStays) {
  std::ofstream(folder_ / "a.txt") << "old";
  {
    OutputFile file(folder_ / "a.txt");
    file.write("half of the new");
  }
  EXPECT_EQ(contents(folder_ / "a.txt"), "old");
  EXPECT_EQ(files(), 1u);
}

}  // namespace
}  // namespace meniscus::io
