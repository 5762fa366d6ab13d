// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tests of the reader of scene files.
#include "sdk/scene/scene_file.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

namespace meniscus {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// A folder of its own for each test, gone afterwards.
class SceneFile : public testing::Test {
 protected:
  SceneFile() {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(testing::TempDir()) / (std::string("meniscus_scene_file_") + test->name());
    fs::create_directories(folder_);
  }
  ~SceneFile() override { fs::remove_all(folder_); }

  std::string write(const std::string& name, const std::string& text) const {
    const fs::path path = folder_ / name;
    std::ofstream(path) << text;
    return path.string();
  }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  fs::path folder_;
};

/// The message, with its code, that reading a scene ends with.
template <class Read>
std::pair<ErrorCode, std::string> error_of(Read read) {
  try {
    read();
  } catch (const Error& error) {
    return {error.code(), error.what()};
  }
  return {};
}

constexpr const char* two_volumes = R"({
  // a comment
  "name": "two",
  "frame_time": 0.01, /* and another */
  "world": {"gravity": [0, 0, -1.62], "device": "cpu", "kernel": "wendland_c2",
    "density": {"solver": "jacobi"}},
  "fluids": [{"name": "water"}, {"name": "oil", "rest_density": 900, "color": [1, 0.5, 0]}],
  "shapes": [
    {"name": "tank", "friction": 0.5,
     "geometry": {"type": "container", "half_extents": [1, 2, 3], "openings": [
       {"face": "y_high"}, {"face": "x_low", "lower": [-1, 0, 0], "upper": [-1, 0.5, 0.5]}]}},
    {"name": "hill", "geometry": {"type": "height_field", "columns": 2, "rows": 3, "heights": [1, 2, 3, 4, 5, 6]}}
  ],
  "volumes": [
    {"fluid": "oil", "region": {"type": "ball", "radius": 0.25}, "velocity": [1, 2, 3],
     "seeding": "disordered", "pose": {"position": [4, 5, 6], "rotation": {"axis": [0, 0, 3], "degrees": 90}}},
    {"fluid": "water", "region": {"type": "box", "lower": [0, 0, 0], "upper": [1, 1, 2]},
     "pose": {"rotation": [0, 2, 0, 0]}}
  ],
  "sinks": [{"name": "far", "region": {"type": "box", "lower": [-9, -9, -9], "upper": [9, 9, 9]}, "outside": true}],
  "probes": [
    {"type": "point_pressure", "name": "deep", "point": [0, 0.1, 0]},
    {"type": "wall_pressure", "name": "side", "shape": "tank", "patch": {"lower": [0, 0, 0], "upper": [1, 1, 1]}, "area": 2},
    {"type": "wall_force", "name": "all", "shape": "hill"}
  ],
  "camera": {"position": [1, 1, 1]}
})";

TEST_F(SceneFile, ReadsEveryPart) {
  const Scene scene = read_scene(write("two.json", two_volumes));
  EXPECT_EQ(scene.name, "two");
  EXPECT_FLOAT_EQ(scene.frame_time, 0.01f);
  EXPECT_EQ(scene.frames, Scene().frames);
  EXPECT_FLOAT_EQ(scene.world.gravity.z, -1.62f);
  EXPECT_EQ(scene.world.device, DeviceChoice::cpu);
  EXPECT_EQ(scene.world.density.solver, DensitySolver::jacobi);
  EXPECT_EQ(scene.world.kernel, SmoothingKernel::wendland_c2);
  ASSERT_EQ(scene.fluids.size(), 2u);
  EXPECT_EQ(scene.fluids[1].name, "oil");
  EXPECT_FLOAT_EQ(scene.fluids[1].rest_density, 900);
  EXPECT_FLOAT_EQ(scene.fluids[1].color.y, 0.5f);
  ASSERT_EQ(scene.sinks.size(), 1u);
  EXPECT_TRUE(scene.sinks[0].def.outside);
  EXPECT_FLOAT_EQ(std::get<BoxRegion>(scene.sinks[0].def.region).upper.z, 9);
  ASSERT_TRUE(scene.camera.has_value());
  EXPECT_FLOAT_EQ(scene.camera->position.x, 1);
  EXPECT_FLOAT_EQ(scene.camera->field_of_view, SceneCamera().field_of_view);
}

