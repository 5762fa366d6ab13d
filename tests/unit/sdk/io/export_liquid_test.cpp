// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tests of the export of liquid surfaces.
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>

#include "sdk/io/obj.h"
#include "sdk/io/ply.h"
#include "sdk/io/vtp.h"
#include "tests/unit/fluid/surfaces.h"
#include "tests/unit/sdk/io/export_files.h"
#include "tests/worlds.h"

namespace meniscus::io {
namespace {

/// A little water, and some oil elsewhere.
class ExportLiquid : public ExportFolder {
 protected:
  ExportLiquid() {
    World world(tests::world_def(pbd::DeviceKind::cpu, 0.1f));
    FluidDef oil;
    oil.name = "olive oil";
    const std::vector<FluidDef> defs = {{}, oil};
    const std::vector<FluidId> ids = {world.create_fluid(defs[0]), world.create_fluid(defs[1])};
    world.add_particles(ids[0], tests::lattice(4, 3, 3, 0.1f, {0, 0, 0}));
    world.add_particles(ids[1], tests::lattice(2, 2, 2, 0.1f, {3, 0, 0}));
    liquid_ = liquid_frame_of(world, ids, defs);
  }

  static const aiScene* read(Assimp::Importer& importer, const std::filesystem::path& path,
                             unsigned steps = 0) {
    const aiScene* scene = importer.ReadFile(path.string(), steps);
    EXPECT_NE(scene, nullptr) << importer.GetErrorString();
    return scene;
  }

  size_t triangles_of(uint32_t fluid) const {
    return static_cast<size_t>(std::count(liquid_.fluids.begin(), liquid_.fluids.end(), fluid));
  }

  LiquidFrame liquid_;
};

TEST_F(ExportLiquid, EachFluidHasItsOwnSurface) {
  EXPECT_EQ(liquid_.names, (std::vector<std::string>{"water", "olive oil"}));
  EXPECT_GT(triangles_of(0), triangles_of(1));
  EXPECT_EQ(tests::open_edges(liquid_.triangles), 0u);
  for (size_t t = 0; t < liquid_.triangles.size(); ++t) {
    for (const uint32_t v : liquid_.triangles[t])
      EXPECT_EQ(liquid_.vertices[v].x > 1, liquid_.fluids[t] == 1);
  }
}

TEST_F(ExportLiquid, AnotherProgramReadsTheObjFluidByFluid) {
  write_obj(folder_ / "a.obj", liquid_);
  Assimp::Importer importer;
  const aiScene* scene = read(importer, folder_ / "a.obj");
  ASSERT_EQ(scene->mNumMeshes, 2u);
  EXPECT_STREQ(scene->mMeshes[1]->mName.C_Str(), "olive_oil");
  for (unsigned i = 0; i < 2; ++i) {
    EXPECT_EQ(scene->mMeshes[i]->mNumFaces, triangles_of(i));
    EXPECT_TRUE(scene->mMeshes[i]->HasNormals());
  }
}

TEST_F(ExportLiquid, WhatAnotherProgramReadsFromThePlyIsClosed) {
  write_ply(folder_ / "a.ply", liquid_);
  Assimp::Importer importer;
  const aiScene* scene = read(importer, folder_ / "a.ply", aiProcess_JoinIdenticalVertices);
  ASSERT_EQ(scene->mNumMeshes, 1u);
  const aiMesh& mesh = *scene->mMeshes[0];
  ASSERT_EQ(mesh.mNumFaces, liquid_.triangles.size());
  std::vector<std::array<uint32_t, 3>> triangles;
  for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
    const unsigned* c = mesh.mFaces[f].mIndices;
    triangles.push_back({c[0], c[1], c[2]});
  }
  EXPECT_EQ(tests::open_edges(triangles), 0u);
  ASSERT_TRUE(mesh.HasNormals());
}

TEST_F(ExportLiquid, TheVtpHasAnArrayForEachThing) {
  write_vtp(folder_ / "a.vtp", liquid_);
  const std::string file = contents(folder_ / "a.vtp");
  EXPECT_EQ(attribute(file, "<Piece", "NumberOfPolys=\""), std::to_string(liquid_.triangles.size()));
  const std::string points = appended(file, "Points", liquid_.vertices.size() * sizeof(Vec3));
  EXPECT_EQ(value_at<float>(points, 0), liquid_.vertices[0].x);
  appended(file, "Normals", liquid_.normals.size() * sizeof(Vec3));
  const std::string fluids = appended(file, "fluid", liquid_.fluids.size() * sizeof(uint32_t));
  EXPECT_EQ(value_at<uint32_t>(fluids, fluids.size() - 4), 1u);
}

}  // namespace
}  // namespace meniscus::io
