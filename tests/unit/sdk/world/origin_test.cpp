// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A scene far from zero is as precise as one at zero, if WorldDef::origin is in it.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/cloth_worlds.h"
#include "tests/expect_error.h"
#include "tests/worlds.h"

namespace meniscus::tests {
namespace {

constexpr float s = 0.05f;
constexpr Vec3 far_away{1e4f, 0, 1e4f};
constexpr float step = 0x1p-10f;  // m, of floats there

WorldDef def_at(pbd::DeviceKind device, Vec3 origin) {
  WorldDef def = world_def(device, s);
  def.origin = origin;
  return def;
}

/// One of each kind of object, at places that floats represent exactly with and without the shift `o`.
struct Scene {
  World world;
  Vec3 o;
  FluidId water = world.create_fluid({});
  ShapeId vessel = world.create_shape(tank(o, o + Vec3{1, 1, 0.5f}));
  BodyId crate{}, paddle{};
  ClothId veil{};
  RopeId line{};
  ProbeId centre{}, momentum{}, level{};

  Scene(const WorldDef& def, Vec3 shift) : world(def), o(shift) {
    add_solids();
    add_cloth();
    add_flow();
    world.add_fluid(block(water, o, o + Vec3{0.5f, 0.75f, 0.5f}));
    const std::vector<Vec3> drop{o + Vec3{0.75f, 0.875f, 0.25f}};
    world.add_particles(water, drop);
    centre = world.create_probe({.kind = ProbeKind::fluid_centre});
    momentum = world.create_probe({.kind = ProbeKind::fluid_angular_momentum, .point = o});
    level =
        world.create_probe({.kind = ProbeKind::level, .point = o + Vec3{0.25f, 0, 0.25f}, .radius = 0.125f});
  }

  void add_solids() {
    PlaneGeometry slope{{1, 1, 0}, o.x - 0.5f};
    ShapeDef plane = shape(slope);
    plane.surface.friction = 0.5f;
    world.create_shape(plane);
    BodyDef box;
    box.geometry = BoxGeometry{{0.125f, 0.125f, 0.125f}};
    box.pose.position = o + Vec3{0.75f, 0.25f, 0.25f};
    crate = world.create_body(box);
    world.create_joint({.a = crate, .frame = {o + Vec3{0.75f, 0.5f, 0.25f}}});
    box.motion = BodyMotion::kinematic;
    box.keyframes = {{0, {o + Vec3{0.75f, 0.75f, 0.25f}}}, {1, {o + Vec3{0.5f, 0.75f, 0.25f}}}};
    paddle = world.create_body(box);
    world.move_body(paddle, {o + Vec3{0.875f, 0.75f, 0.25f}}, 1);
    world.apply_impulse(crate, {0.5f, 0, 0}, o + Vec3{0.75f, 0.25f, 0.375f});
  }

  void add_cloth() {
    veil = world.create_cloth(sheet(0.25f, 0.25f, 5, 5, o + Vec3{0.25f, 0.875f, 0.25f}));
    AttachmentDef held;
    held.cloth = veil;
    held.region = Aabb{o, o + Vec3{0.1875f, 1, 0.5f}};
    world.create_attachment(held);
    line = world.create_rope(rope({o + Vec3{0.75f, 1, 0.25f}, o + Vec3{0.75f, 1.75f, 0.25f}}, 7));
  }