TEST_F(SceneFile, ReadsShapes) {
  const Scene scene = read_scene(write("two.json", two_volumes));
  ASSERT_EQ(scene.shapes.size(), 2u);
  EXPECT_FLOAT_EQ(scene.shapes[0].surface.friction, 0.5f);
  const auto& tank = std::get<ContainerGeometry>(scene.shapes[0].geometry);
  EXPECT_FLOAT_EQ(tank.half_extents.z, 3);
  ASSERT_EQ(tank.openings.size(), 2u);
  EXPECT_FALSE(tank.openings[0].region.has_value());
  EXPECT_EQ(tank.openings[1].face, Face::x_low);
  ASSERT_TRUE(tank.openings[1].region.has_value());
  EXPECT_FLOAT_EQ(tank.openings[1].region->upper.y, 0.5f);
  const auto& hill = std::get<HeightFieldGeometry>(scene.shapes[1].geometry);
  EXPECT_EQ(hill.rows, 3);
  EXPECT_EQ(hill.heights, (std::vector<float>{1, 2, 3, 4, 5, 6}));
}

TEST_F(SceneFile, ReadsVolumesAndRotations) {
  const Scene scene = read_scene(write("two.json", two_volumes));
  ASSERT_EQ(scene.volumes.size(), 2u);
  EXPECT_EQ(scene.volumes[0].fluid, "oil");
  EXPECT_FLOAT_EQ(std::get<BallRegion>(scene.volumes[0].def.region).radius, 0.25f);
  EXPECT_FLOAT_EQ(scene.volumes[0].def.velocity.y, 2);
  EXPECT_EQ(scene.volumes[0].def.seeding, Seeding::disordered);
  EXPECT_EQ(scene.volumes[1].def.seeding, Seeding::lattice);
  const Pose& turned = scene.volumes[0].def.pose;
  EXPECT_FLOAT_EQ(turned.position.x, 4);
  EXPECT_FLOAT_EQ(turned.rotation.z, std::sqrt(0.5f));
  EXPECT_FLOAT_EQ(turned.rotation.w, std::sqrt(0.5f));
  EXPECT_EQ(turned.rotation.x, 0);
  // A quaternion of any length is made a unit one.
  EXPECT_FLOAT_EQ(scene.volumes[1].def.pose.rotation.y, 1);
  EXPECT_FLOAT_EQ(std::get<BoxRegion>(scene.volumes[1].def.region).upper.z, 2);
}

TEST_F(SceneFile, ReadsProbes) {
  const Scene scene = read_scene(write("two.json", two_volumes));
  ASSERT_EQ(scene.probes.size(), 3u);
  EXPECT_EQ(scene.probes[0].def.kind, ProbeKind::point_pressure);
  EXPECT_FLOAT_EQ(scene.probes[0].def.point.y, 0.1f);
  EXPECT_EQ(scene.probes[1].def.kind, ProbeKind::wall_pressure);
  EXPECT_EQ(scene.probes[1].shape, "tank");
  EXPECT_FLOAT_EQ(scene.probes[1].def.area, 2);
  ASSERT_TRUE(scene.probes[1].def.patch.has_value());
  EXPECT_EQ(scene.probes[2].def.kind, ProbeKind::wall_force);
  EXPECT_FALSE(scene.probes[2].def.patch.has_value());
}

TEST_F(SceneFile, SyntaxErrorGivesLineAndColumn) {
  const std::string file = write("broken.json", "{\n  \"name\": \"x\",\n  \"frames\": 1 2\n}");
  const auto [code, message] = error_of([&] { read_scene(file); });
  EXPECT_EQ(code, ErrorCode::parse);
  EXPECT_TRUE(message.starts_with(file + ": line 3, column 15: syntax error")) << message;
}

TEST_F(SceneFile, NumberBeyondDoubleGivesLineAndColumn) {
  // 1e999 stands in a text and in a comment first: neither is meant.
  const std::string file =
      write("huge.json", "{\n  \"name\": \"1e999\",\n  // 1e999\n  \"frame_time\": 1e999\n}");
  const auto [code, message] = error_of([&] { read_scene(file); });
  EXPECT_EQ(code, ErrorCode::parse);
  EXPECT_EQ(message, file + ": line 4, column 21: number overflow parsing '1e999'");
}

