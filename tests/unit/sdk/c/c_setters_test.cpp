// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// State that C sets is what C then reads, and meshes may stand in memory.
#include <gtest/gtest.h>
#include <meniscus/meniscus_c.h>

#include <vector>

namespace meniscus::tests {
namespace {

#define OK(call) ASSERT_EQ(call, MENISCUS_OK) << meniscus_last_error()

class CSetters : public testing::Test {
 protected:
  void SetUp() override {
    MeniscusDef* def = make(MENISCUS_WORLD_DEF);
    OK(meniscus_def_set_text(def, "device", "cpu"));
    OK(meniscus_world_create(def, &world_));
    meniscus_def_destroy(def);
  }
  void TearDown() override { meniscus_world_destroy(world_); }

  static MeniscusDef* make(MeniscusDefKind kind) {
    MeniscusDef* def = nullptr;
    EXPECT_EQ(meniscus_def_create(kind, &def), MENISCUS_OK) << meniscus_last_error();
    return def;
  }
  MeniscusId create(MeniscusDef* def) {
    MeniscusId id{};
    EXPECT_EQ(meniscus_create(world_, def, &id), MENISCUS_OK) << meniscus_last_error();
    meniscus_def_destroy(def);
    return id;
  }

  MeniscusWorld* world_ = nullptr;
};

TEST_F(CSetters, Particles) {
  const MeniscusId water = create(make(MENISCUS_FLUID_DEF));
  const std::vector<MeniscusVec3> first{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  OK(meniscus_add_particles(world_, water, first.data(), nullptr, first.size(), nullptr));
  const std::vector<MeniscusVec3> to{{0, 5, 0}, {1, 5, 0}, {2, 5, 0}};
  const MeniscusVec3* read = nullptr;
  size_t count = 0;
  const auto expect = [&](size_t slot, float x, float y) {
    ASSERT_EQ(count, first.size());
    EXPECT_EQ(read[slot].x, x);
    EXPECT_EQ(read[slot].y, y);
  };
  OK(meniscus_set_positions(world_, to.data(), to.size()));
  OK(meniscus_positions(world_, &read, &count));
  expect(2, 2, 5);
  OK(meniscus_set_fluid_positions(world_, water, first.data(), first.size()));
  const uint64_t last = 2;
  OK(meniscus_set_particle_positions(world_, &last, to.data(), 1));
  OK(meniscus_positions(world_, &read, &count));
  expect(0, 0, 0), expect(2, 0, 5);
  OK(meniscus_set_velocities(world_, to.data(), to.size()));
  OK(meniscus_set_fluid_velocities(world_, water, to.data(), to.size()));
  OK(meniscus_set_particle_velocities(world_, &last, first.data(), 1));
  OK(meniscus_velocities(world_, &read, &count));
  expect(1, 1, 5), expect(2, 0, 0);
  EXPECT_EQ(meniscus_set_positions(world_, to.data(), 2), MENISCUS_INVALID_ARGUMENT);
  OK(meniscus_set_filter(world_, water, MeniscusFilter{0, 0}));
}

TEST_F(CSetters, Cloth) {
  const MeniscusId cloth = create(make(MENISCUS_CLOTH_DEF));
  const MeniscusVec3* read = nullptr;
  size_t count = 0;
  OK(meniscus_cloth_positions(world_, cloth, &read, &count));
  std::vector<MeniscusVec3> to(read, read + count);
  for (MeniscusVec3& p : to) p.y += 3;
  OK(meniscus_set_vertex_positions(world_, cloth, to.data(), to.size()));
  OK(meniscus_set_vertex_velocities(world_, cloth, to.data(), to.size()));
  OK(meniscus_cloth_positions(world_, cloth, &read, &count));
  EXPECT_EQ(read[7].y, to[7].y);
  OK(meniscus_cloth_velocities(world_, cloth, &read, &count));
  EXPECT_EQ(read[7].x, to[7].x);
  OK(meniscus_set_filter(world_, cloth, MeniscusFilter{1, 0}));
}

/// A tetrahedron in memory, which then moves.
TEST_F(CSetters, ShapesAndMeshesInMemory) {
  const std::vector<MeniscusVec3> vertices{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const std::vector<uint32_t> faces{0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
  MeniscusDef* def = make(MENISCUS_SHAPE_DEF);
  OK(meniscus_def_set_text(def, "geometry", "mesh"));
  OK(meniscus_def_set_vectors(def, "geometry.vertices", vertices.data(), vertices.size()));
  OK(meniscus_def_set_indices(def, "geometry.triangles", faces.data(), faces.size()));
  MeniscusId shape{};
  OK(meniscus_create(world_, def, &shape));
  OK(meniscus_set_shape_pose(world_, shape, MeniscusPose{{10, 0, 0}, {0, 0, 0, 1}}));
  const MeniscusVec3 point{10.1f, 0.1f, 0.1f};
  float distance = 1;
  OK(meniscus_solid_distances(world_, &point, 1, 1, nullptr, &distance));
  EXPECT_LT(distance, 0);
  OK(meniscus_def_set_number(def, "surface.friction", 0.5));
  OK(meniscus_set_surface(world_, shape, def));
  OK(meniscus_set_filter(world_, shape, MeniscusFilter{1, 2}));
  const MeniscusId of_another_kind{MENISCUS_BODY, shape.index, shape.generation};
  EXPECT_EQ(meniscus_set_surface(world_, of_another_kind, def), MENISCUS_INVALID_ARGUMENT);
  meniscus_def_destroy(def);
}

}  // namespace
}  // namespace meniscus::tests