  void add_flow() {
    EmitterDef tap;
    tap.fluid = water;
    tap.pose.position = o + Vec3{0.875f, 0.5f, 0.25f};
    world.create_emitter(tap);
    world.create_sink({.region = BoxRegion{o + Vec3{0.9375f, 0, 0}, o + Vec3{1, 0.0625f, 0.5f}}});
    world.create_sink({.region = HalfSpaceRegion{{-1, 0, 0}, -o.x - 0.9375f}});
  }
};

class OriginTest : public OnDevice {
 protected:
  static constexpr int steps = 15;
};

TEST_P(OriginTest, ASceneFarAwayHasTheBitsOfOneAtZero) {
  Scene here(def_at(GetParam(), {0, 0, 0}), {0, 0, 0}), there(def_at(GetParam(), far_away), far_away);
  ASSERT_EQ(here.world.particle_count(), there.world.particle_count());
  for (int k = 0; k < steps; ++k) {
    here.world.step(1 / 60.0f);
    there.world.step(1 / 60.0f);
    ASSERT_EQ(here.world.state_hash(), there.world.state_hash()) << k;
  }
  EXPECT_EQ(here.world.probe(here.level), there.world.probe(there.level));
  EXPECT_EQ(here.world.probe(here.momentum), there.world.probe(there.momentum));
  EXPECT_EQ(here.world.diagnostics().density_error_mean, there.world.diagnostics().density_error_mean);
}

/// Expects equal places, but for the shift and the rounding of the read-out.
template <class T, class Place>
void expect_shifted(std::span<const T> here, std::span<const T> there, const Place& place) {
  ASSERT_EQ(here.size(), there.size());
  ASSERT_FALSE(here.empty());
  for (size_t i = 0; i < here.size(); ++i)
    ASSERT_LE(max_component(abs(place(there[i]) - far_away - place(here[i]))), 0.51f * step) << i;
}

Vec3 itself(Vec3 p) {
  return p;
}

TEST_P(OriginTest, ReadOutsAreInTheUsersFrame) {
  Scene a(def_at(GetParam(), {0, 0, 0}), {0, 0, 0}), b(def_at(GetParam(), far_away), far_away);
  run(a.world, steps, 1 / 60.0f);
  run(b.world, steps, 1 / 60.0f);
  expect_shifted(a.world.positions(), b.world.positions(), itself);
  expect_shifted(a.world.cloth_positions(a.veil), b.world.cloth_positions(b.veil), itself);
  expect_shifted(a.world.rope_positions(a.line), b.world.rope_positions(b.line), itself);
  expect_shifted(a.world.ellipsoids(), b.world.ellipsoids(), [](const Ellipsoid& e) { return e.centre; });
  const auto contacts_of = [](const World& w) { return w.particle_contacts(); };
  const std::vector<ParticleContact> touch = contacts_of(a.world), touch_far = contacts_of(b.world);
  expect_shifted(std::span<const ParticleContact>(touch), std::span<const ParticleContact>(touch_far),
                 [](const ParticleContact& c) { return c.point; });
  const SurfaceMesh mesh = a.world.surface_mesh(), mesh_far = b.world.surface_mesh();
  expect_shifted(std::span<const Vec3>(mesh.vertices), std::span<const Vec3>(mesh_far.vertices), itself);
  const Vec3 places[] = {a.world.body_state(a.crate).pose.position,
                         a.world.body_state(a.paddle).pose.position, a.world.cloth_state(a.veil).centre,
                         a.world.probe_vector(a.centre)},
             far_places[] = {b.world.body_state(b.crate).pose.position,
                             b.world.body_state(b.paddle).pose.position, b.world.cloth_state(b.veil).centre,
                             b.world.probe_vector(b.centre)};
  expect_shifted(std::span<const Vec3>(places), std::span<const Vec3>(far_places), itself);
}

TEST_P(OriginTest, QueriesAreInTheUsersFrame) {
  Scene a(def_at(GetParam(), {0, 0, 0}), {0, 0, 0}), b(def_at(GetParam(), far_away), far_away);
  const Vec3 from{0.75f, 0.9375f, 0.0625f}, to{0.75f, 0, 0.25f}, corner{0.0625f, 0.0625f, 0.0625f};
  const auto hit = a.world.cast_ray(from, to), far_hit = b.world.cast_ray(far_away + from, far_away + to);
  ASSERT_TRUE(hit && far_hit);
  EXPECT_EQ(hit->distance, far_hit->distance);
  expect_shifted(std::span<const Vec3>(&hit->point, 1), std::span<const Vec3>(&far_hit->point, 1), itself);
  const Vec3 points[] = {corner}, far_points[] = {far_away + corner};
  EXPECT_EQ(a.world.solid_distances(points, 1), b.world.solid_distances(far_points, 1));
  EXPECT_EQ(a.world.overlap_ball(corner, 0.125f).particles,
            b.world.overlap_ball(far_away + corner, 0.125f).particles);
  EXPECT_EQ(a.world.overlap_box({corner}, {0.125f, 0.125f, 0.125f}).particles,
            b.world.overlap_box({far_away + corner}, {0.125f, 0.125f, 0.125f}).particles);
}

TEST_P(OriginTest, ACentreWithoutParticlesIsZero) {
  World world(def_at(GetParam(), far_away));
  const ProbeId centre = world.create_probe({.kind = ProbeKind::fluid_centre});
  world.step(0.01f);
  EXPECT_EQ(world.probe_vector(centre), (Vec3{0, 0, 0}));
}

TEST(OriginGraphics, ArraysAreInTheUsersFrame) {
  constexpr auto cpu = pbd::DeviceKind::cpu;
  Scene a(def_at(cpu, {0, 0, 0}), {0, 0, 0}), b(def_at(cpu, far_away), far_away);
  const auto written = [](const Scene& scene) {
    std::vector<Ellipsoid> ellipsoids(scene.world.particle_count());
    std::vector<uint32_t> fluids(ellipsoids.size());
    scene.world.write_particles({ellipsoids.data(), fluids.data()});
    return ellipsoids;
  };
  const std::vector<Ellipsoid> here = written(a), there = written(b);
  expect_shifted(std::span<const Ellipsoid>(here), std::span<const Ellipsoid>(there),
                 [](const Ellipsoid& e) { return e.centre; });
}

/// A column of water that collapses onto a crate, at places that floats round.
World rounded_scene(const WorldDef& def, Vec3 o, BodyId& crate) {
  World world(def);
  const FluidId water = world.create_fluid({});
  world.create_shape(tank(o, o + Vec3{1.6f, 2, 0.6f}));
  BodyDef box;
  box.geometry = BoxGeometry{{0.1f, 0.1f, 0.1f}};
  box.pose.position = o + Vec3{1.2f, 0.1f, 0.3f};
  crate = world.create_body(box);
  world.create_cloth(sheet(0.4f, 0.4f, 9, 9, o + Vec3{0.4f, 0.9f, 0.3f}));
  world.add_fluid(block(water, o, o + Vec3{0.6f, 0.6f, 0.6f}));
  return world;
}

TEST_P(OriginTest, RoundedPlacesChangeAFlowByLessThanOnePercent) {
  BodyId crate{}, far_crate{};
  World here = rounded_scene(def_at(GetParam(), {0, 0, 0}), {0, 0, 0}, crate),
        there = rounded_scene(def_at(GetParam(), far_away), far_away, far_crate);
  ASSERT_EQ(here.particle_count(), there.particle_count());
  run(here, 20, 1 / 60.0f);
  run(there, 20, 1 / 60.0f);
  const Diagnostics a = here.diagnostics(), b = there.diagnostics();
  EXPECT_NEAR(b.density_error_mean, a.density_error_mean, 0.01);
  EXPECT_NEAR(b.density_error_interior, a.density_error_interior, 0.01);
  EXPECT_NEAR(b.kinetic_energy, a.kinetic_energy, 0.01 * a.kinetic_energy);
  EXPECT_NEAR(mean_height(there), mean_height(here), 0.01f * mean_height(here));
  EXPECT_NEAR(there.body_state(far_crate).centre_of_mass.x - far_away.x,
              here.body_state(crate).centre_of_mass.x, 0.01f);
}

TEST_P(OriginTest, PeriodicEndsAreInTheUsersFrame) {
  const auto make = [&](Vec3 o) {
    WorldDef def = def_at(GetParam(), o);
    def.gravity = {0.5f, 0, 0};
    def.periodic.x = {o.x, o.x + 0.5f};
    World world(def);
    world.add_fluid(block(world.create_fluid({}), o, o + Vec3{0.5f, 0.25f, 0.25f}));
    run(world, steps, 1 / 60.0f);
    EXPECT_EQ(world.def().periodic.x->low, o.x);
    return world;
  };
  EXPECT_EQ(make({0, 0, 0}).state_hash(), make(far_away).state_hash());
}

TEST_P(OriginTest, ItIsFixed) {
  World world(def_at(GetParam(), far_away));
  WorldDef def = world.def();
  EXPECT_EQ(def.origin, far_away);
  def.substeps = 2;
  world.set_def(def);
  def.origin = {0, 0, 0};
  expect_error(ErrorCode::invalid_argument, "WorldDef::origin", [&] { world.set_def(def); });
  def.origin = {NAN, 0, 0};
  expect_error(ErrorCode::invalid_argument, "WorldDef::origin", [&] { World{def}; });
}

TEST_P(OriginTest, APeriodThatRoundsAwayIsRefused) {
  WorldDef def = def_at(GetParam(), {1e9f, 0, 0});
  def.periodic.x = {0, 1};
  expect_error(ErrorCode::invalid_argument, "WorldDef::periodic.x.high", [&] { World{def}; });
}

TEST_P(OriginTest, PlacesNearItAreNotWarnedOf) {
  World world(def_at(GetParam(), far_away));
  const FluidId water = world.create_fluid({});
  world.add_particles(water, std::vector<Vec3>{far_away});
  EXPECT_TRUE(world.warnings().empty());
  world.add_particles(water, std::vector<Vec3>{{0, 0, 0}});
  EXPECT_EQ(world.warnings().size(), 1u);
}

MENISCUS_ON_EACH_DEVICE(OriginTest);

}  // namespace
}  // namespace meniscus::tests
