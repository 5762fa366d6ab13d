// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A damaged mesh file is refused by its name and its defect, whatever the scene uses it for.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include <meniscus/scene.h>
#include "sdk/scene/scene_file.h"
#include "tests/unit/collision/mesh_files.h"

namespace meniscus {
namespace {

namespace fs = std::filesystem;
using namespace collision::mesh_files;

struct Role {
  const char* name;
  const char* scene;  ///< with FILE where the file stands
};

constexpr Role roles[] = {
    {"shape", R"("shapes": [{"name": "a", "geometry": {"type": "mesh", "file": "FILE"}}])"},
    {"body", R"("bodies": [{"name": "a", "geometry": {"type": "mesh", "file": "FILE"}}])"},
    {"hull", R"("bodies": [{"name": "a", "geometry": {"type": "hull", "file": "FILE"}}])"},
    {"part", R"("shapes": [{"name": "a", "geometry": {"type": "compound", "parts":
                [{"geometry": {"type": "mesh", "file": "FILE"}}]}}])"},
    {"volume", R"("fluids": [{"name": "w"}],
                  "volumes": [{"fluid": "w", "region": {"type": "mesh", "file": "FILE"}}])"},
    {"emitter", R"("fluids": [{"name": "w"}],
                   "emitters": [{"name": "a", "fluid": "w", "opening": {"type": "mesh", "file": "FILE"}, "speed": 1}])"},
    {"cloth", R"("cloths": [{"name": "a", "geometry": {"type": "mesh", "file": "FILE"}}])"},
};

struct BadFile {
  const char* name;
  std::string bytes;
  const char* defect;
};

std::vector<BadFile> bad_files() {
  std::string cut_ply = binary_ply();
  cut_ply.resize(cut_ply.size() - 5);
  std::string index_obj = obj();
  index_obj += "f 1 2 9\n";
  return {
      {"cut.ply", cut_ply, "is too short for a list of its element 'face' number 3"},
      {"index.ply", ply_header("binary_little_endian") + ply_body(99), "a vertex that it lacks"},
      {"many.ply", ply_header("binary_little_endian", "4", "500000000") + ply_body(), "promises 500000000"},
      {"cut.stl", binary_stl().substr(0, 150), "promises 4 triangles"},
      {"index.obj", index_obj, "names vertex 9 of 4"},
      {"count.gltf", "{\"accessors\": [{\"count\": 4000000000}]}", "accessor 0 of 4000000000"},
      {"cut.dae", dae().substr(0, 500), "ends within"},
      {"mesh.raw", obj(), "the extension 'raw'"}};
}

class MeshRole : public testing::TestWithParam<Role> {};

TEST_P(MeshRole, RefusesDamagedFilesByName) {
  const fs::path folder = fs::path(testing::TempDir()) / (std::string("meniscus_role_") + GetParam().name);
  fs::create_directories(folder);
  for (const BadFile& file : bad_files()) {
    std::ofstream(folder / file.name, std::ios::binary) << file.bytes;
    std::string scene = GetParam().scene;
    scene.replace(scene.find("FILE"), 4, file.name);
    const std::string path = (folder / "scene.json").string();
    std::ofstream(path) << R"({"name": "x", "world": {"device": "cpu", "threads": 1}, )" << scene << "}";
    try {
      build_scene(read_scene(path));
      ADD_FAILURE() << file.name << " was read";
    } catch (const Error& error) {
      EXPECT_EQ(static_cast<int>(error.code()), static_cast<int>(ErrorCode::mesh)) << error.what();
      const std::string why = error.what();
      EXPECT_NE(why.find((folder / file.name).string()), std::string::npos) << why;
      EXPECT_NE(why.find(file.defect), std::string::npos) << why;
    }
  }
  fs::remove_all(folder);
}

INSTANTIATE_TEST_SUITE_P(Each, MeshRole, testing::ValuesIn(roles),
                         [](const auto& role) { return std::string(role.param.name); });

}  // namespace
}  // namespace meniscus
