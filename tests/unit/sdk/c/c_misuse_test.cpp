// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Null handles and pointers, wrong kinds, stale ids and wrong sizes: each gives a status and changes nothing.
#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "tests/unit/sdk/c/c_scenes.h"

namespace meniscus::tests {
namespace {

struct Destroy {
  void operator()(MeniscusWorld* world) const { meniscus_world_destroy(world); }
  void operator()(MeniscusDef* def) const { meniscus_def_destroy(def); }
  void operator()(MeniscusScene* scene) const { meniscus_scene_destroy(scene); }
};

template <class Handle>
using Owned = std::unique_ptr<Handle, Destroy>;

/// Arguments for calls: nulls where the caller wants them.
struct Arguments {
  MeniscusWorld* world = nullptr;
  MeniscusId id{};
};

using Call = std::function<MeniscusStatus(const Arguments&)>;
struct NamedCall {
  const char* name;
  Call call;
};

#define NO_RESULT(function)                                                  \
  {                                                                          \
#function, [](const Arguments& a) { return function(a.world, nullptr); } \
  }
#define NO_ARRAY(function)                                                            \
  {                                                                                   \
#function, [](const Arguments& a) { return function(a.world, nullptr, nullptr); } \
  }
#define NO_RESULT_OF_ID(function)                                                  \
  {                                                                                \
#function, [](const Arguments& a) { return function(a.world, a.id, nullptr); } \
  }
#define NO_ARRAY_OF_ID(function)                                                            \
  {                                                                                         \
#function, [](const Arguments& a) { return function(a.world, a.id, nullptr, nullptr); } \
  }

/// Calls whose results are null. They must fail with a world and without one.
const std::vector<NamedCall>& calls_without_results() {
  static const std::vector<NamedCall> calls = {
      NO_RESULT(meniscus_def),
      NO_RESULT(meniscus_set_def),
      NO_RESULT(meniscus_device),
      NO_RESULT(meniscus_support_radius),
      NO_RESULT(meniscus_time),
      NO_RESULT(meniscus_diagnostics),
      NO_RESULT(meniscus_state_hash),
      NO_RESULT(meniscus_device_bytes),
      NO_RESULT(meniscus_particle_count),
      NO_RESULT(meniscus_set_wind),
      NO_RESULT(meniscus_write_gl_particles),
      NO_RESULT(meniscus_snapshot),
      NO_RESULT(meniscus_restore),
      NO_RESULT(meniscus_save),
      NO_RESULT_OF_ID(meniscus_set_force_field),
      {"dlpack",
       [](const Arguments& a) { return meniscus_dlpack(a.world, MENISCUS_DEVICE_IDS, nullptr, nullptr); }},
      {"write_particles",
       [](const Arguments& a) { return meniscus_write_particles(a.world, nullptr, nullptr, nullptr); }},
      {"step_end", [](const Arguments& a) { return meniscus_step_end(a.world, nullptr); }},
      NO_ARRAY(meniscus_create),
      NO_ARRAY(meniscus_add_fluid),
      NO_ARRAY(meniscus_warnings),
      NO_ARRAY(meniscus_memory_shares),
      NO_ARRAY(meniscus_mesh_repairs),
      NO_ARRAY(meniscus_tear_events),
      NO_ARRAY(meniscus_ids),
      NO_ARRAY(meniscus_positions),
      NO_ARRAY(meniscus_velocities),
      NO_ARRAY(meniscus_fluids),
      NO_ARRAY(meniscus_density_errors),
      NO_ARRAY(meniscus_pressures),
      NO_ARRAY(meniscus_ellipsoids),
      NO_ARRAY(meniscus_diffuse),
      NO_ARRAY(meniscus_surface_mesh),
      NO_ARRAY(meniscus_particle_contacts),
      NO_ARRAY(meniscus_solid_contacts),
      NO_ARRAY(meniscus_contact_events),
      NO_RESULT_OF_ID(meniscus_particle_mass),
      NO_RESULT_OF_ID(meniscus_set_fluid),
      NO_RESULT_OF_ID(meniscus_probe),
      NO_RESULT_OF_ID(meniscus_probe_vector),
      NO_RESULT_OF_ID(meniscus_body_state),
      NO_RESULT_OF_ID(meniscus_body_mass),
      NO_RESULT_OF_ID(meniscus_hinge_angle),
      NO_RESULT_OF_ID(meniscus_cloth_welded_vertices),
      NO_RESULT_OF_ID(meniscus_cloth_bending_fraction),
      NO_RESULT_OF_ID(meniscus_cloth_state),
      NO_RESULT_OF_ID(meniscus_attachment_force),
      NO_ARRAY_OF_ID(meniscus_flow_count),
      NO_ARRAY_OF_ID(meniscus_cloth_positions),
      NO_ARRAY_OF_ID(meniscus_cloth_velocities),
      NO_ARRAY_OF_ID(meniscus_cloth_normals),
      NO_ARRAY_OF_ID(meniscus_cloth_triangles),
      NO_ARRAY_OF_ID(meniscus_cloth_texture),
      NO_ARRAY_OF_ID(meniscus_cloth_strains),
      NO_ARRAY_OF_ID(meniscus_cloth_wetness),
      NO_ARRAY_OF_ID(meniscus_rope_positions),
      NO_ARRAY_OF_ID(meniscus_rope_velocities),
      NO_ARRAY_OF_ID(meniscus_rope_frames),
      NO_ARRAY_OF_ID(meniscus_attachment_vertices),
      {"remove_particles", [](const Arguments& a) { return meniscus_remove_particles(a.world, nullptr, 3); }},
      {"add_particles",
       [](const Arguments& a) {
         return meniscus_add_particles(a.world, a.id, nullptr, nullptr, 3, nullptr);
       }},
      {"particle_impulses",
       [](const Arguments& a) { return meniscus_apply_particle_impulses(a.world, nullptr, nullptr, 3); }},
      {"vertex_impulses",
       [](const Arguments& a) { return meniscus_apply_vertex_impulses(a.world, a.id, nullptr, nullptr, 3); }},
      {"positions", [](const Arguments& a) { return meniscus_set_positions(a.world, nullptr, 3); }},
      {"velocities", [](const Arguments& a) { return meniscus_set_velocities(a.world, nullptr, 3); }},
      {"fluid_positions",
       [](const Arguments& a) { return meniscus_set_fluid_positions(a.world, a.id, nullptr, 3); }},
      {"fluid_velocities",
       [](const Arguments& a) { return meniscus_set_fluid_velocities(a.world, a.id, nullptr, 3); }},
      {"particle_positions",
       [](const Arguments& a) { return meniscus_set_particle_positions(a.world, nullptr, nullptr, 3); }},
      {"particle_velocities",
       [](const Arguments& a) { return meniscus_set_particle_velocities(a.world, nullptr, nullptr, 3); }},
      {"vertex_positions",
       [](const Arguments& a) { return meniscus_set_vertex_positions(a.world, a.id, nullptr, 3); }},
      {"vertex_velocities",
       [](const Arguments& a) { return meniscus_set_vertex_velocities(a.world, a.id, nullptr, 3); }},
      NO_RESULT_OF_ID(meniscus_set_surface),
      {"cast_ray",
       [](const Arguments& a) {
         return meniscus_cast_ray(a.world, {0, 1, 0}, {0, 0, 0}, MENISCUS_ALL, nullptr);
       }},
      {"nearest",
       [](const Arguments& a) {
         return meniscus_nearest(a.world, {0, 1, 0}, 1, MENISCUS_ALL, nullptr);
       }},
      {"samples",
       [](const Arguments& a) { return meniscus_sample_fluid(a.world, nullptr, 3, nullptr, nullptr); }},
      {"sleep_events", [](const Arguments& a) { return meniscus_sleep_events(a.world, nullptr, nullptr); }},
      {"flow_events", [](const Arguments& a) { return meniscus_flow_events(a.world, nullptr, nullptr); }},
      {"memory_stats", [](const Arguments& a) { return meniscus_memory_stats(a.world, nullptr); }},
      {"add_hook",
       [](const Arguments& a) {
         return meniscus_add_hook(a.world, MENISCUS_SOLVED, nullptr, nullptr, nullptr);
       }},
      {"start_recording", [](const Arguments& a) { return meniscus_start_recording(a.world, nullptr); }},
      {"distances",
       [](const Arguments& a) { return meniscus_solid_distances(a.world, nullptr, 3, 1, nullptr, nullptr); }},
      {"clone", [](const Arguments& a) { return meniscus_clone(a.world, nullptr, nullptr); }},
      {"objects",
       [](const Arguments& a) { return meniscus_objects(a.world, MENISCUS_BODY, nullptr, nullptr); }},
      {"find", [](const Arguments& a) { return meniscus_find(a.world, MENISCUS_BODY, nullptr, nullptr); }},
      {"ball",
       [](const Arguments& a) {
         return meniscus_overlap_ball(a.world, {0, 0, 0}, 1, MENISCUS_ALL, nullptr);
       }},
      {"box",
       [](const Arguments& a) {
         return meniscus_overlap_box(a.world, {{}, {0, 0, 0, 1}}, {1, 1, 1}, MENISCUS_ALL, nullptr);
       }},
  };
  return calls;
}

/// Calls that need nothing but a world, or a world and an id.
const std::vector<NamedCall>& calls_of_worlds() {
  static const std::vector<NamedCall> calls = {
      {"step", [](const Arguments& a) { return meniscus_step(a.world, 0.01f, nullptr); }},
      {"relax", [](const Arguments& a) { return meniscus_relax(a.world, 1); }},
      {"cancel", [](const Arguments& a) { return meniscus_cancel(a.world); }},
      {"progress", [](const Arguments& a) { return meniscus_set_progress(a.world, nullptr, nullptr); }},
      {"filter",
       [](const Arguments& a) {
         return meniscus_set_filter(a.world, a.id, {1, 1});
       }},
      {"shape_pose",
       [](const Arguments& a) {
         return meniscus_set_shape_pose(a.world, a.id, {{}, {0, 0, 0, 1}});
       }},
      {"item",
       [](const Arguments& a) { return meniscus_scene_item(a.world, MENISCUS_BODY, 0, nullptr, nullptr); }},
  };
  return calls;
}

const std::vector<NamedCall>& calls_of_ids() {
  static const std::vector<NamedCall> calls = {
      {"destroy", [](const Arguments& a) { return meniscus_destroy(a.world, a.id); }},
      {"pose",
       [](const Arguments& a) {
         return meniscus_set_body_pose(a.world, a.id, {{}, {0, 0, 0, 1}});
       }},
      {"velocity", [](const Arguments& a) { return meniscus_set_body_velocity(a.world, a.id, {}, {}); }},
      {"force", [](const Arguments& a) { return meniscus_apply_force(a.world, a.id, {}, {}); }},
      {"central force", [](const Arguments& a) { return meniscus_apply_central_force(a.world, a.id, {}); }},
      {"torque", [](const Arguments& a) { return meniscus_apply_torque(a.world, a.id, {}); }},
      {"impulse", [](const Arguments& a) { return meniscus_apply_impulse(a.world, a.id, {}, {}); }},
      {"move",
       [](const Arguments& a) {
         return meniscus_move_body(a.world, a.id, {{}, {0, 0, 0, 1}}, 1);
       }},
  };
  return calls;
}

class CMisuse : public testing::Test {
 protected:
  void SetUp() override {
    MeniscusWorld* made = nullptr;
    ASSERT_EQ(c_tank_with_body("cpu", &made, &body_), MENISCUS_OK) << meniscus_last_error();
    world_.reset(made);
    before_ = hash();
  }
  void TearDown() override { EXPECT_EQ(hash(), before_) << "a call that failed has changed the world"; }

