// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tests of the export to USD. Programs of others read such files in tests/exports/.
#include "sdk/io/usd/usd_scene.h"

#include <algorithm>
#include <cmath>

#include "sdk/io/usd/usd_recording.h"
#include "tests/unit/sdk/io/export_files.h"
#include "tests/unit/sdk/io/usd_reader.h"

namespace meniscus::io {
namespace {

TEST(UsdText, ReadsBackWithAllDigits) {
  const std::vector<Vec3> points = {{0.1f, -1e-7f, 3e8f}, {1.0f / 3, 0, -0.0f}};
  const std::vector<double> numbers = usd_numbers(usd_array(std::span<const Vec3>(points)));
  ASSERT_EQ(numbers.size(), 6u);
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_EQ(static_cast<float>(numbers[i]), (&points[i / 3].x)[i % 3]) << i;
  const std::vector<uint64_t> ids = {0, ~0ull >> 1};
  EXPECT_EQ(usd_array(std::span<const uint64_t>(ids)), "[0, 9223372036854775807]");
  EXPECT_EQ(usd_value(Quat{1, 2, 3, 4}), "(4, 1, 2, 3)") << "the scalar part is first";
  EXPECT_EQ(usd_value(Vec3{NAN, INFINITY, 1}), "(0, 0, 1)") << "readers refuse others";
  EXPECT_EQ(usd_extent({}), "[]");
}

TEST(UsdText, NamesAreAllowedAndDiffer) {
  UsdNames names;
  EXPECT_EQ(names.add("crate, red", "body"), "crate__red");
  EXPECT_EQ(names.add("crate; red", "body"), "crate__red_2");
  EXPECT_EQ(names.add("3", "body"), "_3");
  EXPECT_EQ(names.add("", "body"), "body");
  EXPECT_EQ(names.add("", "body"), "body_2");
  EXPECT_EQ(usd_text("a\"b\\c\n"), "\"a\\\"b\\\\c\\\\x0a\"");
}

/// Points that grow in number, and a place that moves.
class UsdRecordingTest : public ExportFolder {
 protected:
  void SetUp() override {
    ExportFolder::SetUp();
    std::filesystem::create_directories(folder_ / "frames");
    stage_.root = {"Xform", "scene", {}, {}, {}, {}};
    UsdPrim points{"Points", "water", {}, {"float[] widths = [0.5] (interpolation = \"constant\")"}, {}, {}};
    stage_.vary(points, {"point3f[] points"});
    UsdPrim body{"Xform", "crate", {}, {}, {}, {}};
    stage_.vary(body, {"float3 xformOp:translate", {}, true});
    stage_.root.children = {points, body};
  }

  static std::vector<std::string> values(int frame) {
    const std::vector<Vec3> points(static_cast<std::size_t>(frame), {1, 2, static_cast<float>(frame)});
    return {usd_array(std::span<const Vec3>(points)), usd_value(Vec3{static_cast<float>(frame), 0, 0})};
  }

  std::string clip(int frame) const { return "frames/usd.0000" + std::to_string(frame) + ".usda"; }
  bool exists(const std::string& name) const { return std::filesystem::exists(folder_ / name); }

