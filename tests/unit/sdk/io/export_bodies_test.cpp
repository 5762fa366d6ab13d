// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tests of the export of bodies.
#include <assimp/scene.h>
#include <meniscus/error.h>

#include <assimp/Importer.hpp>

#include "sdk/io/obj.h"
#include "sdk/io/ply.h"
#include "sdk/io/vtp.h"
#include "tests/unit/sdk/io/export_files.h"

namespace meniscus::io {
namespace {

/// A crate that was lifted, and a wedge that was turned by 90° about y.
class ExportBodies : public ExportFolder {
 protected:
  ExportBodies() {
    bodies_.resize(2);
    bodies_[0].name = "crate, red";
    bodies_[0].geometry = BoxGeometry{{0.5f, 1, 1.5f}};
    bodies_[0].pose.position = {9, 9, 9};  // where it started: of no interest
    bodies_[1].name = "wedge";
    bodies_[1].geometry = HullGeometry{{{0, 0, 0}, {2, 0, 0}, {0, 3, 0}, {0, 0, 4}}};
    states_.resize(2);
    states_[0].pose.position = states_[0].centre_of_mass = {0, 10, 0};
    states_[0].velocity = {1, 0, 0};
    states_[0].angular_velocity = {0, 2, 0};
    states_[1].pose = {{20, 0, 0}, {0, std::sqrt(0.5f), 0, std::sqrt(0.5f)}};
  }

  SurfaceFrame frame() const { return BodySurfaces(bodies_).at(0.25, states_); }

  static const aiScene* read(Assimp::Importer& importer, const std::filesystem::path& path) {
    const aiScene* scene = importer.ReadFile(path.string(), 0);
    EXPECT_NE(scene, nullptr) << importer.GetErrorString();
    return scene;
  }

