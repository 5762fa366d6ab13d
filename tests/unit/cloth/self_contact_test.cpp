// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tests of cloth that collides with cloth.
#include "cloth/self_contact/self_contacts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <random>

#include "tests/bench/harness/self_contact_bench.h"
#include "tests/devices.h"
#include "tests/many_threads.h"
#include "tests/triangle_intersections.h"

namespace meniscus::tests {
namespace {

constexpr float spacing = 0.01f, thickness = 0.006f, mass = 2e-5f, substep = 0.002f;

cloth::ContactPiece piece(float friction = 0.3f) {
  cloth::ContactPiece p;
  p.thickness = thickness;
  p.friction = friction;
  return p;
}

size_t intersections(SelfContactBench& bench, const ClothCase& c) {
  std::vector<TriangleCorners> triangles;
  for (const pbd::SurfaceTriangle& t : c.triangles) triangles.push_back({t.a, t.b, t.c});
  const std::vector<Vec3> x = bench.positions();
  return TriangleIntersections(x, triangles).count();
}

struct Momentum {
  double x = 0, y = 0, z = 0;
};
Momentum momentum(SelfContactBench& bench, const ClothCase& c) {
  Momentum sum;
  const std::vector<Vec3> v = bench.velocities();
  for (size_t i = 0; i < v.size(); ++i) {
    const double m = 1.0 / double(c.vertices[i].w);
    sum.x += m * double(v[i].x), sum.y += m * double(v[i].y), sum.z += m * double(v[i].z);
  }
  return sum;
}

/// A sheet above another, turned by 30° and a little wavy, so that vertices meet triangles everywhere.
ClothCase two_sheets(float gap, float speed, int side = 21) {
  ClothCase c;
  c.add_sheet(side, side, spacing, mass, piece(),
              [](float u, float v) {
                return Vec3{u, 0, v};
              },
              {0, 0.5f * speed, 0});
  c.add_sheet(side, side, spacing, 2 * mass, piece(),
              [=](float u, float v) {
                const float wave = 0.2f * thickness * std::sin(200 * u);
                return Vec3{0.866f * u - 0.5f * v, gap + wave, 0.5f * u + 0.866f * v};
              },
              {0, -0.5f * speed, 0});
  return c;
}

/// A sheet that lies folded over in three layers, one thickness and a half apart, the lowest of which is
/// held.
ClothCase folded(int columns, int rows) {
  ClothCase c;
  c.gravity = {0, -9.81f, 0};
  const float gap = 1.5f * thickness, radius = 0.5f * gap, bend = 3.14159265f * radius;
  const float straight = (spacing * float(columns - 1) - 2 * bend) / 3;
  c.add_sheet(columns, rows, spacing, mass, piece(), [=](float u, float v) {
    float s = u + 0.5f * spacing * float(columns - 1);
    if (s < straight) return Vec3{s, 0, v};
    s -= straight;
    if (s < bend)
      return Vec3{straight + radius * std::sin(s / radius), radius - radius * std::cos(s / radius), v};
    s -= bend;
    if (s < straight) return Vec3{straight - s, gap, v};
    s -= straight;
    if (s < bend)
      return Vec3{-radius * std::sin(s / radius), gap + radius - radius * std::cos(s / radius), v};
    return Vec3{s - bend, 2 * gap, v};
  });
  for (size_t i = 0; i < c.vertices.size(); ++i)
    if (c.rest[i].x < -0.5f * spacing * float(columns - 1) + straight) c.vertices[i].w = 0;
  return c;
}

class SelfContactTest : public OnDevice {
 protected:
  std::unique_ptr<SelfContactBench> bench(const ClothCase& c) const {
    return make_self_contact_bench(GetParam(), c);
  }
};

TEST_P(SelfContactTest, CollidingSheetsKeepMomentum) {
  for (float speed : {0.5f, 3.0f}) {
    const ClothCase c = two_sheets(2 * thickness, speed, 15);
    const auto b = bench(c);
    const Momentum before = momentum(*b, c);
    const double scale = 225 * double(mass) * double(speed);
    uint32_t contacts = 0;
    for (int k = 0; k < 10; ++k) {
      b->step(5 * substep);
      contacts = std::max(contacts, b->most_contacts());
      const Momentum now = momentum(*b, c);
      EXPECT_NEAR(now.x, before.x, 1e-5 * scale);
      EXPECT_NEAR(now.y, before.y, 1e-5 * scale);
      EXPECT_NEAR(now.z, before.z, 1e-5 * scale);
      EXPECT_EQ(b->most_crossings(), 0u) << "at " << speed << " m/s";
    }
    EXPECT_GT(contacts, 150u);
    EXPECT_EQ(intersections(*b, c), 0u);
  }
}

/// One iteration leaves much of a fast collision to the CCD fail-safe. Away from the origin and in short
/// substeps the rounding of positions would matter. The momentum must not change.
TEST_P(SelfContactTest, WhatTheGuardJoinsKeepsItsMomentum) {
  struct Place {
    float away, substep;  // m, s
  };
  for (const Place& place : {Place{0, substep}, Place{2, 0.2f * substep}}) {
    ClothCase c = two_sheets(2 * thickness, 6, 15);
    for (pbd::Vec4& x : c.vertices) x = pbd::with_w(x.xyz() + place.away * Vec3{1, -0.7f, 0.9f}, x.w);
    c.iterations = 1;
    const auto b = bench(c);
    const Momentum before = momentum(*b, c);
    const double scale = 225 * double(mass) * 6;
    uint32_t joined = 0;
    for (int k = 0; k < 10; ++k) {
      b->step(5 * place.substep);
      joined = std::max(joined, b->most_crossings());
      const Momentum now = momentum(*b, c);
      EXPECT_NEAR(now.x, before.x, 5e-7 * scale) << "at " << place.away << " m";
      EXPECT_NEAR(now.y, before.y, 5e-7 * scale) << "at " << place.away << " m";
      EXPECT_NEAR(now.z, before.z, 5e-7 * scale) << "at " << place.away << " m";
    }
    EXPECT_GT(joined, 0u);
    EXPECT_EQ(intersections(*b, c), 0u);
  }
}

/// A sheet between two that are driven through it and through one another: no motion of it is right.
TEST_P(SelfContactTest, CountsSubstepsInWhichNoRoundsSuffice) {
  ClothCase c;
  c.substeps = 1;
  c.keeps_edges = false;
  for (const float side : {0.0f, -1.0f, 1.0f}) {
    c.add_sheet(9, 9, spacing, mass, piece(),
                [&](float u, float v) {
                  return Vec3{u + 0.2f * spacing * side, 1.5f * thickness * side, v};
                },
                {0, -4 * side * thickness / substep, 0});
  }
  for (size_t i = 81; i < c.vertices.size(); ++i) c.vertices[i].w = 0;
  const auto b = bench(c);
  b->step(substep);
  EXPECT_EQ(b->given_up(), 1u);
  for (size_t i = 0; i < 81; ++i) EXPECT_EQ(b->positions()[i].y, 0);
  const auto others = bench(two_sheets(2 * thickness, 6, 15));
  others->step(5 * substep);
  EXPECT_EQ(others->given_up(), 0u);
}

/// Whether vertices of the first sheet's middle are still below those of the second near them.
void expect_in_order(std::span<const Vec3> x, size_t first_sheet, float thicknesses) {
  for (size_t i = 0; i < first_sheet; ++i) {
    if (std::hypot(x[i].x, x[i].z) > 2.5f * spacing) continue;
    for (size_t j = first_sheet; j < x.size(); ++j) {
      if (std::hypot(x[i].x - x[j].x, x[i].z - x[j].z) < 0.2f * spacing) {
        EXPECT_LT(x[i].y, x[j].y) << thicknesses << " thicknesses a substep";
      }
    }
  }
}

/// The pairs of features, of all there are, that meet on their way from one state to the next.
size_t passages(const ClothCase& c, std::span<const Vec3> from, std::span<const Vec3> to) {
  constexpr float least = 1e-7f;  // m
  std::vector<std::array<uint32_t, 2>> edges;
  for (const pbd::SurfaceTriangle& t : c.triangles)
    for (const auto& [a, b] : {std::minmax(t.a, t.b), std::minmax(t.b, t.c), std::minmax(t.c, t.a)})
      edges.push_back({a, b});
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  const auto meet = [&](const std::array<uint32_t, 4>& corners, bool are_edges) {
    pbd::FeaturePair pair{};
    pair.edges = are_edges;
    for (size_t k = 0; k < 4; ++k) {
      for (size_t n = 0; n < k; ++n)
        if (corners[k] == corners[n]) return false;
      pair.start[k] = from[corners[k]] - from[corners[0]];
      pair.motion[k] = (to[corners[k]] - from[corners[k]]) - (to[corners[0]] - from[corners[0]]);
    }
    return pbd::nearest(pair, 0).distance < pbd::relative_motion(pair) + least &&
           pbd::time_of_nearness(pair, least) <= 1;
  };
  size_t count = 0;
  for (const pbd::SurfaceTriangle& t : c.triangles)
    for (uint32_t v = 0; v < from.size(); ++v) count += meet({v, t.a, t.b, t.c}, false);
  for (size_t e = 0; e < edges.size(); ++e)
    for (size_t f = 0; f < e; ++f) count += meet({edges[e][0], edges[e][1], edges[f][0], edges[f][1]}, true);
  return count;
}

TEST_P(SelfContactTest, NothingGoesThroughHoweverFast) {
  for (float thicknesses : {1.0f, 2.0f, 5.0f, 10.0f, 20.0f}) {
    const float speed = thicknesses * thickness / substep;
    const ClothCase c = two_sheets(3 * thickness + 0.003f, speed, 9);
    const auto b = bench(c);
    for (int n = 0; n < 2; ++n) {
      b->step(5 * substep);
      EXPECT_EQ(intersections(*b, c), 0u) << thicknesses << " thicknesses a substep";
      EXPECT_EQ(b->given_up(), 0u) << thicknesses << " thicknesses a substep";
      // Faster sheets crumple to bundles of upright folds.
      if (thicknesses < 20) expect_in_order(b->positions(), 81, thicknesses);
    }
  }
}

// Sheets that collide so fast may fold around one another, so pairs are looked at on their way.
TEST_P(SelfContactTest, NoPairMeetsOnItsWayHoweverFast) {
  for (float thicknesses : {5.0f, 20.0f}) {
    ClothCase c = two_sheets(3 * thickness + 0.003f, thicknesses * thickness / substep, 9);
    c.substeps = 1;
    const auto b = bench(c);
    std::vector<Vec3> from = b->positions();
    for (int k = 0; k < 10; ++k) {
      b->step(substep);
      const std::vector<Vec3> to = b->positions();
      EXPECT_EQ(passages(c, from, to), 0u) << thicknesses << " thicknesses a substep, substep " << k;
      from = to;
    }
  }
}

/// Their tree has more levels than those of small sheets, and is looked through from higher up.
TEST_P(SelfContactTest, NothingGoesThroughLargeSheets) {
  constexpr int side = 100;
  ClothCase c = two_sheets(2 * thickness, 3, side);
  c.substeps = 1;
  c.keeps_edges = false;
  const auto b = bench(c);
  for (int k = 0; k < 6; ++k) {
    b->step(substep);
    EXPECT_EQ(intersections(*b, c), 0u) << "after substep " << k;
  }
  EXPECT_GT(b->most_contacts(), 10000u);
}

TEST_P(SelfContactTest, AFoldedSheetKeepsItsLayersApart) {
  const ClothCase c = folded(61, 12);
  const auto b = bench(c);
  ASSERT_EQ(intersections(*b, c), 0u);
  for (int k = 0; k < 25; ++k) {
    b->step(5 * substep);
    EXPECT_EQ(intersections(*b, c), 0u) << "after step " << k;
  }
  EXPECT_GT(b->most_contacts(), 200u);
  double top = 0;
  const std::vector<Vec3> x = b->positions();
  for (size_t i = 0; i < x.size(); ++i)
    if (i % 61 >= 46 && i % 61 < 59) top += double(x[i].y) / (12 * 13);
  EXPECT_NEAR(top, 2 * thickness, 0.05 * thickness);
}

TEST_P(SelfContactTest, PairsAreLookedForAsOftenAsClothMoves) {
  const ClothCase c = folded(41, 12);
  const auto b = bench(c);
  for (int k = 0; k < 40; ++k) b->step(5 * substep);
  EXPECT_EQ(b->listings(), 1u);  // of 5 substeps
  EXPECT_EQ(b->one_substep_listings(), 0u);
  const ClothCase fast = two_sheets(2 * thickness, 3, 9);
  const auto other = bench(fast);
  other->step(5 * substep);
  EXPECT_GE(other->listings(), 3u);
}

/// The most pairs of features that are listed while a rippled sheet and the same sheet above it fly on, each
/// with a velocity of its own.
uint32_t listed_pairs(SelfContactBench& bench) {
  uint32_t most = 0;
  for (int k = 0; k < 4; ++k) {
    bench.step(5 * substep);
    most = std::max(most, bench.most_candidates());
  }
  return most;
}

ClothCase rippled_sheets(float gap, Vec3 lower, Vec3 upper) {
  ClothCase c;
  for (const bool above : {false, true}) {
    c.add_sheet(
        21, 21, spacing, mass, piece(),
        [&](float u, float v) {
          return Vec3{u, (above ? gap : 0.0f) + 0.4f * thickness * std::sin(300 * u), v};
        },
        above ? upper : lower);
  }
  return c;
}

// What all cloth shares costs nothing.
TEST_P(SelfContactTest, PairsAreThoseAtRestHoweverFastAllMove) {
  const Vec3 still{0, 0, 0};
  for (const float gap : {1.3f * thickness, 0.1f}) {
    const ClothCase rest = rippled_sheets(gap, still, still);
    const uint32_t at_rest = listed_pairs(*bench(rest));
    for (const Vec3 velocity : {Vec3{50, 0, 0}, Vec3{-20, 35, 60}}) {
      const ClothCase moving = rippled_sheets(gap, velocity, velocity);
      const auto b = bench(moving);
      const uint32_t found = listed_pairs(*b);
      EXPECT_GT(found, 0u);
      EXPECT_NEAR(found, at_rest, 0.1 * at_rest) << "at " << velocity.x << " m/s";
      EXPECT_EQ(b->listings(), 1u);
    }
  }
}

// A flag on a vehicle that drives past others.
TEST_P(SelfContactTest, PartsThatMoveApartCostNoMore) {
  const uint32_t at_rest = listed_pairs(*bench(rippled_sheets(0.1f, {0, 0, 0}, {0, 0, 0})));
  const uint32_t found = listed_pairs(*bench(rippled_sheets(0.1f, {0, 0, 0}, {50, 0, 0})));
  EXPECT_LT(found, 1.1 * at_rest);
}

/// Small sheets, each with a velocity of its own and with vertices that move to and fro, on their way past
/// and into one another.
ClothCase swarm(std::mt19937& random, float relative_speed, Vec3 common) {
  std::uniform_real_distribution<float> any(-1, 1);
  const auto direction = [&] { return Vec3{any(random), any(random), any(random)}; };
  ClothCase c;
  c.substeps = 1;
  c.keeps_edges = false;
  for (int n = 0; n < 5; ++n) {
    const Vec3 origin{3 * spacing * any(random), 3.5f * thickness * float(n), 3 * spacing * any(random)};
    const Vec3 velocity = common + relative_speed * direction();
    c.add_sheet(6, 6, spacing, mass, piece(), [&](float u, float v) { return origin + Vec3{u, 0, v}; });
    for (size_t v = c.velocities.size() - 36; v < c.velocities.size(); ++v)
      c.velocities[v] = velocity + 0.2f * relative_speed * direction();
  }
  return c;
}

// Against all pairs there are, with pieces in frames of their own.
TEST_P(SelfContactTest, NoPairThatMeetsIsMissedHoweverFastAllMove) {
  std::mt19937 random(5);
  for (const float speed : {3.0f, 30.0f}) {
    for (const Vec3 common : {Vec3{0, 0, 0}, Vec3{50, 0, 0}, Vec3{-20, 35, 60}}) {
      const ClothCase c = swarm(random, speed, common);
      const auto b = bench(c);
      std::vector<Vec3> from = b->positions();
      for (int k = 0; k < 4; ++k) {
        b->step(substep);
        const std::vector<Vec3> to = b->positions();
        EXPECT_EQ(passages(c, from, to), 0u) << speed << " m/s in " << common.x << " m/s, step " << k;
        from = to;
      }
    }
  }
}

// If candidates for many substeps would not even be valid for two, none are kept, nor at the start of the
// next step. Cloth that is thrown up past a vertex that is held keeps them again where it is slow.
TEST_P(SelfContactTest, PairsOfFastClothAreLookedForForASubstepAlone) {
  constexpr float speed = 6;
  constexpr int steps = 20;  // to the top
  ClothCase c;
  c.add_sheet(9, 9, spacing, mass, piece(), [](float u, float v) { return Vec3{u, 0, v}; }, {0, speed, 0});
  c.gravity = {0, -speed / (steps * 5 * substep), 0};
  c.keeps_edges = false;
  c.vertices[0].w = 0;
  c.velocities[0] = {0, 0, 0};
  const auto b = bench(c);
  b->step(5 * substep);
  EXPECT_EQ(b->listings(), 5u);
  EXPECT_GE(b->one_substep_listings(), 4u);
  b->step(5 * substep);
  EXPECT_EQ(b->one_substep_listings(), 5u);
  for (int k = 2; k < steps + 1; ++k) b->step(5 * substep);
  EXPECT_LT(b->listings(), 5u);
  EXPECT_EQ(b->one_substep_listings(), 0u);
}

TEST_P(SelfContactTest, SameBitsForAnyNumberOfThreads) {
  if (GetParam() != pbd::DeviceKind::cpu) GTEST_SKIP() << "threads are the CPU's";
  const ManyThreads many;
  const ClothCase c = folded(41, 16);
  std::vector<Vec3> first;
  for (int threads : {1, 2, 3, 8}) {
    const auto b = make_cpu_self_contact_bench(c, threads);
    for (int k = 0; k < 12; ++k) b->step(5 * substep);
    EXPECT_GT(b->most_contacts(), 250u);
    const std::vector<Vec3> x = b->positions();
    if (first.empty()) first = x;
    EXPECT_EQ(std::memcmp(x.data(), first.data(), x.size() * sizeof(Vec3)), 0) << threads << " threads";
  }
}

TEST_P(SelfContactTest, SameBitsEachTime) {
  const ClothCase c = folded(41, 16);
  std::vector<Vec3> first;
  for (int run = 0; run < 3; ++run) {
    const auto b = bench(c);
    for (int k = 0; k < 12; ++k) b->step(5 * substep);
    const std::vector<Vec3> x = b->positions();
    if (first.empty()) first = x;
    EXPECT_EQ(std::memcmp(x.data(), first.data(), x.size() * sizeof(Vec3)), 0) << "run " << run;
  }
}

TEST_P(SelfContactTest, FiltersSayWhoMeetsWhom) {
  ClothCase c = two_sheets(2 * thickness, 3.0f, 11);
  c.pieces[1].filter.mask = ~1u;
  c.keeps_edges = false;
  const auto b = bench(c);
  for (int k = 0; k < 4; ++k) b->step(5 * substep);
  EXPECT_EQ(b->most_contacts(), 0u);
  for (Vec3 v : b->velocities()) EXPECT_NEAR(std::fabs(v.y), 1.5f, 1e-4f);
}

TEST_P(SelfContactTest, APartMayLeaveItselfAlone) {
  ClothCase c = folded(41, 10);
  c.pieces[0].self = false;
  const auto b = bench(c);
  for (int k = 0; k < 15; ++k) b->step(5 * substep);
  EXPECT_EQ(b->most_contacts(), 0u);
  EXPECT_GT(intersections(*b, c), 10u);
}

TEST_P(SelfContactTest, AMeshFinerThanItsThicknessStaysAtRest) {
  ClothCase c;
  cloth::ContactPiece thick = piece();
  thick.thickness = 3.7f * spacing;
  // Bent along a quarter of a cylinder, so that its normals are no one sheet's.
  const float radius = 0.03f;
  c.add_sheet(15, 15, spacing, mass, thick, [=](float u, float v) {
    return Vec3{radius * std::sin(u / radius), radius * std::cos(u / radius), v};
  });
  c.keeps_edges = false;
  for (size_t i = 0; i < c.rest.size(); ++i) c.rest[i] = c.vertices[i].xyz();
  const auto b = bench(c);
  for (int k = 0; k < 5; ++k) b->step(5 * substep);
  for (Vec3 v : b->velocities()) EXPECT_EQ(length(v), 0);
}

TEST_P(SelfContactTest, OverlapIsOpenedSlowly) {
  for (float gap : {0.0f, 0.02f, 0.5f}) {
    ClothCase c = two_sheets(gap * thickness, 0, 13);
    for (size_t i = 169; i < 338; ++i) c.vertices[i].y = gap * thickness;
    const auto b = bench(c);
    for (int k = 0; k < 8; ++k) {
      b->step(5 * substep);
      for (Vec3 v : b->velocities()) EXPECT_LT(length(v), 2 * thickness / 0.02f) << "gap " << gap;
    }
  }
}

TEST_P(SelfContactTest, FrictionStopsASlidingSheet) {
  // v²/(2μg) is the distance that it slides.
  constexpr float mu = 0.4f, speed = 0.5f;
  ClothCase c;
  c.gravity = {0, -9.81f, 0};
  c.add_sheet(41, 15, spacing, mass, piece(mu), [](float u, float v) { return Vec3{u, 0, v}; });
  for (pbd::Vec4& x : c.vertices) x.w = 0;
  c.add_sheet(9, 9, spacing, mass, piece(mu),
              [](float u, float v) {
                return Vec3{u - 0.1f, thickness, v + 0.002f};
              },
              {speed, 0, 0});
  const auto b = bench(c);
  const auto middle = [&] {
    double x = 0;
    const std::vector<Vec3> positions = b->positions();
    for (size_t i = 615; i < 696; ++i) x += double(positions[i].x) / 81;
    return x;
  };
  const double start = middle();
  for (int k = 0; k < 20; ++k) b->step(5 * substep);
  EXPECT_NEAR(middle() - start, speed * speed / (2 * mu * 9.81f), 0.1 * speed * speed / (2 * mu * 9.81f));
  for (size_t i = 615; i < 696; ++i) EXPECT_LT(length(b->velocities()[i]), 0.02f);
}

MENISCUS_ON_EACH_DEVICE(SelfContactTest);

}  // namespace
}  // namespace meniscus::tests
