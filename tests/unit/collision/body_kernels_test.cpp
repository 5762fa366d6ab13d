// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The kernels of rigid bodies one by one: grouping, mass splitting, sums, and what shapes a body carries.
#include "collision/body/body_kernels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <vector>

#include "collision/contact/contact_set.inl"
#include "tests/unit/collision/mesh_shapes.h"

namespace meniscus::collision {
namespace {

using namespace body_kernels;
using pbd::Vec4;

template <class T>
View<T> view(std::vector<T>& values) {
  return {values.data(), static_cast<uint32_t>(values.size())};
}

template <class Kernel>
void launch(size_t count, const Kernel& kernel) {
  for (uint32_t i = 0; i < count; ++i) kernel(i);
}

/// Bodies and their contacts, as the solver has them within a substep.
struct Bench {
  static constexpr uint32_t lanes = 16;
  static constexpr float radius = 0.025f;

  std::vector<BodyProxy> bodies;
  std::vector<Contact> contacts;
  std::vector<uint32_t> touching, touching_counts, start{0}, particle, key, sorted_key, number, grouped, slot;
  std::vector<Vec4> position, previous, moved;
  std::vector<ContactSum> partial;
  std::vector<ContactMotion> motion, next_motion;  // of the bodies

  void add_body(float mass, Vec3 inertia, Vec3 centre) {
    BodyProxy body{};
    body.start = body.pose = {centre, {0, 0, 0, 1}};
    body.inverse_mass = 1 / mass;
    body.inverse_inertia = {1 / inertia.x, 1 / inertia.y, 1 / inertia.z};
    bodies.push_back(body);
  }

  /// A particle that is `depth` too near to a surface of the body with this normal.
  void add_contact(uint32_t body, Vec3 point, Vec3 normal, float particle_mass, float depth) {
    touching.push_back(static_cast<uint32_t>(position.size()));
    position.push_back(pbd::with_w(point + (radius - depth) * normal, 1 / particle_mass));
    slot.push_back(0);
    previous = moved = position;
    start.push_back(start.back());
    add_contact_of_last(body, point, normal);
  }

  /// One more of the last particle.
  void add_contact_of_last(uint32_t body, Vec3 point, Vec3 normal) {
    Contact c{};
    c.point = point;
    c.normal = normal;
    c.body = body;
    c.fraction = 1;
    c.radius = radius;
    contacts.push_back(c);
    particle.push_back(touching.back());
    ++start.back();
  }

  ContactView contact_view() {
    touching_counts = {static_cast<uint32_t>(touching.size()), 0};
    return {view(start), view(contacts), view(particle), {view(touching), view(touching_counts)}};
  }

  void group() {
    const size_t n = contacts.size();
    for (auto* values : {&key, &sorted_key, &number, &grouped}) values->resize(n);
    const auto count = static_cast<uint32_t>(bodies.size());
    launch(n, NoteBodies{contact_view(), view(position), view(key), view(number), count});
    grouped = number;
    std::stable_sort(grouped.begin(), grouped.end(), [&](uint32_t a, uint32_t b) { return key[a] < key[b]; });
    std::transform(grouped.begin(), grouped.end(), sorted_key.begin(), [&](uint32_t k) { return key[k]; });
    launch(n, FindGroups{view(sorted_key), view(bodies)});
    launch(n, Split{view(grouped), view(bodies), view(position), contact_view()});
    motion.assign(count, {{0, 0, 0}, {0, 0, 0}});
    next_motion = motion;
  }

  void sum(uint32_t lane_count = lanes) {
    partial.resize(bodies.size() * lane_count);
    launch(partial.size(), SumLanes{view(grouped), view(bodies), view(contacts), view(partial), lane_count});
  }

  void iterate() {
    launch(touching.size(),
           contact_kernels::Project{
               {{view(position), view(moved), view(previous), view(slot), contact_view()}, {}, 0}});
    sum();
    launch(contacts.size(), Follow{view(grouped), view(bodies), view(partial), view(motion),
                                   view(next_motion), contact_view(), lanes});
    motion.swap(next_motion);
  }