  UsdStage stage_;
};

TEST_F(UsdRecordingTest, AShortRunIsOneFile) {
  UsdRecording recording(folder_, stage_);
  for (int frame = 0; frame < 4; ++frame) recording.add(frame, values(frame));
  recording.finish();
  const UsdFile file(folder_ / "scene.usda");
  EXPECT_TRUE(file.closed());
  for (const char* said : {"metersPerUnit = 1\n", "upAxis = \"Y\"\n", "startTimeCode = 0\n",
                           "endTimeCode = 3\n", "timeCodesPerSecond = 24\n", "defaultPrim = \"scene\"\n"})
    EXPECT_NE(file.metadata().find(said), std::string::npos) << said;
  EXPECT_EQ(file.numbers("/scene/water.widths"), std::vector<double>{0.5});
  const auto points = file.samples("/scene/water.points"),
             place = file.samples("/scene/crate.xformOp:translate");
  ASSERT_EQ(points.size(), 4u);
  for (int frame = 0; frame < 4; ++frame) {
    EXPECT_EQ(points.at(frame).size(), static_cast<std::size_t>(3 * frame));
    EXPECT_EQ(place.at(frame).at(0), frame);
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder_ / "frames"));
}

TEST_F(UsdRecordingTest, WhileItRecordsTheStageHasTheFramesSoFar) {
  UsdRecording recording(folder_, stage_);
  for (int frame = 0; frame < 4; ++frame) {
    recording.add(frame, values(frame));
    if (frame == 0) continue;  // its transform to the next is not known yet
    const UsdFile master(folder_ / "scene.usda");
    EXPECT_TRUE(master.closed());
    const std::string end = "templateEndTime = " + std::to_string(frame - 1) + '\n';
    EXPECT_NE(master.metadata().find(end), std::string::npos) << master.metadata();
    for (int k = 0; k < frame; ++k) {
      const UsdFile layer(folder_ / clip(k));
      EXPECT_TRUE(layer.closed());
      const auto points = layer.samples("/scene/water.points");
      ASSERT_EQ(points.size(), 1u);
      EXPECT_EQ(points.at(k).size(), static_cast<std::size_t>(3 * k));
      const auto place = layer.samples("/scene/crate.xformOp:translate");
      ASSERT_EQ(place.size(), 2u) << "so that it moves between the frames";
      EXPECT_EQ(place.at(k + 1).at(0), k + 1);
    }
  }
  EXPECT_TRUE(UsdFile(folder_ / "frames/usd_static.usda").has("/scene/water.points"));
  EXPECT_TRUE(UsdFile(folder_ / "frames/usd_manifest.usda").has("/scene/water.points"));
  EXPECT_FALSE(UsdFile(folder_ / "frames/usd_manifest.usda").has("/scene/water.widths"));
}

TEST_F(UsdRecordingTest, ALongRunKeepsItsClips) {
  UsdRecording recording(folder_, stage_, 40);
  for (int frame = 7; frame < 10; ++frame) recording.add(frame, values(frame));
  recording.finish();
  const std::string master = contents(folder_ / "scene.usda");
  for (const char* said : {"startTimeCode = 7\n", "endTimeCode = 9\n", "templateStartTime = 7\n",
                           "templateEndTime = 9\n", "subLayers = [@./frames/usd_static.usda@]\n"})
    EXPECT_NE(master.find(said), std::string::npos) << said;
  EXPECT_EQ(UsdFile(folder_ / clip(9)).samples("/scene/water.points").at(9).size(), 27u);
}

/// A scene of one of each.
Scene scene_of_all() {
  Scene scene;
  scene.name = "all";
  scene.frame_time = 0.0416667f;
  scene.world.device = DeviceChoice::cpu;
  scene.world.particle_spacing = 0.1f;
  scene.fluids.resize(2);
  scene.fluids[0].name = "water";
  scene.fluids[1].name = "olive oil";
  scene.shapes.resize(2);
  scene.shapes[0].name = "ground";
  scene.shapes[1].name = "tank";
  scene.shapes[1].geometry = ContainerGeometry{{1, 1, 1}, {}};
  scene.shapes[1].pose.position = {0, 1, 0};
  scene.bodies.resize(1);
  scene.bodies[0].def.name = "crate";
  scene.cloths.resize(2);
  scene.cloths[0].name = "sheet";
  scene.cloths[0].geometry = SheetGeometry{1, 1, 3, 3};
  scene.cloths[1].name = "rag";
  scene.cloths[1].geometry = ClothTriangles{{{3, 0, 0}, {4, 0, 0}, {3, 0, 1}}, {0, 2, 1}};
  scene.cloths[1].fabric.tear_strain = 0.5f;
  scene.ropes.resize(1);
  scene.ropes[0].name = "line";
  scene.ropes[0].points = {{5, 0, 0}, {6, 0, 0}, {6, 1, 0}};
  scene.ropes[0].closed = true;
  return scene;
}

class UsdSceneTest : public ExportFolder {
 protected:
  void SetUp() override {
    ExportFolder::SetUp();
    std::filesystem::create_directories(folder_ / "frames");
    const BuiltScene built = build_scene(scene_);
    frame_.cloth = cloth_frame_of(built.world, built.cloths, scene_.cloths);
    add_texture(frame_.cloth, built.world, built.cloths);
    frame_.ropes = rope_frame_of(built.world, built.ropes, scene_.ropes);
    frame_.positions = {{0, 1, 0}, {0, 2, 0}, {0.5f, 1, 0}};
    frame_.velocities = {{1, 0, 0}, {2, 0, 0}, {3, 0, 0}};
    frame_.ids = {4, 5, 9};
    frame_.fluids = {0, 1, 0};
    frame_.bodies.resize(1);
    frame_.bodies[0].pose = {{1, 2, 3}, {0, 1, 0, 0}};
    frame_.bodies[0].velocity = {0, -1, 0};
    frame_.bodies[0].angular_velocity = {0, 0, 1};
    frame_.liquid.names = {"water", "olive oil"};
    frame_.liquid.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {7, 0, 0}, {8, 0, 0}, {7, 1, 0}};
    frame_.liquid.normals.assign(6, {0, 0, 1});
    frame_.liquid.velocities.assign(6, {1, 2, 3});
    frame_.liquid.triangles = {{0, 1, 2}, {3, 4, 5}};
    frame_.liquid.fluids = {0, 1};
  }

