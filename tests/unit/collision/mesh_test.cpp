// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tests of the reader of mesh files.
#include "collision/mesh/mesh.h"

#include <gtest/gtest.h>
#include <meniscus/error.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

#include "collision/mesh/clean.h"
#include "tests/unit/collision/mesh_files.h"
#include "tests/unit/collision/mesh_shapes.h"

namespace meniscus::collision {
namespace {

class MeshFile : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::path(testing::TempDir()) / (std::string("meniscus_mesh_") + test->name());
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string write(const std::string& name, const std::string& text) {
    const std::string path = (folder_ / name).string();
    std::ofstream(path) << text;
    return path;
  }

  void expect_error(const std::string& path, ErrorCode code, float scale = 1) {
    try {
      load_mesh(path, scale);
      ADD_FAILURE() << path << " was accepted";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), code) << error.what();
      EXPECT_NE(std::string(error.what()).find(path), std::string::npos) << error.what();
    }
  }

  // The message that load_solid refuses the file with.
  std::string why_not_solid(const std::string& path) {
    try {
      load_solid(path);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::mesh);
      EXPECT_NE(std::string(error.what()).find(path), std::string::npos) << error.what();
      return error.what();
    }
    return "nothing";
  }

  std::filesystem::path folder_;
};

// A unit cube of quadrilaterals, with its lowest corner at the origin.
const char* const cube_obj =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
    "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

const char* const tetrahedron_ply =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 4\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";

// A tetrahedron that hangs on two nodes: one moved and turned by its parents, one mirrored.
const char* const two_nodes_dae = R"(<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="meter" meter="1"/><up_axis>Y_UP</up_axis></asset>
<library_geometries><geometry id="g"><mesh>
<source id="p"><float_array id="pa" count="12">0 0 0 1 0 0 0 1 0 0 0 1</float_array>
<technique_common><accessor source="#pa" count="4" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
<param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="4"><input semantic="VERTEX" source="#v" offset="0"/><p>0 2 1 0 1 3 0 3 2 1 2 3</p></triangles>
</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s">
<node id="a"><translate>10 0 0</translate><node id="b"><rotate>0 0 1 90</rotate><instance_geometry url="#g"/></node></node>
<node id="c"><translate>-10 0 0</translate><scale>-2 1 1</scale><instance_geometry url="#g"/></node>
</visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>)";

// Of the cube: two faces in a material, and four in another.
const char* const painted_cube_obj =
    "mtllib paints.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
    "usemtl red\nf 1 2 6 5\nf 2 3 7 6\nusemtl green\nf 1 4 3 2\nf 5 6 7 8\nf 3 4 8 7\nf 4 1 5 8\n";
const char* const paints_mtl = "newmtl red\nKd 0.8 0.1 0.05\nnewmtl green\nKd 0.1 1.5 0.2\n";

void expect_box(const TriangleMesh& mesh, Vec3 lower, Vec3 upper) {
  const Aabb box = bounds(mesh);
  EXPECT_LT(length(box.lower - lower), 1e-5f) << box.lower.x << ' ' << box.lower.y << ' ' << box.lower.z;
  EXPECT_LT(length(box.upper - upper), 1e-5f) << box.upper.x << ' ' << box.upper.y << ' ' << box.upper.z;
}

TEST_F(MeshFile, TrianglesHaveTheColoursOfTheirMaterials) {
  write("paints.mtl", paints_mtl);
  const PaintedMesh cube = load_painted_mesh(MeshSource(write("cube.obj", painted_cube_obj)));
  ASSERT_EQ(cube.mesh.triangles.size(), 12u);
  ASSERT_EQ(cube.colors.size(), 12u);
  for (std::size_t i = 0; i < 12; ++i) {
    const auto lies_at = [&](float Vec3::*axis, float at) {
      return std::ranges::all_of(cube.mesh.triangles[i],
                                 [&](uint32_t v) { return cube.mesh.vertices[v].*axis == at; });
    };
    const bool is_red = lies_at(&Vec3::y, 0) || lies_at(&Vec3::x, 1);
    EXPECT_EQ(cube.colors[i], (is_red ? Vec3{0.8f, 0.1f, 0.05f} : Vec3{0.1f, 1, 0.2f}))
        << i << "; none is brighter than white";
  }
}

TEST_F(MeshFile, WithoutMaterialsNothingHasAColour) {
  for (const auto& [name, text] :
       {std::pair{"cube.obj", cube_obj}, std::pair{"tetrahedron.ply", tetrahedron_ply}}) {
    for (const auto& color : load_painted_mesh(MeshSource(write(name, text))).colors)
      EXPECT_EQ(color, std::nullopt) << name;
  }
}