  uint64_t hash() const {
    uint64_t value = 0;
    EXPECT_EQ(meniscus_state_hash(world_.get(), &value), MENISCUS_OK) << meniscus_last_error();
    return value;
  }

  Owned<MeniscusWorld> world_;
  MeniscusId body_{};
  uint64_t before_ = 0;
};

TEST_F(CMisuse, NullWorldsAndResultsAreRefused) {
  for (const auto& [name, call] : calls_without_results()) {
    EXPECT_EQ(call({nullptr, body_}), MENISCUS_INVALID_ARGUMENT) << name;
    EXPECT_NE(std::string(meniscus_last_error()), "") << name;
    for (uint32_t kind = MENISCUS_NONE; kind <= MENISCUS_PROBE + 1; ++kind) {
      const MeniscusStatus status = call({world_.get(), {kind, body_.index, body_.generation}});
      EXPECT_TRUE(status == MENISCUS_INVALID_ARGUMENT || status == MENISCUS_NOT_FOUND)
          << name << " for kind " << kind << ": " << meniscus_status_name(status);
    }
  }
  for (const auto* calls : {&calls_of_worlds(), &calls_of_ids()}) {
    for (const auto& [name, call] : *calls)
      EXPECT_EQ(call({nullptr, body_}), MENISCUS_INVALID_ARGUMENT) << name;
  }
}

TEST_F(CMisuse, WrongIdsAreRefused) {
  for (const auto& [name, call] : calls_of_ids()) {
    EXPECT_EQ(call({world_.get(), {}}), MENISCUS_INVALID_ARGUMENT) << name << ": " << meniscus_last_error();
    EXPECT_EQ(call({world_.get(), {MENISCUS_FLUID, 0, 0}}), MENISCUS_INVALID_ARGUMENT) << name;
    EXPECT_EQ(call({world_.get(), {99, 0, 0}}), MENISCUS_INVALID_ARGUMENT) << name;
    EXPECT_EQ(call({world_.get(), {MENISCUS_BODY, 5, body_.generation}}), MENISCUS_NOT_FOUND) << name;
    EXPECT_EQ(call({world_.get(), {MENISCUS_BODY, body_.index, body_.generation + 1}}), MENISCUS_NOT_FOUND)
        << name;
  }
}

TEST_F(CMisuse, WrongSizesAreRefusedBeforeTheCall) {
  MeniscusStepReport report{};
  for (const uint32_t size : {0u, 3u, uint32_t{sizeof report} + 1}) {
    report.size = size;
    EXPECT_EQ(meniscus_step(world_.get(), 0.01f, &report), MENISCUS_INVALID_ARGUMENT) << size;
  }
  // A caller that was compiled with an older, shorter struct gets its part, and nothing behind it.
  MeniscusDiagnostics diagnostics{};
  diagnostics.size = offsetof(MeniscusDiagnostics, density_error_max);
  diagnostics.density_error_max = 77;
  EXPECT_EQ(meniscus_diagnostics(world_.get(), &diagnostics), MENISCUS_OK);
  EXPECT_GT(diagnostics.particles, 0u);
  EXPECT_EQ(diagnostics.density_error_max, 77);
}

TEST_F(CMisuse, DefinitionsOfAnotherKindAreRefused) {
  MeniscusDef* made = nullptr;
  ASSERT_EQ(meniscus_def_create(MENISCUS_WIND_DEF, &made), MENISCUS_OK);
  const Owned<MeniscusDef> wind(made);
  MeniscusId id{};
  MeniscusWorld* other = nullptr;
  EXPECT_EQ(meniscus_create(world_.get(), made, &id), MENISCUS_INVALID_ARGUMENT);
  EXPECT_EQ(meniscus_set_def(world_.get(), made), MENISCUS_INVALID_ARGUMENT);
  EXPECT_EQ(meniscus_add_fluid(world_.get(), made, nullptr), MENISCUS_INVALID_ARGUMENT);
  EXPECT_EQ(meniscus_world_create(made, &other), MENISCUS_INVALID_ARGUMENT);
  EXPECT_EQ(other, nullptr);
  EXPECT_EQ(id.kind, uint32_t{MENISCUS_NONE});
  EXPECT_EQ(meniscus_def_create(static_cast<MeniscusDefKind>(99), &made), MENISCUS_INVALID_ARGUMENT);
}

TEST_F(CMisuse, NullsOfDefinitionsAreRefused) {
  MeniscusDef* made = nullptr;
  ASSERT_EQ(meniscus_def_create(MENISCUS_BODY_DEF, &made), MENISCUS_OK);
  const Owned<MeniscusDef> def(made);
  for (MeniscusDef* handle : {made, static_cast<MeniscusDef*>(nullptr)}) {
    const char* path = handle ? nullptr : "name";
    EXPECT_EQ(meniscus_def_set_number(handle, path, 1), MENISCUS_INVALID_ARGUMENT);
    EXPECT_EQ(meniscus_def_set_flag(handle, path, 1), MENISCUS_INVALID_ARGUMENT);
    EXPECT_EQ(meniscus_def_set_text(handle, path, "x"), MENISCUS_INVALID_ARGUMENT);
    EXPECT_EQ(meniscus_def_set_vector(handle, path, {}), MENISCUS_INVALID_ARGUMENT);
    EXPECT_EQ(meniscus_def_set_rotation(handle, path, {}), MENISCUS_INVALID_ARGUMENT);
    EXPECT_EQ(meniscus_def_set_id(handle, path, {}), MENISCUS_INVALID_ARGUMENT);
    EXPECT_EQ(meniscus_def_set_numbers(handle, path, nullptr, 0), MENISCUS_INVALID_ARGUMENT);
    EXPECT_EQ(meniscus_def_resize(handle, path, 0), MENISCUS_INVALID_ARGUMENT);
    EXPECT_EQ(meniscus_def_get_number(handle, path, nullptr), MENISCUS_INVALID_ARGUMENT);
  }
  EXPECT_EQ(meniscus_def_set_text(made, "name", nullptr), MENISCUS_INVALID_ARGUMENT);
  EXPECT_EQ(meniscus_def_get_number(made, "density", nullptr), MENISCUS_INVALID_ARGUMENT);
  EXPECT_EQ(meniscus_def_get_text(made, "name", nullptr), MENISCUS_INVALID_ARGUMENT);
  EXPECT_EQ(meniscus_def_resize(made, "keyframes", SIZE_MAX), MENISCUS_OUT_OF_MEMORY);
  EXPECT_EQ(meniscus_def_resize(made, "mass", 2), MENISCUS_INVALID_ARGUMENT);
  EXPECT_EQ(meniscus_def_copy(nullptr, &made), MENISCUS_INVALID_ARGUMENT);
  EXPECT_EQ(meniscus_def_members(MENISCUS_BODY_DEF, nullptr, nullptr), MENISCUS_INVALID_ARGUMENT);
  meniscus_def_destroy(nullptr);
  meniscus_world_destroy(nullptr);
  meniscus_scene_destroy(nullptr);
  meniscus_gl_particles_destroy(nullptr);
}

TEST_F(CMisuse, ErrorsOfScenesHaveTheirParts) {
  MeniscusScene* made = nullptr;
  EXPECT_EQ(meniscus_scene_read(nullptr, nullptr, 0, &made), MENISCUS_INVALID_ARGUMENT);
  EXPECT_EQ(meniscus_scene_read("x.json", nullptr, 1, &made), MENISCUS_INVALID_ARGUMENT);
  EXPECT_EQ(meniscus_scene_read("no_such_file.json", nullptr, 0, &made), MENISCUS_IO);
  EXPECT_EQ(meniscus_scene_read_text("{\"name\": \"x\", \"fluids\": [{\"rest_densty\": 1}]}", nullptr, &made),
            MENISCUS_PARSE);
  const char *file = nullptr, *path = nullptr, *fix = nullptr;
  meniscus_scene_error(&file, &path, &fix);
  EXPECT_STREQ(file, "scene");
  EXPECT_STREQ(path, "fluids[0].rest_densty");
  EXPECT_STREQ(fix, "did you mean \"rest_density\"?");
  EXPECT_EQ(made, nullptr);
  EXPECT_EQ(meniscus_scene_check(nullptr), MENISCUS_INVALID_ARGUMENT);
  EXPECT_EQ(meniscus_scene_build(nullptr, nullptr), MENISCUS_INVALID_ARGUMENT);
  EXPECT_EQ(meniscus_scene_info(nullptr, nullptr), MENISCUS_INVALID_ARGUMENT);
  meniscus_scene_error(nullptr, nullptr, nullptr);
}

TEST_F(CMisuse, ItemsOfScenesAreFoundByNumber) {
  MeniscusScene* made = nullptr;
  ASSERT_EQ(meniscus_scene_read_text(R"({"name": "x", "world": {"device": "cpu"}, "fluids": [{"name": "a"}],
      "granulars": [{"name": "b"}], "bodies": [{"name": "c", "geometry": {"type": "box"},
      "copies": {"count": [2, 1, 1], "step": [2, 0, 0]}}]})",
                                     nullptr, &made),
            MENISCUS_OK)
      << meniscus_last_error();
  const Owned<MeniscusScene> scene(made);
  MeniscusWorld* built = nullptr;
  ASSERT_EQ(meniscus_scene_build(made, &built), MENISCUS_OK) << meniscus_last_error();
  const Owned<MeniscusWorld> world(built);
  MeniscusId id{};
  const char* name = nullptr;
  EXPECT_EQ(meniscus_scene_item(built, MENISCUS_FLUID, 1, &id, &name), MENISCUS_OK);
  EXPECT_STREQ(name, "b");
  EXPECT_EQ(meniscus_scene_item(built, MENISCUS_BODY, 1, &id, &name), MENISCUS_OK);
  EXPECT_STREQ(name, "c_1");
  MeniscusBodyState state{};
  state.size = sizeof state;
  EXPECT_EQ(meniscus_body_state(built, id, &state), MENISCUS_OK);
  EXPECT_EQ(state.pose.position.x, 2);
  EXPECT_EQ(meniscus_scene_item(built, MENISCUS_BODY, 2, &id, &name), MENISCUS_NOT_FOUND);
  EXPECT_EQ(meniscus_scene_item(built, static_cast<MeniscusKind>(77), 0, &id, &name),
            MENISCUS_INVALID_ARGUMENT);
}

TEST_F(CMisuse, StatusesAndStagesHaveNames) {
  EXPECT_STREQ(meniscus_status_name(MENISCUS_NON_FINITE), "non_finite");
  EXPECT_STREQ(meniscus_status_name(MENISCUS_INTERNAL), "internal");
  EXPECT_STREQ(meniscus_status_name(static_cast<MeniscusStatus>(99)), "unknown");
  EXPECT_STREQ(meniscus_stage_name(0), "predict");
  EXPECT_EQ(meniscus_stage_name(7), nullptr);
}

}  // namespace
}  // namespace meniscus::tests
