// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Once warm, a step allocates nothing: neither on the host nor on the device.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <new>
#include <string>
#include <vector>

#include "sdk/engine/engine.h"
#include "tests/cloth_worlds.h"
#include "tests/worlds.h"

namespace {

std::atomic<long> allocations{0};

void* counted(std::size_t bytes) {
  allocations.fetch_add(1, std::memory_order_relaxed);
  if (void* memory = std::malloc(bytes ? bytes : 1)) return memory;
  throw std::bad_alloc();
}

}  // namespace

// Those with an alignment are left alone: oneTBB's threads may use them, and nothing here does.
void* operator new(std::size_t bytes) {
  return counted(bytes);
}
void* operator new[](std::size_t bytes) {
  return counted(bytes);
}
void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept {
  allocations.fetch_add(1, std::memory_order_relaxed);
  return std::malloc(bytes ? bytes : 1);
}
void* operator new[](std::size_t bytes, const std::nothrow_t& tag) noexcept {
  return operator new(bytes, tag);
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete[](void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
  std::free(memory);
}

namespace meniscus::tests {
namespace {

class AllocationTest : public OnDevice {
 protected:
  static long during(World& world, int steps) {
    const long before = allocations.load();
    run(world, steps, 0.016f);
    return allocations.load() - before;
  }

  /// Water in a tank that it fills to the walls, so that the number of contacts hardly changes.
  World pool(const DensitySolverDef& density = {}) const {
    WorldDef def = world_def(GetParam(), 0.05f);
    def.density = density;
    World world(def);
    world.create_shape(tank({0, 0, 0}, {0.5f, 1, 0.5f}));
    world.add_fluid(block(world.create_fluid({}), {0, 0, 0}, {0.5f, 0.4f, 0.5f}));
    return world;
  }
};

TEST_P(AllocationTest, TheCountWorks) {
  const long before = allocations.load();
  int* volatile number = new int(3);  // or the compiler leaves both out
  delete number;
  EXPECT_EQ(allocations.load(), before + 1);
}

TEST_P(AllocationTest, AWarmStepAllocatesNothingOnTheHost) {
  World world = pool();
  run(world, 60, 0.016f);
  EXPECT_EQ(during(world, 20), 0);
}

TEST_P(AllocationTest, NorWithProbesAndSinks) {
  World world = pool();
  world.create_probe({});
  world.create_sink({"", BoxRegion{{5, 5, 5}, {6, 6, 6}}, false, {}, {}});
  run(world, 60, 0.016f);
  EXPECT_EQ(during(world, 20), 0);
}

TEST_P(AllocationTest, NorWithAPressureGridAndATolerance) {
  World world = pool({.solver = DensitySolver::grid, .tolerance = 1e-3f});
  run(world, 60, 0.016f);
  EXPECT_EQ(during(world, 20), 0);
}

TEST_P(AllocationTest, NorWithABaseline) {
  for (DensitySolver solver : {DensitySolver::pcisph, DensitySolver::wcsph, DensitySolver::dfsph}) {
    World world = pool({.solver = solver});
    run(world, 60, 0.016f);
    EXPECT_EQ(during(world, 20), 0) << static_cast<int>(solver);
  }
}

TEST_P(AllocationTest, AWarmStepHoldsTheSameMemoryOnTheDevice) {
  World world = pool();
  run(world, 60, 0.016f);
  const size_t held = world.device_bytes();
  run(world, 40, 0.016f);
  EXPECT_EQ(world.device_bytes(), held);
}

/// What is taken before the first step is nearly all that this one needs, cloth and solids as well.
TEST_P(AllocationTest, AWorldKnowsBeforeItsFirstStepWhatItTakes) {
  World world = pool();
  world.create_cloth(sheet(0.4f, 0.4f, 30, 30, {0.25f, 0.8f, 0.25f}));
  world.create_shape(shape(HeightFieldGeometry{64, 64, 0.1f, std::vector<float>(64 * 64, -5.0f)}));
  const std::vector<MemoryShare> shares = world.memory_shares();
  size_t sum = 0;
  std::vector<std::string> names;
  for (size_t k = 0; k < shares.size(); ++k) {
    sum += shares[k].bytes;
    names.push_back(shares[k].what);
    EXPECT_GT(shares[k].bytes, 0u) << shares[k].what;
    if (k > 0) {
      EXPECT_LE(shares[k].bytes, shares[k - 1].bytes) << shares[k].what;
    }
  }
  EXPECT_EQ(sum, world.device_bytes());
  for (const char* name : {"neighbour lists", "particle positions", "cloth edges", "height fields"})
    EXPECT_EQ(std::count(names.begin(), names.end(), name), 1) << name;
  world.step(0.016f);
  EXPECT_LT(static_cast<double>(world.device_bytes()), 1.1 * static_cast<double>(sum));
}

// Where nothing is sorted there is no array to sort into.
TEST_P(AllocationTest, ClothAloneTakesHalfOfWhatItsStateTakesBesideFluid) {
  const auto bytes = [&](bool with_fluid) {
    World world(world_def(GetParam(), 0.05f));
    if (with_fluid) world.add_particles(world.create_fluid({}), std::vector<Vec3>{{5, 5, 5}});
    world.create_cloth(sheet(0.4f, 0.4f, 100, 100));
    world.step(0.016f);
    size_t sum = 0;
    for (const MemoryShare& share : world.memory_shares())
      if (share.what == "particle positions" || share.what == "particle velocities") sum += share.bytes;
    return static_cast<double>(sum);
  };
  EXPECT_NEAR(bytes(false) / bytes(true), 0.5, 0.1);  // there is room for more than one drop
}

TEST_P(AllocationTest, LookingAtAWorldTwiceTakesNoMoreMemory) {
  World world = pool();
  run(world, 20, 0.016f);
  world.diagnostics();
  const size_t held = world.device_bytes();
  for (int k = 0; k < 5; ++k) {
    world.step(0.016f);
    world.diagnostics();
    world.pressures();
    world.velocities();
  }
  EXPECT_EQ(world.device_bytes(), held);
}

TEST_P(AllocationTest, WhatIsDestroyedGivesItsMemoryBack) {
  World world = pool();
  const ShapeDef hills = shape(HeightFieldGeometry{64, 64, 0.1f, std::vector<float>(64 * 64, -5.0f)});
  const auto come_and_go = [&] {
    const ShapeId id = world.create_shape(hills);
    world.step(0.016f);
    world.destroy_shape(id);
  };
  come_and_go();
  const size_t held = world.device_bytes();
  for (int k = 0; k < 10; ++k) come_and_go();
  EXPECT_LE(world.device_bytes(), held);
}

std::unique_ptr<Engine> make_engine_on(pbd::DeviceKind kind, const EngineDef& def) {
#if MENISCUS_HAS_CUDA
  if (kind == pbd::DeviceKind::cuda) return make_cuda_engine(def, 0, nullptr);
#endif
  return kind == pbd::DeviceKind::cpu ? make_cpu_engine(def, 0) : nullptr;
}

/// Allocations of the device in steps of a pool that is warm. The engine shows the device's own count: not
/// even memory that is given back at once passes by.
uint64_t allocations_on(pbd::DeviceKind kind, const fluid::DensityParameters& density) {
  constexpr float s = 0.05f;
  EngineDef def;
  def.particle_spacing = s;
  def.kernel = fluid::calibrate(s, 2 * s);
  def.solver.support_radius = 2 * s;
  def.solver.contact_radius = 0.5f * s;
  def.density = density;
  def.density.correction_limit = 0.25f * s;
  collision::RigidWorld rigid({});
  def.rigid = &rigid;
  const std::unique_ptr<Engine> engine = make_engine_on(kind, def);
  engine->set_materials(std::vector<ParticleMaterial>{{{1000, 0, 5, 0, 0, 0}, {}, {}}});
  SolidShapes solids;
  solids.shapes.resize(1);  // y > 0
  solids.fixed = 1;
  engine->set_shapes(solids);
  ParticleBatch batch;
  for (Vec3 p : lattice(10, 8, 10, s, {0, 0, 0})) {
    batch.position.push_back(pbd::with_w(p, 1 / (1000 * s * s * s)));
    batch.velocity.push_back({0, 0, 0, 0});
    batch.phase.push_back(pbd::phase_fluid);
  }
  engine->append(batch);
  for (int k = 0; k < 60; ++k) engine->step(0.016f, 10);
  const uint64_t count = engine->device().memory().allocations;
  for (int k = 0; k < 20; ++k) engine->step(0.016f, 10);
  return engine->device().memory().allocations - count;
}

TEST_P(AllocationTest, AWarmStepAllocatesNothingOnTheDevice) {
  EXPECT_EQ(allocations_on(GetParam(), {}), 0u);
}

TEST_P(AllocationTest, NorWithAPressureGridAndAToleranceOnTheDevice) {
  fluid::DensityParameters density;
  density.pressure_grid = true;
  density.tolerance = 1e-3f;
  EXPECT_EQ(allocations_on(GetParam(), density), 0u);
}

MENISCUS_ON_EACH_DEVICE(AllocationTest);

}  // namespace
}  // namespace meniscus::tests
