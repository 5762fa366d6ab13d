// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Driven surfaces: where they are, and what they do to fluid, cloth and bodies.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <tuple>

#include "tests/coupling/body_worlds.h"
#include "tests/coupling/driven_worlds.h"
#include "tests/expect_error.h"
#include "tests/sheet_crossings.h"

namespace meniscus::tests {
namespace {

constexpr float s = 0.05f, dt = 0.016f;

class DrivenSurfaceTest : public OnDevice {
 protected:
  World world_{world_def(GetParam(), s)};

  WorldDef fine_def() const {
    WorldDef def = world_def(GetParam(), s);
    def.substeps = 10;
    return def;
  }
};

TEST_P(DrivenSurfaceTest, IsWhereItsKeyframesSay) {
  const PieceMesh plate = mesh_of(SheetGeometry{0.4f, 0.4f, 3, 3});
  ClothDef def = driven(plate, {0, 1, 0}, {0.3f, 1, 0}, 0.1f, 0.4f);
  auto& motion = std::get<DrivenTriangles>(def.geometry);
  motion.keyframes.push_back({0.7f, moved_by(plate.vertices, {0, 1, 0})});
  motion.loop = true;
  def.pose.position = {0, 0, 2};
  const ClothId id = world_.create_cloth(def);
  for (int k = 1; k <= 70; ++k) {
    world_.step(0.02f);
    double t = world_.time();
    while (t > 0.7) t -= 0.6;
    const double x = t < 0.1 ? 0 : t < 0.4 ? t - 0.1 : 0.7 - t;
    const float v = t < 0.1 + 1e-6 ? 0 : t < 0.4 + 1e-6 ? 1.0f : -1.0f;
    for (size_t n = 0; n < plate.vertices.size(); ++n) {
      const Vec3 expected = plate.vertices[n] + Vec3{static_cast<float>(x), 1, 2};
      EXPECT_LT(length(world_.cloth_positions(id)[n] - expected), 2e-6f) << t;
      const bool turns = std::fabs(t - 0.1) < 1e-3 || std::fabs(t - 0.4) < 1e-3 || t > 0.7 - 1e-3;
      if (turns) continue;
      EXPECT_LT(length(world_.cloth_velocities(id)[n] - Vec3{v, 0, 0}), 1e-3f) << t;
    }
  }
}

constexpr float radius = 0.12f, setting_out = 2 * dt, arrival = 2 * dt + 0.4f;
constexpr Vec3 start{-0.16f, 0.3f, 0.3f}, finish{0.24f, 0.3f, 0.3f};

/// What a ball does to a cube of water in free fall, into which it goes by its diameter at 1 m/s.
struct Push {
  double momentum;  // kg·m/s, along x
  double energy;    // J
  std::size_t particles;
};

Push push_by(World world, const std::function<void(World&)>& add_ball) {
  const FluidId water = world.create_fluid({});
  add_ball(world);
  world.add_fluid(block(water, {0, 0, 0}, {0.6f, 0.6f, 0.6f}));
  run(world, 30, dt);
  return {fluid_momentum(world, water).linear.x, world.diagnostics().kinetic_energy, world.particle_count()};
}

// Analytic ball: 7.00 kg·m/s and 3.41 J. Distance field of the mesh: 6.81. Driven mesh: 6.62 and 3.54.
TEST_P(DrivenSurfaceTest, PushesWaterAsAKinematicBallDoes) {
  WorldDef def = world_def(GetParam(), s);
  def.gravity = {0, 0, 0};
  const Push solid = push_by(World(def), [](World& world) {
    BodyDef ball = kinematic(SphereGeometry{radius}, start);
    ball.keyframes = {{setting_out, {start, {0, 0, 0, 1}}}, {arrival, {finish, {0, 0, 0, 1}}}};
    world.create_body(ball);
  });
  const PieceMesh mesh = mesh_of(ClothSphere{radius, 6});
  const Push surface = push_by(World(def), [&](World& world) {
    world.create_cloth(driven(mesh, start, finish, setting_out, arrival));
  });
  EXPECT_GT(solid.momentum, 5);
  EXPECT_NEAR(surface.momentum, solid.momentum, 0.08 * solid.momentum);
  EXPECT_NEAR(surface.energy, solid.energy, 0.08 * solid.energy);
  EXPECT_EQ(surface.particles, solid.particles);
}

// Seeding leaves out what is inside of a closed surface, as it does inside of a solid.
TEST_P(DrivenSurfaceTest, IsSeededAroundAndNotInside) {
  const PieceMesh mesh = mesh_of(ClothSphere{radius, 6});
  const ClothDef def = driven(mesh, {0.3f, 0.3f, 0.3f}, {0.3f, 0.3f, 0.3f}, 0, 1);
  world_.create_cloth(def);
  const FluidId water = world_.create_fluid({});
  EXPECT_LT(world_.add_fluid(block(water, {0, 0, 0}, {0.6f, 0.6f, 0.6f})), 1728u);
  for (const Vec3 p : world_.positions()) EXPECT_GT(length(p - Vec3{0.3f, 0.3f, 0.3f}), radius);
}

TEST_P(DrivenSurfaceTest, LetsNoWaterThrough) {
  const PieceMesh plate = mesh_of(SheetGeometry{0.3f, 0.3f, 13, 13});
  world_.create_shape(tank({0, 0, 0}, {0.3f, 1, 0.3f}));
  const FluidId water = world_.create_fluid({});
  world_.add_fluid(block(water, {0, 0.05f, 0}, {0.3f, 0.35f, 0.3f}));
  const ClothId id =
      world_.create_cloth(driven(plate, {0.15f, 0.025f, 0.15f}, {0.15f, 0.425f, 0.15f}, 0, 0.4f));
  SheetCrossings crossings(world_.cloth_positions(id), world_.cloth_triangles(id));
  size_t crossed = 0;
  for (int k = 0; k < 40; ++k) {
    world_.step(dt);
    crossed += crossings.advance(world_.cloth_positions(id), world_.positions());
  }
  EXPECT_EQ(crossed, 0u);
  for (const Vec3 p : world_.positions()) EXPECT_GT(p.y, 0.425f);
}

TEST_P(DrivenSurfaceTest, CarriesClothAndBodies) {
  World world(fine_def());
  const PieceMesh plate = mesh_of(SheetGeometry{1, 1, 21, 21});
  ClothDef floor = driven(plate, {0, 0.5f, 0}, {0.4f, 0.5f, 0}, 0.5f, 1.5f);
  floor.fabric.friction = 1;
  world.create_cloth(floor);
  ClothDef lying = sheet(0.4f, 0.4f, 9, 9, {0, 0.52f, 0});
  lying.fabric.friction = 1;
  const ClothId cloth = world.create_cloth(lying);
  BodyDef crate;
  crate.name = "crate";
  crate.geometry = BoxGeometry{{0.05f, 0.05f, 0.05f}};
  crate.pose.position = {-0.35f, 0.575f, 0};
  crate.surface.friction = 1;
  const BodyId body = world.create_body(crate);
  run(world, 100, dt);
  EXPECT_NEAR(world.cloth_state(cloth).centre.x, 0.4f, 0.04f);
  EXPECT_NEAR(world.body_state(body).pose.position.x, 0.05f, 0.04f);
  EXPECT_GT(world.cloth_state(cloth).centre.y, 0.5f);
  EXPECT_GT(world.body_state(body).pose.position.y, 0.54f);
}

TEST_P(DrivenSurfaceTest, TakesClothAlongThatIsSewnToIt) {
  World world(fine_def());
  const PieceMesh rail = mesh_of(SheetGeometry{0.4f, 0.05f, 9, 2});
  const ClothId bar = world.create_cloth(driven(rail, {0, 1, 0}, {0.5f, 1.2f, 0}, 0, 0.8f));
  ClothDef curtain = sheet(0.4f, 0.4f, 9, 9, {0, 0.8f, 0.025f});
  curtain.pose.rotation = {std::sqrt(0.5f), 0, 0, std::sqrt(0.5f)};
  const ClothId cloth = world.create_cloth(curtain);
  AttachmentDef seam = attach(cloth, vertices_from(0, 9));
  seam.other_cloth = bar;
  world.create_attachment(seam);
  run(world, 50, dt);
  const auto held = world.cloth_positions(cloth), rails = world.cloth_positions(bar);
  for (uint32_t v = 0; v < 9; ++v) EXPECT_LT(length(held[v] - rails[9 + v]), 0.01f);
  AttachmentDef pin = attach(bar, {0});
  expect_error(ErrorCode::invalid_argument, "driven surface", [&] { world.create_attachment(pin); });
}

// Files of a mesh that moves are the keyframes that they hold.
TEST_P(DrivenSurfaceTest, FilesAreKeyframes) {
  const PieceMesh mesh = mesh_of(ClothSphere{radius, 3});
  std::map<std::string, std::string> files;
  ClothDef in_memory = driven(mesh, {0, 0, 0}, {0, 0, 0}, 0, 1);
  auto& motion = std::get<DrivenTriangles>(in_memory.geometry);
  motion.keyframes.clear();
  for (int k = 0; k < 4; ++k) {
    motion.keyframes.push_back({static_cast<float>(k) / 25,
                                moved_by(mesh.vertices, {0.02f * static_cast<float>(k * k), 0.3f, 0.3f})});
    const std::string number = std::to_string(10007 + k).substr(1);
    files["ball_" + number + ".obj"] = obj_text(motion.keyframes.back().vertices, mesh.triangles);
  }
  ClothDef numbered = in_memory;
  DrivenFiles from_files;
  from_files.files = "ball_%04d.obj";
  from_files.first = 7;
  from_files.last = 10;
  from_files.frames_per_second = 25;
  numbered.geometry = from_files;
  WorldDef def = world_def(GetParam(), s);
  def.read_file = [&](const std::string& name) -> std::optional<std::string> {
    const auto found = files.find(name);
    return found == files.end() ? std::nullopt : std::optional(found->second);
  };
  World a(world_def(GetParam(), s)), b(def);
  const ClothId first = a.create_cloth(in_memory), second = b.create_cloth(numbered);
  for (int k = 0; k < 9; ++k) {
    a.step(dt);
    b.step(dt);
    const auto x = a.cloth_positions(first), y = b.cloth_positions(second);
    ASSERT_EQ(x.size(), y.size());
    for (const Vec3 p : x)  // a file has its vertices in the order of its faces
      EXPECT_TRUE(std::ranges::any_of(y, [&](Vec3 q) { return length(p - q) < 1e-6f; }));
  }
}

TEST_P(DrivenSurfaceTest, RefusesWhatItIsNot) {
  const PieceMesh plate = mesh_of(SheetGeometry{0.4f, 0.4f, 3, 3});
  const ClothDef good = driven(plate, {0, 1, 0}, {1, 1, 0}, 0, 1);
  const auto refused = [&](const std::string& text,
                           const std::function<void(ClothDef&, DrivenTriangles&)>& spoil,
                           ErrorCode code = ErrorCode::invalid_argument) {
    ClothDef def = good;
    spoil(def, std::get<DrivenTriangles>(def.geometry));
    expect_error(code, text, [&] { world_.create_cloth(def); });
  };
  refused("times of keyframes must increase", [](ClothDef&, DrivenTriangles& d) { d.keyframes[1].time = 0; });
  refused("keyframe 1 has 8 vertices",
          [](ClothDef&, DrivenTriangles& d) { d.keyframes[1].vertices.pop_back(); });
  refused("vertices[4] of keyframe 1 is not finite",
          [](ClothDef&, DrivenTriangles& d) { d.keyframes[1].vertices[4].y = NAN; });
  refused("keyframes", [](ClothDef&, DrivenTriangles& d) { d.keyframes.clear(); });
  refused("loop needs at least 2", [](ClothDef&, DrivenTriangles& d) {
    d.keyframes.pop_back();
    d.loop = true;
  });
  refused(
      "vertex 77", [](ClothDef&, DrivenTriangles& d) { d.triangles[1] = 77; }, ErrorCode::mesh);
  refused("velocity", [](ClothDef& def, DrivenTriangles&) { def.velocity = {1, 0, 0}; });
  refused("inflation", [](ClothDef& def, DrivenTriangles&) { def.inflation = InflationDef{}; });
  refused("tear", [](ClothDef& def, DrivenTriangles&) { def.fabric.tear_strain = 1; });
  EXPECT_EQ(world_.cloth_ids().size(), 0u);
  const ClothId id = world_.create_cloth(good);
  const std::vector<Vec3> zeros(9);
  expect_error(ErrorCode::invalid_argument, "driven surface", [&] { world_.set_cloth_positions(id, zeros); });
  expect_error(ErrorCode::invalid_argument, "driven surface",
               [&] { world_.set_cloth_velocities(id, zeros); });
}

MENISCUS_ON_EACH_DEVICE(DrivenSurfaceTest);

}  // namespace
}  // namespace meniscus::tests
