// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Each number of each definition, at its bounds and beyond: C++ and scene files must allow the same, and
// errors must name the bounds that the schema prints. A new field is tested without an edit here.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "sdk/scene/scene_file.h"
#include "tests/unit/sdk/fields/number_trials.h"
#include "tests/unit/sdk/scene/example_scene.h"

namespace meniscus::tests {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Whether a call throws, and with what.
template <class Call>
std::string refusal(const Call& call) {
  try {
    call();
    return {};
  } catch (const Error& error) {
    return error.what();
  }
}

void put(Json& document, const Number& number, double value) {
  if (number.is_rotation)
    document[number.place] = {value, 0, 0, 1};
  else if (number.is_whole)
    document[number.place] = static_cast<int64_t>(value);
  else
    document[number.place] = value;
}

/// What the schema says of a place in a document; of alternatives, that which the document has there.
const Json& schema_at(const Json& schema, const Json& document, Json::json_pointer place) {
  std::vector<std::string> keys;
  for (; !place.empty(); place.pop_back()) keys.insert(keys.begin(), place.back());
  const Json* rule = &schema;
  const Json* value = &document;
  for (const std::string& key : keys) {
    if (rule->contains("oneOf")) {
      for (const Json& way : (*rule)["oneOf"]) {
        if (way["properties"]["type"]["const"] == (*value)["type"]) rule = &way;
      }
    }
    rule = value->is_array() ? &(*rule)["items"] : &(*rule)["properties"][key];
    value = value->is_array() ? &(*value)[std::stoul(key)] : &(*value)[key];
  }
  return *rule;
}

/// The bounds that the schema prints, but for those of a type.
std::vector<std::string> printed_bounds(const Json& schema, const FieldRule& rule) {
  std::vector<std::string> bounds;
  if (std::isfinite(rule.low))
    bounds.push_back(schema.at(rule.above_low ? "exclusiveMinimum" : "minimum").dump());
  if (std::isfinite(rule.high))
    bounds.push_back(schema.at(rule.below_high ? "exclusiveMaximum" : "maximum").dump());
  return bounds;
}

void expect_named(const std::string& message, const std::string& text) {
  EXPECT_NE(message.find(text), std::string::npos) << '"' << message << "\" does not name " << text;
}

/// A scene with every key, of which C++ takes all definitions as they are.
Json complete_scene(const Json& schema, std::size_t choice) {
  Json document = example_scene(schema, choice);
  const std::function<void(Json&)> mend = [&](Json& value) {
    if (value.is_object() && value.value("type", Json()) == "hull") {  // its file is not read here
      value.erase("file");
      value.erase("scale");
      value["points"] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    }
    if (value.is_object() && value.value("/force/type"_json_pointer, Json()) == "vortex")
      value.erase("quantity");
    for (Json& child : value) {
      if (child.is_structured()) mend(child);
    }
  };
  mend(document);
  return document;
}

class FieldsTest : public testing::Test {
 protected:
  const Json schema_ = Json::parse(scene_schema());
  Json document_;
  std::set<std::string> done_;

  /// The definition is what the document has at this place.
  template <class Def>
  void try_def(Def& def, const std::string& place) {
    ASSERT_EQ(refusal([&] { check::def(def); }), "") << place;
    for (const Number& number : numbers_of(def, place)) {
      if (!done_.insert(number.name).second) continue;
      for (const double value : trials(number)) try_value(def, number, value);
      if (!number.is_rotation) {  // in a file it may have any length
        for (const double value : huge_trials(number)) try_value(def, number, value);
      }
      try_beyond_floats(number);
    }
  }

 private:
  template <class Def>
  void try_value(Def& def, const Number& number, double value) {
    SCOPED_TRACE(number.name + " = " + std::to_string(value) + " at " + number.place.to_string());
    number.set(value);
    const std::string in_code = refusal([&] { check::def(def); });
    number.reset();
    Json changed = document_;
    put(changed, number, value);
    const std::string in_file = refusal([&] { parse_scene(changed); });
    if (value == infinity && number.rule.or_infinite) {
      EXPECT_EQ(in_code, "") << "infinity has a meaning in C++";
      EXPECT_NE(in_file, "") << "JSON has no infinity";
      return;
    }
    EXPECT_EQ(in_code.empty(), in_file.empty()) << "C++: " << in_code << "\nfile: " << in_file;
    if (is_in(number, value)) return;
    expect_named(in_code, number.name);
    expect_named(in_file, key_of(number));
    if (!std::isfinite(value)) return;
    for (const std::string& bound :
         printed_bounds(schema_at(schema_, document_, number.place), number.rule)) {
      expect_named(in_code, bound);
      expect_named(in_file, bound);
    }
  }

  /// A file can hold numbers that no member can.
  void try_beyond_floats(const Number& number) {
    for (const double value : {1e39, -1e300, number.is_whole ? 0.5 : 1e300}) {
      SCOPED_TRACE(number.name + " = " + std::to_string(value) + " at " + number.place.to_string());
      Json changed = document_;
      if (number.is_rotation)
        changed[number.place] = {value, 0, 0, 1};
      else
        changed[number.place] = value;
      expect_named(refusal([&] { parse_scene(changed); }), key_of(number));
    }
  }

