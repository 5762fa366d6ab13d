// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Mesh files that are damaged, hostile or of no known format: each is read or refused by name, in little
// time.
#include <gtest/gtest.h>
#include <meniscus/error.h>
#include <sys/stat.h>

#include <assimp/IOStream.hpp>
#include <chrono>
#include <filesystem>
#include <fstream>

#include "collision/mesh/file/assimp_io.h"
#include "collision/mesh/file/defect.h"
#include "collision/mesh/file/tuning.h"
#include "collision/mesh/mesh.h"
#include "tests/unit/collision/mesh_files.h"

namespace meniscus::collision {
namespace {

namespace fs = std::filesystem;
using namespace mesh_files;

class MeshFiles : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(testing::TempDir()) / (std::string("meniscus_files_") + test->name());
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string write(const std::string& name, const std::string& bytes) const {
    const std::string path = (folder_ / name).string();
    std::ofstream(path, std::ios::binary | std::ios::trunc) << bytes;
    return path;
  }

  /// Why a file is refused, by a message that names it; empty if it is read.
  static std::string defect_of(const std::string& path, ErrorCode code = ErrorCode::mesh) {
    try {
      load_mesh(path);
    } catch (const Error& error) {
      EXPECT_EQ(static_cast<int>(error.code()), static_cast<int>(code)) << error.what();
      EXPECT_NE(std::string(error.what()).find(path), std::string::npos) << error.what();
      return error.what();
    }
    return "";
  }

  void expect_defect(const std::string& name, const std::string& bytes, const std::string& defect) const {
    const std::string why = defect_of(write(name, bytes));
    EXPECT_NE(why.find(defect), std::string::npos) << "\"" << why << "\" of " << name << " lacks " << defect;
  }

  fs::path folder_;
};

using MeshFileBounds = MeshFiles;

/// The same text with the first `from` replaced.
std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST_F(MeshFiles, EachFormatIsRead) {
  for (const auto& [name, bytes] : good_files()) {
    const TriangleMesh mesh = load_solid(write(name, bytes));
    EXPECT_EQ(mesh.triangles.size(), 4u) << name;
    EXPECT_NEAR(signed_volume(mesh), 1.0 / 6, 1e-6) << name;
  }
  EXPECT_EQ(load_mesh(write("CAPITALS.STL", binary_stl())).triangles.size(), 4u);
}

TEST_F(MeshFiles, FilesCutAtAnyByteAreReadOrRefused) {
  for (const auto& [name, bytes] : good_files()) {
    const auto start = std::chrono::steady_clock::now();
    for (std::size_t size = 0; size < bytes.size(); ++size) defect_of(write(name, bytes.substr(0, size)));
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20)) << name;
  }
}

TEST_F(MeshFiles, FilesWithAnyByteChangedAreReadOrRefused) {
  for (const auto& [name, bytes] : good_files()) {
    const auto start = std::chrono::steady_clock::now();
    for (std::size_t at = 0; at < bytes.size(); ++at) {
      std::string damaged = bytes;
      damaged[at] = at % 2 ? '\xff' : '9';
      defect_of(write(name, damaged));
    }
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20)) << name;
  }
}

TEST_F(MeshFiles, OtherFormatsAreRefusedByTheirExtension) {
  for (const char* name : {"a.raw", "a.blend", "a.ogex", "a", "a.obj.txt"})
    expect_defect(name, obj(), "meshes are read from .obj, .ply, .stl, .gltf, .glb, .fbx, .dae, .3ds");
  expect_defect("really.dae", obj(), "is not valid");
  expect_defect("really.gltf", dae(), "is not valid JSON");
}

TEST_F(MeshFiles, DefectsOfPlyAreNamed) {
  const std::string head = ply_header("binary_little_endian");
  expect_defect("cut.ply", head + ply_body().substr(0, 60), "list of its element 'face' number 0");
  expect_defect("short.ply", head + ply_body().substr(0, 40), "promises 4 of its element 'vertex'");
  expect_defect("index.ply", head + ply_body(255), "a vertex that it lacks: face 3 of 4 vertices");
  expect_defect("negative.ply", head + ply_body(-1), "a vertex that it lacks: face 3");
  expect_defect("header.ply", "ply\nformat ascii 1.0\nelement vertex ",
                "in place of the number of an element");
  expect_defect("endless.ply", "ply\nformat ascii 1.0\nelement vertex 4\n", "before 'end_header'");
  expect_defect("many.ply", ply_header("binary_little_endian", "4", "500000000") + ply_body(),
                "promises 500000000 of its element 'face'");
  expect_defect("overflow.ply", ply_header("ascii", "18446744073709551615") + "0 0 0\n", "promises");
  expect_defect("list.ply", head + ply_body().substr(0, 48) + "\xff" + ply_body().substr(49), "number 0");
  expect_defect("word.ply", with(ascii_ply(), "0 1 0\n", "0 b 0\n"), "'b' in place of a number");
  expect_defect("type.ply", with(ascii_ply(), "float y", "complex y"), "unknown type 'complex'");
}

TEST_F(MeshFiles, DefectsOfStlAreNamed) {
  expect_defect("many.stl", binary_stl(500000000), "promises 500000000 triangles, which need 25000000084");
  expect_defect("cut.stl", binary_stl().substr(0, 200), "promises 4 triangles");
  expect_defect("word.stl", with(ascii_stl(), "vertex 0 1 0", "vertex 0 x 0"), "has 'x' in facet 0");
  expect_defect("open.stl", with(ascii_stl(), "endsolid", "solid"),
                "where 'facet' or 'endsolid' should come");
  expect_defect("none.stl", "solid a\nendsolid a\n", "has no triangle");
}