TEST_F(SceneFile, RefusesWhatIsNoDocument) {
  for (const char* text : {"", "[", "{\"name\": \"x\",}", "{\"name\": 1e999}", "{\"name\": \"\xff\"}"}) {
    const std::string file = write("broken.json", text);
    const auto [code, message] = error_of([&] { read_scene(file); });
    EXPECT_EQ(code, ErrorCode::parse) << text;
    EXPECT_TRUE(message.starts_with(file + ": ")) << message;
  }
}

TEST_F(SceneFile, KeyThatStandsTwiceIsAnError) {
  const std::string file =
      write("twice.json", R"({"name": "x", "world": {"substeps": 2, "iterations": 3, "substeps": 4}})");
  const auto [code, message] = error_of([&] { read_scene(file); });
  EXPECT_EQ(code, ErrorCode::parse);
  EXPECT_EQ(message, file + ": the key \"substeps\" stands twice in one object");
}

TEST_F(SceneFile, NulCharactersAndDeepNestingAreRefused) {
  const std::string nul = write("nul.json", R"({"name": "a\u0000b"})");
  EXPECT_EQ(error_of([&] { read_scene(nul); }).second, nul + ": the text \"a\\u0000b\" has a NUL character");
  const std::vector<std::string> change{"name=\"a\\u0000b\""};
  const std::string good = write("good.json", R"({"name": "x"})");
  EXPECT_NE(error_of([&] { read_scene(good, change); }).second.find("has a NUL character"),
            std::string::npos);
  const std::string deep = write("deep.json", "{\"a\": " + std::string(1000000, '['));
  EXPECT_EQ(error_of([&] { read_scene(deep); }).second, deep + ": is nested more than 256 levels deep");
}

TEST_F(SceneFile, DeepOverridesAreRefused) {
  const std::string good = write("good.json", R"({"name": "x"})");
  std::string path = "a";
  for (int k = 0; k < 50000; ++k) path += ".a";
  const std::vector<std::string> deep_path{path + "=1"}, deep_value{"a=" + std::string(100000, '[')};
  EXPECT_NE(error_of([&] { read_scene(good, deep_path); }).second.find("the path must"), std::string::npos);
  EXPECT_NE(error_of([&] { read_scene(good, deep_value); }).second.find("256 levels"), std::string::npos);
}

TEST_F(SceneFile, MissingSceneFileIsNamed) {
  const auto [code, message] = error_of([&] { read_scene(path("none.json")); });
  EXPECT_EQ(code, ErrorCode::io);
  EXPECT_EQ(message, path("none.json") + ": cannot be read: No such file or directory");
  EXPECT_EQ(error_of([&] { read_scene(folder_.string()); }).first, ErrorCode::io);
}

std::string mesh_scene(const std::string& file) {
  return R"({"name": "m", "fluids": [{}], "volumes": [{"fluid": "water", "region": {"type": "mesh", "file": ")" +
         file + R"("}}]})";
}

std::string region_file(const Scene& scene) {
  return std::get<MeshRegion>(scene.volumes.at(0).def.region).file;
}

TEST_F(SceneFile, MeshIsLookedForBesideTheScene) {
  write("ball.obj", "");
  const std::string file = write("scene.json", mesh_scene("ball.obj"));
  EXPECT_EQ(region_file(read_scene(file)), path("ball.obj"));
  EXPECT_EQ(region_file(read_scene(write("absolute.json", mesh_scene(path("ball.obj"))))), path("ball.obj"));
}

TEST_F(SceneFile, MissingMeshIsNamedWithItsPlace) {
  const std::string file = write("scene.json", mesh_scene("none.obj"));
  const auto [code, message] = error_of([&] { read_scene(file); });
  EXPECT_EQ(code, ErrorCode::io);
  EXPECT_EQ(message, file + ": volumes[0].region.file: cannot read mesh file \"" + path("none.obj") + "\"");

  const std::string shape = R"({"name": "s", "shapes": [{"name": "a", "geometry": {"type": "plane"}},
                               {"name": "b", "geometry": {"type": "mesh", "file": "none.obj"}}]})";
  const auto of_shape = error_of([&] { read_scene(write("shape.json", shape)); });
  EXPECT_NE(of_shape.second.find("shapes[1].geometry.file: cannot read"), std::string::npos)
      << of_shape.second;
}