  std::vector<BodyDef> bodies_;
  std::vector<BodyState> states_;
};

TEST_F(ExportBodies, SurfacesFollowTheirPoses) {
  const SurfaceFrame f = frame();
  ASSERT_EQ(f.vertices.size(), 8u + 4u);
  ASSERT_EQ(f.triangles.size(), 12u + 4u);
  EXPECT_EQ(std::count(f.bodies.begin(), f.bodies.end(), 0u), 12);
  EXPECT_EQ(std::count(f.bodies.begin(), f.bodies.end(), 1u), 4);
  for (std::size_t i = 0; i < 8; ++i) EXPECT_FLOAT_EQ(std::abs(f.vertices[i].y - 10), 1);
  float far_x = 0, near_z = 0;
  for (std::size_t i = 8; i < 12; ++i) {
    far_x = std::max(far_x, f.vertices[i].x);
    near_z = std::min(near_z, f.vertices[i].z);
  }
  EXPECT_NEAR(far_x, 24, 1e-5f) << "z of the wedge's frame points along x";
  EXPECT_NEAR(near_z, -2, 1e-5f) << "and x along −z";
}

TEST_F(ExportBodies, VerticesMoveWithTheirBody) {
  const SurfaceFrame f = frame();
  ASSERT_EQ(f.velocities.size(), 12u);
  for (std::size_t i = 0; i < 8; ++i) {
    const Vec3 p = f.vertices[i], v = f.velocities[i];
    EXPECT_FLOAT_EQ(v.x, 1 + 2 * p.z);
    EXPECT_FLOAT_EQ(v.y, 0);
    EXPECT_FLOAT_EQ(v.z, -2 * p.x);
  }
  EXPECT_EQ(f.velocities[8].x, 0);
  write_ply(folder_ / "a.ply", f);
  write_vtp(folder_ / "a.vtp", f);
  const std::string ply = contents(folder_ / "a.ply"), vtp = contents(folder_ / "a.vtp");
  const std::size_t data = ply.find("end_header\n") + std::strlen("end_header\n");
  EXPECT_EQ(value_at<float>(ply, data + 3 * 24 + 12), f.velocities[3].x);
  EXPECT_EQ(value_at<float>(appended(vtp, "velocity", 12 * 12), 12 * 3), f.velocities[3].x);
}

TEST_F(ExportBodies, ShapesStandWhereTheyAre) {
  std::vector<ShapeDef> shapes(2);
  shapes[1].name = "tank";
  shapes[1].geometry = ContainerGeometry{{1, 2, 3}};
  shapes[1].pose.position = {10, 0, 0};
  const SurfaceFrame f = shape_surfaces(shapes);
  EXPECT_STREQ(f.kind, "shape");
  ASSERT_EQ(f.triangles.size(), 12u) << "the walls of the tank alone";
  for (const uint32_t shape : f.bodies) EXPECT_EQ(shape, 1u);
  for (const Vec3 p : f.vertices) EXPECT_FLOAT_EQ(std::abs(p.x - 10), 1);
  write_ply(folder_ / "a.ply", f);
  EXPECT_NE(contents(folder_ / "a.ply").find("property uint shape\n"), std::string::npos);
}

TEST_F(ExportBodies, PlyHasABodyNumberAFace) {
  write_ply(folder_ / "a.ply", frame());
  const std::string file = contents(folder_ / "a.ply");
  const std::size_t data = file.find("end_header\n") + std::strlen("end_header\n");
  EXPECT_NE(file.find("element vertex 12\n"), std::string::npos);
  EXPECT_NE(file.find("element face 16\n"), std::string::npos);
  const std::size_t faces = data + 12 * 24;
  ASSERT_EQ(file.size(), faces + 16 * 17);
  EXPECT_EQ(value_at<uint8_t>(file, faces), 3u);
  EXPECT_EQ(value_at<uint32_t>(file, faces + 11 * 17 + 13), 0u) << "the crate's last face";
  EXPECT_EQ(value_at<uint32_t>(file, faces + 12 * 17 + 13), 1u) << "the wedge's first";
}

TEST_F(ExportBodies, AnotherProgramReadsThePly) {
  write_ply(folder_ / "a.ply", frame());
  Assimp::Importer importer;
  const aiScene* scene = read(importer, folder_ / "a.ply");
  ASSERT_EQ(scene->mNumMeshes, 1u);
  EXPECT_EQ(scene->mMeshes[0]->mNumVertices, 12u);
  ASSERT_EQ(scene->mMeshes[0]->mNumFaces, 16u);
  const SurfaceFrame f = frame();
  for (int k = 0; k < 3; ++k) EXPECT_EQ(scene->mMeshes[0]->mFaces[15].mIndices[k], f.triangles[15][k]);
}

TEST_F(ExportBodies, AnotherProgramReadsTheObjBodyByBody) {
  write_obj(folder_ / "a.obj", frame());
  Assimp::Importer importer;
  const aiScene* scene = read(importer, folder_ / "a.obj");
  ASSERT_EQ(scene->mNumMeshes, 2u);
  EXPECT_STREQ(scene->mMeshes[0]->mName.C_Str(), "crate,_red") << "names end at a blank";
  EXPECT_STREQ(scene->mMeshes[1]->mName.C_Str(), "wedge");
  EXPECT_EQ(scene->mMeshes[0]->mNumFaces, 12u);
  EXPECT_EQ(scene->mMeshes[1]->mNumFaces, 4u);
  const SurfaceFrame f = frame();
  const Vec3 wanted = f.vertices[f.triangles[13][2]];
  const aiVector3D found = scene->mMeshes[1]->mVertices[scene->mMeshes[1]->mFaces[1].mIndices[2]];
  EXPECT_EQ(found, aiVector3D(wanted.x, wanted.y, wanted.z)) << "every digit is there";
}

TEST_F(ExportBodies, VtpOffsetsPointToTheArrays) {
  write_vtp(folder_ / "a.vtp", frame());
  const std::string file = contents(folder_ / "a.vtp");
  EXPECT_NE(file.find("NumberOfPoints=\"12\" NumberOfPolys=\"16\""), std::string::npos);
  const SurfaceFrame f = frame();
  EXPECT_EQ(value_at<float>(appended(file, "Points", 12 * 12), 12 * 11 + 8), f.vertices[11].z);
  EXPECT_EQ(value_at<uint32_t>(appended(file, "body", 4 * 16), 4 * 11), 0u);
  EXPECT_EQ(value_at<uint32_t>(appended(file, "body", 4 * 16), 4 * 12), 1u);
  EXPECT_EQ(value_at<int64_t>(appended(file, "connectivity", 8 * 48), 8 * 47), f.triangles[15][2]);
  EXPECT_EQ(value_at<int64_t>(appended(file, "offsets", 8 * 16), 8 * 15), 48);
  EXPECT_NE(file.find("Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">0.25<"), std::string::npos);
  EXPECT_EQ(file.substr(file.size() - 11), "</VTKFile>\n");
}

TEST_F(ExportBodies, EachBodyNeedsAState) {
  states_.pop_back();
  try {
    frame();
    FAIL() << "a body without a state was placed";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::invalid_argument);
    EXPECT_NE(std::string(error.what()).find("states has 1"), std::string::npos);
  }
}

}  // namespace
}  // namespace meniscus::io
