// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tests of the export of cloth and ropes.
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>

#include <meniscus/scene.h>
#include "sdk/io/obj.h"
#include "sdk/io/ply.h"
#include "sdk/io/vtp.h"
#include "tests/unit/sdk/io/export_files.h"

namespace meniscus::io {
namespace {

/// A square of two triangles that faces up, a lone triangle that faces x, and two ropes, one of them closed.
class ExportCloth : public ExportFolder {
 protected:
  ExportCloth() {
    cloth_.time = 0.25;
    cloth_.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {1, 0, 1}, {5, 0, 0}, {5, 1, 0}, {5, 0, 0.3f}};
    cloth_.normals.assign(4, {0, 1, 0});
    cloth_.normals.resize(7, {1, 0, 0});
    for (int i = 0; i < 7; ++i) cloth_.velocities.push_back({static_cast<float>(i), 0, -1});
    cloth_.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}};
    cloth_.strains = {0.01f, 0.02f, 0.03f};
    cloth_.pieces = {0, 0, 1};
    cloth_.vertex_pieces = {0, 0, 0, 0, 1, 1, 1};
    cloth_.names = {"table cloth", "rag"};
    ropes_.time = 0.25;
    ropes_.vertices = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 5, 0}, {1, 5, 0}, {1, 6, 0.1f}};
    ropes_.velocities.assign(6, {3, 2, 1});
    ropes_.lines = {{0, 1, 2}, {3, 4, 5, 3}};
    ropes_.radii = {0.1f, 0.2f};
    ropes_.names = {"rope", "hoop"};
  }

  static const aiScene* read(Assimp::Importer& importer, const std::filesystem::path& path) {
    const aiScene* scene = importer.ReadFile(path.string(), 0);
    EXPECT_NE(scene, nullptr) << importer.GetErrorString();
    return scene;
  }

  ClothFrame cloth_;
  RopeFrame ropes_;
};

TEST_F(ExportCloth, PiecesAreCounted) {
  EXPECT_EQ(cloth_.vertex_counts(), (std::vector<std::size_t>{4, 3}));
  EXPECT_EQ(cloth_.triangle_counts(), (std::vector<std::size_t>{2, 1}));
}

TEST_F(ExportCloth, AnotherProgramReadsTheObjPieceByPiece) {
  write_obj(folder_ / "a.obj", cloth_);
  Assimp::Importer importer;
  const aiScene* scene = read(importer, folder_ / "a.obj");
  ASSERT_EQ(scene->mNumMeshes, 2u);
  EXPECT_STREQ(scene->mMeshes[0]->mName.C_Str(), "table_cloth");
  EXPECT_STREQ(scene->mMeshes[1]->mName.C_Str(), "rag");
  EXPECT_EQ(scene->mMeshes[0]->mNumFaces, 2u);
  ASSERT_TRUE(scene->mMeshes[0]->HasNormals());
  EXPECT_EQ(scene->mMeshes[0]->mNormals[0], aiVector3D(0, 1, 0));
  const aiMesh& rag = *scene->mMeshes[1];
  EXPECT_EQ(rag.mNormals[rag.mFaces[0].mIndices[0]], aiVector3D(1, 0, 0));
  EXPECT_EQ(rag.mVertices[rag.mFaces[0].mIndices[2]], aiVector3D(5, 0, 0.3f)) << "every digit is there";
}

TEST_F(ExportCloth, AnotherProgramReadsTheRopesOfAnObj) {
  write_obj(folder_ / "a.obj", ropes_);
  Assimp::Importer importer;
  const aiScene* scene = read(importer, folder_ / "a.obj");
  ASSERT_EQ(scene->mNumMeshes, 2u);
  EXPECT_STREQ(scene->mMeshes[1]->mName.C_Str(), "hoop");
  EXPECT_EQ(scene->mMeshes[0]->mPrimitiveTypes, unsigned{aiPrimitiveType_LINE});
  EXPECT_EQ(scene->mMeshes[0]->mNumFaces, 2u) << "edges";
  EXPECT_EQ(scene->mMeshes[1]->mNumFaces, 3u) << "back to where it began";
}

TEST_F(ExportCloth, AnotherProgramReadsThePly) {
  write_ply(folder_ / "a.ply", cloth_);
  Assimp::Importer importer;
  const aiScene* scene = read(importer, folder_ / "a.ply");
  ASSERT_EQ(scene->mNumMeshes, 1u);
  const aiMesh& mesh = *scene->mMeshes[0];
  EXPECT_EQ(mesh.mNumVertices, 7u);
  ASSERT_EQ(mesh.mNumFaces, 3u);
  for (int k = 0; k < 3; ++k) EXPECT_EQ(mesh.mFaces[2].mIndices[k], cloth_.triangles[2][k]);
  EXPECT_EQ(mesh.mVertices[6], aiVector3D(5, 0, 0.3f));
  ASSERT_TRUE(mesh.HasNormals());
  EXPECT_EQ(mesh.mNormals[3], aiVector3D(0, 1, 0));
  EXPECT_EQ(mesh.mNormals[4], aiVector3D(1, 0, 0));
}