TEST_F(MeshFile, PolygonsBecomeWeldedTriangles) {
  const TriangleMesh cube = load_mesh(write("cube.obj", cube_obj), 1);
  EXPECT_EQ(cube.vertices.size(), 8u);
  EXPECT_EQ(cube.triangles.size(), 12u);
  EXPECT_NEAR(signed_volume(cube), 1, 1e-6);
}

TEST_F(MeshFile, ScaleIsMetresAFileUnit) {
  const TriangleMesh mesh = load_mesh(write("tetrahedron.ply", tetrahedron_ply), 0.01f);
  EXPECT_EQ(mesh.vertices.size(), 4u);
  expect_box(mesh, {0, 0, 0}, {0.01f, 0.01f, 0.01f});
  EXPECT_NEAR(signed_volume(mesh), 1e-6 / 6, 1e-12);
}

TEST_F(MeshFile, NodeTransformsAreAppliedAndMirrorsKeepTheInsideIn) {
  const TriangleMesh both = load_mesh(write("two.dae", two_nodes_dae), 1);
  EXPECT_EQ(both.triangles.size(), 8u);
  expect_box(both, {-12, 0, 0}, {10, 1, 1});
  EXPECT_NEAR(signed_volume(both), 1.0 / 6 + 2.0 / 6, 1e-5);
}

TEST_F(MeshFile, SeveralPartsBecomeOneMesh) {
  std::string text = cube_obj;
  text += "o other\nv 5 0 0\nv 6 0 0\nv 5 1 0\nv 5 0 1\nf 9 11 10\nf 9 10 12\nf 9 12 11\nf 10 11 12\n";
  const TriangleMesh mesh = load_mesh(write("parts.obj", text), 1);
  EXPECT_EQ(mesh.vertices.size(), 12u);
  EXPECT_NEAR(signed_volume(mesh), 1 + 1.0 / 6, 1e-5);
}

TEST_F(MeshFile, LinesAndPointsArePassedOver) {
  const std::string text = std::string(cube_obj) + "v 50 0 0\nl 1 9\np 9\n";
  const TriangleMesh mesh = load_mesh(write("line.obj", text), 1);
  EXPECT_EQ(mesh.triangles.size(), 12u);
  expect_box(mesh, {0, 0, 0}, {1, 1, 1});
}

TEST_F(MeshFile, FbxSaysHowLongItsUnitIs) {
  const std::string path = write("inches.fbx", mesh_files::fbx("2.54"));
  expect_box(load_mesh(path), {0, 0, 0}, {0.0254f, 0.0254f, 0.0254f});
  expect_box(load_solid(path, 100), {0, 0, 0}, {2.54f, 2.54f, 2.54f});
}

TEST_F(MeshFile, FacesThatShowTheWrongSideAreTurned) {
  const std::string text =
      std::string(cube_obj).replace(std::string(cube_obj).find("f 1 2 6 5"), 9, "f 5 6 2 1");
  const std::string path = write("turned.obj", text);
  EXPECT_NEAR(signed_volume(load_mesh(path)), 1, 1e-6);
  EXPECT_NEAR(signed_volume(load_solid(path)), 1, 1e-6);
}

TEST_F(MeshFile, ASolidIsRefusedByItsDefectAndTheFilesFace) {
  const std::string cube = cube_obj;
  EXPECT_EQ(why_not_solid(write("cube.obj", cube)), "nothing");

  // The first face has no area, and counts. The second has lost its neighbour at the edge 1 4.
  const std::string open =
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\nf 1 1 2\n"
      "f 2 3 7\nf 2 7 6\nf 1 4 3\nf 1 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 3 4 8 7\n";
  const std::string why_open = why_not_solid(write("open.obj", open));
  EXPECT_NE(why_open.find("open edge at face 3 (4 in all)"), std::string::npos) << why_open;
  EXPECT_NO_THROW(load_mesh((folder_ / "open.obj").string()));

  const std::string beside = "v 2 1 0\nv 2 2 0\nv 1 2 0\nv 2 1 1\nv 2 2 1\nv 1 2 1\n";
  const std::string touching =
      cube + beside + "f 3 11 10 9\nf 7 12 13 14\nf 3 9 12 7\nf 9 10 13 12\nf 10 11 14 13\nf 11 3 7 14\n";
  const std::string why_touching = why_not_solid(write("touching.obj", touching));
  EXPECT_NE(why_touching.find("non-manifold edge at face 6 with face 2"), std::string::npos) << why_touching;

  const std::string through = cube +
                              "v 0.2 0.3 -1\nv 0.4 0.3 -1\nv 0.3 0.5 -1\nv 0.3 0.35 0.5\n"
                              "f 9 11 10\nf 9 10 12\nf 10 11 12\nf 11 9 12\n";
  const std::string why_through = why_not_solid(write("through.obj", through));
  EXPECT_NE(why_through.find("self-intersection at face 0 with face 1"), std::string::npos) << why_through;
}

