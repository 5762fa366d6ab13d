// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The public calls for scenes: text to a world, checks without a world, and the parts of errors.
#include <gtest/gtest.h>
#include <meniscus/scene.h>

#include <functional>
#include <limits>

namespace meniscus {
namespace {

SceneError error_of(const std::function<void()>& call) {
  try {
    call();
  } catch (const SceneError& error) {
    return error;
  }
  ADD_FAILURE() << "nothing was thrown";
  return {ErrorCode::parse, "", "", ""};
}

constexpr const char* pool = R"({
  "name": "pool",  // a comment
  "world": {"device": "cpu", "particle_spacing": 0.1},
  "fluids": [{"name": "water"}],
  "shapes": [{"name": "tank", "geometry": {"type": "container", "half_extents": [0.5, 0.5, 0.5]}}],
  "volumes": [{"fluid": "water", "region": {"type": "box", "lower": [-0.5, -0.5, -0.5], "upper": [0.5, 0, 0.5]}}]
})";

TEST(SceneText, BecomesAWorld) {
  const Scene scene = read_scene_text(pool);
  check_scene(scene);
  BuiltScene built = build_scene(scene);
  EXPECT_EQ(built.world.particle_count(), 500u);
  EXPECT_EQ(built.volumes, std::vector<std::size_t>{500});
  built.world.step(scene.frame_time);
}

TEST(SceneErrors, TellFilePathAndFix) {
  const SceneError key =
      error_of([] { read_scene_text(R"({"name": "x", "fluids": [{"rest_densty": 1}]})", "", "x.json"); });
  EXPECT_EQ(key.code(), ErrorCode::parse);
  EXPECT_EQ(key.file(), "x.json");
  EXPECT_EQ(key.path(), "fluids[0].rest_densty");
  EXPECT_EQ(key.fix(), "did you mean \"rest_density\"?");
  EXPECT_EQ(std::string(key.what()),
            "x.json: fluids[0].rest_densty: unknown key; did you mean \"rest_density\"?");

  const SceneError value =
      error_of([] { read_scene_text(R"({"name": "x", "fluids": [{"rest_density": -1}]})"); });
  EXPECT_EQ(value.path(), "fluids[0].rest_density");
  EXPECT_EQ(value.fix(), "must be at least 0.001 and at most 1000000");

  const SceneError missing = error_of([] { read_scene("no_such_file.json"); });
  EXPECT_EQ(missing.code(), ErrorCode::io);
  EXPECT_EQ(missing.file(), "no_such_file.json");
  EXPECT_EQ(missing.path(), "");
}

TEST(SceneErrors, OfAChangedSceneComeBeforeAWorldIsMade) {
  Scene scene = read_scene_text(pool);
  scene.fluids[0].rest_density = std::numeric_limits<float>::quiet_NaN();
  const SceneError value = error_of([&] { check_scene(scene); });
  EXPECT_EQ(value.code(), ErrorCode::invalid_argument);
  EXPECT_EQ(value.path(), "fluids[0]");
  EXPECT_NE(std::string(value.what()).find("FluidDef::rest_density"), std::string::npos);
  EXPECT_EQ(std::string(error_of([&] { build_scene(scene); }).what()), value.what());

  scene = read_scene_text(pool);
  scene.volumes[0].fluid = "watr";
  const SceneError name = error_of([&] { check_scene(scene); });
  EXPECT_EQ(name.path(), "volumes[0].fluid");
  EXPECT_EQ(name.fix(), "did you mean \"water\"?");
}

TEST(SceneErrors, OfThingsThatNameOthersAreFoundByTheCheck) {
  Scene scene = read_scene_text(pool);
  SceneAttachment nothing;
  nothing.def.name = "hook";
  nothing.def.vertices = {0};
  scene.attachments.push_back(nothing);
  EXPECT_EQ(error_of([&] { check_scene(scene); }).path(), "attachments[0]");
}

}  // namespace
}  // namespace meniscus