TEST_F(ExportCloth, PlyHasAPieceAndAStrainAFace) {
  write_ply(folder_ / "a.ply", cloth_);
  const std::string file = contents(folder_ / "a.ply");
  const std::size_t data = file.find("end_header\n") + std::strlen("end_header\n");
  const std::size_t faces = data + 7 * 36;
  ASSERT_EQ(file.size(), faces + 3 * 21);
  EXPECT_EQ(value_at<float>(file, data + 2 * 36 + 24), 2.0f) << "the third vertex's velocity";
  EXPECT_EQ(value_at<uint8_t>(file, faces), 3u);
  EXPECT_EQ(value_at<uint32_t>(file, faces + 2 * 21 + 13), 1u);
  EXPECT_EQ(value_at<float>(file, faces + 2 * 21 + 17), 0.03f);
}

TEST_F(ExportCloth, PlyHasTheEdgesOfRopes) {
  write_ply(folder_ / "a.ply", ropes_);
  const std::string file = contents(folder_ / "a.ply");
  EXPECT_NE(file.find("element edge 5\n"), std::string::npos);
  const std::size_t data = file.find("end_header\n") + std::strlen("end_header\n");
  const std::size_t edges = data + 6 * 28;
  ASSERT_EQ(file.size(), edges + 5 * 12);
  EXPECT_EQ(value_at<float>(file, data + 3 * 28 + 24), 0.2f) << "the hoop's radius";
  EXPECT_EQ(value_at<uint32_t>(file, edges + 4 * 12), 5u);
  EXPECT_EQ(value_at<uint32_t>(file, edges + 4 * 12 + 4), 3u) << "back to where it began";
  EXPECT_EQ(value_at<uint32_t>(file, edges + 4 * 12 + 8), 1u);
}

TEST_F(ExportCloth, VtpHasTheArraysOfCloth) {
  write_vtp(folder_ / "a.vtp", cloth_);
  const std::string file = contents(folder_ / "a.vtp");
  EXPECT_NE(file.find("NumberOfPoints=\"7\" NumberOfPolys=\"3\""), std::string::npos);
  EXPECT_EQ(value_at<float>(appended(file, "Points", 7 * 12), 12 * 6 + 8), 0.3f);
  EXPECT_EQ(value_at<float>(appended(file, "velocity", 7 * 12), 12 * 5), 5.0f);
  EXPECT_EQ(value_at<float>(appended(file, "Normals", 7 * 12), 12 * 4), 1.0f);
  EXPECT_EQ(value_at<uint32_t>(appended(file, "cloth", 3 * 4), 8), 1u);
  EXPECT_EQ(value_at<float>(appended(file, "strain", 3 * 4), 4), 0.02f);
  EXPECT_EQ(value_at<int64_t>(appended(file, "connectivity", 8 * 9), 8 * 8), 6);
  EXPECT_EQ(value_at<int64_t>(appended(file, "offsets", 8 * 3), 8 * 2), 9);
  EXPECT_EQ(file.substr(file.size() - 11), "</VTKFile>\n");
}

TEST_F(ExportCloth, VtpHasAPolylineARope) {
  write_vtp(folder_ / "a.vtp", ropes_);
  const std::string file = contents(folder_ / "a.vtp");
  EXPECT_NE(file.find("NumberOfPoints=\"6\" NumberOfLines=\"2\""), std::string::npos);
  EXPECT_EQ(value_at<float>(appended(file, "radius", 6 * 4), 4 * 3), 0.2f);
  EXPECT_EQ(value_at<uint32_t>(appended(file, "rope", 2 * 4), 4), 1u);
  EXPECT_EQ(value_at<int64_t>(appended(file, "connectivity", 8 * 7), 8 * 6), 3) << "back to where it began";
  EXPECT_EQ(value_at<int64_t>(appended(file, "offsets", 8 * 2), 0), 3);
  EXPECT_EQ(value_at<int64_t>(appended(file, "offsets", 8 * 2), 8), 7);
}

TEST_F(ExportCloth, FramesAreTakenFromTheWorld) {
  Scene scene;
  scene.world.device = DeviceChoice::cpu;
  scene.cloths.resize(2);
  scene.cloths[0].name = "one";
  scene.cloths[0].geometry = SheetGeometry{1, 1, 3, 3};
  scene.cloths[1].name = "two";
  scene.cloths[1].geometry = SheetGeometry{1, 1, 2, 2};
  scene.cloths[1].pose.position = {0, 3, 0};
  scene.ropes.resize(1);
  scene.ropes[0].points = {{5, 0, 0}, {6, 0, 0}, {6, 1, 0}};
  scene.ropes[0].closed = true;
  const BuiltScene built = build_scene(scene);
  const ClothFrame cloth = cloth_frame_of(built.world, built.cloths, scene.cloths);
  ASSERT_EQ(cloth.vertices.size(), 13u);
  EXPECT_EQ(cloth.velocities.size(), 13u);
  ASSERT_EQ(cloth.normals.size(), 13u);
  EXPECT_FLOAT_EQ(cloth.normals[12].y, 1);
  EXPECT_EQ(cloth.triangle_counts(), (std::vector<std::size_t>{8, 2}));
  EXPECT_EQ(cloth.strains.size(), 10u);
  EXPECT_EQ(cloth.names[1], "two");
  for (const uint32_t corner : cloth.triangles.back()) EXPECT_FLOAT_EQ(cloth.vertices[corner].y, 3);
  const RopeFrame ropes = rope_frame_of(built.world, built.ropes, scene.ropes);
  EXPECT_EQ(ropes.lines.at(0), (std::vector<uint32_t>{0, 1, 2, 0}));
  EXPECT_FLOAT_EQ(ropes.vertices.at(2).y, 1);
}

}  // namespace
}  // namespace meniscus::io