  UsdFile written() {
    std::vector<BodyDef> bodies = bodies_of(scene_);
    const BodySurfaces surfaces(bodies);
    const UsdScene usd(scene_, {.particles = true, .surface = true}, &surfaces, frame_);
    UsdRecording recording(folder_, usd.stage());
    recording.add(0, usd.values(frame_));
    recording.finish();
    return UsdFile(folder_ / "scene.usda");
  }

  static std::vector<double> at_0(const UsdFile& file, const std::string& attribute) {
    const auto samples = file.samples(attribute);
    return samples.contains(0) ? samples.at(0) : std::vector<double>{-1e9};
  }

  Scene scene_ = scene_of_all();
  SceneFrame frame_;
};

using Numbers = std::vector<double>;

TEST_F(UsdSceneTest, ParticlesAreASetOfPointsAFluid) {
  const UsdFile file = written();
  EXPECT_TRUE(file.closed());
  EXPECT_EQ(at_0(file, "/scene/particles/water.points"), (Numbers{0, 1, 0, 0.5, 1, 0}));
  EXPECT_EQ(at_0(file, "/scene/particles/water.velocities"), (Numbers{1, 0, 0, 3, 0, 0}));
  EXPECT_EQ(at_0(file, "/scene/particles/water.ids"), (Numbers{4, 9}));
  EXPECT_EQ(at_0(file, "/scene/particles/olive_oil.ids"), (Numbers{5}));
  EXPECT_FLOAT_EQ(static_cast<float>(file.numbers("/scene/particles/water.widths").at(0)), 0.1f);
  EXPECT_NE(file.metadata().find("timeCodesPerSecond = 24\n"), std::string::npos) << "not 23.99998";
}

TEST_F(UsdSceneTest, MeshesHaveVelocitiesNormalsAndTheirOwnNumbers) {
  const UsdFile file = written();
  EXPECT_EQ(at_0(file, "/scene/surface/olive_oil.points"), (Numbers{7, 0, 0, 8, 0, 0, 7, 1, 0}));
  EXPECT_EQ(at_0(file, "/scene/surface/olive_oil.velocities"), (Numbers{1, 2, 3, 1, 2, 3, 1, 2, 3}));
  EXPECT_EQ(at_0(file, "/scene/surface/olive_oil.faceVertexIndices"), (Numbers{0, 1, 2}));
  EXPECT_EQ(at_0(file, "/scene/surface/olive_oil.faceVertexCounts"), (Numbers{3}));
  EXPECT_EQ(at_0(file, "/scene/cloth/sheet.normals").size(), 27u);
}

