// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Cloth, ropes, attachments and wind in scene files.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

#include "sdk/scene/scene_file.h"

namespace meniscus {
namespace {

namespace fs = std::filesystem;

constexpr const char* text = R"({
  "name": "x",
  "world": {"cloth": {"over_relaxation": 1.2, "warm_start": 0.1, "stretch_rounds": 3}},
  "bodies": [{"name": "bar", "motion": "kinematic", "geometry": {"type": "box"}, "copies": {"count": [2, 1, 1], "step": [2, 0, 0]}}],
  "cloths": [
    {"name": "flag", "geometry": {"type": "sheet", "width": 3, "depth": 2, "columns": 7, "rows": 5},
     "pose": {"position": [1, 2, 3]}, "stretch": [1.5, 1, 0.5], "velocity": [4, 5, 6],
     "fabric": {"density": 0.3, "stretch_model": "triangles", "warp_stiffness": 11, "weft_stiffness": 12,
                "shear_stiffness": 13, "bending_model": "dihedral", "bending_stiffness": 14,
                "unyielding": ["weft"], "stretch_damping": 0.5, "bending_damping": 0.6, "thickness": 0.01,
                "friction": 0.7, "permittivity": 0.15, "absorbency": 0.45,
                "retention": 0.65, "drainage": 0.03, "drag": 1.1, "lift": 1.2, "tear_strain": 0.25},
     "groups": 6, "mask": 9, "self_collision": false, "tethers": false, "color": [0.1, 0.2, 0.3]},
    {"name": "rag", "geometry": {"type": "triangles", "vertices": [[0, 0, 0], [1, 0, 0], [0, 0, 1]],
                                 "triangles": [0, 2, 1]}},
    {"name": "ball", "geometry": {"type": "sphere", "radius": 0.4, "divisions": 3},
     "inflation": {"pressure": 500, "air_pressure": 90000}},
    {"name": "skirt", "geometry": {"type": "tube", "top_radius": 0.3, "bottom_radius": 0.6, "height": 0.8,
                                   "columns": 12, "rows": 4}}
  ],
  "ropes": [
    {"name": "line", "points": [[0, 0, 0], [0, 3, 0]], "segments": 6, "pose": {"position": [7, 0, 0]},
     "velocity": [1, 0, 0], "radius": 0.02, "density": 900, "youngs_modulus": 5e6, "damping": 0.2, "mask": 4,
     "color": [0.3, 0.2, 0.1]},
    {"name": "hoop", "points": [[0, 0, 0], [1, 0, 0], [0, 0, 1]], "bends_and_twists": true,
     "shear_modulus": 2e6, "unyielding": true, "closed": true, "straight_at_rest": true}
  ],
  "attachments": [
    {"name": "hoist", "cloth": "flag", "vertices": [0, 7], "region": {"lower": [0, 1, 2], "upper": [3, 4, 5]},
     "body": "bar_1"},
    {"name": "seam", "cloth": "rag", "vertices": [1], "other_cloth": "flag", "reach": 9, "compliance": 0.001},
    {"name": "halyard", "rope": "line", "vertices": [6], "other_rope": "hoop", "reach": 20},
    {"name": "clamp", "rope": "hoop", "vertices": [0, 1], "clamped": true}
  ],
  "wind": {"velocity": [8, 0, 1], "air_density": 1.1, "gust_speed": 2, "gust_size": 3, "seed": 4}
})";

Scene scene() {
  return parse_scene(nlohmann::json::parse(text));
}

TEST(SceneCloth, SolverAndWind) {
  const Scene s = scene();
  EXPECT_FLOAT_EQ(s.world.cloth.over_relaxation, 1.2f);
  EXPECT_FLOAT_EQ(s.world.cloth.warm_start, 0.1f);
  EXPECT_EQ(s.world.cloth.stretch_rounds, 3);
  ASSERT_TRUE(s.wind.has_value());
  EXPECT_FLOAT_EQ(s.wind->velocity.x, 8);
  EXPECT_FLOAT_EQ(s.wind->air_density, 1.1f);
  EXPECT_FLOAT_EQ(s.wind->gust_speed, 2);
  EXPECT_FLOAT_EQ(s.wind->gust_size, 3);
  EXPECT_EQ(s.wind->seed, 4u);
  EXPECT_FALSE(parse_scene(nlohmann::json::parse(R"({"name": "x"})")).wind.has_value());
}

