// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tests of values that the command line sets in a scene.
#include "sdk/scene/scene_override.h"

#include <gtest/gtest.h>
#include <meniscus/error.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "sdk/scene/scene_file.h"

namespace meniscus {
namespace {

using Json = nlohmann::json;

Json document() {
  return Json::parse(
      R"({"name": "x", "world": {"iterations": 10}, "fluids": [{"name": "water"}, {"name": "oil"}],
                         "volumes": [{"fluid": "water", "region": {"type": "mesh", "file": ""}}]})");
}

Json with(const std::string& override_text) {
  Json result = document();
  apply_override(result, override_text);
  return result;
}

std::string error_of(const std::string& override_text) {
  try {
    with(override_text);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::invalid_argument);
    return error.what();
  }
  return "no error";
}

TEST(SceneOverride, ReplacesAndAdds) {
  EXPECT_EQ(with("world.iterations=4")["world"]["iterations"], 4);
  EXPECT_EQ(with("fluids[1].dynamic_viscosity=0.1")["fluids"][1]["dynamic_viscosity"], 0.1);
  EXPECT_EQ(with("world.density.solver=jacobi")["world"]["density"]["solver"], "jacobi");
  EXPECT_EQ(with("world.gravity=[0, 0, -1]")["world"]["gravity"], Json::array({0, 0, -1}));
  EXPECT_EQ(with("fluids[0]={\"name\": \"milk\"}")["fluids"][0]["name"], "milk");
}

TEST(SceneOverride, ValueThatIsNoJsonIsText) {
  EXPECT_EQ(with("name=two words")["name"], "two words");
  EXPECT_EQ(with("name=\"12\"")["name"], "12");
  EXPECT_EQ(with("name=a=b")["name"], "a=b");
  EXPECT_EQ(with("name=")["name"], "");
  EXPECT_EQ(with("camera=true")["camera"], true);
}

TEST(SceneOverride, FileIsFromTheCurrentFolder) {
  const auto file = [](const std::string& value) {
    return with("volumes[0].region.file=" + value)["volumes"][0]["region"]["file"].get<std::string>();
  };
  EXPECT_EQ(file("a.ply"), (std::filesystem::current_path() / "a.ply").string());
  EXPECT_EQ(file("\"a.ply\""), (std::filesystem::current_path() / "a.ply").string());
  EXPECT_EQ(file("/x/a.ply"), "/x/a.ply");
  EXPECT_EQ(file("glmark2:bunny.obj"), "glmark2:bunny.obj");
  EXPECT_EQ(file(""), "");
}

TEST(SceneOverride, PathThatDoesNotFitIsNamed) {
  EXPECT_EQ(error_of("fluids[2].dynamic_viscosity=1"),
            "--set fluids[2].dynamic_viscosity=1: \"fluids\" has 2 items, counted from 0");
  EXPECT_EQ(error_of("fluids.dynamic_viscosity=1"),
            "--set fluids.dynamic_viscosity=1: \"fluids\" is an array of 2, which has no key "
            "\"dynamic_viscosity\"");
  EXPECT_EQ(error_of("name.short=1"), "--set name.short=1: \"name\" is \"x\", which has no key \"short\"");
  EXPECT_EQ(error_of("world[0]=1"), "--set world[0]=1: \"world\" is not an array, and has no items");
  EXPECT_EQ(error_of("sinks[0].name=a"),
            "--set sinks[0].name=a: \"sinks\" is not an array, and has no items");
}

TEST(SceneOverride, TextThatDoesNotReadIsNamed) {
  EXPECT_EQ(error_of("world.iterations"),
            "--set world.iterations: must read path=value, as in world.iterations=4");
  for (const char* path : {"", ".", "world.", "world..iterations", "[0]", "fluids[", "fluids[]", "fluids[-1]",
                           "fluids[x]", "fluids[0", "fluids[0]name", "fluids[99999999999999999999]"}) {
    const std::string text = std::string(path) + "=1";
    EXPECT_EQ(error_of(text), "--set " + text + ": the path must read like fluids[0].dynamic_viscosity");
  }
}

TEST(SceneOverride, ReaderJudgesWhatWasSet) {
  const auto message = [](const std::string& override_text) -> std::string {
    try {
      parse_scene(with(override_text), "scene.json");
    } catch (const Error& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_EQ(message("fluids[0].dynamic_viscosity=0.5"), "no error");
  EXPECT_EQ(message("wrold.iterations=4"), "scene.json: wrold: unknown key; did you mean \"world\"?");
  EXPECT_EQ(message("world.iterations=many"),
            "scene.json: world.iterations: \"many\" is not allowed; must be a whole number");
}

}  // namespace
}  // namespace meniscus
