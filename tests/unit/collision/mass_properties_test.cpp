// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tests of masses and inertias against closed forms.
#include "collision/mesh/mass_properties.h"

#include <gtest/gtest.h>
#include <meniscus/error.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "tests/unit/collision/solid_shapes.h"

namespace meniscus::collision {
namespace {

using Tensor = std::array<double, 6>;  // xx, yy, zz, xy, yz, zx

const Pose somewhere{{3, -1, 2}, {0.18257419f, 0.36514837f, 0.54772256f, 0.73029674f}};

// The inertia about the centre along the axes of the frame in which `turn` puts the geometry.
Tensor tensor_of(const MassProperties& body, Quat turn = {0, 0, 0, 1}) {
  Tensor t{};
  const Vec3 units[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const double moments[] = {body.inertia.x, body.inertia.y, body.inertia.z};
  for (int k = 0; k < 3; ++k) {
    const Vec3 a = rotate(turn, rotate(body.axes, units[k]));
    const double products[] = {a.x * a.x, a.y * a.y, a.z * a.z, a.x * a.y, a.y * a.z, a.z * a.x};
    for (int i = 0; i < 6; ++i) t[i] += moments[k] * products[i];
  }
  return t;
}

void expect_equal(const MassProperties& a, const MassProperties& b, double tolerance = 1e-6,
                  Quat turn_of_b = {0, 0, 0, 1}) {
  EXPECT_NEAR(a.mass / b.mass, 1, tolerance);
  EXPECT_LT(length(a.centre - b.centre), std::max(1e-6, tolerance));
  const Tensor ta = tensor_of(a), tb = tensor_of(b, turn_of_b);
  for (int i = 0; i < 6; ++i) EXPECT_NEAR(ta[i], tb[i], tolerance * (tb[0] + tb[1] + tb[2])) << i;
}

// A solid of revolution around y, as a pile of discs.
void expect_revolution(const MassProperties& body, double top, double density,
                       const std::function<double(double)>& radius) {
  double mass = 0, along = 0, across = 0;
  constexpr int discs = 4000;
  for (int i = 0; i < discs; ++i) {
    const double y = top * (2 * (i + 0.5) / discs - 1), r = radius(y);
    const double m = density * std::numbers::pi * r * r * 2 * top / discs;
    mass += m;
    along += m * r * r / 2;
    across += m * (r * r / 4 + y * y);
  }
  EXPECT_NEAR(body.mass / mass, 1, 1e-5);
  EXPECT_NEAR(body.inertia.y / along, 1, 1e-5);
  EXPECT_NEAR(body.inertia.x / across, 1, 1e-5);
  EXPECT_EQ(body.inertia.z, body.inertia.x);
  EXPECT_EQ(length(body.centre), 0);
}

void expect_error(ErrorCode code, const std::function<void()>& call) {
  try {
    call();
    ADD_FAILURE() << "was accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), code) << error.what();
  }
}

TEST(MassProperties, ClosedFormsAreTheIntegrals) {
  const auto sphere = [](double y) { return std::sqrt(0.25 - y * y); };
  expect_revolution(sphere_mass(0.5f, 800), 0.5, 800, sphere);
  expect_revolution(cylinder_mass(0.25f, 0.75f, 2700), 0.75, 2700, [](double) { return 0.25; });
  const auto capsule = [](double y) {
    const double beyond = std::max(0.0, std::fabs(y) - 0.75);
    return std::sqrt(0.0625 - beyond * beyond);
  };
  expect_revolution(capsule_mass(0.25f, 0.75f, 1000), 1, 1000, capsule);
}

TEST(MassProperties, AMeshOfABoxIsABox) {
  const Vec3 half{0.5f, 0.25f, 1};
  expect_equal(mesh_mass(box_mesh(-half, half), 500), box_mass(half, 500));
  const MassProperties moved = mesh_mass(placed(box_mesh(-half, half), somewhere), 500);
  EXPECT_LT(length(moved.centre - somewhere.position), 1e-6f);
  MassProperties expected = box_mass(half, 500);
  expected.centre = somewhere.position;
  expect_equal(moved, expected, 1e-6, somewhere.rotation);
}

TEST(MassProperties, AMeshOfABallComesNearTheSphere) {
  expect_equal(mesh_mass(ball_mesh(0.5f, 6), 1000), sphere_mass(0.5f, 1000), 1.5e-3);
}

TEST(MassProperties, ATetrahedronHasItsClosedForm) {
  const float a = 0.5f, b = 1, c = 2;
  const TriangleMesh mesh{{{0, 0, 0}, {a, 0, 0}, {0, b, 0}, {0, 0, c}},
                          {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
  const MassProperties body = mesh_mass(mesh, 600);
  const double mass = 600 * a * b * c / 6;
  EXPECT_NEAR(body.mass / mass, 1, 1e-9);
  EXPECT_LT(length(body.centre - Vec3{a / 4, b / 4, c / 4}), 1e-6f);
  const Tensor t = tensor_of(body),
               exact{3 * (b * b + c * c), 3 * (a * a + c * c), 3 * (a * a + b * b), a * b, b * c, c * a};
  for (int i = 0; i < 6; ++i) EXPECT_NEAR(t[i], mass / 80 * exact[i], 1e-6 * mass) << i;
}

TEST(MassProperties, AHollowBodyLacksWhatItsInnerShellHolds) {
  const TriangleMesh hollow = joined(box_mesh({-1, -1, -1}, {1, 1, 1}),
                                     inside_out(box_mesh({-0.5f, -0.5f, -0.5f}, {0.5f, 0.5f, 0.5f})));
  const MassProperties body = mesh_mass(hollow, 100);
  const MassProperties outer = box_mass({1, 1, 1}, 100), inner = box_mass({0.5f, 0.5f, 0.5f}, 100);
  EXPECT_NEAR(body.mass, outer.mass - inner.mass, 1e-9);
  EXPECT_NEAR(body.inertia.x, outer.inertia.x - inner.inertia.x, 1e-4);
}

// Each half lies on its side in its own frame, and is put upright by its pose.
TEST(MassProperties, TwoHalvesMakeAWhole) {
  const Quat quarter_turn{0, 0, std::sqrt(0.5f), std::sqrt(0.5f)};  // about z
  const MassProperties half = box_mass({0.3f, 0.1f, 0.5f}, 700), whole = box_mass({0.2f, 0.3f, 0.5f}, 700);
  const PlacedMass parts[] = {{half, {{-0.1f, 0, 0}, quarter_turn}}, {half, {{0.1f, 0, 0}, quarter_turn}}};
  expect_equal(combine(parts), whole);

  const PlacedMass moved[] = {{half, somewhere * parts[0].pose}, {half, somewhere * parts[1].pose}};
  MassProperties expected = whole;
  expected.centre = somewhere.position;
  expect_equal(combine(moved), expected, 1e-6, somewhere.rotation);
}

TEST(MassProperties, PartsMayHaveTheirCentreElsewhere) {
  const MassProperties left = mesh_mass(box_mesh({-1, -0.5f, -0.5f}, {0, 0.5f, 0.5f}), 300);
  const MassProperties right = mesh_mass(box_mesh({5, -0.5f, -0.5f}, {6, 0.5f, 0.5f}), 300);
  const PlacedMass parts[] = {{left, {}}, {right, {{-5, 0, 0}, {0, 0, 0, 1}}}};
  expect_equal(combine(parts), box_mass({1, 0.5f, 0.5f}, 300));
}

TEST(MassProperties, AGivenMassScalesTheMoments) {
  const MassProperties body = with_mass(box_mass({1, 2, 3}, 10), 7);
  EXPECT_EQ(body.mass, 7);
  EXPECT_NEAR(body.inertia.x, 7.0 / 3 * (4 + 9), 1e-5);
}

TEST(MassProperties, WhatHasNoMassIsRefused) {
  const float nan = std::nanf(""), infinite = std::numeric_limits<float>::infinity();
  for (float bad : {0.0f, -1.0f, nan, infinite}) {
    expect_error(ErrorCode::invalid_argument, [&] { sphere_mass(bad, 1000); });
    expect_error(ErrorCode::invalid_argument, [&] { sphere_mass(1, bad); });
    expect_error(ErrorCode::invalid_argument, [&] { box_mass({1, bad, 1}, 1000); });
    expect_error(ErrorCode::invalid_argument, [&] { capsule_mass(bad, 1, 1000); });
    if (bad != 0) expect_error(ErrorCode::invalid_argument, [&] { capsule_mass(1, bad, 1000); });
    expect_error(ErrorCode::invalid_argument, [&] { cylinder_mass(bad, 1, 1000); });
    expect_error(ErrorCode::invalid_argument, [&] { mesh_mass(ball_mesh(1, 2), bad); });
    expect_error(ErrorCode::invalid_argument, [&] { with_mass(sphere_mass(1, 1), bad); });
  }
  expect_error(ErrorCode::invalid_argument, [] { combine({}); });
  expect_error(ErrorCode::mesh, [] { mesh_mass({}, 1000); });
  expect_error(ErrorCode::mesh, [] { mesh_mass(inside_out(ball_mesh(1, 2)), 1000); });
  expect_error(ErrorCode::mesh, [] { cylinder_mass(1e-4f, 1, 1000); });  // a needle
  expect_error(ErrorCode::mesh, [] { sphere_mass(1e-10f, 1000); });      // moments beyond float's reach
}

}  // namespace
}  // namespace meniscus::collision
