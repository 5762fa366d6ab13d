// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Invalid cloth, ropes, attachments and wind are refused, and the world does not change.
#include <gtest/gtest.h>

#include "tests/cloth_worlds.h"
#include "tests/unit/sdk/world/solids/body_worlds.h"

namespace meniscus::tests {
namespace {

constexpr ErrorCode invalid = ErrorCode::invalid_argument;

/// A world with cloth in it, and a twin that is not asked for anything wrong.
class ClothErrorTest : public OnDevice {
 protected:
  struct Parts {
    World world;
    ClothId cloth;
    RopeId rope, rod;
    BodyId body;
  };
  TemporaryFolder folder_;
  Parts tried_ = make(), twin_ = make();
  World& world_ = tried_.world;

  Parts make() const {
    Parts p{World(world_def(GetParam(), 0.05f)), {}, {}, {}, {}};
    p.cloth = p.world.create_cloth(sheet(0.5f, 0.5f, 4, 4));
    p.rope = p.world.create_rope(rope({{1, 0, 0}, {2, 0, 0}}, 4));
    RopeDef rod = rope({{1, 1, 0}, {2, 1, 0}}, 4);
    rod.bends_and_twists = true;
    p.rod = p.world.create_rope(rod);
    p.body = p.world.create_body(body(BoxGeometry{{0.1f, 0.1f, 0.1f}}, {0, 3, 0}));
    p.world.create_attachment(attach(p.cloth, {0}));
    p.world.step(0.01f);
    return p;
  }

  template <class Call>
  void expect_refused(ErrorCode code, const std::string& named, const Call& call) {
    expect_error(code, named, call);
    EXPECT_EQ(world_.state_hash(), twin_.world.state_hash()) << named;
    EXPECT_EQ(world_.device_bytes(), twin_.world.device_bytes()) << named;
  }
  template <class Change>
  void expect_cloth_refused(const std::string& named, const Change& change, ErrorCode code = invalid) {
    ClothDef def = sheet(1, 1, 3, 3);
    change(def);
    expect_refused(code, named, [&] { world_.create_cloth(def); });
  }
  template <class Change>
  void expect_rope_refused(const std::string& named, const Change& change) {
    RopeDef def = rope({{0, 0, 0}, {0, 1, 0}}, 2);
    change(def);
    expect_refused(invalid, named, [&] { world_.create_rope(def); });
  }
  template <class Change>
  void expect_attachment_refused(const std::string& named, const Change& change, ErrorCode code = invalid) {
    AttachmentDef def = attach(tried_.cloth, {5});
    change(def);
    expect_refused(code, named, [&] { world_.create_attachment(def); });
  }