TEST_F(UsdSceneTest, ClothHasATextureAndTopologyThatVariesOnlyWhereItTears) {
  const UsdFile file = written();
  EXPECT_EQ(file.numbers("/scene/cloth/sheet.faceVertexIndices").size(), 24u);
  EXPECT_EQ(at_0(file, "/scene/cloth/rag.faceVertexIndices").size(), 3u);
  const Numbers corners = file.numbers("/scene/cloth/sheet.faceVertexIndices"),
                texture = file.numbers("/scene/cloth/sheet.primvars:st");
  ASSERT_EQ(texture.size(), 48u);
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const auto vertex = static_cast<std::size_t>(corners[k]);
    EXPECT_EQ(texture[2 * k], 0.5 * static_cast<double>(vertex % 3));
    EXPECT_EQ(texture[2 * k + 1], 0.5 * static_cast<double>(vertex / 3));
  }
}

TEST_F(UsdSceneTest, BodiesMoveAndShapesStand) {
  const UsdFile file = written();
  EXPECT_EQ(at_0(file, "/scene/bodies/crate.xformOp:translate"), (Numbers{1, 2, 3}));
  EXPECT_EQ(at_0(file, "/scene/bodies/crate.xformOp:orient"), (Numbers{0, 0, 1, 0}));
  EXPECT_EQ(at_0(file, "/scene/bodies/crate.physics:velocity"), (Numbers{0, -1, 0}));
  EXPECT_NEAR(at_0(file, "/scene/bodies/crate.physics:angularVelocity").at(2), 57.29578, 1e-4);
  EXPECT_EQ(file.numbers("/scene/bodies/crate/mesh.faceVertexIndices").size(), 36u);
  EXPECT_EQ(file.numbers("/scene/shapes/tank.xformOp:translate"), (Numbers{0, 1, 0}));
  EXPECT_EQ(file.numbers("/scene/shapes/tank.points").size() % 3, 0u);
  EXPECT_FALSE(file.has("/scene/shapes/ground.points")) << "a plane has no end";
}

TEST_F(UsdSceneTest, MaterialsHaveColourAndRoughness) {
  scene_.cloths[0].color = {0.25f, 0.5f, 0.75f};
  const UsdFile file = written();
  EXPECT_EQ(file.text("/scene/cloth/sheet.material:binding"), "</scene/materials/sheet>");
  EXPECT_EQ(file.numbers("/scene/materials/sheet/surface.inputs:diffuseColor"), (Numbers{0.25, 0.5, 0.75}));
  EXPECT_FLOAT_EQ(static_cast<float>(file.numbers("/scene/materials/sheet/surface.inputs:roughness").at(0)),
                  usd_roughness::cloth);
}

TEST_F(UsdSceneTest, TheUpAxisIsAgainstGravity) {
  EXPECT_NE(written().metadata().find("upAxis = \"Y\""), std::string::npos);
  scene_.world.gravity = {0, 0, -9.81f};
  EXPECT_NE(written().metadata().find("upAxis = \"Z\""), std::string::npos);
}

TEST_F(UsdSceneTest, RopesAreCurvesThatCloseWhereTheyClose) {
  const UsdFile file = written();
  EXPECT_EQ(file.numbers("/scene/ropes/line.curveVertexCounts"), (Numbers{4}));
  EXPECT_EQ(at_0(file, "/scene/ropes/line.points"), (Numbers{5, 0, 0, 6, 0, 0, 6, 1, 0, 5, 0, 0}));
}

}  // namespace
}  // namespace meniscus::io