  /// The last key on the way to a number; behind it are places in lists.
  static std::string key_of(const Number& number) {
    Json::json_pointer place = number.place;
    while (place.back().find_first_not_of("0123456789") == std::string::npos) place.pop_back();
    return place.back();
  }
};

TEST_F(FieldsTest, CodeAndFilesAllowTheSameNumbers) {
  for (std::size_t choice = 0; choice < most_alternatives; ++choice) {
    document_ = complete_scene(schema_, choice);
    Scene scene = parse_scene(document_);
    try_def(scene.world, "/world");
    try_def(scene.fluids.at(0), "/fluids/0");
    try_def(scene.granulars.at(0), "/granulars/0");
    try_def(scene.shapes.at(0), "/shapes/0");
    try_def(scene.bodies.at(0).def, "/bodies/0");
    try_def(scene.joints.at(0).def, "/joints/0");
    try_def(scene.cloths.at(0), "/cloths/0");
    try_def(scene.ropes.at(0), "/ropes/0");
    try_def(scene.wind.value(), "/wind");
    try_def(scene.volumes.at(0).def, "/volumes/0");
    try_def(scene.emitters.at(0).def, "/emitters/0");
    try_def(scene.sinks.at(0).def, "/sinks/0");
    try_def(scene.probes.at(0).def, "/probes/0");
    try_def(scene.force_fields.at(0), "/force_fields/0");
    AttachmentDef& attachment = scene.attachments.at(0).def;
    attachment.cloth = ClothId{};  // as in the file, where they are names
    attachment.body = BodyId{};
    try_def(attachment, "/attachments/0");
  }
  EXPECT_GT(done_.size(), 150u);
}

/// What no scene has.
TEST_F(FieldsTest, ASurfaceMeshIsChecked) {
  SurfaceMeshDef def;
  for (const Number& number : numbers_of(def, "")) {
    for (const double value : trials(number)) {
      number.set(value);
      EXPECT_EQ(refusal([&] { check::def(def); }).empty(), is_in(number, value)) << number.name << value;
      number.reset();
    }
  }
}

template <class... Defs>
void expect_taken(const Defs&... defs) {
  const auto expect = [](const auto& def) { EXPECT_EQ(refusal([&] { check::def(def); }), ""); };
  (expect(defs), ...);
}

TEST(FieldDefaults, AreAllowed) {
  expect_taken(WorldDef{}, DensitySolverDef{}, ArtificialPressureDef{}, RigidSolverDef{}, ClothSolverDef{},
               DiffuseDef{}, FluidDef{}, GranularDef{}, SurfaceMeshDef{}, FluidVolumeDef{}, ShapeDef{},
               SurfaceDef{}, BodyDef{}, Keyframe{}, JointDef{}, ClothDef{}, FabricDef{}, InflationDef{},
               WindDef{}, EmitterDef{}, SinkDef{}, ProbeDef{}, ForceFieldDef{});
  expect_taken(UniformForce{}, RadialForce{}, VortexForce{}, DragForce{}, NoiseForce{}, GridForce{});
  expect_taken(PlaneGeometry{}, BoxGeometry{}, ContainerGeometry{}, Opening{}, SphereGeometry{},
               CapsuleGeometry{}, CylinderGeometry{}, MeshGeometry{}, CompoundPart{});
  expect_taken(FixedJoint{}, HingeJoint{}, SliderJoint{}, BallJoint{}, SpringJoint{});
  expect_taken(BoxRegion{}, BallRegion{}, MeshRegion{}, HalfSpaceRegion{}, DiscOpening{}, RectangleOpening{},
               MeshOpening{});
  expect_taken(SheetGeometry{}, ClothFile{}, ClothSphere{}, ClothTube{});
}

/// Those that are nothing without content, with the least of it.
TEST(FieldDefaults, AreAllowedWithContent) {
  const std::vector<Vec3> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  HeightFieldGeometry heights;
  heights.columns = heights.rows = 2;
  heights.heights = {0, 0, 0, 0};
  RopeDef rope;
  rope.points = {corners[0], corners[1]};
  AttachmentDef attachment;
  attachment.cloth = ClothId{};
  attachment.vertices = {0};
  expect_taken(heights, HullGeometry{corners}, CompoundGeometry{{CompoundPart{}}},
               ClothTriangles{corners, {0, 1, 2}}, rope, attachment);
  expect_taken(DrivenFiles{.files = "a_%d.obj"}, MotionFile{.file = "a.usda"},
               DrivenTriangles{{0, 1, 2}, {{0, corners}}, false});
}

TEST(FieldNames, AreThoseOfTheStructs) {
  EXPECT_EQ(type_name<FluidDef>(), "FluidDef");
  EXPECT_EQ(type_name<BoxGeometry>(), "BoxGeometry");
  EXPECT_EQ(type_name<float>(), "float");
}

}  // namespace
}  // namespace meniscus::tests
