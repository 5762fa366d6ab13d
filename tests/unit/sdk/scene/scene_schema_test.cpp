// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The schema and the reader come from one description; these hold them, the committed schema and the samples
// together.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>

#include "sdk/scene/scene_file.h"
#include "tests/unit/sdk/scene/example_scene.h"

namespace meniscus {
namespace {

using Json = nlohmann::json;

std::string file_text(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(SceneSchema, EqualsTheCommittedFile) {
  EXPECT_TRUE(scene_schema() == file_text(MENISCUS_SAMPLES_DIR "/scene.schema.json"))
      << "write it anew: meniscus schema > samples/scene.schema.json";
}

/// Every `type` that a document names, with where.
void gather_types(const Json& json, const std::string& place, std::set<std::string>& types) {
  if (json.is_object() && json.contains("type")) types.insert(place + json["type"].get<std::string>());
  for (const auto& [key, child] : json.items()) {
    if (child.is_structured()) gather_types(child, json.is_array() ? place : key + ":", types);
  }
}

TEST(SceneSchema, ReaderTakesEveryKeyOfTheSchema) {
  const Json schema = Json::parse(scene_schema());
  std::set<std::string> types;
  for (std::size_t choice = 0; choice < tests::most_alternatives; ++choice) {
    const Json document = tests::example_scene(schema, choice);
    gather_types(document, "", types);
    EXPECT_NO_THROW(parse_scene(document)) << "alternative " << choice;
  }
  // Cloth and solids have a mesh and a sphere each, but under one key.
  EXPECT_EQ(types.size(), 10u + 5u + 5u + 3u + 11u + 3u + 1u + 14u + 7u)
      << "geometries of solids and of cloth, joints, regions, probes and openings, each at least once; and "
         "of "
         "sinks the half-space; checks; forces and everywhere";
}

/// Whether an alternative is for values like this one: of its `type`, or of its kind where it has none.
bool is_meant(const Json& alternative, const Json& value) {
  if (!value.is_object()) return alternative["type"] != "object";
  if (alternative["type"] != "object") return false;
  if (!alternative["properties"].contains("type")) return true;
  return alternative["properties"]["type"]["const"] == value.value("type", "");
}

/// Checks that a document has only keys of the schema, and all that the schema requires.
void check_keys(const Json& schema, const Json& value, const std::string& place) {
  if (schema.contains("oneOf")) {
    for (const Json& alternative : schema["oneOf"]) {
      if (is_meant(alternative, value)) return check_keys(alternative, value, place);
    }
    ADD_FAILURE() << place << " fits no alternative";
  }
  if (value.is_array()) {
    for (const Json& item : value) check_keys(schema["items"], item, place + "[]");
  }
  if (!value.is_object()) return;
  for (const Json& key : schema.value("required", Json::array())) {
    EXPECT_TRUE(value.contains(key.get<std::string>())) << place << " lacks " << key;
  }
  for (const auto& [key, child] : value.items()) {
    ASSERT_TRUE(schema["properties"].contains(key)) << place << "." << key;
    check_keys(schema["properties"][key], child, place + "." + key);
  }
}

TEST(SceneSchema, SamplesHaveItsKeys) {
  const Json schema = Json::parse(scene_schema());
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(MENISCUS_SAMPLES_DIR "/scenes")) {
    if (entry.is_directory()) continue;  // meshes of a sample
    check_keys(schema, Json::parse(file_text(entry.path()), nullptr, true, true), entry.path().filename());
    ++count;
  }
  EXPECT_GE(count, 19);
}

/// Every object is closed, and every key says what it is for.
void check_described(const Json& schema, const std::string& place) {
  if (schema.contains("items")) check_described(schema["items"], place + "[]");
  if (schema.contains("oneOf")) {
    for (const Json& alternative : schema["oneOf"]) check_described(alternative, place + "|");
  }
  if (!schema.contains("properties")) return;
  EXPECT_EQ(schema.value("additionalProperties", true), false) << place;
  for (const auto& [key, property] : schema["properties"].items()) {
    const bool tells = property.contains("const") || !property.value("description", "").empty();
    EXPECT_TRUE(tells) << place << "." << key;
    check_described(property, place + "." + key);
  }
}

TEST(SceneSchema, DescribesEveryKey) {
  check_described(Json::parse(scene_schema()), "");
}

TEST(SceneSchema, CarriesUnitsRangesAndDefaults) {
  const Json schema = Json::parse(scene_schema());
  const Json& density = schema["properties"]["fluids"]["items"]["properties"]["rest_density"];
  EXPECT_EQ(density["description"], "density at rest (kg/m³)");
  EXPECT_EQ(density["minimum"], 0.001);
  EXPECT_EQ(density["maximum"], 1e6);
  EXPECT_EQ(density["default"], 1000);
  const Json& spacing = schema["properties"]["world"]["properties"]["particle_spacing"];
  EXPECT_EQ(spacing["default"], 0.05) << "the float's shortest text, not its digits in double precision";
  const Json& face = schema["properties"]["shapes"]["items"]["properties"]["geometry"]["oneOf"][1]
                           ["properties"]["openings"]["items"]["properties"]["face"];
  EXPECT_EQ(face["enum"].size(), 6u);
  EXPECT_EQ(face["default"], "y_high");
  const Json& body = schema["properties"]["bodies"]["items"]["properties"];
  EXPECT_EQ(body["mask"]["type"], "integer");
  EXPECT_EQ(body["mask"]["maximum"], 4294967295u);
  EXPECT_EQ(body["mask"]["default"], 4294967295u);
  EXPECT_FALSE(body["mass"].contains("default")) << "left out, the density gives it";
}

TEST(SceneSchema, BoundsWhatTheReaderBounds) {
  const Json scene = Json::parse(scene_schema())["properties"];
  EXPECT_EQ(scene["frames"]["maximum"], 2147483647);
  const Json& most = scene["emitters"]["items"]["properties"]["most_particles"];
  EXPECT_EQ(most["minimum"], 0);
  EXPECT_EQ(most["maximum"], 4294967295u);
  const Json& count = scene["bodies"]["items"]["properties"]["copies"]["properties"]["count"];
  EXPECT_EQ(count["minItems"], 3);
  EXPECT_EQ(count["maxItems"], 3);
}

}  // namespace
}  // namespace meniscus
