// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Many objects that are made one by one: in time that grows with their number, and not with its square.
#include <gtest/gtest.h>

#include <chrono>

#include "tests/worlds.h"

namespace meniscus::tests {
namespace {

class CreationTest : public OnDevice {
 protected:
  World world_{world_def(GetParam(), 0.1f)};
};

template <class Call>
double seconds_of(const Call& call) {
  const auto start = std::chrono::steady_clock::now();
  call();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

constexpr int many = 30000;  // at the square of this the CPU took 25 s

TEST_P(CreationTest, ManyFluidsAreMadeInLinearTime) {
  FluidId last;
  EXPECT_LT(seconds_of([&] {
              for (int i = 0; i < many; ++i) last = world_.create_fluid({});
            }),
            5);
  world_.add_particles(last, std::vector<Vec3>{{0, 1, 0}});
  world_.step(0.001f);
  EXPECT_EQ(world_.fluids()[0], last.index);
}

TEST_P(CreationTest, ManyProbesAreMadeInLinearTime) {
  world_.add_fluid(block(world_.create_fluid({}), {0, 0, 0}, {0.4f, 0.4f, 0.4f}));
  ProbeDef def;
  def.kind = ProbeKind::point_pressure;
  ProbeId last;
  EXPECT_LT(seconds_of([&] {
              for (int i = 0; i < many; ++i) last = world_.create_probe(def);
            }),
            5);
  EXPECT_LT(seconds_of([&] {
              for (int i = many - 1; i > 0; --i) {
                world_.destroy_probe(last);
                last = world_.create_probe(def);
              }
            }),
            5);
  world_.step(0.001f);
  EXPECT_NO_THROW(world_.probe(last));
}

TEST_P(CreationTest, ManySinksAreMadeAndDestroyedInLinearTime) {
  const SinkDef def{"", BoxRegion{{8, 8, 8}, {9, 9, 9}}, false, {}, {}};
  std::vector<SinkId> all;
  EXPECT_LT(seconds_of([&] {
              for (int i = 0; i < many; ++i) all.push_back(world_.create_sink(def));
            }),
            5);
  EXPECT_LT(seconds_of([&] {
              for (const SinkId id : all) world_.destroy_sink(id);
            }),
            5);
  const SinkId everywhere = world_.create_sink({"", BoxRegion{{-9, -9, -9}, {9, 9, 9}}, false, {}, {}});
  world_.add_particles(world_.create_fluid({}), std::vector<Vec3>{{0, 1, 0}});
  world_.step(0.001f);
  EXPECT_EQ(world_.sink_count(everywhere).total, 1u);
}

MENISCUS_ON_EACH_DEVICE(CreationTest);

}  // namespace
}  // namespace meniscus::tests
