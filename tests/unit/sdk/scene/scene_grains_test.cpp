// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Granular materials in scene files.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "pbd/math/vec.h"
#include "sdk/scene/scene_file.h"
#include "tests/expect_error.h"

namespace meniscus {
namespace {

constexpr const char* text = R"({
  "name": "wet sand",
  "world": {"device": "cpu", "particle_spacing": 0.1},
  "fluids": [{"name": "water"}],
  "granulars": [{"name": "gravel"}, {"name": "sand", "density": 1700, "friction": 0.4, "color": [1, 0.5, 0]}],
  "volumes": [
    {"fluid": "sand", "region": {"type": "box", "lower": [0, 0, 0], "upper": [1, 0.5, 1]}},
    {"fluid": "water", "region": {"type": "box", "lower": [0, 1, 0], "upper": [1, 1.5, 1]}}
  ]
})";

TEST(SceneGrains, AreMadeBehindTheFluids) {
  const Scene scene = parse_scene(nlohmann::json::parse(text));
  ASSERT_EQ(scene.granulars.size(), 2u);
  EXPECT_EQ(scene.granulars[1].density, 1700);
  EXPECT_EQ(scene.granulars[1].friction, 0.4f);
  EXPECT_EQ(scene.granulars[1].color, (Vec3{1, 0.5f, 0}));
  const BuiltScene built = build_scene(scene);
  ASSERT_EQ(built.fluids.size(), 3u);
  ASSERT_EQ(built.world.particle_count(), 1000u);
  EXPECT_EQ(built.world.fluids().front(), built.fluids[2].index);
  EXPECT_EQ(built.world.fluids().back(), built.fluids[0].index);
  EXPECT_NEAR(built.world.particle_mass(built.fluids[2]), 1.7f, 1e-5f);
}

TEST(SceneGrains, AreNotCalledAsAFluidIs) {
  tests::expect_error(ErrorCode::parse, R"(granulars[0].name: "water" is the name of fluids[0] already)", [] {
    parse_scene(nlohmann::json::parse(R"({"name": "x", "fluids": [{}], "granulars": [{"name": "water"}]})"));
  });
}

}  // namespace
}  // namespace meniscus
