// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The result of World::body_mass for each geometry, against closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "tests/unit/sdk/world/solids/body_worlds.h"

namespace meniscus::tests {
namespace {

constexpr float density = 800;

/// Ascending: which principal axis comes first is not said.
std::array<float, 3> sorted(Vec3 v) {
  std::array<float, 3> values{v.x, v.y, v.z};
  std::sort(values.begin(), values.end());
  return values;
}

class BodyMassTest : public testing::Test {
 protected:
  TemporaryFolder folder_;
  World world_{world_def(pbd::DeviceKind::cpu, 0.5f)};  // coarse fields: no particle looks at them

  BodyMass mass_of(BodyDef def) {
    def.density = density;
    return world_.body_mass(world_.create_body(def));
  }
  BodyMass mass_of(const Geometry& geometry) { return mass_of(body(geometry)); }

  static void expect_mass(const BodyMass& found, float volume, Vec3 centre, Vec3 inertia,
                          float tolerance = 1e-5f) {
    const float mass = density * volume, size = std::cbrt(volume);
    EXPECT_NEAR(found.volume, volume, tolerance * volume);
    EXPECT_NEAR(found.mass, mass, tolerance * mass);
    expect_near(found.centre, centre, tolerance * size);
    for (int k = 0; k < 3; ++k)
      EXPECT_NEAR(sorted(found.inertia)[k], sorted(inertia)[k], 3 * tolerance * mass * size * size) << k;
  }

  /// Of a box with these edges, about its centre, at the test's density.
  static Vec3 box_inertia(Vec3 e) {
    const float m = density * e.x * e.y * e.z / 12;
    return m * Vec3{e.y * e.y + e.z * e.z, e.x * e.x + e.z * e.z, e.x * e.x + e.y * e.y};
  }

