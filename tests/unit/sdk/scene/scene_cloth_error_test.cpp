// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Errors about cloth and ropes in scene files, and their messages.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "sdk/scene/scene_file.h"

namespace meniscus {
namespace {

struct Mistake {
  const char* name;
  const char* pointer;  ///< into the document below
  const char* value;    ///< to put there; null takes away what is there
  const char* message;
};

void PrintTo(const Mistake& mistake, std::ostream* out) {
  *out << mistake.pointer << " = " << (mistake.value ? mistake.value : "nothing");
}

nlohmann::json good_scene() {
  return nlohmann::json::parse(R"({
    "name": "x",
    "bodies": [{"name": "bar", "geometry": {"type": "box"}}],
    "cloths": [{"name": "flag", "geometry": {"type": "sheet"}, "fabric": {}},
               {"name": "balloon", "geometry": {"type": "sphere"}, "inflation": {}},
               {"name": "rag", "geometry": {"type": "triangles", "vertices": [[0, 0, 0], [1, 0, 0], [0, 0, 1]],
                                            "triangles": [0, 2, 1]}}],
    "ropes": [{"name": "line", "points": [[0, 0, 0], [1, 0, 0]]}],
    "attachments": [{"name": "hoist", "cloth": "flag", "vertices": [0]}],
    "wind": {}
  })");
}

class SceneClothMistake : public testing::TestWithParam<Mistake> {};

TEST_P(SceneClothMistake, IsNamed) {
  nlohmann::json document = good_scene();
  ASSERT_NO_THROW(parse_scene(document));
  const nlohmann::json::json_pointer at(GetParam().pointer);
  if (GetParam().value) {
    document[at] = nlohmann::json::parse(GetParam().value);
  } else {
    document.at(at.parent_pointer()).erase(at.back());
  }
  try {
    parse_scene(document, "scene.json");
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::parse);
    EXPECT_EQ(error.what(), std::string("scene.json: ") + GetParam().message);
  }
}

std::string mistake_name(const testing::TestParamInfo<Mistake>& info) {
  return info.param.name;
}

INSTANTIATE_TEST_SUITE_P(
    Cloth, SceneClothMistake,
    testing::Values(
        Mistake{
            "UnknownKey", "/cloths/0/fabric/grain", "1",
            R"(cloths[0].fabric.grain: unknown key; allowed: "density", "stretch_model", "warp_stiffness", )"
            R"("weft_stiffness", "shear_stiffness", "bending_model", "bending_stiffness", "unyielding", )"
            R"("stretch_damping", "bending_damping", "thickness", "friction", "fluid_friction", )"
            R"("fluid_adhesion", "slip_length", "permittivity", "absorbency", "retention", "drainage", "drag", )"
            R"("lift", "tear_strain")"},
        Mistake{"NegativeSlip", "/cloths/0/fabric/slip_length", "-0.1",
                "cloths[0].fabric.slip_length: -0.1 is not allowed; must be at least 0"},
        Mistake{"Misspelt", "/cloths/0/fabric/warp_stifness", "1",
                R"(cloths[0].fabric.warp_stifness: unknown key; did you mean "warp_stiffness"?)"},
        Mistake{"NoWeight", "/cloths/0/fabric/density", "0",
                "cloths[0].fabric.density: 0 is not allowed; must be at least 1e-06 and at most 10000"},
        Mistake{"NegativeStiffness", "/cloths/0/fabric/shear_stiffness", "-1",
                "cloths[0].fabric.shear_stiffness: -1 is not allowed; must be at least 0"},
        Mistake{
            "UnknownModel", "/cloths/0/fabric/bending_model", R"("quadratic")",
            R"(cloths[0].fabric.bending_model: "quadratic" is not known; allowed: "isometric", "dihedral")"},
        Mistake{"UnknownStiffness", "/cloths/0/fabric/unyielding", R"(["warp", "wept"])",
                R"(cloths[0].fabric.unyielding[1]: "wept" is not known; did you mean "weft"?)"},
        Mistake{"NoGeometry", "/cloths/0/geometry", nullptr,
                "cloths[0].geometry: missing, and needed: its shape at rest"},
        Mistake{
            "UnknownGeometry", "/cloths/0/geometry/type", R"("box")",
            R"(cloths[0].geometry.type: "box" is not known; allowed: "sheet", "mesh", "triangles", "sphere", )"
            R"("tube", "driven_triangles", "driven_files")"},
        Mistake{"OneColumn", "/cloths/0/geometry/columns", "1",
                "cloths[0].geometry.columns: 1 is not allowed; must be at least 2 and at most 10000"},
        Mistake{"HalfATriangle", "/cloths/2/geometry/triangles", "[0, 1, 2, 0]",
                "cloths[2].geometry: triangles must hold three numbers each, but there are 4"},
        Mistake{
            "NegativeVertex", "/cloths/2/geometry/triangles", "[0, 1, -2]",
            "cloths[2].geometry.triangles[2]: -2 is not allowed; must be at least 0 and at most 4294967295"},
        Mistake{"NoDivisions", "/cloths/1/geometry/divisions", "0",
                "cloths[1].geometry.divisions: 0 is not allowed; must be at least 1 and at most 500"},
        Mistake{"MoreThanVacuum", "/cloths/1/inflation/pressure", "-101325",
                "cloths[1].inflation: pressure must be greater than minus the air_pressure"},
        Mistake{"SameName", "/cloths/1/name", R"("flag")",
                R"(cloths[1].name: "flag" is the name of cloths[0] already)"},
        Mistake{"OverRelaxed", "/world/cloth/over_relaxation", "2",
                "world.cloth.over_relaxation: 2 is not allowed; must be at least 1 and at most 1.3"},
        Mistake{"GustsOfNoSize", "/wind/gust_size", "0",
                "wind.gust_size: 0 is not allowed; must be greater than 0"}),
    mistake_name);