TEST_F(SceneFile, EmptyMeshNameAsksForAnOverride) {
  const std::string file = write("scene.json", mesh_scene(""));
  const auto [code, message] = error_of([&] { read_scene(file); });
  EXPECT_EQ(code, ErrorCode::io);
  EXPECT_EQ(message, file +
                         ": volumes[0].region.file: this scene needs a mesh file of yours; pass --set "
                         "volumes[0].region.file=PATH");
}

TEST_F(SceneFile, AliasStandsForAModelOfGlmark2) {
  const std::string file = write("scene.json", mesh_scene("glmark2:hare.obj"));
  ASSERT_EQ(setenv("MENISCUS_GLMARK2_DIR", folder_.c_str(), 1), 0);
  const auto [code, message] = error_of([&] { read_scene(file); });
  write("hare.obj", "");
  const std::string found = region_file(read_scene(file));
  unsetenv("MENISCUS_GLMARK2_DIR");
  EXPECT_EQ(code, ErrorCode::io);
  EXPECT_NE(message.find("volumes[0].region.file"), std::string::npos) << message;
  EXPECT_NE(message.find(path("hare.obj")), std::string::npos) << message;
  EXPECT_NE(message.find("package glmark2-data"), std::string::npos) << message;
  EXPECT_EQ(found, path("hare.obj"));
}

// ---- samples ----

TEST_F(SceneFile, EverySampleReads) {
  write("bunny.obj", "");
  const std::vector<std::string> mesh_override{"volumes[0].region.file=" + write("armadillo.ply", "")};
  ASSERT_EQ(setenv("MENISCUS_GLMARK2_DIR", folder_.c_str(), 1), 0);
  int count = 0;
  for (const auto& entry : fs::directory_iterator(fs::path(MENISCUS_SAMPLES_DIR) / "scenes")) {
    if (entry.is_directory()) continue;  // meshes of a sample
    const std::string stem = entry.path().stem();
    const bool needs_mesh = stem == "armadillo_splash";
    const Scene scene = needs_mesh ? read_scene(entry.path(), mesh_override) : read_scene(entry.path());
    EXPECT_EQ(scene.name, stem);
    EXPECT_FALSE(scene.description.empty()) << stem;
    EXPECT_FALSE(scene.volumes.empty() && scene.cloths.empty() && scene.ropes.empty()) << stem;
    ++count;
  }
  unsetenv("MENISCUS_GLMARK2_DIR");
  EXPECT_GE(count, 19);
}

TEST_F(SceneFile, ArmadilloSampleAsksForItsMesh) {
  const auto [code, message] =
      error_of([] { read_scene(MENISCUS_SAMPLES_DIR "/scenes/armadillo_splash.json"); });
  EXPECT_EQ(code, ErrorCode::io);
  EXPECT_NE(message.find("pass --set volumes[0].region.file=PATH"), std::string::npos) << message;
}

/// How many lattice points a sample's boxes hold, with spacings counted exactly.
long box_particles(const Scene& scene) {
  long count = 0;
  for (const SceneVolume& volume : scene.volumes) {
    const auto* box = std::get_if<BoxRegion>(&volume.def.region);
    if (!box) continue;
    const auto layers = [&](float lower, float upper) {
      return std::lround((upper - lower) / scene.world.particle_spacing);
    };
    count += layers(box->lower.x, box->upper.x) * layers(box->lower.y, box->upper.y) *
             layers(box->lower.z, box->upper.z);
  }
  return count;
}

TEST_F(SceneFile, SamplesHoldAsManyParticlesAsTheySay) {
  const auto count = [](const std::string& name) {
    return box_particles(read_scene(MENISCUS_SAMPLES_DIR "/scenes/" + name + ".json"));
  };
  EXPECT_EQ(count("dam_break"), 100'000);
  EXPECT_EQ(count("dam_break_1m"), 1'000'000);
  EXPECT_EQ(count("hydrostatic"), 10'240);
  EXPECT_EQ(count("double_dam_break"), 60'000);
  EXPECT_EQ(count("floating_crates"), 43'200);
  EXPECT_EQ(count("ball_splash"), 51'200);
  EXPECT_EQ(count("box_flood"), 100'000);
  EXPECT_EQ(count("cup_pour"), 30'720);
  EXPECT_EQ(count("water_wheel"), 25'600);
  EXPECT_EQ(bodies_of(read_scene(MENISCUS_SAMPLES_DIR "/scenes/box_flood.json")).size(), 1000u);
}

}  // namespace
}  // namespace meniscus
