// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Rods as the host builds them, and the equations of one rod on their own.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <random>

#include "cloth/rods/band.h"
#include "cloth/rods/rod.h"
#include "pbd/contacts.h"
#include "tests/bench/harness/rod_bench.h"
#include "tests/expect_error.h"

namespace meniscus::tests {

namespace {

using cloth::BandRow;
using cloth::build_rod;
using cloth::RodModel;
using cloth::RodParameters;
using cloth::RodSegment;

constexpr double pi = std::numbers::pi;

std::vector<Vec3> circle(float radius, uint32_t count) {
  std::vector<Vec3> points;
  for (uint32_t k = 0; k < count; ++k) {
    const double a = 2 * pi * k / count;
    points.push_back({radius * static_cast<float>(std::cos(a)), radius * static_cast<float>(std::sin(a)), 0});
  }
  return points;
}

float angle_of(Quat q) {
  return 2 * std::atan2(std::hypot(q.x, std::hypot(q.y, q.z)), std::fabs(q.w));
}

TEST(RodBuild, MassAndStiffnessAreThoseOfTheSection) {
  RodParameters p;
  p.radius = 0.01f;
  p.density = 2000;
  p.youngs_modulus = 3e6f;
  p.shear_modulus = 1e6f;
  const RodModel rod = build_rod(straight({0, 0, 0}, {0, 0, 2}, 4), p);
  const double area = pi * 1e-4, inertia = pi * 1e-8 / 4;
  ASSERT_EQ(rod.masses.size(), 5u);
  EXPECT_NEAR(std::accumulate(rod.masses.begin(), rod.masses.end(), 0.0), 2000 * area * 2, 1e-5);
  EXPECT_NEAR(rod.masses[0], 0.5 * rod.masses[1], 1e-7);
  for (const RodSegment& s : rod.segments) {
    EXPECT_FLOAT_EQ(s.rest_length, 0.5f);
    EXPECT_NEAR(s.stretch_compliance * 3e6 * area, 0.5, 1e-6);
    EXPECT_NEAR(s.shear_compliance * 0.9 * 1e6 * area, 0.5, 1e-6);
    EXPECT_NEAR(s.bend_compliance * 3e6 * inertia, 0.25, 1e-6);
    EXPECT_NEAR(s.twist_compliance * 1e6 * 2 * inertia, 0.25, 1e-6);
    EXPECT_NEAR(angle_of(s.rest), 0, 1e-6);
  }
  EXPECT_EQ(rod.segments.front().before, pbd::no_index);
  EXPECT_EQ(rod.segments.back().after, pbd::no_index);
}

TEST(RodBuild, GivenStiffnessTakesThePlaceOfTheSections) {
  RodParameters p;
  p.stretch_stiffness = std::numeric_limits<float>::infinity();
  p.bending_stiffness = 2.0f;
  p.twist_stiffness = 4.0f;
  const RodModel rod = build_rod(straight({0, 0, 0}, {1, 0, 0}, 2), p);
  EXPECT_EQ(rod.segments[0].stretch_compliance, 0);
  EXPECT_EQ(rod.segments[0].shear_compliance, 0);
  EXPECT_FLOAT_EQ(rod.segments[0].bend_compliance, 0.125f);
  EXPECT_FLOAT_EQ(rod.segments[0].twist_compliance, 0.0625f);
}

TEST(RodBuild, FramesLieAlongTheSegments) {
  const std::vector<Vec3> points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, -2}, {1, 1, -1}};
  const RodModel rod = build_rod(points, {});
  for (size_t k = 0; k < rod.frames.size(); ++k) {
    const Vec3 along = normalized_or(points[k + 1] - points[k], {0, 0, 0});
    EXPECT_NEAR(length(rotate(rod.frames[k], {0, 0, 1}) - along), 0, 1e-6) << "segment " << k;
  }
}

TEST(RodBuild, RestShapeIsThatOfThePointsOrStraight) {
  RodParameters p;
  p.closed = true;
  const RodModel curved = build_rod(circle(0.3f, 12), p);
  ASSERT_EQ(curved.segments.size(), 12u);
  EXPECT_EQ(curved.segments.back().after, 0u);
  EXPECT_EQ(curved.segments.front().before, 11u);
  for (const RodSegment& s : curved.segments) EXPECT_NEAR(angle_of(s.rest), pi / 6, 1e-5);
  p.straight_at_rest = true;
  for (const RodSegment& s : build_rod(circle(0.3f, 12), p).segments) EXPECT_NEAR(angle_of(s.rest), 0, 1e-5);
}

