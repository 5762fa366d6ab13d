// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Memory that runs out in the C library is a status. No exception comes through, and nothing leaks.
#include <meniscus/error.h>

#include "tests/faults/fail_everywhere.h"
#include "tests/unit/sdk/c/c_scenes.h"

namespace meniscus::tests {
namespace {

/// Throws the status as C++ does, for fail_everywhere().
void expect_made(MeniscusStatus status) {
  if (status != MENISCUS_OK)
    throw Error(static_cast<ErrorCode>(static_cast<int>(status) - 1), meniscus_last_error());
}

TEST(CFaults, MissingMemoryIsAStatus) {
  forget_stacks();
  const int failures = fail_everywhere([] {
    MeniscusWorld* world = nullptr;
    MeniscusId emitter{}, sink{};
    MeniscusStatus status = c_emitter_and_sink("cpu", &world, &emitter, &sink);
    const MeniscusParticleContact* contacts = nullptr;
    std::size_t count = 0;
    if (status == MENISCUS_OK) status = meniscus_step(world, 0.02f, nullptr);
    if (status == MENISCUS_OK) status = meniscus_particle_contacts(world, &contacts, &count);
    meniscus_world_destroy(world);
    expect_made(status);
  });
  EXPECT_GT(failures, 100);
}

TEST(CFaults, MissingMemoryInAScenesTextIsAStatus) {
  forget_stacks();
  const int failures = fail_everywhere([] {
    MeniscusScene* scene = nullptr;
    MeniscusStatus status = meniscus_scene_read_text("{\"name\": \"x\", \"fluids\": [{}]}", nullptr, &scene);
    if (status == MENISCUS_OK) status = meniscus_scene_check(scene);
    meniscus_scene_destroy(scene);
    expect_made(status);
  });
  EXPECT_GT(failures, 10);
}

}  // namespace
}  // namespace meniscus::tests
