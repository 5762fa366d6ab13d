// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A world says what its user probably does not intend.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/cloth_worlds.h"
#include "tests/worlds.h"

namespace meniscus::tests {
namespace {

class WarningsTest : public OnDevice {
 protected:
  World world_{world_def(GetParam(), 0.05f)};
  FluidId water_ = world_.create_fluid({});

  /// The warnings in which `part` occurs.
  std::vector<std::string> with(const std::string& part) const {
    std::vector<std::string> found = world_.warnings();
    std::erase_if(found, [&](const std::string& w) { return w.find(part) == std::string::npos; });
    return found;
  }

  BodyId add_box(const char* name, Vec3 position, float damping = 0) {
    BodyDef def;
    def.name = name;
    def.geometry = BoxGeometry{{0.1f, 0.1f, 0.1f}};
    def.pose.position = position;
    def.linear_damping = damping;
    return world_.create_body(def);
  }
};

TEST_P(WarningsTest, ThereAreNoneWhereAllIsWell) {
  world_.create_shape(tank({-0.4f, 0, -0.4f}, {0.4f, 2, 0.4f}));
  world_.create_shape(shape(PlaneGeometry{}));
  world_.add_fluid(block(water_, {-0.4f, 0, -0.4f}, {0.4f, 0.2f, 0.4f}));
  for (float y : {0.5f, 0.7f, 0.9f}) add_box("crate", {0, y, 0});  // stacked without a gap
  const ClothId sheet_id = world_.create_cloth(sheet(0.5f, 0.5f, 5, 5, {0, 1.5f, 0}));
  world_.create_attachment(attach(sheet_id, {0, 4}));
  EXPECT_EQ(world_.warnings(), std::vector<std::string>{});
  run(world_, 5, 0.01f);
  EXPECT_EQ(world_.warnings(), std::vector<std::string>{});
}

TEST_P(WarningsTest, OverlapsAreCounted) {
  add_box("left", {0, 1, 0});
  add_box("right", {0.15f, 1, 0});
  add_box("upper", {0, 1.19f, 0});
  world_.create_shape(shape(BoxGeometry{{0.2f, 0.2f, 0.2f}}, {3, 0, 0}));
  const std::vector<Vec3> inside{{3, 0.1f, 0}, {3, 0, 0}}, outside{{3, 1, 0}};
  world_.add_particles(water_, inside);
  world_.add_particles(water_, outside);
  ClothDef veil = sheet(0.2f, 0.2f, 3, 3, {3, 0.15f, 0});
  veil.name = "veil";
  world_.create_cloth(veil);
  const auto solids = with("of solids overlap");
  ASSERT_EQ(solids.size(), 1u);
  EXPECT_NE(solids[0].find("3 pairs"), std::string::npos) << solids[0];  // left and upper meet right
  EXPECT_NE(solids[0].find("deepest by 0.05 m"), std::string::npos) << solids[0];
  EXPECT_NE(solids[0].find("\"left\" and the body \"right\""), std::string::npos) << solids[0];
  const auto points = with("inside of solids");
  ASSERT_EQ(points.size(), 2u);
  EXPECT_EQ(points[0], "2 of the particles of fluid 0 are inside of solids, the deepest by 0.2 m");
  EXPECT_EQ(points[1], "9 of the vertices of the cloth \"veil\" are inside of solids, the deepest by 0.05 m");
}

TEST_P(WarningsTest, ClothAndBodiesBesideAContainerAreNamed) {
  ShapeDef vessel = tank({-1, 0, -1}, {1, 2, 1});
  vessel.name = "vessel";
  world_.create_shape(vessel);
  add_box("within", {0, 1, 0});
  add_box("beside", {3, 1, 0});
  ClothDef flag = sheet(0.2f, 0.2f, 3, 3, {0, 3, 0});
  flag.name = "flag";
  world_.create_cloth(flag);
  const auto found = with("outside of the container \"vessel\"");
  ASSERT_EQ(found.size(), 2u);
  EXPECT_NE(found[0].find("the cloth \"flag\""), std::string::npos) << found[0];
  EXPECT_NE(found[1].find("the body \"beside\""), std::string::npos) << found[1];
}

TEST_P(WarningsTest, BodiesAboveAnOpenContainerAreInside) {
  ShapeDef vessel = tank({-1, 0, -1}, {1, 2, 1});
  ContainerGeometry& inside = std::get<ContainerGeometry>(vessel.geometry);
  inside.openings = {{Face::y_high, {}}, {Face::x_high, Aabb{{0, -0.5f, -0.5f}, {0, 0.5f, 0.5f}}}};
  world_.create_shape(vessel);
  add_box("above", {0, 5, 0});
  add_box("before the hole", {3, 1, 0});
  EXPECT_TRUE(with("outside of the container").empty());
  add_box("below", {0, -1, 0});
  add_box("beside the hole", {3, 1, 0.8f});
  EXPECT_EQ(with("outside of the container").size(), 2u);
}

TEST_P(WarningsTest, DragOnFreeFallIsNamed) {
  add_box("feather", {0, 1, 0}, 0.5f);
  add_box("stone", {2, 1, 0});
  ClothDef flag = sheet(0.2f, 0.2f, 3, 3, {0, 3, 0});
  flag.name = "flag";
  const ClothId id = world_.create_cloth(flag);
  auto found = with("does not fall freely");
  ASSERT_EQ(found.size(), 2u);
  EXPECT_NE(found[0].find("\"feather\""), std::string::npos) << found[0];
  EXPECT_NE(found[1].find("\"flag\""), std::string::npos) << found[1];
  world_.set_wind({.air_density = 0});
  EXPECT_EQ(with("does not fall freely").size(), 1u);
  world_.set_wind({});
  world_.create_attachment(attach(id, {0}));
  EXPECT_EQ(with("does not fall freely").size(), 1u);
}

TEST_P(WarningsTest, PlacesFarFromTheOriginAreRounded) {
  world_.add_particles(water_, std::vector<Vec3>{{8000, 0, 0}});
  EXPECT_TRUE(with("rounded").empty());
  world_.add_particles(water_, std::vector<Vec3>{{0, 0, 9000}});
  ASSERT_EQ(with("rounded").size(), 1u);
  EXPECT_NE(with("rounded")[0].find("9e+03 m from WorldDef::origin"), std::string::npos)
      << with("rounded")[0];
}

MENISCUS_ON_EACH_DEVICE(WarningsTest);

}  // namespace
}  // namespace meniscus::tests
