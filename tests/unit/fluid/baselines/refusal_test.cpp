// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What the baselines do not allow is refused by name, and changes nothing.
#include <gtest/gtest.h>

#include "tests/expect_error.h"
#include "tests/unit/fluid/baselines/baseline_worlds.h"

namespace meniscus::tests {
namespace {

RopeDef small_rope() {
  RopeDef rope;
  rope.points = {{0, 0, 0}, {1, 0, 0}};
  return rope;
}

template <class Call>
void expect_refused(const std::string& named, const Call& call) {
  expect_error(ErrorCode::invalid_argument, named, call);
}

TEST(BaselineRefusalTest, ClothRopesAndGrains) {
  for (DensitySolver solver : all_baselines) {
    World world(baseline_def(pbd::DeviceKind::cpu, solver));
    expect_refused("cloth", [&] { world.create_cloth(ClothDef{}); });
    expect_refused("ropes", [&] { world.create_rope(small_rope()); });
    expect_refused("granular", [&] { world.create_granular({}); });
    world.create_fluid({});
    EXPECT_NO_THROW(world.step(baseline_frame));
  }
}

TEST(BaselineRefusalTest, AChangeToABaselineWhereTheyAre) {
  for (DensitySolver solver : all_baselines) {
    WorldDef def = world_def(pbd::DeviceKind::cpu, baseline_spacing);
    World with_cloth(def), with_rope(def), with_grains(def);
    with_cloth.create_cloth(ClothDef{});
    with_rope.create_rope(small_rope());
    with_grains.create_granular({});
    def.density.solver = solver;
    expect_refused("cloth", [&] { with_cloth.set_def(def); });
    expect_refused("ropes", [&] { with_rope.set_def(def); });
    expect_refused("granular", [&] { with_grains.set_def(def); });
    EXPECT_EQ(with_cloth.def().density.solver, DensitySolver::chebyshev);
  }
}

TEST(BaselineRefusalTest, ParametersOfTheDensityConstraint) {
  for (DensitySolver solver : all_baselines) {
    WorldDef def = baseline_def(pbd::DeviceKind::cpu, solver);
    def.density.artificial_pressure.strength = 0.1f;
    expect_refused("artificial_pressure", [&] { World world(def); });
  }
  for (DensitySolver solver : {DensitySolver::pcisph, DensitySolver::dfsph}) {
    WorldDef def = baseline_def(pbd::DeviceKind::cpu, solver);
    def.density.compressibility = 1e-6f;
    expect_refused("compressibility", [&] { World world(def); });
  }
}

TEST(BaselineRefusalTest, OtherKernels) {
  for (DensitySolver solver : all_baselines) {
    WorldDef def = baseline_def(pbd::DeviceKind::cpu, solver);
    def.kernel = SmoothingKernel::wendland_c2;
    expect_refused("kernel", [&] { World world(def); });
  }
}

}  // namespace
}  // namespace meniscus::tests