TEST(RodBuild, AppendedRodsAreNumberedOn) {
  RodModel model = build_rod(straight({0, 0, 0}, {1, 0, 0}, 3), {});
  append(model, build_rod(straight({0, 1, 0}, {1, 1, 0}, 2), {}), 10);
  ASSERT_EQ(model.segments.size(), 5u);
  EXPECT_EQ(model.chains[1].first, 3u);
  EXPECT_EQ(model.chains[1].count, 2u);
  EXPECT_EQ(model.segments[3].a, 10u);
  EXPECT_EQ(model.segments[4].b, 12u);
  EXPECT_EQ(model.segments[3].before, pbd::no_index);
  EXPECT_EQ(model.segments[3].after, 4u);
  EXPECT_EQ(model.frames.size(), 5u);
  EXPECT_EQ(model.masses.size(), 7u);
}

TEST(RodBuild, BadInputIsRefused) {
  const auto refused = [](const char* named, const std::vector<Vec3>& points, const RodParameters& p = {}) {
    expect_error(ErrorCode::invalid_argument, named, [&] { build_rod(points, p); });
  };
  const std::vector<Vec3> good = straight({0, 0, 0}, {1, 0, 0}, 2);
  refused("at least 2", {{0, 0, 0}});
  refused("points 1 and 2", {{0, 0, 0}, {1, 0, 0}, {1, 0, 0}});
  refused("point 1", {{0, 0, 0}, {std::nanf(""), 0, 0}});
  RodParameters p;
  p.closed = true;
  refused("at least 3", {{0, 0, 0}, {1, 0, 0}}, p);
  refused("points 2 and 0", {{0, 0, 0}, {1, 0, 0}, {0, 0, 0}}, p);
  p = {};
  p.radius = 0;
  refused("radius", good, p);
  p = {};
  p.density = -1;
  refused("density", good, p);
  p = {};
  p.youngs_modulus = std::nanf("");
  refused("Young's modulus", good, p);
  p = {};
  p.bending_stiffness = 0;
  refused("bending stiffness", good, p);
  p = {};
  p.damping = -0.1f;
  refused("damping", good, p);
}

// ---- the band ----

/// Positive definite: its diagonal outweighs the rest of a row.
std::vector<BandRow> random_band(uint32_t count, uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> number(-1, 1);
  const auto vector = [&] { return Vec3{number(random), number(random), number(random)}; };
  std::vector<BandRow> rows(count);
  for (BandRow& row : rows) {
    row.diagonal = {16, 17, 18, number(random), number(random), number(random)};
    row.next = {vector(), vector(), vector()};
    row.after = {vector(), vector(), vector()};
    row.right = vector();
  }
  return rows;
}

Vec3 product(const std::vector<BandRow>& rows, const std::vector<uint32_t>& order, size_t i,
             const std::vector<Vec3>& x) {
  Vec3 sum = rows[order[i]].diagonal * x[i];
  if (i >= 1) sum += rows[order[i - 1]].next * x[i - 1];
  if (i >= 2) sum += rows[order[i - 2]].after * x[i - 2];
  if (i + 1 < x.size()) sum += transposed_times(rows[order[i]].next, x[i + 1]);
  if (i + 2 < x.size()) sum += transposed_times(rows[order[i]].after, x[i + 2]);
  return sum;
}

void expect_solved(const cloth::RodChain& chain, uint32_t cut) {
  const std::vector<BandRow> before = random_band(2 * (chain.first + chain.count), 7);
  std::vector<BandRow> rows = before;
  const cloth::BandOrder order{chain, cut};
  solve_band({rows.data(), static_cast<uint32_t>(rows.size())}, order);
  std::vector<uint32_t> places;
  std::vector<Vec3> x;
  for (uint32_t i = 0; i < order.count(); ++i) {
    places.push_back(order[i]);
    x.push_back(rows[order[i]].right);
  }
  for (size_t i = 0; i < x.size(); ++i)
    EXPECT_NEAR(length(product(before, places, i, x) - before[places[i]].right), 0, 1e-5) << "row " << i;
}

TEST(RodBand, IsSolved) {
  expect_solved({3, 20, 0}, 0);
  expect_solved({0, 1, 0}, 0);
  expect_solved({0, 2, 0}, 0);
}

TEST(RodBand, IsSolvedFromAnywhereInALoop) {
  expect_solved({2, 15, 1}, 0);
  expect_solved({2, 15, 1}, 7);
  expect_solved({0, 3, 1}, 1);
}

}  // namespace

}  // namespace meniscus::tests
