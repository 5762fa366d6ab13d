// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Snapshots, files and clones in C go on as the world does. Objects are found by kind and name.
#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <string>

#include "tests/unit/sdk/c/c_scenes.h"
#include "tests/worlds.h"

namespace meniscus::tests {
namespace {

struct Destroy {
  void operator()(MeniscusWorld* world) const { meniscus_world_destroy(world); }
  void operator()(MeniscusSnapshot* snapshot) const { meniscus_snapshot_destroy(snapshot); }
};
template <class Handle>
using Owned = std::unique_ptr<Handle, Destroy>;

uint64_t hash_of(MeniscusWorld* world) {
  uint64_t hash = 0;
  EXPECT_EQ(meniscus_state_hash(world, &hash), MENISCUS_OK) << meniscus_last_error();
  return hash;
}

uint64_t hash_after(MeniscusWorld* world, int steps) {
  for (int k = 0; k < steps; ++k)
    EXPECT_EQ(meniscus_step(world, 0.02f, nullptr), MENISCUS_OK) << meniscus_last_error();
  return hash_of(world);
}

class CState : public OnDevice {
 protected:
  void SetUp() override {
    MeniscusWorld* made = nullptr;
    ASSERT_EQ(c_tank_with_body(GetParam() == pbd::DeviceKind::cuda ? "cuda" : "cpu", &made, &body_),
              MENISCUS_OK)
        << meniscus_last_error();
    world_.reset(made);
    hash_after(made, 4);
  }