INSTANTIATE_TEST_SUITE_P(
    Ropes, SceneClothMistake,
    testing::Values(Mistake{"OnePoint", "/ropes/0/points", "[[0, 0, 0]]",
                            "ropes[0].points: an array of 1 is not allowed; must have at least 2 items"},
                    Mistake{"ClosedOnTwoPoints", "/ropes/0/closed", "true",
                            "ropes[0]: a closed rope needs at least 3 points"},
                    Mistake{"NoRadius", "/ropes/0/radius", "0",
                            "ropes[0].radius: 0 is not allowed; must be at least 1e-06 and at most 1000"}),
    mistake_name);

INSTANTIATE_TEST_SUITE_P(
    Attachments, SceneClothMistake,
    testing::Values(Mistake{"Nothing", "/attachments/0/cloth", nullptr,
                            "attachments[0]: exactly one of cloth and rope is needed"},
                    Mistake{"Both", "/attachments/0/rope", R"("line")",
                            "attachments[0]: exactly one of cloth and rope is needed"},
                    Mistake{"NoVertices", "/attachments/0/vertices", nullptr,
                            "attachments[0]: vertices or a region are needed"},
                    Mistake{"UnknownCloth", "/attachments/0/cloth", R"("flog")",
                            R"(attachments[0].cloth: there is no cloth named "flog"; did you mean "flag"?)"},
                    Mistake{"UnknownBody", "/attachments/0/body", R"("bat")",
                            R"(attachments[0].body: there is no body named "bat"; did you mean "bar"?)"},
                    Mistake{"UnknownRope", "/attachments/0/other_rope", R"("flag")",
                            R"(attachments[0].other_rope: there is no rope named "flag"; allowed: "line")"},
                    Mistake{"NoReach", "/attachments/0/reach", "0",
                            "attachments[0].reach: 0 is not allowed; must be greater than 0"}),
    mistake_name);

TEST(SceneClothMistakes, TwoHoldersAreTooMany) {
  nlohmann::json document = good_scene();
  document["attachments"][0]["body"] = "bar";
  document["attachments"][0]["other_cloth"] = "balloon";
  try {
    parse_scene(document, "scene.json");
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(),
                 "scene.json: attachments[0]: at most one of body, other_cloth and other_rope is allowed");
  }
}

}  // namespace
}  // namespace meniscus
