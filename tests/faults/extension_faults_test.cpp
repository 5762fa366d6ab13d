// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Constraints of a user's own for which memory runs out leave no hook behind.
#include <meniscus/extend.h>

#include "tests/faults/fail_everywhere.h"
#include "tests/worlds.h"

namespace meniscus::tests {
namespace {

/// C = x of the first point less that of the second.
struct SameX {
  static constexpr uint32_t point_count = 2;
  uint32_t points[point_count];
  float compliance;

  MENISCUS_BOTH_DEVICES float value(const Vec3 (&x)[2], Vec3 (&gradient)[2]) const {
    gradient[0] = {1, 0, 0};
    gradient[1] = {-1, 0, 0};
    return x[0].x - x[1].x;
  }
};

TEST(ExtensionFaults, AConstraintThatFailsLeavesNoHook) {
  forget_stacks();
  World world = dam_break(pbd::DeviceKind::cpu, 0.2f);
  const auto next_id = [&] {
    const HookId id = world.add_hook(Hook::solved, [](const SubstepView&) {});
    world.remove_hook(id);
    return static_cast<uint64_t>(id) + 1;
  };
  uint64_t first = next_id();
  const auto make = [&] {
    try {
      const ConstraintsOf<SameX> constraints(world, {{{0, 1}, 0}});
    } catch (const std::bad_alloc&) {  // outside of the library
      throw Error(ErrorCode::out_of_memory, "");
    }
  };
  int rests = 0;
  const int failures = fail_everywhere(make, [&](bool, bool succeeded) {
    const uint64_t last = next_id() - 1;
    for (uint64_t id = first; id < last && !succeeded; ++id) {
      ++rests;  // of the first hook
      EXPECT_THROW(world.remove_hook(static_cast<HookId>(id)), Error) << "it has stayed";
    }
    first = last + 1;
  });
  EXPECT_GT(failures, 5);
  EXPECT_GT(rests, 0) << "the second hook has never failed";
}

}  // namespace
}  // namespace meniscus::tests