  Owned<MeniscusWorld> world_;
  MeniscusId body_{};
};

TEST_P(CState, ASnapshotIsGoneBackTo) {
  MeniscusSnapshot* taken = nullptr;
  ASSERT_EQ(meniscus_snapshot(world_.get(), &taken), MENISCUS_OK) << meniscus_last_error();
  const Owned<MeniscusSnapshot> snapshot(taken);
  const uint64_t now = hash_of(world_.get()), later = hash_after(world_.get(), 4);
  ASSERT_NE(now, later);
  ASSERT_EQ(meniscus_restore(world_.get(), taken), MENISCUS_OK) << meniscus_last_error();
  EXPECT_EQ(hash_of(world_.get()), now);
  EXPECT_EQ(hash_after(world_.get(), 4), later);
}

TEST_P(CState, ForceFieldsAreMadeChangedAndDestroyed) {
  MeniscusDef* def = nullptr;
  MeniscusId field{};
  ASSERT_EQ(meniscus_def_create(MENISCUS_FORCE_FIELD_DEF, &def), MENISCUS_OK);
  EXPECT_EQ(meniscus_def_set_text(def, "force", "uniform"), MENISCUS_OK) << meniscus_last_error();
  EXPECT_EQ(meniscus_def_set_vector(def, "force.value", {3, 0, 0}), MENISCUS_OK) << meniscus_last_error();
  ASSERT_EQ(meniscus_create(world_.get(), def, &field), MENISCUS_OK) << meniscus_last_error();
  EXPECT_EQ(field.kind, uint32_t{MENISCUS_FORCE_FIELD});
  MeniscusWorld* cloned = nullptr;
  ASSERT_EQ(meniscus_clone(world_.get(), nullptr, &cloned), MENISCUS_OK) << meniscus_last_error();
  const Owned<MeniscusWorld> other(cloned);
  EXPECT_EQ(meniscus_def_set_vector(def, "force.value", {-3, 0, 0}), MENISCUS_OK);
  EXPECT_EQ(meniscus_set_force_field(world_.get(), field, def), MENISCUS_OK) << meniscus_last_error();
  meniscus_def_destroy(def);
  EXPECT_NE(hash_after(world_.get(), 1), hash_after(cloned, 1));
  EXPECT_EQ(meniscus_destroy(world_.get(), field), MENISCUS_OK) << meniscus_last_error();
  EXPECT_EQ(meniscus_destroy(world_.get(), field), MENISCUS_NOT_FOUND);
}

TEST_P(CState, AStepHasTwoHalves) {
  MeniscusWorld* cloned = nullptr;
  ASSERT_EQ(meniscus_clone(world_.get(), nullptr, &cloned), MENISCUS_OK) << meniscus_last_error();
  const Owned<MeniscusWorld> other(cloned);
  EXPECT_EQ(meniscus_step_end(cloned, nullptr), MENISCUS_INVALID_ARGUMENT);
  ASSERT_EQ(meniscus_step_begin(cloned, 0.02f), MENISCUS_OK) << meniscus_last_error();
  uint64_t hash = 0;
  EXPECT_EQ(meniscus_state_hash(cloned, &hash), MENISCUS_INVALID_ARGUMENT);
  MeniscusStepReport report{};
  report.size = sizeof report;
  ASSERT_EQ(meniscus_step_end(cloned, &report), MENISCUS_OK) << meniscus_last_error();
  EXPECT_GT(report.substeps, 0);
  EXPECT_EQ(hash_of(cloned), hash_after(world_.get(), 1));
}

TEST_P(CState, ParticlesAreTensorsOfDlpack) {
  struct DLManagedTensor* tensor = nullptr;
  void* stream = nullptr;
  ASSERT_EQ(meniscus_dlpack(world_.get(), MENISCUS_DEVICE_POSITIONS, &tensor, &stream), MENISCUS_OK)
      << meniscus_last_error();
  ASSERT_NE(tensor, nullptr);
  EXPECT_EQ(stream != nullptr, GetParam() == pbd::DeviceKind::cuda);
  struct Layout {
    char tensor[48];
    void* manager;
    void (*deleter)(DLManagedTensor*);
  };
  reinterpret_cast<Layout*>(tensor)->deleter(tensor);
  EXPECT_EQ(meniscus_dlpack(world_.get(), static_cast<MeniscusDeviceArray>(9), &tensor, nullptr),
            MENISCUS_INVALID_ARGUMENT);
}

TEST_P(CState, FilesAndClonesGoOnAlike) {
  const std::string path = (std::filesystem::path(testing::TempDir()) / "c_state.menisnap").string();
  ASSERT_EQ(meniscus_save(world_.get(), path.c_str()), MENISCUS_OK) << meniscus_last_error();
  MeniscusWorld *loaded = nullptr, *cloned = nullptr;
  ASSERT_EQ(meniscus_load(path.c_str(), nullptr, &loaded), MENISCUS_OK) << meniscus_last_error();
  const Owned<MeniscusWorld> from_file(loaded);
  std::filesystem::remove(path);
  ASSERT_EQ(meniscus_clone(world_.get(), nullptr, &cloned), MENISCUS_OK) << meniscus_last_error();
  const Owned<MeniscusWorld> copy(cloned);
  const uint64_t later = hash_after(world_.get(), 4);
  EXPECT_EQ(hash_after(loaded, 4), later);
  EXPECT_EQ(hash_after(cloned, 4), later);
}

TEST_P(CState, ObjectsAreFoundByKindAndName) {
  const MeniscusId* ids = nullptr;
  std::size_t count = 0;
  for (uint32_t kind = MENISCUS_FLUID; kind <= MENISCUS_PROBE; ++kind)
    EXPECT_EQ(meniscus_objects(world_.get(), static_cast<MeniscusKind>(kind), &ids, &count), MENISCUS_OK)
        << kind;
  ASSERT_EQ(meniscus_objects(world_.get(), MENISCUS_BODY, &ids, &count), MENISCUS_OK);
  ASSERT_EQ(count, 1u);
  MeniscusId found{};
  ASSERT_EQ(meniscus_find(world_.get(), MENISCUS_BODY, "crate", &found), MENISCUS_OK)
      << meniscus_last_error();
  for (const MeniscusId& id : {ids[0], found}) {
    EXPECT_EQ(id.kind, body_.kind);
    EXPECT_EQ(id.index, body_.index);
    EXPECT_EQ(id.generation, body_.generation);
  }
  EXPECT_EQ(meniscus_find(world_.get(), MENISCUS_BODY, "boat", &found), MENISCUS_NOT_FOUND);
  EXPECT_EQ(meniscus_objects(world_.get(), MENISCUS_NONE, &ids, &count), MENISCUS_INVALID_ARGUMENT);
}

TEST_P(CState, BadFilesAndDevicesAreRefused) {
  MeniscusWorld* none = nullptr;
  EXPECT_EQ(meniscus_load("/no/such/file", nullptr, &none), MENISCUS_IO);
  MeniscusLoadDef def;
  meniscus_load_def_init(&def);
  def.device = "abacus";
  EXPECT_EQ(meniscus_clone(world_.get(), &def, &none), MENISCUS_INVALID_ARGUMENT);
  EXPECT_NE(std::string(meniscus_last_error()).find("abacus"), std::string::npos);
  EXPECT_EQ(none, nullptr);
}

TEST_P(CState, AForceAtTheCentrePushes) {
  MeniscusWorld* cloned = nullptr;
  ASSERT_EQ(meniscus_clone(world_.get(), nullptr, &cloned), MENISCUS_OK) << meniscus_last_error();
  const Owned<MeniscusWorld> copy(cloned);
  MeniscusId body{};
  ASSERT_EQ(meniscus_find(cloned, MENISCUS_BODY, "crate", &body), MENISCUS_OK);
  MeniscusBodyState pushed{}, free{};
  pushed.size = free.size = sizeof free;
  ASSERT_EQ(meniscus_apply_central_force(cloned, body, {400, 0, 0}), MENISCUS_OK) << meniscus_last_error();
  hash_after(cloned, 1);
  hash_after(world_.get(), 1);
  ASSERT_EQ(meniscus_body_state(cloned, body, &pushed), MENISCUS_OK);
  ASSERT_EQ(meniscus_body_state(world_.get(), body_, &free), MENISCUS_OK);
  EXPECT_GT(pushed.velocity.x, free.velocity.x + 0.5f);
}

MENISCUS_ON_EACH_DEVICE(CState);

}  // namespace
}  // namespace meniscus::tests
