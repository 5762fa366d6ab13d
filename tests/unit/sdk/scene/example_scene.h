// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Scenes with everything that the schema offers.
#pragma once

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

namespace meniscus::tests {

using Json = nlohmann::json;

/// Makes documents that have every key of a schema. Where it offers alternatives, `choice` picks one.
class Example {
 public:
  explicit Example(std::size_t choice) : choice_(choice) {}

  Json of(const Json& schema, const std::string& key) const {
    if (schema.contains("oneOf")) return of(schema["oneOf"][choice_ % schema["oneOf"].size()], key);
    if (schema.contains("const")) return schema["const"];
    if (schema.contains("enum")) return schema["enum"][choice_ % schema["enum"].size()];
    if (schema["type"] == "object") return object(schema);
    if (schema["type"] == "array") return array(schema, key);
    if (schema["type"] == "string") return "name";  // one for all, so that references hit
    if (schema.contains("default")) return schema["default"];
    if (schema["type"] == "boolean") return true;
    if (schema.contains("exclusiveMinimum")) return schema["exclusiveMinimum"].get<double>() + 1;
    return schema.value("minimum", Json(0));
  }

 private:
  Json object(const Json& schema) const {
    Json result = Json::object();
    for (const auto& [key, property] : schema["properties"].items()) result[key] = of(property, key);
    return result;
  }

  Json array(const Json& schema, const std::string& key) const {
    if (schema.contains("default")) return schema["default"];
    if (key == "rotation") return {0, 0, 0, 1};
    if (key == "upper" || key == "axis") return {1, 1, 1};
    const std::size_t count = std::max<std::size_t>(1, schema.value("minItems", 1u));
    Json result = Json::array();
    for (std::size_t i = 0; i < count; ++i) result.push_back(of(schema["items"], key));
    return result;
  }

  std::size_t choice_;
};

/// Names that the schema leaves open, but that must fit one another.
inline Json with_fitting_names(Json document) {
  document["granulars"][0]["name"] = "sand";
  document["bodies"][0]["name"] = "body";
  document["bodies"][0]["motion"] = "kinematic";  // the one kind that may have every key
  for (const char* key : {"velocity", "angular_velocity"}) document["bodies"][0][key] = {0, 0, 0};
  document["bodies"][0].erase("motion_file");  // it excludes keyframes, and is read
  document["joints"][0]["a"] = "body_0";       // the first of the copies
  document["joints"][0]["b"] = "";
  document["attachments"][0]["body"] = "body_0";
  document["emitters"][0]["body"] = "body_0";
  document["sinks"][0]["body"] = "body_0";
  if (document["checks"][0].contains("body")) document["checks"][0]["body"] = "body_0";
  for (const char* key : {"rope", "other_cloth", "other_rope"}) document["attachments"][0].erase(key);
  return document;
}

/// The length of the longest list of alternatives.
inline constexpr std::size_t most_alternatives = 14;

/// Periodic axes go with neither diffuse particles nor the solver `grid`.
inline Json with_fitting_axes(Json document, std::size_t choice) {
  Json& world = document["world"];
  if (choice % 2 == 1) {
    world.erase("periodic");
  } else {
    world.erase("diffuse");
    world["density"]["solver"] = "chebyshev";
    for (Json& axis : world["periodic"]) axis["high"] = 1;
  }
  return document;
}

/// A document with every key of the schema, of those that exclude one another with some; which alternatives
/// it has, `choice` picks.
inline Json example_scene(const Json& schema, std::size_t choice) {
  return with_fitting_axes(with_fitting_names(Example(choice).of(schema, "")), choice);
}

}  // namespace meniscus::tests
