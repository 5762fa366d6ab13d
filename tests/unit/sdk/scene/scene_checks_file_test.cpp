// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The checks that a scene file states, and the errors in them.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "sdk/scene/scene_file.h"

namespace meniscus {
namespace {

nlohmann::json scene_with(const char* check) {
  nlohmann::json document = nlohmann::json::parse(R"({
    "name": "x",
    "bodies": [{"name": "boat", "geometry": {"type": "box"}}],
    "cloths": [{"name": "sail", "geometry": {"type": "sheet"}}],
    "probes": [{"type": "point_pressure", "name": "deep", "point": [0, 0, 0]}]
  })");
  document["checks"] = nlohmann::json::array({nlohmann::json::parse(check)});
  return document;
}

TEST(SceneChecksFile, AreRead) {
  const Scene scene = parse_scene(scene_with(
      R"({"type": "body_position", "name": "sails", "body": "boat", "axis": "x", "low": 1, "from": 5})"));
  ASSERT_EQ(scene.checks.size(), 1u);
  const SceneCheck& check = scene.checks[0];
  EXPECT_EQ(check.kind, CheckKind::body_position);
  EXPECT_EQ(check.name, "sails");
  EXPECT_EQ(check.body, "boat");
  EXPECT_EQ(check.axis, Axis::x);
  EXPECT_EQ(check.low, 1.0f);
  EXPECT_FALSE(check.high);
  EXPECT_EQ(check.from, 5.0f);
  EXPECT_FALSE(check.until);
}

TEST(SceneChecksFile, FaultsNeedNoLimit) {
  for (const char* kind : {"outside", "crossings"}) {
    const std::string check = std::string(R"({"name": "none", "type": ")") + kind + "\"}";
    EXPECT_EQ(parse_scene(scene_with(check.c_str())).checks[0].high, 0.0f) << kind;
  }
  EXPECT_EQ(parse_scene(scene_with(R"({"name": "few", "type": "outside", "high": 3})")).checks[0].high, 3.0f);
}

struct Mistake {
  const char* check;
  const char* message;
};

TEST(SceneChecksFile, MistakesAreNamed) {
  const Mistake mistakes[] = {
      {R"({"name": "a", "type": "energy"})", "checks[0]: low or high is needed"},
      {R"({"name": "a", "type": "energy", "low": 2, "high": 1})", "checks[0]: low must not be above high"},
      {R"({"name": "a", "type": "energy", "high": 1, "from": 2, "until": 1})",
       "checks[0]: from must not be above until"},
      {R"({"name": "a", "type": "energy", "high": 1, "from": -1})",
       "checks[0].from: -1 is not allowed; must be at least 0"},
      {R"({"name": "a", "type": "energi", "high": 1})",
       R"(checks[0].type: "energi" is not known; did you mean "energy"?)"},
      {R"({"name": "a", "type": "energy", "high": 1, "body": "boat"})", "checks[0].body: unknown key"},
      {R"({"name": "a", "type": "body_tilt", "high": 1})",
       "checks[0].body: missing, and needed: name of the body"},
      {R"({"name": "a", "type": "body_tilt", "high": 1, "body": "boot"})",
       R"(checks[0].body: there is no body named "boot"; did you mean "boat"?)"},
      {R"({"name": "a", "type": "tears", "high": 1, "cloth": "boat"})",
       R"(checks[0].cloth: there is no cloth named "boat")"},
      {R"({"name": "a", "type": "probe", "high": 1, "probe": "deap"})",
       R"(checks[0].probe: there is no probe named "deap"; did you mean "deep"?)"},
  };
  for (const Mistake& mistake : mistakes) {
    try {
      parse_scene(scene_with(mistake.check), "scene.json");
      ADD_FAILURE() << mistake.check << " is taken";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::parse);
      EXPECT_EQ(std::string(error.what()).substr(0, 12 + std::string(mistake.message).size()),
                std::string("scene.json: ") + mistake.message);
    }
  }
}

}  // namespace
}  // namespace meniscus