TEST(SceneCloth, PieceOfCloth) {
  const ClothDef flag = scene().cloths.at(0);
  EXPECT_EQ(flag.name, "flag");
  const auto& sheet = std::get<SheetGeometry>(flag.geometry);
  EXPECT_FLOAT_EQ(sheet.width, 3);
  EXPECT_FLOAT_EQ(sheet.depth, 2);
  EXPECT_EQ(sheet.columns, 7);
  EXPECT_EQ(sheet.rows, 5);
  EXPECT_FLOAT_EQ(flag.pose.position.z, 3);
  EXPECT_FLOAT_EQ(flag.stretch.z, 0.5f);
  EXPECT_FLOAT_EQ(flag.velocity.y, 5);
  EXPECT_EQ(flag.filter.groups, 6u);
  EXPECT_EQ(flag.filter.mask, 9u);
  EXPECT_FALSE(flag.self_collision);
  EXPECT_FALSE(flag.tethers);
  EXPECT_FALSE(flag.inflation.has_value());
  EXPECT_FLOAT_EQ(flag.color.z, 0.3f);
}

TEST(SceneCloth, Fabric) {
  const FabricDef f = scene().cloths.at(0).fabric;
  EXPECT_FLOAT_EQ(f.density, 0.3f);
  EXPECT_EQ(f.stretch_model, StretchModel::triangles);
  EXPECT_FLOAT_EQ(f.warp_stiffness, 11);
  EXPECT_EQ(f.weft_stiffness, std::numeric_limits<float>::infinity()) << "unyielding";
  EXPECT_FLOAT_EQ(f.shear_stiffness, 13);
  EXPECT_EQ(f.bending_model, BendingModel::dihedral);
  EXPECT_FLOAT_EQ(f.bending_stiffness, 14);
  EXPECT_FLOAT_EQ(f.stretch_damping, 0.5f);
  EXPECT_FLOAT_EQ(f.bending_damping, 0.6f);
  EXPECT_FLOAT_EQ(f.thickness, 0.01f);
  EXPECT_FLOAT_EQ(f.friction, 0.7f);
  EXPECT_FLOAT_EQ(f.drag, 1.1f);
  EXPECT_FLOAT_EQ(f.lift, 1.2f);
  EXPECT_FLOAT_EQ(f.tear_strain, 0.25f);
  EXPECT_FLOAT_EQ(f.permittivity, 0.15f);
  EXPECT_FLOAT_EQ(f.absorbency, 0.45f);
  EXPECT_FLOAT_EQ(f.retention, 0.65f);
  EXPECT_FLOAT_EQ(f.drainage, 0.03f);
}

TEST(SceneCloth, GeometriesAndInflation) {
  const Scene s = scene();
  const auto& triangles = std::get<ClothTriangles>(s.cloths.at(1).geometry);
  ASSERT_EQ(triangles.vertices.size(), 3u);
  EXPECT_FLOAT_EQ(triangles.vertices[2].z, 1);
  EXPECT_EQ(triangles.triangles, (std::vector<uint32_t>{0, 2, 1}));
  const ClothDef& ball = s.cloths.at(2);
  EXPECT_FLOAT_EQ(std::get<ClothSphere>(ball.geometry).radius, 0.4f);
  EXPECT_EQ(std::get<ClothSphere>(ball.geometry).divisions, 3);
  ASSERT_TRUE(ball.inflation.has_value());
  EXPECT_FLOAT_EQ(ball.inflation->pressure, 500);
  EXPECT_FLOAT_EQ(ball.inflation->air_pressure, 90000);
  const auto& tube = std::get<ClothTube>(s.cloths.at(3).geometry);
  EXPECT_FLOAT_EQ(tube.top_radius, 0.3f);
  EXPECT_FLOAT_EQ(tube.bottom_radius, 0.6f);
  EXPECT_FLOAT_EQ(tube.height, 0.8f);
  EXPECT_EQ(tube.columns, 12);
  EXPECT_EQ(tube.rows, 4);
}

