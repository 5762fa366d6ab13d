// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tests of the cache of distance fields of meshes.
#include "collision/sdf/mesh_fields.h"

#include <gtest/gtest.h>
#include <meniscus/error.h>

#include "pbd/device/cpu/cpu_device.h"
#include "tests/unit/collision/solid_shapes.h"

namespace meniscus::collision {
namespace {

constexpr float cell = 0.1f, margin = 0.2f, h = 0.3f;

TEST(MeshHash, TellsContentsApart) {
  const TriangleMesh box = box_mesh({0, 0, 0}, {1, 1, 1});
  const MeshHash hash = hash_of(box);
  EXPECT_EQ(hash, hash_of(box_mesh({0, 0, 0}, {1, 1, 1})));
  TriangleMesh moved = box, turned = box, larger = box;
  moved.vertices[3].y = std::nextafter(moved.vertices[3].y, 2.0f);
  std::swap(turned.triangles[0], turned.triangles[1]);
  larger.vertices.push_back({0, 0, 0});
  for (const TriangleMesh& other : {moved, turned}) {
    EXPECT_NE(hash.first, hash_of(other).first);
    EXPECT_NE(hash.second, hash_of(other).second);
  }
  EXPECT_NE(hash, hash_of(larger));
}

TEST(MeshFields, EqualMeshesShareAField) {
  pbd::CpuDevice device;
  MeshFields<pbd::CpuDevice> fields;
  const TriangleMesh box = box_mesh({0, 0, 0}, {1, 1, 1});
  const uint32_t a = fields.acquire(device, box, cell, 0, margin, h);
  const size_t bytes = device.memory().bytes;
  EXPECT_EQ(fields.acquire(device, box, cell, 0, margin, h), a);
  EXPECT_EQ(device.memory().bytes, bytes);
  ASSERT_EQ(fields.views().size(), 1u);

  fields.release(a);
  EXPECT_LT(sample_sdf(fields.views()[a], {0.5f, 0.5f, 0.5f}).distance, -0.4f);
  fields.release(a);
  EXPECT_EQ(device.memory().bytes, 0u);
  EXPECT_EQ(fields.views()[a].values.count, 0u);
}

TEST(MeshFields, OtherMeshesAndSettingsHaveTheirOwn) {
  pbd::CpuDevice device;
  MeshFields<pbd::CpuDevice> fields;
  const TriangleMesh box = box_mesh({0, 0, 0}, {1, 1, 1}), longer = box_mesh({0, 0, 0}, {1, 1, 1.5f});
  const uint32_t numbers[] = {fields.acquire(device, box, cell, 0, margin, h),
                              fields.acquire(device, longer, cell, 0, margin, h),
                              fields.acquire(device, box, 2 * cell, 0, margin, h),
                              fields.acquire(device, box, cell, 0, 2 * margin, h),
                              fields.acquire(device, box, cell, 0, margin, h / 2),
                              fields.acquire(device, box, cell, 0.02f, margin, h)};
  for (uint32_t i = 0; i < 6; ++i) EXPECT_EQ(numbers[i], i);
  const std::vector<SdfView> views = fields.views();
  EXPECT_EQ(views[2].nodes.spacing, 2 * cell);
  EXPECT_LT(views[5].nodes.spacing, cell);
  EXPECT_GT(sample_sdf(views[0], {0.5f, 0.5f, 1.2f}).distance, 0);
  EXPECT_LT(sample_sdf(views[1], {0.5f, 0.5f, 1.2f}).distance, 0);
}

TEST(MeshFields, ATargetErrorWinsOverACellSize) {
  pbd::CpuDevice device;
  MeshFields<pbd::CpuDevice> fields;
  const TriangleMesh box = box_mesh({0, 0, 0}, {1, 1, 1});
  const uint32_t a = fields.acquire(device, box, cell, 0.1f, margin, h);
  EXPECT_EQ(fields.acquire(device, box, 3 * cell, 0.1f, margin, h), a);
  EXPECT_NE(fields.acquire(device, box, cell, 0.04f, margin, h), a);
}

TEST(MeshFields, NumbersStayAndAreUsedAgain) {
  pbd::CpuDevice device;
  MeshFields<pbd::CpuDevice> fields;
  const auto acquire = [&](float size) {
    return fields.acquire(device, box_mesh({0, 0, 0}, {size, size, size}), cell, 0, margin, h);
  };
  const uint32_t small = acquire(0.5f), large = acquire(1);
  const float* values = fields.views()[large].values.data;
  fields.release(small);
  EXPECT_EQ(acquire(0.7f), small);
  EXPECT_EQ(acquire(0.8f), 2u);
  EXPECT_EQ(fields.views()[large].values.data, values);
}

TEST(MeshFields, TheGridHoldsTheDensityMap) {
  pbd::CpuDevice device;
  MeshFields<pbd::CpuDevice> fields;
  const uint32_t a = fields.acquire(device, box_mesh({0, 0, 0}, {1, 1, 1}), cell, 0, 0, h);
  const SdfView view = fields.views()[a];
  EXPECT_NEAR(sample_density(view, {0.5f, 0, 0.5f}).density, 0.5f, 0.01f);
  EXPECT_EQ(sample_density(view, {0.5f, 0.5f, 0.5f}).density, 1);
  EXPECT_EQ(sample_density(view, {0.5f, -h, 0.5f}).density, 0);
  EXPECT_LE(view.nodes.origin.y, -h);
}

TEST(MeshFields, ARefusalAddsNothing) {
  pbd::CpuDevice device;
  MeshFields<pbd::CpuDevice> fields;
  const TriangleMesh box = box_mesh({0, 0, 0}, {1, 1, 1});
  EXPECT_THROW(fields.acquire(device, box, -cell, 0, margin, h), Error);
  EXPECT_THROW(fields.acquire(device, box, cell, 0, margin, 0), Error);
  EXPECT_THROW(fields.acquire(device, {}, cell, 0, margin, h), Error);
  EXPECT_TRUE(fields.views().empty());
  EXPECT_EQ(device.memory().bytes, 0u);
}

}  // namespace
}  // namespace meniscus::collision
