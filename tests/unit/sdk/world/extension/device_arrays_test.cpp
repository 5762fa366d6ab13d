// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Arrays on the device, DLPack, and a caller's GPU and stream.
#include <gtest/gtest.h>

#include <cstddef>
#include <optional>
#include <thread>

#include "sdk/world/host/dlpack.h"
#include "tests/expect_error.h"
#include "tests/unit/sdk/world/extension/device_memory.h"
#include "tests/worlds.h"

// The structs of dlpack.h, as a consumer has them.
struct DLTestTensor {
  void* data;
  int32_t device_type, device_id;
  int32_t ndim;
  uint8_t code, bits;
  uint16_t lanes;
  int64_t *shape, *strides;
  uint64_t byte_offset;
};
struct DLTestManagedTensor {
  DLTestTensor tensor;
  void* manager;
  void (*deleter)(DLManagedTensor*);
};

namespace meniscus::tests {
namespace {

class DeviceArraysTest : public OnDevice {};

TEST_P(DeviceArraysTest, HoldWhatTheReadOutsHold) {
  World world = dam_break(GetParam(), 0.1f);
  run(world, 3, 0.01f);
  world.remove_particles(std::vector<ParticleId>{3, 17});
  const DeviceArrays arrays = world.device_arrays();
  const std::vector<Vec3> positions = on_host<Vec3>(arrays.positions),
                          velocities = on_host<Vec3>(arrays.velocities);
  const std::vector<uint32_t> phases = on_host<uint32_t>(arrays.phases);
  const std::vector<ParticleId> ids = on_host<ParticleId>(arrays.ids);
  ASSERT_EQ(positions.size(), world.particle_count());
  for (size_t i = 0; i < positions.size(); ++i) {
    ASSERT_EQ(ids[i], world.ids()[i]);
    ASSERT_EQ(positions[i], world.positions()[i]);
    ASSERT_EQ(velocities[i], world.velocities()[i]);
    ASSERT_EQ(phases[i], world.fluids()[i]);
  }
  EXPECT_EQ(arrays.positions.on_cuda, GetParam() == pbd::DeviceKind::cuda);
  EXPECT_EQ(arrays.positions.stream != nullptr, arrays.positions.on_cuda);
}

TEST_P(DeviceArraysTest, AreInTheUsersFrame) {
  WorldDef def = world_def(GetParam(), 0.1f);
  def.origin = {100, 0, 0};
  World world(def);
  world.add_particles(world.create_fluid({}), std::vector<Vec3>{{101, 2, 3}});
  EXPECT_EQ(on_host<Vec3>(world.device_arrays().positions)[0], (Vec3{101, 2, 3}));
}

TEST_P(DeviceArraysTest, StayWhileSomebodyHoldsThem) {
  std::optional<World> world = dam_break(GetParam(), 0.1f);
  const DeviceArrays first = world->device_arrays();
  const std::vector<Vec3> before = on_host<Vec3>(first.positions);
  run(*world, 3, 0.01f);
  DeviceArrays second = world->device_arrays();
  EXPECT_NE(second.positions.data, first.positions.data);
  EXPECT_EQ(on_host<Vec3>(first.positions), before);
  const void* const memory = second.positions.data;
  second = {};
  EXPECT_EQ(world->device_arrays().positions.data, memory) << "what nobody holds serves again";
  world.reset();
  DeviceArray apart = first.positions;
  apart.stream = nullptr;  // it has gone with the world
  EXPECT_EQ(on_host<Vec3>(apart), before);
}

TEST_P(DeviceArraysTest, AWorldWithoutParticlesHasEmptyOnes) {
  const World world(world_def(GetParam(), 0.1f));
  const DeviceArrays arrays = world.device_arrays();
  EXPECT_EQ(arrays.positions.shape[0], 0);
  EXPECT_EQ(arrays.positions.data, nullptr);
}

TEST_P(DeviceArraysTest, BecomeTensorsOfDlpack) {
  std::optional<World> world = dam_break(GetParam(), 0.1f);
  std::optional<DeviceArrays> arrays = world->device_arrays();
  const std::vector<Vec3> positions = on_host<Vec3>(arrays->positions);
  DLManagedTensor* const managed = to_dlpack(arrays->positions);
  DLManagedTensor* const managed_ids = to_dlpack(arrays->ids);
  const auto* const tensor = reinterpret_cast<const DLTestManagedTensor*>(managed);
  const auto* const ids = reinterpret_cast<const DLTestManagedTensor*>(managed_ids);
  EXPECT_EQ(tensor->tensor.device_type, GetParam() == pbd::DeviceKind::cuda ? 2 : 1);
  EXPECT_EQ(tensor->tensor.ndim, 2);
  EXPECT_EQ(tensor->tensor.shape[0], int64_t(positions.size()));
  EXPECT_EQ(tensor->tensor.shape[1], 3);
  EXPECT_EQ(tensor->tensor.strides[0], 3);
  EXPECT_EQ(tensor->tensor.strides[1], 1);
  EXPECT_EQ(tensor->tensor.code, 2);  // kDLFloat
  EXPECT_EQ(tensor->tensor.bits, 32);
  EXPECT_EQ(ids->tensor.ndim, 1);
  EXPECT_EQ(ids->tensor.code, 1);  // kDLUInt
  EXPECT_EQ(ids->tensor.bits, 64);
  ids->deleter(managed_ids);
  DeviceArray seen = arrays->positions;
  seen.memory.reset();
  seen.stream = nullptr;
  arrays.reset();
  world.reset();
  EXPECT_EQ(on_host<Vec3>(seen), positions) << "the tensor holds the memory";
  tensor->deleter(managed);
}

TEST_P(DeviceArraysTest, SayInDlpackThatTheyAreReadOnly) {
  const World world = dam_break(GetParam(), 0.1f);
  DeviceArray array = world.device_arrays().positions;
  // As dlpack.h has it.
  static_assert(offsetof(DLManagedTensorVersioned, manager) == 8);
  static_assert(offsetof(DLManagedTensorVersioned, flags) == 24);
  static_assert(offsetof(DLManagedTensorVersioned, tensor) == 32);
  const long holders = array.memory.use_count();
  for (const bool read_only : {false, true}) {
    DLManagedTensorVersioned* const tensor = to_dlpack_versioned(array, read_only);
    EXPECT_EQ(tensor->version.of_layout, 1u);
    EXPECT_EQ(tensor->version.of_features, 0u);
    EXPECT_EQ(tensor->flags, read_only ? 1u : 0u);
    EXPECT_EQ(tensor->tensor.data, array.data);
    EXPECT_EQ(tensor->tensor.shape[1], 3);
    EXPECT_EQ(array.memory.use_count(), holders + 1);
    tensor->deleter(tensor);
    EXPECT_EQ(array.memory.use_count(), holders);
  }
}

TEST(DeviceArrays, NameTheirTypesAsNumpyDoes) {
  EXPECT_STREQ(type_string(ElementType::float32), "<f4");
  EXPECT_STREQ(type_string(ElementType::uint32), "<u4");
  EXPECT_STREQ(type_string(ElementType::uint64), "<u8");
}

TEST(CallersGpu, IsRefusedOnTheCpuByName) {
  WorldDef def = world_def(pbd::DeviceKind::cpu, 0.1f);
  def.cuda_device = 0;
  expect_error(ErrorCode::invalid_argument, "WorldDef::cuda_device", [&] { World world(def); });
  def.cuda_device.reset();
  int not_null = 0;
  def.cuda_stream = &not_null;
  expect_error(ErrorCode::invalid_argument, "WorldDef::cuda_stream", [&] { World world(def); });
  def.cuda_stream = nullptr;
  def.cuda_device = -1;
  expect_error(ErrorCode::invalid_argument, "WorldDef::cuda_device", [&] { World world(def); });
}

TEST(CallersGpu, MustExist) {
  WorldDef def = world_def(pbd::DeviceKind::cuda, 0.1f);
  def.cuda_device = 1000;
  EXPECT_THROW(World world(def), Error);
}

TEST(CallersGpu, CannotChange) {
  World world(world_def(pbd::DeviceKind::cpu, 0.1f));
  WorldDef def = world.def();
  def.cuda_device = 0;
  expect_error(ErrorCode::invalid_argument, "cuda_device", [&] { world.set_def(def); });
}

#if MENISCUS_HAS_CUDA
TEST(CallersGpu, RunsTheWorldOnTheCallersStream) {
  if (!pbd::cuda_status().usable) GTEST_SKIP() << "no GPU";
  WorldDef def = world_def(pbd::DeviceKind::cuda, 0.1f);
  def.cuda_device = 0;
  def.cuda_stream = make_gpu_stream();
  World plain = dam_break(pbd::DeviceKind::cuda, 0.1f);
  run(plain, 20, 0.01f);
  {
    World world = dam_break(def);
    run(world, 20, 0.01f);
    EXPECT_EQ(world.device_arrays().ids.stream, def.cuda_stream);
    EXPECT_EQ(world.state_hash(), plain.state_hash());
  }
  destroy_gpu_stream(def.cuda_stream);
  def.cuda_stream = reinterpret_cast<void*>(1);  // cudaStreamLegacy
  expect_error(ErrorCode::invalid_argument, "WorldDef::cuda_stream", [&] { World world(def); });
}
#endif

// A dam break onto a crate and a sheet on one of the GPUs.
World coupled_on(int gpu) {
  WorldDef def = world_def(pbd::DeviceKind::cuda, 0.1f);
  def.cuda_device = gpu;
  World world = dam_break(def);
  BodyDef crate;
  crate.geometry = BoxGeometry{{0.15f, 0.15f, 0.15f}};
  crate.density = 300;
  crate.pose.position = {0.5f, 1.2f, 0.25f};
  world.create_body(crate);
  ClothDef sheet;
  sheet.geometry = SheetGeometry{.width = 0.4f, .depth = 0.4f, .columns = 8, .rows = 8};
  sheet.pose.position = {0.3f, 1.6f, 0.25f};
  world.create_cloth(sheet);
  return world;
}

TEST(CallersGpu, TwoGpusRunAWorldEachInOneProcess) {
  if (!pbd::cuda_status(1).usable) GTEST_SKIP() << "no second GPU";
  World alone = coupled_on(0);
  World first = coupled_on(0), second = coupled_on(1);
  run(alone, 30, 0.01f);
  for (int k = 0; k < 10; ++k) {
    first.step(0.01f);
    second.step(0.01f);
  }
  std::thread other([&] { run(second, 20, 0.01f); });
  run(first, 20, 0.01f);
  other.join();
  EXPECT_EQ(first.state_hash(), alone.state_hash());
  EXPECT_EQ(second.state_hash(), alone.state_hash());
  EXPECT_EQ(second.device_arrays().positions.device, 1);
  World moved = second.clone({.cuda_device = 0});
  run(moved, 5, 0.01f);
  run(second, 5, 0.01f);
  EXPECT_EQ(moved.state_hash(), second.state_hash()) << "a world goes over to another GPU";
}

MENISCUS_ON_EACH_DEVICE(DeviceArraysTest);

}  // namespace
}  // namespace meniscus::tests
