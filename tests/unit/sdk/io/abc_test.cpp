// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tests of the export to Alembic: the files are read back by Alembic.
#include "sdk/io/abc/abc_recording.h"

#include <Alembic/AbcCoreOgawa/All.h>
#include <Alembic/AbcGeom/All.h>
#include <meniscus/error.h>
#include <sys/resource.h>

#include <csignal>

#include "pbd/math/vec.h"
#include "tests/unit/sdk/io/export_files.h"

namespace meniscus::io {
namespace {

namespace abc = Alembic::Abc;
namespace geom = Alembic::AbcGeom;

/// Two fluids of one name, a sheet of two triangles, a crate that falls and turns, and a rope; z is up.
class AbcTest : public ExportFolder {
 protected:
  void SetUp() override {
    ExportFolder::SetUp();
    scene_.name = "all of it";
    scene_.frame_time = 0.02f;
    scene_.world.gravity = {0, 0, -9.81f};
    scene_.fluids.resize(2);
    scene_.cloths.resize(1);
    scene_.cloths[0].name = "a sheet/flag";
    scene_.ropes.resize(1);
    SceneBody crate;
    crate.def.name = "crate";
    crate.def.geometry = BoxGeometry{{0.1f, 0.2f, 0.3f}};
    scene_.bodies.push_back(crate);
    ShapeDef floor, block;
    block.geometry = BoxGeometry{{1, 1, 1}};
    block.pose.position = {4, 5, 6};
    scene_.shapes = {floor, block};
  }

  static SceneFrame frame(int number) {
    const auto t = static_cast<float>(number);
    SceneFrame f;
    f.number = number;
    f.time = 0.02 * number;
    f.positions = {{t, 0, 1}, {0, t, 2}, {3, 3, t}};
    f.velocities = {{1, 0, 0}, {0, 1, 0}, {0, 0, t}};
    f.ids = {7, 9, uint64_t{1} << 40};
    f.fluids = {0, 1, 0};
    if (number > 3) f.diffuse = {{{1, 2, t}, {0, 0, 1}, 0.5f, DiffuseKind::foam}};
    f.bodies.resize(1);
    f.bodies[0].pose = {{0, 0, -t}, {0, 0, std::sqrt(0.5f), std::sqrt(0.5f)}};
    f.cloth.names = {"a sheet/flag"};
    f.cloth.vertices = {{0, 0, t}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    f.cloth.velocities = {{0, 0, 50}, {}, {}, {}};
    f.cloth.normals.assign(4, {0, 0, 1});
    f.cloth.triangles = {{0, 1, 2}, {0, 2, 3}};
    f.cloth.pieces = {0, 0};
    f.cloth.vertex_pieces.assign(4, 0);
    f.cloth.texture = {{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 0.5f}};
    f.ropes.vertices = {{0, 0, 0}, {0, t, 1}};
    f.ropes.velocities = {{0, 0, 0}, {0, 50, 0}};
    f.ropes.lines = {{0, 1, 0}};
    f.ropes.radii = {0.25f};
    f.ropes.names = {"rope"};
    f.liquid.names = {"water", "water"};
    if (number == 3) return f;  // a fluid without a surface at first
    f.liquid.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, t}};
    f.liquid.velocities.assign(3, {0, 0, t});
    f.liquid.normals.assign(3, {0, 0, 1});
    f.liquid.triangles = {{0, 1, 2}};
    f.liquid.fluids = {1};
    return f;
  }

  void write(int first, int last) {
    const BodySurfaces bodies(bodies_of(scene_));
    AbcRecording recording(path(), scene_, {.surface = true, .diffuse = true}, &bodies, frame(first));
    for (int number = first; number <= last; ++number) recording.add(frame(number));
    EXPECT_FALSE(std::filesystem::exists(path())) << "before its end";
    recording.finish();
  }
  std::filesystem::path path() const { return folder_ / "scene.abc"; }

