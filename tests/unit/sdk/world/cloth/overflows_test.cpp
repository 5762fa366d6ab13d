// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What exceeds a fixed size of cloth is refused.
#include <gtest/gtest.h>

#include "tests/cloth_worlds.h"
#include "tests/expect_error.h"

namespace meniscus::tests {
namespace {

class ClothOverflows : public OnDevice {
 protected:
  static constexpr float spacing = 0.05f;
};

TEST_P(ClothOverflows, RefuseMorePiecesThanVerticesCanName) {
  World world(world_def(GetParam(), spacing));
  const RopeDef def = rope({{0, 0, 0}, {1, 0, 0}}, 1);
  RopeId last{};
  for (int k = 0; k < 65536; ++k) last = world.create_rope(def);
  expect_error(ErrorCode::capacity, "65536 pieces", [&] { world.create_rope(def); });
  expect_error(ErrorCode::capacity, "65536 pieces", [&] { world.create_cloth(sheet(1, 1, 3, 3)); });
  world.destroy_rope(last);
  world.create_cloth(sheet(1, 1, 3, 3));
}

MENISCUS_ON_EACH_DEVICE(ClothOverflows);

}  // namespace
}  // namespace meniscus::tests
