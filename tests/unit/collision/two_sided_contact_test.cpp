// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A vertex between two surfaces, against sweeps over one contact after the other until nothing changes.
#include "collision/contact/two_sided_contact.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace meniscus::collision {
namespace {

constexpr float radius = 0.004f;

struct TwoSided {
  pbd::Contact floor{}, body{};
  float w;  ///< 1/kg, of the vertex
  Vec3 x{0, 0, 0};
};

pbd::Contact contact(Vec3 normal, float lack, float give, float friction) {
  pbd::Contact c{};
  c.normal = normal;
  c.point = -(radius - lack) * normal;
  c.radius = radius;
  c.friction = friction;
  c.body_inverse_mass = give;
  c.body = pbd::no_index;
  return c;
}

/// From a vertex as heavy as what presses on it to one of a ten-thousandth.
std::vector<TwoSided> cases() {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> share(-1, 1);
  std::vector<TwoSided> all;
  for (int k = 0; k < 400; ++k) {
    TwoSided p;
    p.w = 5000;
    const float body_give = p.w * std::pow(10.0f, -2 - 2 * share(random));
    const float floor_give = k % 2 ? 0 : p.w * std::pow(10.0f, -2 - 2 * share(random));
    p.floor = contact({0, 1, 0}, 0.1f * radius * share(random), floor_give, 0.8f);
    p.body = contact({0, -1, 0}, 0.1f * radius * share(random), body_give, 0.5f);
    all.push_back(p);
  }
  return all;
}

/// How far the contact lacks its distance when it and the body behind it have moved, m.
double lack(const pbd::Contact& c, const TwoSided& before, double moved_y) {
  const double distance = double{plane_distance(c, before.x)} + double{c.normal.y} * moved_y;
  return double{c.radius} - distance - double{c.body_inverse_mass} * double{c.normal_multiplier};
}

// Of two constraints with λ ≥ 0, C ≥ 0 and λ C = 0 there is one solution, which sweeps come to in the end.
TEST(TwoSidedContactTest, IsWhereSweepsWouldTakeIt) {
  for (const TwoSided& before : cases()) {
    double floor = 0, body = 0;  // multipliers
    const double w = double{before.w};
    for (int sweep = 0; sweep < 200'000; ++sweep) {
      const double lack_floor = double{radius} - double{plane_distance(before.floor, before.x)};
      const double lack_body = double{radius} - double{plane_distance(before.body, before.x)};
      floor = std::max(0.0, (lack_floor + w * body) / (w + double{before.floor.body_inverse_mass}));
      body = std::max(0.0, (lack_body + w * floor) / (w + double{before.body.body_inverse_mass}));
    }
    TwoSided p = before;
    const Vec3 push = two_sided_between(p.floor, p.body, p.w).push_apart(p.x, 1);
    const double scale = std::max({floor, body, 1e-9});
    EXPECT_NEAR(double{p.floor.normal_multiplier}, floor, 1e-3 * scale);
    EXPECT_NEAR(double{p.body.normal_multiplier}, body, 1e-3 * scale);
    EXPECT_NEAR(double{push.y}, floor - body, 1e-3 * scale);
    EXPECT_LT(lack(p.floor, before, w * double{push.y}), 1e-3 * double{radius});
    EXPECT_LT(lack(p.body, before, w * double{push.y}), 1e-3 * double{radius});
  }
}

// Contacts take back what they pushed too far, and never pull.
TEST(TwoSidedContactTest, IsReleased) {
  for (const TwoSided& before : cases()) {
    TwoSided p = before;
    p.x += p.w * two_sided_between(p.floor, p.body, p.w).push_apart(p.x, 1);
    p.body.point -= 0.5f * radius * p.body.normal;  // it leaves
    p.x += p.w * two_sided_between(p.floor, p.body, p.w).push_apart(p.x, 1);
    EXPECT_GE(p.floor.normal_multiplier, 0);
    EXPECT_EQ(p.body.normal_multiplier, 0);
    if (p.floor.body_inverse_mass == 0) {
      EXPECT_GT(plane_distance(p.floor, p.x), 0.99f * radius);
    }
  }
}

class TwoSidedFriction : public testing::Test {
 protected:
  /// Under a load of 1 kg·m on both, where the body has been displaced sideways by `way`.
  static TwoSided under_load(float body_give, float way) {
    TwoSided p;
    p.w = 5000;
    p.floor = contact({0, 1, 0}, 0, 0, 0.8f);
    p.body = contact({0, -1, 0}, 0, body_give, 0.5f);
    p.floor.normal_multiplier = p.body.normal_multiplier = 1;
    p.body.surface_motion = {way, 0, 0};
    return p;
  }
};

// The slip of a body is corrected at once, however light the vertex, because the vertex has pushed the body
// back.
TEST_F(TwoSidedFriction, TakesTheBodyBack) {
  constexpr float give = 0.1f, way = 0.02f;
  TwoSided p = under_load(give, way);
  const Vec3 push = two_sided_between(p.floor, p.body, p.w).apply_friction({0, 0, 0});
  EXPECT_NEAR(p.body.tangent_multiplier.x, way / give, 1e-3f * way / give);
  EXPECT_NEAR(p.floor.tangent_multiplier.x, -way / give, 1e-3f * way / give);
  EXPECT_LT(length(p.w * push), 1e-3f * way) << "the vertex stays on the floor";
}

// With no more than Coulomb's law gives.
TEST_F(TwoSidedFriction, EndsWithTheLoad) {
  constexpr float give = 0.1f, way = 0.2f;  // 2 kg·m would take it back
  for (const bool through : {false, true}) {
    TwoSided p = under_load(give, way);
    const TwoSidedContact both_sides = two_sided_between(p.floor, p.body, p.w);
    if (through)
      both_sides.transfer_friction({0, 0, 0});
    else
      EXPECT_LT(length(p.w * both_sides.apply_friction({0, 0, 0})), 1e-3f * way);
    EXPECT_NEAR(p.body.tangent_multiplier.x, 0.5f, 1e-4f);
    EXPECT_NEAR(p.floor.tangent_multiplier.x, -0.5f, 1e-4f);
  }
}

// On a floor that is smoother than the body it goes along with the body.
TEST_F(TwoSidedFriction, LeavesTheVertexOnTheRougherOne) {
  constexpr float give = 0.1f, way = 0.2f;
  TwoSided p = under_load(give, way);
  p.floor.friction = 0.2f;
  const Vec3 push = two_sided_between(p.floor, p.body, p.w).apply_friction({0, 0, 0});
  EXPECT_NEAR(p.floor.tangent_multiplier.x, -0.2f, 1e-4f);
  EXPECT_NEAR(p.body.tangent_multiplier.x, 0.2f, 1e-3f);
  EXPECT_NEAR(p.w * push.x, way - give * 0.2f, 1e-2f * way);
}

// If neither surface holds the vertex, as when it is pulled out between the two, no force is transferred
// between them. Each has its own friction.
TEST_F(TwoSidedFriction, IsNotHandedThroughAVertexThatSlipsOnBoth) {
  TwoSided p = under_load(0.1f, 0.2f);
  two_sided_between(p.floor, p.body, p.w).transfer_friction({0.5f, 0, 0});
  EXPECT_EQ(length(p.body.tangent_multiplier), 0);
  EXPECT_EQ(length(p.floor.tangent_multiplier), 0);
}

TEST(OpposedPair, IsOfContactsThatFaceEachOther) {
  const float tilt = 0.3f;
  std::vector<pbd::Contact> contacts = {contact({0, 1, 0}, 0.1f * radius, 0, 0.5f),
                                        contact({1, 0, 0}, 0.1f * radius, 1, 0.5f),
                                        contact({std::sin(tilt), -std::cos(tilt), 0}, 0.1f * radius, 1, 0.5f),
                                        contact({0, -1, 0}, 0.1f * radius, 1, 0.5f)};
  const auto find = [&](uint32_t end) {
    const pbd::View<const pbd::Contact> all{contacts.data(), static_cast<uint32_t>(contacts.size())};
    return find_opposed(all, 0, end, {0, 0, 0});
  };
  EXPECT_FALSE(find(2).is_there());
  EXPECT_TRUE(find(3).has(0) && find(3).has(2));
  EXPECT_TRUE(find(4).has(0) && find(4).has(3)) << "the straightest";
  contacts[3].body_inverse_mass = contacts[2].body_inverse_mass = 0;
  EXPECT_FALSE(find(4).is_there()) << "nothing gives way";
}

// A body whose edge is just past the vertex: what it presses with must not squeeze the vertex out.
TEST(TwoSidedContactTest, IsNotSqueezedOut) {
  const float tilt = 0.05f;
  TwoSided p;
  p.w = 5000;
  p.floor = contact({0, 1, 0}, 0.02f * radius, 0, 0.5f);
  p.body = contact({std::sin(tilt), -std::cos(tilt), 0}, 0.02f * radius, 1, 0.5f);
  const Vec3 moved = p.w * two_sided_between(p.floor, p.body, p.w).push_apart(p.x, 1);
  EXPECT_LT(length(moved), 0.05f * radius);
  EXPECT_GT(p.body.normal_multiplier, 0.03f * radius);
  const Vec3 on_vertex = multiplier_sum(p.floor) + multiplier_sum(p.body);
  EXPECT_NEAR(p.w * length(on_vertex), length(moved), 1e-2f * radius) << "what it did is what it took";
}

}  // namespace
}  // namespace meniscus::collision
