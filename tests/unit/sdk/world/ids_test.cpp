// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Ids of living worlds never match, however many worlds and objects were made.
#include <gtest/gtest.h>

#include <memory>

#include "sdk/world/check/id_table.h"
#include "sdk/world/check/world_number.h"
#include "tests/expect_error.h"
#include "tests/worlds.h"

namespace meniscus::tests {
namespace {

TEST(WorldNumber, NoTwoLivingWorldsShareOneHoweverManyWereMade) {
  const WorldNumber first, second;
  for (int i = 0; i < 200000; ++i) {
    const WorldNumber passing;
    ASSERT_NE(passing.first_generation(), first.first_generation());
    ASSERT_NE(passing.first_generation(), second.first_generation());
    ASSERT_NE(passing.first_generation(), 0u) << "the generation of an id that no call returned";
  }
}

TEST(WorldNumber, MoreWorldsThanNumbersAreRefused) {
  std::vector<std::unique_ptr<WorldNumber>> living;
  expect_error(ErrorCode::capacity, "65535 worlds", [&] {
    for (int i = 0; i < 70000; ++i) living.push_back(std::make_unique<WorldNumber>());
  });
  living.pop_back();
  EXPECT_NO_THROW(living.push_back(std::make_unique<WorldNumber>()));
}

TEST(IdTable, GenerationsOfAPlaceStayThoseOfTheWorld) {
  const WorldNumber one, next;
  IdTable<BodyId, int> table("body", one.first_generation());
  BodyId before{};
  for (int i = 0; i < 100000; ++i) {
    const BodyId id = table.insert(i);
    ASSERT_GE(id.generation, one.first_generation());
    ASSERT_LT(id.generation - one.first_generation(), generations_of_a_world);
    ASSERT_FALSE(id == before);
    ASSERT_EQ(table.find(before), nullptr);
    table.erase(id);
    before = id;
  }
  EXPECT_EQ(table.insert(0).index, 1u) << "the first place is used up";
}

TEST(Ids, WorldsThatWereMadeLongAfterRefuseThem) {
  const auto world = [] { return World(world_def(pbd::DeviceKind::cpu, 0.1f)); };
  World old = world();
  const FluidId water = old.create_fluid({});
  for (int i = 0; i < 65535 - 2; ++i) const WorldNumber passing;  // as worlds would take
  for (int i = 0; i < 4; ++i) {
    World young = world();
    const FluidId oil = young.create_fluid({});
    EXPECT_FALSE(oil == water);
    expect_error(ErrorCode::not_found, "fluid", [&] {
      young.add_particles(water, std::vector<Vec3>{{0, 0, 0}});
    });
    expect_error(ErrorCode::not_found, "fluid", [&] {
      old.add_particles(oil, std::vector<Vec3>{{0, 0, 0}});
    });
  }
}

TEST(Ids, OneThatIsNotSetIsCalledSo) {
  World world{WorldDef{}};
  expect_error(ErrorCode::not_found, "no fluid is meant: the id is not set", [&] { world.add_fluid({}); });
}

}  // namespace
}  // namespace meniscus::tests
