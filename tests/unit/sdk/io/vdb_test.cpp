// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tests of the export to OpenVDB: the files are read back by OpenVDB.
#include "sdk/io/vdb.h"

#include <openvdb/io/Stream.h>
#include <openvdb/openvdb.h>
#include <openvdb/tools/Interpolation.h>
#include <openvdb/tools/LevelSetMeasure.h>

#include "pbd/math/vec.h"
#include "tests/unit/fluid/surfaces.h"
#include "tests/unit/sdk/io/export_files.h"
#include "tests/worlds.h"

namespace meniscus::io {
namespace {

constexpr float s = 0.05f;

/// A block of water that turns about an axis, and some oil that moves evenly.
class VdbTest : public ExportFolder {
 protected:
  void SetUp() override {
    ExportFolder::SetUp();
    World world(tests::world_def(pbd::DeviceKind::cpu, s));
    FluidDef oil;
    oil.name = "oil";
    const std::vector<FluidDef> defs = {{}, oil};
    const std::vector<FluidId> ids = {world.create_fluid(defs[0]), world.create_fluid(defs[1])};
    world.add_particles(ids[0], tests::lattice(10, 8, 9, s, {0, 0, 0}));
    world.add_particles(ids[1], tests::lattice(6, 6, 6, s, {3, 0, 0}));
    std::vector<Vec3> velocities;
    for (const Vec3 p : world.positions())
      velocities.push_back(p.x > 2 ? Vec3{1, -2, 3} : cross(Vec3{0, 2, 0}, p));
    world.set_velocities(velocities);
    liquid_ = liquid_frame_of(world, ids, defs);
    write_vdb(folder_ / "a.vdb", liquid_, frame_of(world), s);
    std::ifstream bytes(folder_ / "a.vdb", std::ios::binary);
    grids_ = openvdb::io::Stream(bytes).getGrids();
  }

  template <class Grid>
  typename Grid::Ptr grid(const std::string& name) const {
    for (const auto& grid : *grids_) {
      if (grid->getName() == name) return openvdb::gridPtrCast<Grid>(grid);
    }
    ADD_FAILURE() << "there is no " << name;
    return nullptr;
  }

  LiquidFrame liquid_;
  openvdb::GridPtrVecPtr grids_;
};

TEST_F(VdbTest, EachFluidHasASurfaceAndAVelocity) {
  EXPECT_EQ(grids_->size(), 4u);
  for (const char* name : {"surface_water", "surface_oil"})
    EXPECT_EQ(grid<openvdb::FloatGrid>(name)->getGridClass(), openvdb::GRID_LEVEL_SET);
  EXPECT_FLOAT_EQ(static_cast<float>(grid<openvdb::FloatGrid>("surface_oil")->voxelSize().x()), 0.5f * s);
  EXPECT_FLOAT_EQ(static_cast<float>(grid<openvdb::Vec3SGrid>("velocity_oil")->voxelSize().x()), s);
}

TEST_F(VdbTest, TheLevelSetIsTheDistanceToTheSurface) {
  const auto level = grid<openvdb::FloatGrid>("surface_water");
  ASSERT_TRUE(level);
  std::vector<std::array<uint32_t, 3>> triangles;
  for (std::size_t t = 0; t < liquid_.triangles.size(); ++t) {
    if (liquid_.fluids[t] == 0) triangles.push_back(liquid_.triangles[t]);
  }
  const double enclosed = tests::volume_inside(liquid_.vertices, triangles);
  EXPECT_NEAR(openvdb::tools::levelSetVolume(*level) / enclosed, 1, 0.02);
  const openvdb::tools::GridSampler<openvdb::FloatGrid, openvdb::tools::BoxSampler> sampler(*level);
  for (std::size_t v = 0; v < liquid_.vertices.size(); v += 5) {
    const Vec3 p = liquid_.vertices[v], out = p + 0.5f * s * liquid_.normals[v];
    if (p.x > 2) continue;
    EXPECT_NEAR(sampler.wsSample({p.x, p.y, p.z}), 0, 0.1f * s) << v;
    EXPECT_GT(sampler.wsSample({out.x, out.y, out.z}), 0.2f * s) << "positive outside";
  }
}

TEST_F(VdbTest, TheVelocityIsThatOfTheParticlesWhereverTheSurfaceIsKnown) {
  const auto even = grid<openvdb::Vec3SGrid>("velocity_oil");
  ASSERT_TRUE(even);
  for (auto voxel = even->cbeginValueOn(); voxel; ++voxel)
    ASSERT_LT((voxel.getValue() - openvdb::Vec3s(1, -2, 3)).length(), 1e-5f);
  const auto turning = grid<openvdb::Vec3SGrid>("velocity_water");
  const openvdb::tools::GridSampler<openvdb::Vec3SGrid, openvdb::tools::BoxSampler> sampler(*turning);
  const openvdb::Vec3s middle = sampler.wsSample({5 * s, 4 * s, 5 * s});
  const Vec3 wanted = cross(Vec3{0, 2, 0}, {5 * s, 4 * s, 5 * s});
  EXPECT_LT((middle - openvdb::Vec3s(wanted.x, wanted.y, wanted.z)).length(), 0.1f * s);
  const auto level = grid<openvdb::FloatGrid>("surface_water");
  const auto known = turning->getConstAccessor();
  for (auto voxel = level->cbeginValueOn(); voxel; ++voxel) {
    if (voxel.getValue() > 0.5f * s) continue;
    const openvdb::Vec3d place = level->indexToWorld(voxel.getCoord());
    ASSERT_TRUE(known.isValueOn(openvdb::Coord::round(turning->worldToIndex(place)))) << place;
  }
}

}  // namespace
}  // namespace meniscus::io