  /// The object at a path below /scene.
  abc::IObject at(const std::vector<std::string>& names) const {
    abc::IArchive archive(Alembic::AbcCoreOgawa::ReadArchive(), path().string());
    abc::IObject object = archive.getTop().getChild("scene");
    for (const std::string& name : names) {
      object = object.getChild(name);
      EXPECT_TRUE(object.valid()) << name;
    }
    return object;
  }
  template <class Sample>
  static auto values(const Sample& sample) {
    return std::vector(sample->get(), sample->get() + sample->size());
  }
  template <class Schema>
  static auto value(const Schema& schema, int64_t index) {
    return schema.getValue(abc::ISampleSelector(index));
  }

  Scene scene_;
};

TEST_F(AbcTest, PointsHaveTheirIdsAndVelocities) {
  write(3, 5);
  geom::IPointsSchema points = geom::IPoints(at({"particles", "water"})).getSchema();
  ASSERT_EQ(points.getNumSamples(), 3u);
  const auto last = value(points, 2);
  EXPECT_EQ(values(last.getPositions()), (std::vector<abc::V3f>{{5, 0, 1}, {3, 3, 5}}));
  EXPECT_EQ(values(last.getVelocities()), (std::vector<abc::V3f>{{1, 0, 0}, {0, 0, 5}}));
  EXPECT_EQ(values(last.getIds()), (std::vector<uint64_t>{7, uint64_t{1} << 40}));
  EXPECT_FLOAT_EQ(points.getWidthsParam().getExpandedValue().getVals()->get()[0],
                  scene_.world.particle_spacing);
  EXPECT_EQ(value(geom::IPoints(at({"particles", "water_2"})).getSchema(), 0).getPositions()->size(), 1u);
  geom::IPointsSchema foam = geom::IPoints(at({"diffuse"})).getSchema();
  EXPECT_EQ(value(foam, 0).getPositions()->size(), 0u);
  EXPECT_EQ(values(value(foam, 1).getPositions()), (std::vector<abc::V3f>{{1, 2, 4}}));
  const geom::IInt32GeomParam kind(foam.getArbGeomParams(), "kind");
  EXPECT_EQ(kind.getExpandedValue(abc::ISampleSelector(int64_t{2})).getVals()->get()[0],
            static_cast<int>(DiffuseKind::foam));
}

TEST_F(AbcTest, ClothHasATextureAndIsClockwise) {
  write(0, 1);
  geom::IPolyMeshSchema mesh = geom::IPolyMesh(at({"cloth", "a_sheet_flag"})).getSchema();
  const auto sample = value(mesh, 1);
  EXPECT_EQ(values(sample.getPositions())[0], abc::V3f(0, 0, 1));
  EXPECT_EQ(values(sample.getVelocities())[0], abc::V3f(0, 0, 50));
  EXPECT_EQ(values(sample.getFaceCounts()), (std::vector<int32_t>{3, 3}));
  EXPECT_EQ(values(sample.getFaceIndices()), (std::vector<int32_t>{0, 2, 1, 0, 3, 2}));
  EXPECT_EQ(mesh.getTopologyVariance(), geom::kHomogenousTopology) << "it is stored once";
  const auto uvs = mesh.getUVsParam().getExpandedValue(abc::ISampleSelector(int64_t{1}));
  EXPECT_EQ(uvs.getScope(), geom::kFacevaryingScope);
  EXPECT_EQ(values(uvs.getVals()),
            (std::vector<abc::V2f>{{0, 0}, {1, 1}, {1, 0}, {0, 0}, {0, 0.5f}, {1, 1}}));
  EXPECT_EQ(mesh.getNormalsParam().getExpandedValue().getVals()->size(), 4u);
}

TEST_F(AbcTest, SurfacesMayBeEmpty) {
  write(3, 4);
  const geom::IPolyMeshSchema second = geom::IPolyMesh(at({"surface", "water_2"})).getSchema();
  EXPECT_EQ(value(second, 0).getPositions()->size(), 0u);
  EXPECT_EQ(values(value(second, 1).getPositions())[2], abc::V3f(0, 1, 4));
  EXPECT_EQ(values(value(second, 1).getFaceIndices()), (std::vector<int32_t>{0, 2, 1}));
  EXPECT_EQ(values(value(second, 1).getVelocities())[1], abc::V3f(0, 0, 4));
}

TEST_F(AbcTest, BodiesMoveAndTheSceneIsYUp) {
  write(2, 4);
  const geom::IXformSchema scene = geom::IXform(at({})).getSchema();
  const geom::IXformSchema crate = geom::IXform(at({"bodies", "crate"})).getSchema();
  const abc::M44d pose = crate.getValue(abc::ISampleSelector(int64_t{2})).getMatrix();
  abc::V3d corner;
  pose.multVecMatrix(abc::V3d(0.1, 0.2, 0.3), corner);
  EXPECT_LT((corner - abc::V3d(-0.2, 0.1, -3.7)).length(), 1e-6) << "a quarter turn about z";
  abc::V3d up;
  scene.getValue().getMatrix().multDirMatrix(abc::V3d(0, 0, 1), up);
  EXPECT_LT((up - abc::V3d(0, 1, 0)).length(), 1e-6);
  EXPECT_EQ(geom::IPolyMesh(at({"bodies", "crate", "mesh"})).getSchema().getValue().getFaceCounts()->size(),
            12u);
  abc::V3d block;
  geom::IXform(at({"shapes", "shape"})).getSchema().getValue().getMatrix().multVecMatrix({0, 0, 0}, block);
  EXPECT_EQ(block, abc::V3d(4, 5, 6));
  EXPECT_EQ(at({"shapes"}).getNumChildren(), 1u) << "a plane has no end";
}

TEST_F(AbcTest, RopesAreLines) {
  write(0, 2);
  geom::ICurvesSchema rope = geom::ICurves(at({"ropes", "rope"})).getSchema();
  const auto sample = value(rope, 2);
  EXPECT_EQ(sample.getType(), geom::kLinear);
  EXPECT_EQ(values(sample.getPositions()), (std::vector<abc::V3f>{{0, 0, 0}, {0, 2, 1}, {0, 0, 0}}));
  EXPECT_EQ(values(sample.getVelocities())[1], abc::V3f(0, 50, 0));
  EXPECT_EQ(values(sample.getCurvesNumVertices()), (std::vector<int32_t>{3}));
  EXPECT_FLOAT_EQ(rope.getWidthsParam().getExpandedValue().getVals()->get()[0], 0.5f);
}

TEST_F(AbcTest, TimesAreThoseOfTheFramesAndFilesRepeat) {
  write(3, 5);
  const std::string before = contents(path());
  const auto times = geom::IPoints(at({"particles", "water"})).getSchema().getTimeSampling();
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(times->getSampleTime(static_cast<uint64_t>(i)), 0.02 * (3 + i), 1e-12);
  std::filesystem::remove(path());
  write(3, 5);
  EXPECT_EQ(contents(path()), before);
}

TEST_F(AbcTest, SaysWhatCannotBeWritten) {
  std::filesystem::create_directories(path() / "in the way");
  try {
    const BodySurfaces bodies(bodies_of(scene_));
    AbcRecording recording(path(), scene_, {}, &bodies, frame(0));
    recording.add(frame(0));
    recording.finish();
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::io);
    EXPECT_NE(std::string(error.what()).find("scene.abc"), std::string::npos);
  }
}

/// As on a full disk, also while Alembic writes the end.
TEST_F(AbcTest, ADiskThatIsFullIsAnError) {
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  for (const rlim_t most : {100u, 9000u, 60000u}) {
    const rlimit small{most, before.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
    EXPECT_THROW(write(0, 200), Error) << most;
    setrlimit(RLIMIT_FSIZE, &before);
    EXPECT_TRUE(std::filesystem::is_empty(folder_)) << most;
  }
  std::signal(SIGXFSZ, handler);
}

}  // namespace
}  // namespace meniscus::io