  /// Inertia tensor's entry a·I·b in the geometry's frame.
  static float tensor(const BodyMass& mass, Vec3 a, Vec3 b) {
    const Vec3 u = rotate(conjugate(mass.principal_axes), a), v = rotate(conjugate(mass.principal_axes), b);
    return u.x * mass.inertia.x * v.x + u.y * mass.inertia.y * v.y + u.z * mass.inertia.z * v.z;
  }
};

TEST_F(BodyMassTest, Box) {
  expect_mass(mass_of(BoxGeometry{{0.5f, 1, 1.5f}}), 6, {0, 0, 0}, box_inertia({1, 2, 3}));
}

TEST_F(BodyMassTest, Sphere) {
  constexpr float r = 0.3f, volume = 4 * pi / 3 * r * r * r, i = 0.4f * density * volume * r * r;
  expect_mass(mass_of(SphereGeometry{r}), volume, {0, 0, 0}, {i, i, i});
}

TEST_F(BodyMassTest, Cylinder) {
  constexpr float r = 0.2f, half = 0.5f, volume = pi * r * r * 2 * half, m = density * volume;
  constexpr float across = m * (r * r / 4 + half * half / 3), along = m * r * r / 2;
  const BodyMass mass = mass_of(CylinderGeometry{r, half});
  expect_mass(mass, volume, {0, 0, 0}, {across, along, across});
  EXPECT_NEAR(tensor(mass, {0, 1, 0}, {0, 1, 0}), along, 1e-4f * along);
}

TEST_F(BodyMassTest, Capsule) {
  constexpr float r = 0.2f, half = 0.5f;
  constexpr float tube = density * pi * r * r * 2 * half, cap = density * 2 * pi / 3 * r * r * r;
  const float along = tube * r * r / 2 + 2 * cap * 0.4f * r * r;
  const float across =
      tube * (r * r / 4 + half * half / 3) + 2 * cap * (0.4f * r * r + half * half + 0.75f * r * half);
  expect_mass(mass_of(CapsuleGeometry{r, half}), (tube + 2 * cap) / density, {0, 0, 0},
              {across, along, across});
}

TEST_F(BodyMassTest, ACapsuleOfNoHeightIsASphere) {
  const BodyMass capsule = mass_of(CapsuleGeometry{0.3f, 0}), sphere = mass_of(SphereGeometry{0.3f});
  EXPECT_FLOAT_EQ(capsule.mass, sphere.mass);
  EXPECT_NEAR(capsule.inertia.y, sphere.inertia.y, 1e-5f * sphere.inertia.y);
}

TEST_F(BodyMassTest, Mesh) {
  MeshGeometry mesh{folder_.write("brick.obj", brick_obj)};
  mesh.scale = 0.1f;
  expect_mass(mass_of(mesh), 0.006f, {0.05f, 0.1f, 0.15f}, box_inertia({0.1f, 0.2f, 0.3f}));
}

TEST_F(BodyMassTest, AHullFillsInWhatItsPointsLeaveOut) {
  std::vector<Vec3> corners{{0.5f, 0.9f, 1.4f}};  // the last one lies inside
  for (int c = 0; c < 8; ++c) corners.push_back({c & 1 ? 1.0f : 0, c & 2 ? 2.0f : 0, c & 4 ? 3.0f : 0});
  expect_mass(mass_of(HullGeometry{corners}), 6, {0.5f, 1, 1.5f}, box_inertia({1, 2, 3}));
}

TEST_F(BodyMassTest, ATetrahedronOfAxes) {
  const BodyMass mass = mass_of(HullGeometry{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}});
  EXPECT_NEAR(mass.volume, 1 / 6.0f, 1e-6f);
  expect_near(mass.centre, {0.25f, 0.25f, 0.25f}, 1e-6f);
  // ∫ y² + z² about the centre is 2 · 3/480, ∫ x y is −1/480 there: off the diagonal it is +ρ/480.
  const Vec3 x{1, 0, 0}, y{0, 1, 0};
  EXPECT_NEAR(tensor(mass, x, x), density * 6 / 480, 1e-3f);
  EXPECT_NEAR(tensor(mass, x, y), density / 480, 1e-3f);
}

TEST_F(BodyMassTest, ACompoundOfTwoHalvesIsTheWhole) {
  CompoundGeometry halves;
  for (float x : {-0.25f, 0.25f}) halves.parts.push_back({BoxGeometry{{0.25f, 1, 1.5f}}, {{x, 0, 0}}});
  expect_mass(mass_of(halves), 6, {0, 0, 0}, box_inertia({1, 2, 3}));
}

// A dumbbell of two balls off the origin: its centre and, by Steiner's theorem, its inertia.
TEST_F(BodyMassTest, ACompoundOfPartsThatLieApart) {
  constexpr float r = 0.1f, arm = 0.4f, volume = 4 * pi / 3 * r * r * r, m = density * volume;
  CompoundGeometry dumbbell;
  for (float x : {-arm, arm}) dumbbell.parts.push_back({SphereGeometry{r}, {{x + 1, 2, 3}}});
  constexpr float along = 2 * m * 0.4f * r * r, across = along + 2 * m * arm * arm;
  const BodyMass mass = mass_of(dumbbell);
  expect_mass(mass, 2 * volume, {1, 2, 3}, {along, across, across});
  EXPECT_NEAR(tensor(mass, {1, 0, 0}, {1, 0, 0}), along, 1e-4f * across);
}

TEST_F(BodyMassTest, ATurnedPartTurnsTheInertia) {
  CompoundGeometry turned;
  turned.parts.push_back({BoxGeometry{{0.5f, 1, 1.5f}}, {{0, 0, 0}, about_z(90)}});
  const BodyMass mass = mass_of(turned);
  expect_mass(mass, 6, {0, 0, 0}, box_inertia({1, 2, 3}));
  EXPECT_NEAR(tensor(mass, {1, 0, 0}, {1, 0, 0}), box_inertia({2, 1, 3}).x, 0.5f);
}

TEST_F(BodyMassTest, AMassTakesThePlaceOfTheDensity) {
  BodyDef def = body(BoxGeometry{{0.5f, 1, 1.5f}});
  const BodyMass by_density = mass_of(def);
  def.mass = 12.0f;
  const BodyMass by_mass = mass_of(def);
  EXPECT_EQ(by_mass.mass, 12);
  EXPECT_EQ(by_mass.volume, by_density.volume);
  expect_near(by_mass.inertia, 12 / by_density.mass * by_density.inertia, 1e-4f);
}

TEST_F(BodyMassTest, AKinematicBodyHasNone) {
  BodyDef def = kinematic(BoxGeometry{});
  def.mass = 5.0f;
  const BodyMass mass = mass_of(def);
  EXPECT_EQ(mass.mass, 0);
  EXPECT_EQ(mass.inertia, (Vec3{0, 0, 0}));
}

// The pose is that of the geometry's frame, wherever the centre of mass lies.
TEST_F(BodyMassTest, TheStateTellsBothThePoseAndTheCentre) {
  BodyDef def = body(MeshGeometry{folder_.write("brick.obj", brick_obj)}, {10, 0, 0});
  def.pose.rotation = about_z(90);
  const BodyState state = world_.body_state(world_.create_body(def));
  expect_near(state.pose.position, {10, 0, 0}, 1e-5f);
  expect_near(rotate(state.pose.rotation, {1, 0, 0}), {0, 1, 0}, 1e-5f);
  expect_near(state.centre_of_mass, {9, 0.5f, 1.5f}, 1e-5f);
}

}  // namespace
}  // namespace meniscus::tests