  /// The next things get the ids that they would have got, and all goes on as in the twin.
  void TearDown() override {
    for (World* world : {&world_, &twin_.world}) {
      const ClothId cloth = world->create_cloth(sheet(1, 1, 3, 3, {5, 0, 0}));
      EXPECT_EQ(cloth.index, 1u);
      EXPECT_EQ(world->create_rope(rope({{7, 0, 0}, {8, 0, 0}}, 2)).index, 2u);
      EXPECT_EQ(world->create_attachment(attach(cloth, {1})).index, 1u);
      run(*world, 5, 0.01f);
    }
    EXPECT_EQ(world_.state_hash(), twin_.world.state_hash());
  }
};

TEST_P(ClothErrorTest, FabricIsChecked) {
  struct Case {
    const char* name;
    float FabricDef::*member;
    bool may_be_infinite, may_be_zero;
    float most = infinity;
  };
  const Case cases[] = {{"FabricDef::density", &FabricDef::density, false, false, 1e4f},
                        {"FabricDef::warp_stiffness", &FabricDef::warp_stiffness, true, true},
                        {"FabricDef::weft_stiffness", &FabricDef::weft_stiffness, true, true},
                        {"FabricDef::shear_stiffness", &FabricDef::shear_stiffness, true, true},
                        {"FabricDef::bending_stiffness", &FabricDef::bending_stiffness, true, true},
                        {"FabricDef::stretch_damping", &FabricDef::stretch_damping, false, true, 1e6f},
                        {"FabricDef::bending_damping", &FabricDef::bending_damping, false, true, 1e6f},
                        {"FabricDef::thickness", &FabricDef::thickness, false, true, 1e3f},
                        {"FabricDef::friction", &FabricDef::friction, false, true},
                        {"FabricDef::drag", &FabricDef::drag, false, true},
                        {"FabricDef::lift", &FabricDef::lift, false, true},
                        {"FabricDef::tear_strain", &FabricDef::tear_strain, false, true}};
  for (const Case& c : cases) {
    const auto refused = [&](float value, const std::string& text) {
      expect_cloth_refused(std::string(c.name) + " is " + text,
                           [&](ClothDef& d) { d.fabric.*c.member = value; });
    };
    refused(-1, "-1");
    refused(-infinity, "-inf");
    refused(not_a_number, "nan");
    if (!c.may_be_infinite) refused(infinity, "inf");
    if (!c.may_be_zero) refused(0, "0");
    if (c.most < infinity) refused(1e20f, "1e+20");
  }
}

TEST_P(ClothErrorTest, ModelsAndColoursAreChecked) {
  expect_cloth_refused("FabricDef::stretch_model is 2",
                       [](ClothDef& d) { d.fabric.stretch_model = static_cast<StretchModel>(2); });
  expect_cloth_refused("FabricDef::bending_model is -1",
                       [](ClothDef& d) { d.fabric.bending_model = static_cast<BendingModel>(-1); });
  for (float bad : {-0.1f, 1.1f, not_a_number}) {
    expect_cloth_refused("ClothDef::color", [&](ClothDef& d) { d.color.x = bad; });
    expect_rope_refused("RopeDef::color", [&](RopeDef& d) { d.color.z = bad; });
  }
}

TEST_P(ClothErrorTest, SheetsSpheresAndTubesAreChecked) {
  const auto refused = [&](const std::string& named, const ClothGeometry& geometry) {
    expect_cloth_refused(named, [&](ClothDef& d) { d.geometry = geometry; });
  };
  for (float bad : {0.0f, -1.0f, infinity, not_a_number}) {
    refused("SheetGeometry::width", SheetGeometry{bad, 1, 2, 2});
    refused("SheetGeometry::depth", SheetGeometry{1, bad, 2, 2});
    refused("ClothSphere::radius", ClothSphere{bad, 2});
    refused("ClothTube::top_radius", ClothTube{bad, 1, 1, 8, 3});
    refused("ClothTube::bottom_radius", ClothTube{1, bad, 1, 8, 3});
    refused("ClothTube::height", ClothTube{1, 1, bad, 8, 3});
    refused("ClothFile::scale", ClothFile{folder_.write("brick.obj", brick_obj), bad});
  }
  for (int bad : {1, 0, -5, 2000000}) {
    refused("SheetGeometry::columns is " + std::to_string(bad), SheetGeometry{1, 1, bad, 2});
    refused("SheetGeometry::rows is " + std::to_string(bad), SheetGeometry{1, 1, 2, bad});
    refused("ClothTube::rows is " + std::to_string(bad), ClothTube{1, 1, 1, 8, bad});
  }
  refused("ClothTube::columns is 2", ClothTube{1, 1, 1, 2, 3});
  refused("ClothSphere::divisions is 0", ClothSphere{1, 0});
  refused("ClothSphere::divisions is 501", ClothSphere{1, 501});
}

TEST_P(ClothErrorTest, TrianglesMustBeASurface) {
  const std::vector<Vec3> square{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {1, 0, 1}};
  const auto refused = [&](ErrorCode code, const std::string& named, std::vector<Vec3> vertices,
                           std::vector<uint32_t> triangles) {
    expect_cloth_refused(
        named,
        [&](ClothDef& d) {
          d.geometry = ClothTriangles{vertices, triangles};
        },
        code);
  };
  refused(invalid, "ClothTriangles::triangles is empty; it must be of at least 3 items", square, {});
  refused(invalid, "ClothTriangles::triangles is a list of 4", square, {0, 1, 2, 3});
  refused(ErrorCode::mesh, "has the vertex 4", square, {0, 1, 2, 1, 3, 4});
  refused(ErrorCode::mesh, "vertex 3 of a cloth mesh is in no triangle", square, {0, 1, 2});
  refused(ErrorCode::mesh, "triangle 1 of a cloth mesh has no area", square, {0, 1, 2, 3, 3, 1});
  refused(ErrorCode::mesh, "triangle", square, {0, 1, 2, 0, 1, 3, 0, 1, 2});
  std::vector<Vec3> bad = square;
  bad[2].y = not_a_number;
  refused(invalid, "ClothTriangles::vertices[2] is (0, nan, 1)", bad, {0, 1, 2, 1, 3, 2});
  refused(invalid, "ClothTriangles::vertices is empty", {}, {0, 1, 2});
}

TEST_P(ClothErrorTest, FilesMustBeThere) {
  expect_cloth_refused(
      "missing.obj",
      [&](ClothDef& d) {
        d.geometry = ClothFile{folder_.missing(), 1};
      },
      ErrorCode::io);
}

TEST_P(ClothErrorTest, PlacementIsChecked) {
  expect_cloth_refused("ClothDef::pose", [](ClothDef& d) { d.pose.position.x = not_a_number; });
  expect_cloth_refused("ClothDef::pose", [](ClothDef& d) { d.pose.rotation = {1, 1, 0, 0}; });
  expect_cloth_refused("ClothDef::stretch is (0, 1, 1)", [](ClothDef& d) { d.stretch = {0, 1, 1}; });
  expect_cloth_refused("ClothDef::stretch is (1, -1, 1)", [](ClothDef& d) { d.stretch = {1, -1, 1}; });
  expect_cloth_refused("ClothDef::stretch is (1, 1, inf)", [](ClothDef& d) { d.stretch = {1, 1, infinity}; });
  expect_cloth_refused("ClothDef::velocity is (inf, 0, 0)", [](ClothDef& d) {
    d.velocity = {infinity, 0, 0};
  });
}

TEST_P(ClothErrorTest, GasNeedsASkinAroundIt) {
  const auto refused = [&](const std::string& named, InflationDef gas, const ClothGeometry& geometry,
                           ErrorCode code) {
    expect_cloth_refused(
        named,
        [&](ClothDef& d) {
          d.geometry = geometry;
          d.inflation = gas;
        },
        code);
  };
  const ClothSphere ball{1, 2};
  refused("border", {}, SheetGeometry{}, ErrorCode::mesh);
  refused("border", {}, ClothTube{}, ErrorCode::mesh);
  for (float bad : {0.0f, -1.0f, infinity, not_a_number})
    refused("InflationDef::air_pressure", {0, bad}, ball, invalid);
  for (float bad : {infinity, -infinity, not_a_number, -101325.0f, -2e5f})
    refused("InflationDef::pressure", {bad, 101325}, ball, invalid);
}

TEST_P(ClothErrorTest, RopesAreChecked) {
  expect_rope_refused("RopeDef::points is empty; it must be of at least 2 items",
                      [](RopeDef& d) { d.points.clear(); });
  expect_rope_refused("RopeDef::points is a list of 1", [](RopeDef& d) { d.points.pop_back(); });
  expect_rope_refused("at least 3", [](RopeDef& d) { d.closed = true; });
  expect_rope_refused("RopeDef::points", [](RopeDef& d) { d.points[1].z = not_a_number; });
  expect_rope_refused("of a rope coincide", [](RopeDef& d) { d.points[1] = d.points[0]; });
  expect_rope_refused("of a rope coincide", [](RopeDef& d) {
    d.points[1] = d.points[0];
    d.segments = 0;
  });
  expect_rope_refused("of a rod coincide", [](RopeDef& d) {
    d.points[1] = d.points[0];
    d.bends_and_twists = true;
  });
  expect_rope_refused("RopeDef::segments is -1", [](RopeDef& d) { d.segments = -1; });
  expect_rope_refused("RopeDef::segments is 1000001", [](RopeDef& d) { d.segments = 1000001; });
  expect_rope_refused("RopeDef::pose", [](RopeDef& d) { d.pose.rotation = {0, 0, 0, 0}; });
  expect_rope_refused("RopeDef::velocity", [](RopeDef& d) { d.velocity.y = infinity; });
  for (float bad : {0.0f, -1.0f, 1e-20f, 1e20f, infinity, not_a_number}) {
    expect_rope_refused("RopeDef::radius", [&](RopeDef& d) { d.radius = bad; });
    expect_rope_refused("RopeDef::density", [&](RopeDef& d) { d.density = bad; });
  }
  for (float bad : {0.0f, -1.0f, 1e-20f, not_a_number}) {
    expect_rope_refused("RopeDef::youngs_modulus", [&](RopeDef& d) { d.youngs_modulus = bad; });
    expect_rope_refused("RopeDef::shear_modulus", [&](RopeDef& d) { d.shear_modulus = bad; });
  }
  expect_rope_refused("RopeDef::shear_modulus is inf", [](RopeDef& d) { d.shear_modulus = infinity; });
  for (float bad : {-1.0f, infinity, not_a_number})
    expect_rope_refused("RopeDef::damping", [&](RopeDef& d) { d.damping = bad; });
}

TEST_P(ClothErrorTest, AttachmentsAreChecked) {
  expect_attachment_refused("exactly one of cloth and rope", [](AttachmentDef& d) { d.cloth.reset(); });
  expect_attachment_refused("exactly one of cloth and rope", [&](AttachmentDef& d) { d.rope = tried_.rope; });
  expect_attachment_refused("at most one of body, other_cloth and other_rope", [&](AttachmentDef& d) {
    d.body = tried_.body;
    d.other_rope = tried_.rope;
  });
  expect_attachment_refused("vertices or a region", [](AttachmentDef& d) { d.vertices.clear(); });
  expect_attachment_refused("AttachmentDef::vertices is 16", [](AttachmentDef& d) { d.vertices = {3, 16}; });
  expect_attachment_refused("AttachmentDef::region", [](AttachmentDef& d) {
    d.region = Aabb{{1, 0, 0}, {0, 1, 1}};
  });
  expect_attachment_refused("AttachmentDef::region", [](AttachmentDef& d) {
    d.region = Aabb{{0, 0, 0}, {not_a_number, 1, 1}};
  });
  expect_attachment_refused("holds no vertex", [](AttachmentDef& d) {
    d.vertices.clear();
    d.region = Aabb{{8, 8, 8}, {9, 9, 9}};
  });
  for (float bad : {0.0f, -1.0f, infinity, not_a_number})
    expect_attachment_refused("AttachmentDef::reach", [&](AttachmentDef& d) { d.reach = bad; });
  for (float bad : {-1.0f, infinity, not_a_number})
    expect_attachment_refused("AttachmentDef::compliance", [&](AttachmentDef& d) { d.compliance = bad; });
  expect_attachment_refused("no vertex of the other piece is as near",
                            [&](AttachmentDef& d) { d.other_rope = tried_.rope; });
  expect_attachment_refused("no other vertex of the same piece is as near", [&](AttachmentDef& d) {
    d.other_cloth = d.cloth;
    d.reach = 1e-4f;
  });
  expect_attachment_refused("clamped is for rods alone", [](AttachmentDef& d) { d.clamped = true; });
  const auto clamps = [&](RopeId id) {
    return [id](AttachmentDef& d) {
      d.cloth.reset();
      d.rope = id;
      d.vertices = {0, 1};
      d.clamped = true;
    };
  };
  expect_attachment_refused("clamped is for rods alone", clamps(tried_.rope));
  expect_attachment_refused("to the world alone", [&](AttachmentDef& d) {
    clamps(tried_.rod)(d);
    d.body = tried_.body;
  });
}

TEST_P(ClothErrorTest, AttachmentsNameWhatIsNotThere) {
  const auto unknown = [&](const std::string& named, const auto& change) {
    expect_attachment_refused(named, change, ErrorCode::not_found);
  };
  unknown("no cloth", [](AttachmentDef& d) { d.cloth = ClothId{}; });
  unknown("no body", [](AttachmentDef& d) { d.body = BodyId{}; });
  unknown("no cloth", [](AttachmentDef& d) { d.other_cloth = ClothId{}; });
  unknown("no rope", [](AttachmentDef& d) { d.other_rope = RopeId{}; });
  unknown("no rope", [](AttachmentDef& d) {
    d.cloth.reset();
    d.rope = RopeId{};
  });
}

TEST_P(ClothErrorTest, WindIsChecked) {
  const auto refused = [&](const std::string& named, const WindDef& wind) {
    expect_refused(invalid, named, [&] { world_.set_wind(wind); });
  };
  refused("WindDef::velocity is (nan, 0, 0)", {.velocity = {not_a_number, 0, 0}});
  for (float bad : {-1.0f, infinity, not_a_number}) {
    refused("WindDef::air_density", {.air_density = bad});
    refused("WindDef::gust_speed", {.gust_speed = bad});
  }
  refused("WindDef::gust_speed", {.gust_speed = 1e20f});
  for (float bad : {0.0f, -1.0f, infinity, not_a_number}) refused("WindDef::gust_size", {.gust_size = bad});
}

TEST_P(ClothErrorTest, TheSolverIsChecked) {
  for (float bad : {0.9f, 1.31f, -infinity, not_a_number}) {
    WorldDef def = world_def(GetParam(), 0.05f);
    def.cloth.over_relaxation = bad;
    expect_error(invalid, "ClothSolverDef::over_relaxation", [&] { World world(def); });
  }
  for (float bad : {-0.1f, 0.96f, infinity, not_a_number}) {
    WorldDef def = world_def(GetParam(), 0.05f);
    def.cloth.warm_start = bad;
    expect_error(invalid, "ClothSolverDef::warm_start", [&] { World world(def); });
  }
  for (int bad : {0, -1, 33}) {
    WorldDef def = world_def(GetParam(), 0.05f);
    def.cloth.stretch_rounds = bad;
    expect_error(invalid, "ClothSolverDef::stretch_rounds", [&] { World world(def); });
  }
}

MENISCUS_ON_EACH_DEVICE(ClothErrorTest);

}  // namespace
}  // namespace meniscus::tests