TEST(Mesh, AScanIsASolid) {
  const char* const bunny_file = "/usr/share/glmark2/models/bunny.obj";
  if (!std::filesystem::exists(bunny_file))
    GTEST_SKIP() << "the bunny of the package glmark2-data is not here";
  EXPECT_EQ(load_solid(bunny_file).triangles, load_mesh(bunny_file).triangles);
}

TEST_F(MeshFile, BadFilesAreRefusedByName) {
  expect_error((folder_ / "missing.obj").string(), ErrorCode::io);
  expect_error(folder_.string(), ErrorCode::io);
  expect_error(write("noise.obj2", "this is no mesh"), ErrorCode::mesh);
  expect_error(write("broken.gltf", "{\"asset\": "), ErrorCode::mesh);
  expect_error(write("empty.obj", ""), ErrorCode::mesh);
  expect_error(write("flat.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n"), ErrorCode::mesh);
  expect_error(write("nan.obj", "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"), ErrorCode::mesh);
  expect_error(write("cloud.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\np 1 2 3\n"), ErrorCode::mesh);
}

TEST_F(MeshFile, BadScalesAreRefused) {
  const std::string path = write("cube.obj", cube_obj);
  for (float scale : {0.0f, -1.0f, std::nanf(""), std::numeric_limits<float>::infinity()}) {
    expect_error(path, ErrorCode::invalid_argument, scale);
  }
  for (float scale : {1e-30f, 1e-7f, 1e7f, 1e30f}) expect_error(path, ErrorCode::mesh, scale);
}

TEST(CleanMesh, WeldsVerticesAMillionthOfTheBoxApart) {
  TriangleMesh mesh = box_mesh({0, 0, 0}, {1, 1, 1});
  TriangleMesh soup;  // three own vertices a triangle, each a little off
  Noise noise(3);
  for (const auto& t : mesh.triangles) {
    const auto first = static_cast<uint32_t>(soup.vertices.size());
    for (uint32_t v : t) soup.vertices.push_back(mesh.vertices[v] + noise.in_cube(2e-7f));
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  const TriangleMesh welded = clean_mesh(soup);
  EXPECT_EQ(welded.vertices.size(), 8u);
  EXPECT_EQ(welded.triangles.size(), 12u);
  EXPECT_EQ(clean_mesh(soup).triangles, welded.triangles);
}

TEST(CleanMesh, KeepsVerticesThatAreFurtherApart) {
  TriangleMesh mesh = box_mesh({0, 0, 0}, {1, 1, 1});
  const TriangleMesh second = box_mesh({1.0001f, 0, 0}, {2, 1, 1});
  mesh.vertices.insert(mesh.vertices.end(), second.vertices.begin(), second.vertices.end());
  for (const auto& [a, b, c] : second.triangles) mesh.triangles.push_back({a + 8, b + 8, c + 8});
  EXPECT_EQ(clean_mesh(mesh).vertices.size(), 16u);
}

TEST(CleanMesh, DropsFlatAndRepeatedTrianglesAndUnusedVertices) {
  TriangleMesh mesh = box_mesh({0, 0, 0}, {1, 1, 1});
  const auto clean = mesh;
  mesh.vertices.push_back({9, 9, 9});
  mesh.vertices.push_back({0.5f, 0, 0});
  mesh.triangles.push_back({0, 0, 1});
  mesh.triangles.push_back({0, 9, 1});  // three corners on a line
  mesh.triangles.push_back({2, 3, 0});  // the first one, turned
  const TriangleMesh result = clean_mesh(mesh);
  EXPECT_EQ(result.vertices.size(), 8u);
  EXPECT_EQ(result.triangles, clean.triangles);
}

TEST(Mesh, VolumeOfABallComesNearTheSphere) {
  const TriangleMesh ball = ball_mesh(2, 5);
  const double sphere = 4.0 / 3 * 3.14159265 * 8;
  EXPECT_NEAR(signed_volume(ball) / sphere, 1, 5e-3);
  TriangleMesh turned = ball;
  for (auto& t : turned.triangles) std::swap(t[1], t[2]);
  EXPECT_NEAR(signed_volume(turned), -signed_volume(ball), 1e-4);
}

}  // namespace
}  // namespace meniscus::collision