TEST(SceneCloth, RopesAndRods) {
  const Scene s = scene();
  const RopeDef& line = s.ropes.at(0);
  EXPECT_EQ(line.name, "line");
  ASSERT_EQ(line.points.size(), 2u);
  EXPECT_FLOAT_EQ(line.points[1].y, 3);
  EXPECT_EQ(line.segments, 6);
  EXPECT_FLOAT_EQ(line.pose.position.x, 7);
  EXPECT_FLOAT_EQ(line.velocity.x, 1);
  EXPECT_FLOAT_EQ(line.radius, 0.02f);
  EXPECT_FLOAT_EQ(line.density, 900);
  EXPECT_FLOAT_EQ(line.youngs_modulus, 5e6f);
  EXPECT_FLOAT_EQ(line.damping, 0.2f);
  EXPECT_EQ(line.filter.mask, 4u);
  EXPECT_FLOAT_EQ(line.color.x, 0.3f);
  EXPECT_FALSE(line.bends_and_twists || line.closed || line.straight_at_rest);
  const RopeDef& hoop = s.ropes.at(1);
  EXPECT_TRUE(hoop.bends_and_twists && hoop.closed && hoop.straight_at_rest);
  EXPECT_EQ(hoop.youngs_modulus, std::numeric_limits<float>::infinity()) << "unyielding";
  EXPECT_FLOAT_EQ(hoop.shear_modulus, 2e6f);
}

TEST(SceneCloth, AttachmentsGoByName) {
  const Scene s = scene();
  ASSERT_EQ(s.attachments.size(), 4u);
  const SceneAttachment& hoist = s.attachments[0];
  EXPECT_EQ(hoist.cloth, "flag");
  EXPECT_EQ(hoist.body, "bar_1") << "a copy, by its own name";
  EXPECT_EQ(hoist.def.vertices, (std::vector<uint32_t>{0, 7}));
  ASSERT_TRUE(hoist.def.region.has_value());
  EXPECT_FLOAT_EQ(hoist.def.region->upper.y, 4);
  EXPECT_EQ(s.attachments[1].other_cloth, "flag");
  EXPECT_FLOAT_EQ(s.attachments[1].def.reach, 9);
  EXPECT_FLOAT_EQ(s.attachments[1].def.compliance, 0.001f);
  EXPECT_EQ(s.attachments[2].rope, "line");
  EXPECT_EQ(s.attachments[2].other_rope, "hoop");
  EXPECT_FALSE(s.attachments[2].def.clamped);
  EXPECT_TRUE(s.attachments[3].def.clamped);
  EXPECT_FALSE(s.attachments[3].def.region.has_value());
}

TEST(SceneCloth, IsBuiltWithItsNames) {
  Scene s = scene();
  s.world.device = DeviceChoice::cpu;
  s.attachments[0].def.region.reset();
  s.cloths[0].fabric.weft_stiffness = 12;
  const BuiltScene built = build_scene(s);
  ASSERT_EQ(built.cloths.size(), 4u);
  ASSERT_EQ(built.ropes.size(), 2u);
  ASSERT_EQ(built.attachments.size(), 4u);
  const World& world = built.world;
  EXPECT_EQ(world.cloth_positions(built.cloths[0]).size(), 35u);
  EXPECT_FLOAT_EQ(world.cloth_positions(built.cloths[0])[0].x, 1 - 1.5f * 1.5f) << "stretched at the start";
  EXPECT_EQ(world.rope_positions(built.ropes[0]).size(), 7u);
  EXPECT_FLOAT_EQ(world.rope_positions(built.ropes[0])[6].y, 3);
  EXPECT_EQ(world.attachment_vertices(built.attachments[0]), (std::vector<uint32_t>{0, 7}));
  EXPECT_EQ(world.attachment_vertices(built.attachments[2]), (std::vector<uint32_t>{6}));
}

TEST(SceneCloth, SpheresAreClosedAndTubesAreOpen) {
  Scene s = scene();
  s.world.device = DeviceChoice::cpu;
  s.attachments.clear();
  const BuiltScene built = build_scene(s);
  const ClothState ball = built.world.cloth_state(built.cloths[2]);
  EXPECT_TRUE(ball.closed);
  EXPECT_EQ(built.world.cloth_positions(built.cloths[2]).size(), 10u * 9 + 2);
  EXPECT_EQ(built.world.cloth_triangles(built.cloths[2]).size(), 3u * 20 * 9);
  EXPECT_NEAR(ball.volume, 4.0 / 3 * M_PI * 0.064, 0.07 * 0.268) << "a polyhedron, a little less";
  const ClothState skirt = built.world.cloth_state(built.cloths[3]);
  EXPECT_FALSE(skirt.closed);
  // A frustum of twelve sides: the mean of the two circumferences, times the slant at the middle of a side.
  const double side = 2 * std::sin(M_PI / 12), apothem = std::cos(M_PI / 12);
  const double slant = std::hypot(0.8, 0.3 * apothem);
  EXPECT_NEAR(skirt.area, 12 * side * 0.45 * slant, 1e-4);
  for (const std::size_t piece : {2u, 3u}) {
    const auto positions = built.world.cloth_positions(built.cloths[piece]);
    const auto normals = built.world.cloth_normals(built.cloths[piece]);
    for (std::size_t i = 0; i < positions.size(); ++i)
      EXPECT_GT(positions[i].x * normals[i].x + positions[i].z * normals[i].z +
                    (piece == 2 ? positions[i].y * normals[i].y : 0),
                0)
          << "out of the solid, at vertex " << i;
  }
}

