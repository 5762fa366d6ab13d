// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A body's impulse and torque from its contacts, against the same sums in double precision.
#include "collision/body/body_kernels.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/coupling/body_worlds.h"

namespace meniscus::tests {
namespace {

using namespace collision;
using namespace collision::body_kernels;

template <class T>
pbd::View<T> view(std::vector<T>& values) {
  return {values.data(), static_cast<uint32_t>(values.size())};
}

template <class Kernel>
void launch(uint32_t count, const Kernel& kernel) {
  for (uint32_t i = 0; i < count; ++i) kernel(i);
}

/// Contacts with all three kinds of push on them, of three bodies and of what is fixed, in any order.
std::vector<Contact> random_contacts(std::mt19937& random) {
  std::vector<Contact> contacts;
  for (int n = 0; n < 1500; ++n) {
    Contact c{};
    const Vec3 direction = random_vector(random, 1);
    c.normal = direction / length(direction);
    c.arm = random_vector(random, 2);
    c.normal_multiplier = length(random_vector(random, 1));
    c.tangent_multiplier = random_vector(random, 0.3f);
    c.density_push = random_vector(random, 1);
    const uint32_t owner = static_cast<uint32_t>(random() % 5);
    c.body = owner == 1 || owner > 3 ? pbd::no_index : owner;  // number 1 touches nothing
    contacts.push_back(c);
  }
  return contacts;
}

struct Impulse {
  Sum3 linear, angular;
  double gross = 0, gross_angular = 0;
};

Impulse reference(const std::vector<Contact>& contacts, uint32_t body, double dt) {
  Impulse sum;
  for (const Contact& c : contacts) {
    if (c.body != body) continue;
    const Sum3 push = double{c.normal_multiplier} * Sum3(c.normal) + c.tangent_multiplier + c.density_push;
    sum.linear += -1 / dt * push;
    sum.angular += -1 / dt * cross(Sum3(c.arm), push);
    sum.gross += norm(push) / dt;
    sum.gross_angular += norm(c.arm) * norm(push) / dt;
  }
  return sum;
}

TEST(BodySums, TheImpulseIsTheOppositeOfAllPushesAtTheirLevers) {
  constexpr uint32_t bodies = 4, lanes = 16;
  constexpr float dt = 0.004f;
  std::mt19937 random(5);
  std::vector<Contact> contacts = random_contacts(random);
  std::vector<uint32_t> key, grouped;
  for (uint32_t b = 0; b <= bodies; ++b) {
    for (uint32_t n = 0; n < contacts.size(); ++n) {
      if (std::min(contacts[n].body, bodies) != b) continue;
      key.push_back(contact_kinds * b);
      grouped.push_back(n);
    }
  }
  std::vector<BodyProxy> proxies(bodies);
  std::vector<ContactSum> partial(bodies * lanes);
  std::vector<RigidImpulse> impulses(bodies);
  launch(static_cast<uint32_t>(key.size()), FindGroups{view(key), view(proxies)});
  launch(bodies * lanes, SumLanes{view(grouped), view(proxies), view(contacts), view(partial), lanes});
  launch(bodies, TakeImpulse{view(partial), {}, view(impulses), lanes, 1 / dt});
  for (uint32_t b = 0; b < bodies; ++b) {
    const Impulse expected = reference(contacts, b, double{dt});
    EXPECT_EQ(expected.gross > 0, b != 1) << "body " << b;
    EXPECT_LE(norm(expected.linear - impulses[b].linear), 1e-6 * expected.gross) << "body " << b;
    EXPECT_LE(norm(expected.angular - impulses[b].angular), 1e-6 * expected.gross_angular) << "body " << b;
  }
}

}  // namespace
}  // namespace meniscus::tests
