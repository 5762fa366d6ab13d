// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Emitters and sinks in scene files.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "sdk/scene/scene_file.h"

namespace meniscus {
namespace {

nlohmann::json good_scene() {
  return nlohmann::json::parse(R"({
    "name": "x",
    "fluids": [{"name": "oil"}, {"name": "water"}],
    "bodies": [{"name": "cart", "geometry": {"type": "box"}, "pose": {"position": [9, 0, 0]}}],
    "emitters": [
      {"name": "tap", "fluid": "water", "opening": {"type": "disc", "radius": 0.2}, "speed": 3, "rate": 0.01,
       "start": 1, "stop": 2, "most_particles": 70, "body": "cart", "pose": {"position": [1, 2, 3]}},
      {"name": "slot", "fluid": "oil", "opening": {"type": "rectangle", "width": 0.4, "depth": 0.1}}],
    "sinks": [
      {"name": "hole", "region": {"type": "ball", "radius": 0.3}, "body": "cart", "pose": {"position": [0, 1, 0]}},
      {"name": "edge", "region": {"type": "half_space", "normal": [0, 2, 0], "offset": -1}},
      {"name": "room", "region": {"type": "box", "lower": [-1, -2, -3], "upper": [4, 5, 6]}, "outside": true}]
  })");
}

TEST(SceneFlow, EveryKeyArrives) {
  const Scene scene = parse_scene(good_scene());
  ASSERT_EQ(scene.emitters.size(), 2u);
  const EmitterDef& tap = scene.emitters[0].def;
  EXPECT_EQ(tap.name, "tap");
  EXPECT_EQ(scene.emitters[0].fluid, "water");
  EXPECT_EQ(scene.emitters[0].body, "cart");
  EXPECT_FLOAT_EQ(std::get<DiscOpening>(tap.opening).radius, 0.2f);
  EXPECT_FLOAT_EQ(tap.speed, 3);
  EXPECT_FLOAT_EQ(tap.rate, 0.01f);
  EXPECT_FLOAT_EQ(tap.start, 1);
  EXPECT_FLOAT_EQ(tap.stop, 2);
  EXPECT_EQ(tap.most_particles, 70u);
  EXPECT_FLOAT_EQ(tap.pose.position.z, 3);
  const EmitterDef& slot = scene.emitters[1].def;
  EXPECT_FLOAT_EQ(std::get<RectangleOpening>(slot.opening).width, 0.4f);
  EXPECT_FLOAT_EQ(std::get<RectangleOpening>(slot.opening).depth, 0.1f);
  EXPECT_TRUE(std::isinf(slot.stop));
  EXPECT_FALSE(slot.most_particles);
  ASSERT_EQ(scene.sinks.size(), 3u);
  EXPECT_FLOAT_EQ(std::get<BallRegion>(scene.sinks[0].def.region).radius, 0.3f);
  EXPECT_EQ(scene.sinks[0].body, "cart");
  EXPECT_FLOAT_EQ(scene.sinks[0].def.pose.position.y, 1);
  EXPECT_FLOAT_EQ(std::get<HalfSpaceRegion>(scene.sinks[1].def.region).offset, -1);
  EXPECT_FLOAT_EQ(std::get<BoxRegion>(scene.sinks[2].def.region).upper.z, 6);
  EXPECT_TRUE(scene.sinks[2].def.outside);
}

TEST(SceneFlow, ABuiltSceneFlows) {
  nlohmann::json document = good_scene();
  document["emitters"][0].erase("start");
  document["sinks"] = nlohmann::json::array();
  document["world"] = {{"device", "cpu"}, {"gravity", {0, 0, 0}}};
  BuiltScene built = build_scene(parse_scene(document));
  ASSERT_EQ(built.emitters.size(), 2u);
  for (int k = 0; k < 30; ++k) built.world.step(0.016f);
  EXPECT_GT(built.world.emitter_count(built.emitters[0]).total, 10u);
  EXPECT_GT(built.world.emitter_count(built.emitters[1]).total, 50u);
  for (std::size_t i = 0; i < built.world.particle_count(); ++i) {
    const bool at_the_cart = built.world.positions()[i].x > 5;
    EXPECT_EQ(built.world.fluids()[i], built.fluids[at_the_cart ? 1 : 0].index);
  }
}

struct Mistake {
  const char* name;
  const char* pointer;  ///< into the document above
  const char* value;    ///< to put there; null takes away what is there
  const char* message;
};

class SceneFlowMistake : public testing::TestWithParam<Mistake> {};

TEST_P(SceneFlowMistake, IsNamed) {
  nlohmann::json document = good_scene();
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

INSTANTIATE_TEST_SUITE_P(
    On, SceneFlowMistake,
    testing::Values(
        Mistake{"NoOpening", "/emitters/0/opening", nullptr,
                "emitters[0].opening: missing, and needed: where particles leave from"},
        Mistake{"Opening", "/emitters/0/opening/type", R"("disk")",
                R"(emitters[0].opening.type: "disk" is not known; did you mean "disc"?)"},
        Mistake{"Speed", "/emitters/0/speed", "0",
                "emitters[0].speed: 0 is not allowed; must be greater than 0"},
        Mistake{"Stop", "/emitters/0/stop", "0.5", "emitters[0]: stop must not be below start"},
        Mistake{"Most", "/emitters/0/most_particles", "2.5",
                "emitters[0].most_particles: 2.5 is not allowed; must be a whole number"},
        Mistake{"NoSuchBody", "/emitters/0/body", R"("card")",
                R"(emitters[0].body: there is no body named "card"; did you mean "cart"?)"},
        Mistake{"NoSuchFluid", "/emitters/1/fluid", R"("oill")",
                R"(emitters[1].fluid: there is no fluid named "oill"; did you mean "oil"?)"},
        Mistake{"Twice", "/emitters/1/name", R"("tap")",
                R"(emitters[1].name: "tap" is the name of emitters[0] already)"},
        Mistake{"SinkRegion", "/sinks/0/region", nullptr,
                "sinks[0].region: missing, and needed: particles inside are removed at the end of a frame"},
        Mistake{"SinkBody", "/sinks/0/body", R"("car")",
                R"(sinks[0].body: there is no body named "car"; did you mean "cart"?)"},
        Mistake{"Normal", "/sinks/1/region/normal", "[0, 0, 0]",
                "sinks[1].region: normal must be of a length from 1e-6 to 1e18"}),
    [](const testing::TestParamInfo<Mistake>& p) { return std::string(p.param.name); });

}  // namespace
}  // namespace meniscus