/// The vertices of each piece of a sample, or of each attachment.
struct SampleCounts {
  const char* sample;
  std::vector<std::size_t> cloths, attachments;
};

TEST(SceneCloth, SamplesHoldWhatTheySay) {
  const std::vector<SampleCounts> samples = {{"hanging_cloth", {65 * 65}, {65}},
                                             {"flag", {73 * 49}, {49}},
                                             {"tearing", {49 * 33}, {33, 33}},
                                             {"ball_in_sheet", {41 * 41}, {4}},
                                             {"balloons", {1442, 1002, 1002, 1442, 812}, {}},
                                             {"skirt", {80 * 37}, {80}}};
  for (const SampleCounts& expected : samples) {
    Scene s = read_scene(std::string(MENISCUS_SAMPLES_DIR "/scenes/") + expected.sample + ".json");
    s.world.device = DeviceChoice::cpu;
    const BuiltScene built = build_scene(s);
    std::vector<std::size_t> cloths, attachments;
    for (const ClothId id : built.cloths) cloths.push_back(built.world.cloth_positions(id).size());
    for (const AttachmentId id : built.attachments)
      attachments.push_back(built.world.attachment_vertices(id).size());
    EXPECT_EQ(cloths, expected.cloths) << expected.sample;
    EXPECT_EQ(attachments, expected.attachments) << expected.sample << ": do the regions still fit?";
  }
}

TEST(SceneCloth, BridgeOfRopesHasItsKnots) {
  Scene s = read_scene(MENISCUS_SAMPLES_DIR "/scenes/ropes.json");
  s.world.device = DeviceChoice::cpu;
  const BuiltScene built = build_scene(s);
  EXPECT_EQ(built.ropes.size(), 6u);
  EXPECT_EQ(built.bodies.size(), 12u + 2u);
  EXPECT_EQ(built.attachments.size(), 2u * (1 + 12) + 3u + 1u);
  for (std::size_t i = 0; i < built.attachments.size(); ++i) {
    const bool single = s.attachments[i].def.name == "hook";
    EXPECT_EQ(built.world.attachment_vertices(built.attachments[i]).size(), single ? 1u : 2u) << i;
  }
}

TEST(SceneCloth, FilesAreFromTheScenesFolder) {
  const fs::path folder = fs::path(testing::TempDir()) / "meniscus_scene_cloth";
  fs::create_directories(folder);
  std::ofstream(folder / "a.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  const auto read = [&](const std::string& file) {
    std::ofstream(folder / "scene.json") << R"({"name": "x", "cloths": [{"name": "a", "geometry":
        {"type": "mesh", "scale": 2, "file": ")"
                                         << file << "\"}}]}";
    return read_scene(folder / "scene.json");
  };
  const auto geometry = std::get<ClothFile>(read("a.obj").cloths.at(0).geometry);
  EXPECT_EQ(geometry.file, (folder / "a.obj").string());
  EXPECT_FLOAT_EQ(geometry.scale, 2);
  setenv("MENISCUS_GLMARK2_DIR", folder.c_str(), 1);
  EXPECT_EQ(std::get<ClothFile>(read("glmark2:a.obj").cloths.at(0).geometry).file,
            (folder / "a.obj").string());
  unsetenv("MENISCUS_GLMARK2_DIR");
  try {
    read("none.obj");
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::io);
    EXPECT_NE(std::string(error.what()).find("cloths[0].geometry.file: cannot read mesh file"),
              std::string::npos)
        << error.what();
  }
  fs::remove_all(folder);
}

}  // namespace
}  // namespace meniscus