TEST_F(MeshFiles, DefectsOfObjAreNamed) {
  expect_defect("index.obj", with(obj(), "f 1 4 3", "f 1 5 3"), "line 11 names vertex 5 of 4");
  expect_defect("negative.obj", with(obj(), "f -3", "f -5"), "names the last vertex but 4, of 4");
  expect_defect("normal.obj", with(obj(), "1//1", "1//2"), "names normal 2 of 1");
  expect_defect("zero.obj", with(obj(), "f 1 4 3", "f 0 4 3"), "'0' in place of the number of a vertex");
  expect_defect("word.obj", with(obj(), "v 1 0 0", "v 1 a 0"), "line 3 has 'a' in place of a number");
  expect_defect("binary.obj", obj() + std::string(1, '\0'), "byte 0");
}

TEST_F(MeshFiles, DefectsOfOtherFormatsAreNamed) {
  std::string longer = glb();
  longer[13] = '\x40';  // of the length of the first chunk
  expect_defect("chunk.glb", longer, "ends within its chunk at byte 12");
  expect_defect("size.glb", glb() + "more", "bytes, and has");
  expect_defect("count.gltf",
                with(gltf(), R"("bufferView":0,"componentType":5126,"count":4)",
                     R"("componentType":5126,"count":4000000000)"),
                "accessor 0 of 4000000000 elements");
  expect_defect("word.dae", with(dae(), "0 1 3", "0$1 3"), "'0$1' among the numbers of an element 'p'");
  expect_defect("list.dae", with(dae(), R"(count="12")", R"(count="13")"),
                "'13' numbers in its list 'pa', and has 12");
  expect_defect("accessor.dae", with(dae(), R"(count="4" stride)", R"(count="99" stride)"),
                "an accessor of 297 numbers of its list 'pa', which has 12");
  expect_defect("open.dae", with(dae(), "</mesh>", ""), "closes 'geometry', which is not open");
  std::string chunk_3ds = three_ds();
  chunk_3ds[4] = '\x7f';
  expect_defect("chunk.3ds", chunk_3ds, "ends within its chunk at byte 0");
}

TEST_F(MeshFileBounds, AFileThatIsTooLargeIsNotRead) {
  const std::string path = write("large.stl", "solid");
  fs::resize_file(path, mesh_file_tuning::most_file_bytes + 1);  // a hole, which takes no room on the disk
  EXPECT_NE(defect_of(path).find("2147483648 bytes"), std::string::npos);
}

TEST_F(MeshFileBounds, PipesAndDevicesAreNotWaitedFor) {
  const std::string pipe = (folder_ / "pipe.obj").string();
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_NE(defect_of(pipe, ErrorCode::io), "");
  fs::create_symlink("/dev/zero", folder_ / "zero.mtl");
  EXPECT_EQ(defect_of(write("zero.obj", "mtllib zero.mtl\n" + obj())), "");
  fs::create_symlink("/dev/zero", folder_ / "zero.ply");
  EXPECT_NE(defect_of((folder_ / "zero.ply").string(), ErrorCode::io), "");
}

TEST_F(MeshFileBounds, AReaderThatCirclesIsStopped) {
  ImportBudget budget{1000, 5000};
  const std::string bytes = "0123456789";
  const FileSource none{FileReader()};
  BoundedFiles files("a.obj", bytes, none, budget);
  Assimp::IOStream* stream = files.Open("a.obj", "rb");
  BudgetProgress progress(budget);
  EXPECT_TRUE(progress.Update(0));
  char byte;
  int reads = 0;
  EXPECT_THROW(for (;; ++reads) stream->Read(&byte, 1, 1), FileDefect);
  EXPECT_LT(reads, 5000);
  EXPECT_FALSE(progress.Update(0));
  files.Close(stream);
}

TEST_F(MeshFileBounds, AnObjFileOfManyPartsIsRefused) {
  std::string text = obj();
  for (uint64_t i = 0; i < mesh_file_tuning::most_parts; ++i) text += "o " + std::to_string(i) + "\n";
  expect_defect("parts.obj", text, "one of more than 16384 parts");
}

TEST_F(MeshFileBounds, APolygonOfManyCornersIsRefused) {
  std::string corners;
  for (uint32_t i = 0; i <= mesh_file_tuning::most_corners; ++i) corners += i % 2 ? " 1" : " 2";
  expect_defect("polygon.obj", obj() + "f" + corners + "\n", "with 4097 corners; at most 4096 are read");
  expect_defect(
      "polygon.ply",
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uint uint vertex_index\nend_header\n"
      "0 0 0\n1 0 0\n0 1 0\n0 0 1\n4097" +
          corners + "\n",
      "with 4097 corners");
}

TEST_F(MeshFileBounds, DeepNestingIsRefused) {
  const auto repeated = [](const std::string& text) {
    std::string all;
    for (int i = 0; i < 1000000; ++i) all += text;
    return all;
  };
  expect_defect("deep.gltf", "{\"a\":" + repeated("["), "more than 256 levels deep");
  expect_defect("deep.dae", repeated("<a>"), "more than 256 levels deep");
  expect_defect("deep.fbx", "; FBX 7.4.0\n" + repeated("a: {\n"), "more than 256 levels deep");
}

}  // namespace
}  // namespace meniscus::collision