  float depth(size_t n) const { return radius - plane_distance(contacts[n], position[particle[n]].xyz()); }
  /// Σ m Δx of particles and bodies, kg·m.
  Vec3 momentum() const {
    Vec3 total{0, 0, 0};
    for (size_t i = 0; i < position.size(); ++i)
      total += 1 / position[i].w * (position[i].xyz() - previous[i].xyz());
    for (size_t b = 0; b < bodies.size(); ++b) total += 1 / bodies[b].inverse_mass * motion[b].shift;
    return total;
  }
};

TEST(BodyKernels, ContactsAreGroupedByTheirBodyInTheirOrder) {
  Bench bench;
  for (int b = 0; b < 4; ++b) bench.add_body(1, {1, 1, 1}, {0, 0, 0});
  for (uint32_t body : {2u, 0u, pbd::no_index, 2u, 3u, 2u, 0u})
    bench.add_contact(body, {0, 0, 0}, {0, 1, 0}, 1, 0);
  bench.group();
  const std::vector<uint32_t> expected{1, 6, 0, 3, 5, 4, 2};  // of a fixed shape: last
  EXPECT_EQ(bench.grouped, expected);
  const std::pair<uint32_t, uint32_t> groups[] = {{0, 2}, {0, 0}, {2, 5}, {5, 6}};
  for (int b = 0; b < 4; ++b) {
    EXPECT_EQ(bench.bodies[b].first, groups[b].first) << b;
    EXPECT_EQ(bench.bodies[b].end, groups[b].second) << b;
  }
  EXPECT_EQ(bench.contacts[2].body_inverse_mass, 0);
}

// w_b = n (1/M + (r × n)ᵀ I⁻¹ (r × n)), r to where the particle touches.
TEST(BodyKernels, AContactFindsItsLeverAndItsShare) {
  Bench bench;
  bench.add_body(4, {0.5f, 1, 2}, {1, 0, 0});
  bench.add_contact(0, {1.3f, 0.2f, 0}, {0, 1, 0}, 1, 0);
  bench.add_contact(0, {1, 0.2f, 0}, {0, 1, 0}, 1, 0);
  bench.group();
  const float up = 0.2f + Bench::radius;
  EXPECT_NEAR(length(bench.contacts[0].arm - Vec3{0.3f, up, 0}), 0, 1e-6f);
  EXPECT_NEAR(bench.contacts[0].body_inverse_mass, 2 * (0.25f + 0.09f / 2), 1e-5f);
  EXPECT_NEAR(bench.contacts[1].body_inverse_mass, 2 * 0.25f, 1e-6f);
}

// One that is pressed in will be pushed out to its radius.
TEST(BodyKernels, ALeverEndsWhereTheParticleWillBe) {
  for (float depth : {-0.01f, 0.0f, 0.01f}) {
    Bench bench;
    bench.add_body(4, {0.5f, 1, 2}, {1, 0, 0});
    bench.add_contact(0, {1.3f, 0.2f, 0}, {0, 1, 0}, 1, depth);
    bench.group();
    const float away = std::max(Bench::radius, Bench::radius - depth);
    EXPECT_NEAR(length(bench.contacts[0].arm - Vec3{0.3f, 0.2f + away, 0}), 0, 1e-6f) << depth;
  }
}

// Without the split, each of a hundred simultaneous contacts would move the body by the full distance.
TEST(BodyKernels, ManyContactsMoveABodyNoFurtherThanNeeded) {
  for (float particle_mass : {0.01f, 1.0f, 1e4f}) {
    Bench bench;
    bench.add_body(1, {1, 1, 1}, {0, 0, 0});
    constexpr float depth = 0.01f;
    for (int n = 0; n < 100; ++n) {
      const float x = 0.1f * (float(n % 10) - 4.5f), z = 0.1f * (float(n / 10) - 4.5f);
      bench.add_contact(0, {x, 0.1f, z}, {0, 1, 0}, particle_mass, depth);
    }
    bench.group();
    float before = 0;
    for (int k = 0; k < 60; ++k) {
      bench.iterate();
      const float shift = -bench.motion[0].shift.y;
      EXPECT_LE(shift, depth * 1.001f) << k;
      EXPECT_GE(shift, before - 1e-6f) << k;
      before = shift;
    }
    EXPECT_LT(length(bench.motion[0].turn), 1e-5f);
    for (size_t n = 0; n < 100; ++n) EXPECT_NEAR(bench.depth(n), 0, 0.02f * depth) << particle_mass;
    // Both sides move in proportion to their inverse masses.
    const float share = 100 * particle_mass / (100 * particle_mass + 1);
    EXPECT_NEAR(before, share * depth, 0.05f * share * depth) << particle_mass;
  }
}

// Two bodies that are pressed together in water, with a particle between them that cannot move away. Its push
// must not wait for the many particles that can.
TEST(BodyKernels, AParticleBetweenTwoBodiesHoldsThemApart) {
  constexpr int around = 60;
  constexpr float gap = 0.8f * Bench::radius, wanted = 2 * Bench::radius;
  Bench bench;
  for (float side : {-1.0f, 1.0f}) {
    const auto body = static_cast<uint32_t>(bench.bodies.size());
    bench.add_body(1, {1, 1, 1}, {0, side * (0.1f + gap / 2), 0});
    for (int n = 0; n < around; ++n)  // near, and not touched
      bench.add_contact(body, {0, side * (0.2f + gap / 2), 0}, {0, side, 0}, 0.1f, -0.5f * Bench::radius);
  }
  bench.add_contact(0, {0, -gap / 2, 0}, {0, 1, 0}, 0.1f, Bench::radius - gap / 2);
  bench.add_contact_of_last(1, {0, gap / 2, 0}, {0, -1, 0});
  bench.group();
  EXPECT_NEAR(bench.contacts[2 * around].body_inverse_mass, 2, 1e-5f);
  EXPECT_NEAR(bench.contacts[0].body_inverse_mass, 2 * around, 1e-3f);
  for (int k = 0; k < 4; ++k) bench.iterate();
  const float opened = bench.motion[1].shift.y - bench.motion[0].shift.y;
  EXPECT_GT(opened, 0.25f * (wanted - gap));
  EXPECT_LE(opened, 1.001f * (wanted - gap));
  for (int k = 0; k < 100; ++k) bench.iterate();
  EXPECT_NEAR(bench.motion[1].shift.y - bench.motion[0].shift.y, wanted - gap, 0.02f * wanted);
}

// A held particle stays, and records the impulse by which it has moved the body out, with friction.
TEST(BodyKernels, AHeldParticleRecordsWhatItWithstands) {
  constexpr float depth = 0.004f, held = std::numeric_limits<float>::infinity();
  for (int around : {0, 30}) {
    Bench bench;
    bench.add_body(2, {1, 1, 1}, {0, 0, 0});
    bench.add_contact(0, {0, 0.1f, 0}, {0, 1, 0}, held, depth);
    bench.contacts[0].friction = 0.5f;
    bench.contacts[0].surface_motion = {0.001f, 0, 0};
    for (int n = 0; n < around; ++n)  // near, and not touched
      bench.add_contact(0, {0, 0.1f, 0}, {0, 1, 0}, 0.1f, -0.5f * Bench::radius);
    bench.group();
    EXPECT_EQ(bench.position[0].w, 0);
    EXPECT_NEAR(bench.contacts[0].body_inverse_mass, around ? 1 : 0.5f, 1e-6f) << around;
    for (int k = 0; k < 20; ++k) bench.iterate();
    const Vec3 recorded = bench.moved[0].xyz() - bench.previous[0].xyz();  // it starts as the position
    const Vec3 motion = bench.motion[0].shift;
    EXPECT_EQ(bench.position[0].xyz(), bench.previous[0].xyz());
    EXPECT_NEAR(motion.y, -depth, 0.011f * Bench::radius) << around;
    EXPECT_NEAR(motion.x, -0.001f, 2e-4f) << around;
    EXPECT_NEAR(length(recorded + 2.0f * motion), 0, 1e-5f) << around;
  }
}

TEST(BodyKernels, NothingHappensBetweenAHeldParticleAndAnImmovableSurface) {
  Bench bench;
  bench.add_contact(pbd::no_index, {0, 0, 0}, {0, 1, 0}, std::numeric_limits<float>::infinity(), 0.01f);
  bench.contacts[0].friction = 0.5f;
  bench.add_contact_of_last(pbd::no_index, {0, 0.02f, 0}, {0, -1, 0});
  launch(1, contact_kernels::Project{{{view(bench.position), view(bench.moved), view(bench.previous),
                                       view(bench.slot), bench.contact_view()},
                                      {},
                                      0}});
  EXPECT_EQ(bench.position[0].xyz(), bench.previous[0].xyz());
  EXPECT_EQ(bench.moved[0].xyz(), bench.previous[0].xyz());
  EXPECT_EQ(bench.contacts[0].normal_multiplier, 0);
}

// Attachments are the last of a body's contacts, and leave half of the body to the others.
TEST(BodyKernels, TiesStandApartAndLeaveHalfOfTheBody) {
  Bench bench;
  bench.add_body(1, {1, 1, 1}, {0, 0, 0});
  bench.add_body(1, {1, 1, 1}, {9, 0, 0});
  for (bool is_attachment : {true, false, true, false}) {
    bench.add_contact(0, {0, 0.2f, 0}, {0, 1, 0}, 1, 0);
    if (!is_attachment) continue;
    bench.contacts.back().radius = -1;
    bench.contacts.back().body_inverse_mass = 7;
  }
  bench.add_contact(1, {9, 0.2f, 0}, {0, 1, 0}, 1, 0);
  bench.group();
  EXPECT_EQ(bench.grouped, (std::vector<uint32_t>{1, 3, 0, 2, 4}));
  const uint32_t expected[2][4] = {{0, 2, 2, 4}, {4, 5, 5, 5}};
  for (int b = 0; b < 2; ++b) {
    const BodyProxy& body = bench.bodies[b];
    const uint32_t found[] = {body.first, body.unyielding, body.attached, body.end};
    EXPECT_TRUE(std::equal(found, found + 4, expected[b])) << b;
  }
  EXPECT_EQ(bench.contacts[0].body_inverse_mass, 7);
  EXPECT_EQ(bench.contacts[1].body_inverse_mass, 4);
  EXPECT_EQ(bench.contacts[4].body_inverse_mass, 1);
}

TEST(BodyKernels, APointGivesWayMostInItsSoftestDirection) {
  Noise noise(7);
  for (int n = 0; n < 20; ++n) {
    BodyProxy body{};
    body.pose.rotation = rotation_by(noise.in_cube(3));
    body.inverse_mass = noise.next();
    const Vec3 i = noise.in_cube(10);
    body.inverse_inertia = {i.x * i.x, i.y * i.y, i.z * i.z};
    const Vec3 r = noise.in_cube(1);
    float most = 0;
    for (int k = 0; k < 20000; ++k)
      most = std::max(most, inverse_mass_at(body, r, normalized_or(noise.in_cube(1), {0, 1, 0})));
    EXPECT_LE(most, 1.0001f * largest_inverse_mass_at(body, r)) << n;
    EXPECT_GE(most, 0.99f * largest_inverse_mass_at(body, r)) << n;
    const Vec3 u = normalized_or(noise.in_cube(1), {0, 1, 0});
    EXPECT_NEAR(dot(u, inverse_mass_matrix(body, r) * u), inverse_mass_at(body, r, u), 1e-4f * most) << n;
  }
}

TEST(BodyKernels, MomentumIsKeptToRounding) {
  Bench bench;
  Noise noise(4);
  bench.add_body(3, {0.1f, 0.2f, 0.3f}, {0, 0, 0});
  bench.add_body(0.5f, {0.01f, 0.02f, 0.01f}, {1, 0, 0});
  for (int n = 0; n < 200; ++n) {
    const Vec3 normal = normalized_or(noise.in_cube(1), {0, 1, 0});
    const auto body = static_cast<uint32_t>(n % 2);
    bench.add_contact(body, bench.bodies[body].pose.position + 0.1f * normal, normal, 0.1f,
                      0.01f * noise.next());
    bench.contacts.back().friction = 0.5f;
  }
  bench.group();
  for (int k = 0; k < 20; ++k) bench.iterate();
  float pushed = 0;
  for (const Contact& c : bench.contacts) pushed += length(multiplier_sum(c));
  EXPECT_GT(pushed, 0.01f);
  EXPECT_LT(length(bench.momentum()), 1e-5f * pushed);
}

TEST(BodyKernels, TheImpulseIsWhatTheParticlesGotTheOtherWayRound) {
  Bench bench;
  bench.add_body(1, {1, 1, 1}, {0, 0, 0});
  bench.add_contact(0, {0.3f, 0, 0}, {0, 1, 0}, 1, 0.01f);
  bench.group();
  bench.iterate();
  bench.sum();
  std::vector<RigidImpulse> impulses(1);
  TakeImpulse{view(bench.partial), {}, view(impulses), Bench::lanes, 100}(0);
  const Vec3 got = bench.position[0].xyz() - bench.previous[0].xyz();  // times 1 kg, in 1/100 s
  EXPECT_NEAR(length(impulses[0].linear + 100 * got), 0, 1e-5f);
  EXPECT_NEAR(impulses[0].angular.z, 0.3f * impulses[0].linear.y, 1e-6f);
  EXPECT_LT(impulses[0].linear.y, -0.1f);
}

// Pushes that floats add up exactly: any number of lanes must give the very same sum.
TEST(BodyKernels, SumsDoNotDependOnTheLanes) {
  Bench bench;
  Noise noise(5);
  for (int b = 0; b < 3; ++b) bench.add_body(1, {1, 1, 1}, {0, 0, 0});
  Vec3 expected[3] = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
  for (int n = 0; n < 1000; ++n) {
    const auto body = static_cast<uint32_t>(3 * noise.next());
    bench.add_contact(body, {0, 0, 0}, {0, 1, 0}, 1, 0);
    const Vec3 r = noise.in_cube(100);
    bench.contacts.back().density_push = {std::round(r.x), std::round(r.y), std::round(r.z)};
    expected[body] += bench.contacts.back().density_push;
  }
  bench.group();
  for (uint32_t lanes : {8u, 16u, 64u, 256u}) {
    bench.sum(lanes);
    for (uint32_t b = 0; b < 3; ++b)
      EXPECT_EQ(sum_of_lanes(view(bench.partial), b, lanes).push.xyz(), expected[b]) << lanes;
  }
}

TEST(BodyKernels, ABodyWithoutMassStaysAndItsContactsToo) {
  Bench bench;
  bench.add_body(1, {1, 1, 1}, {0, 0, 0});
  bench.bodies[0].inverse_mass = 0;
  bench.bodies[0].inverse_inertia = {0, 0, 0};
  bench.add_contact(0, {0.3f, 0, 0}, {0, 1, 0}, 1, 0.01f);
  bench.group();
  bench.iterate();
  EXPECT_EQ(bench.motion[0].shift, (Vec3{0, 0, 0}));
  EXPECT_EQ(bench.contacts[0].point, (Vec3{0.3f, 0, 0}));
  EXPECT_NEAR(bench.depth(0), 0, 1e-6f);
}

TEST(BodyKernels, APredictedBodyGoesOnAsItMoves) {
  std::vector<RigidMotion> motion{{{{1, 2, 3}, {0, 0, 0, 1}}, {4, 0, 0}, {0, 2, 0}}};
  std::vector<RigidMass> mass{{0.5f, {1, 2, 3}, {}}};
  std::vector<BodyProxy> bodies(1);
  Predict{view(motion), view(mass), view(bodies), 0.1f}(0);
  EXPECT_EQ(bodies[0].start.position, (Vec3{1, 2, 3}));
  EXPECT_NEAR(length(bodies[0].pose.position - Vec3{1.4f, 2, 3}), 0, 1e-6f);
  EXPECT_NEAR(length(rotate(bodies[0].pose.rotation, {0, 0, 1}) - Vec3{std::sin(0.2f), 0, std::cos(0.2f)}), 0,
              1e-6f);
  EXPECT_EQ(bodies[0].inverse_mass, 0.5f);
  Rest{view(motion), view(bodies)}(0);
  EXPECT_EQ(bodies[0].pose.position, (Vec3{1, 2, 3}));
}

TEST(BodyKernels, ACarriedPlaneIsWhereTheBodyTakesIt) {
  BodyEnds body{};
  body.start = {{0, 0, 0}, {0, 0, 0, 1}};
  body.pose = {{5, 0, 0}, rotation_by({0, 0, 1.5707964f})};
  CarriedShape carried;
  carried.normal = {0, 1, 0};
  carried.offset = -0.5f;
  Shape shape;
  carry(carried, body, shape);
  EXPECT_NEAR(length(shape.size - Vec3{-1, 0, 0}), 0, 1e-6f);
  EXPECT_NEAR(dot(shape.size, {5.5f, 3, 1}), shape.offset, 1e-5f);
}

// Half a turn at most: what lies between the ends may bulge out of the boxes around them.
TEST(BodyKernels, ACarriedShapesBoundsHoldItAllTheWay) {
  Noise noise(6);
  for (int n = 0; n < 200; ++n) {
    CarriedShape carried;
    carried.pose = {noise.in_cube(1), rotation_by(noise.in_cube(3))};
    const Vec3 half = abs(noise.in_cube(0.5f)) + Vec3{0.01f, 0.01f, 0.01f};
    carried.bounds = {-half, half};
    BodyEnds body{};
    body.start = {noise.in_cube(2), rotation_by(noise.in_cube(3))};
    const Vec3 shift = noise.in_cube(1), turn = noise.in_cube(1.8f);
    body.pose = displaced(body.start, shift, turn);
    Shape shape;
    shape.kind = ShapeKind::box;
    carry(carried, body, shape);
    for (int k = 0; k <= 20; ++k) {
      const float t = float(k) / 20;
      const Pose at = displaced(body.start, t * shift, t * turn) * carried.pose;
      for (int c = 0; c < 8; ++c) {
        const Vec3 corner =
            to_world(at, {c & 1 ? half.x : -half.x, c & 2 ? half.y : -half.y, c & 4 ? half.z : -half.z});
        EXPECT_LE(max_component(max(shape.bounds.lower - corner, corner - shape.bounds.upper)), 1e-5f);
      }
    }
  }
}

}  // namespace
}  // namespace meniscus::collision
