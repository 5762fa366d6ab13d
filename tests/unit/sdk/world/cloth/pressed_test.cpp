// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Cloth that is far too large for its space unfolds, and does not burst.
#include <gtest/gtest.h>

#include "tests/cloth_worlds.h"

namespace meniscus::tests {
namespace {

struct PressedCase {
  const char* name;
  float share;  ///< of its lengths, that it has at first
  bool held;    ///< at all borders
  int substeps, iterations;
  float mean_stretch, max_stretch;  ///< in the end, at most
};

void PrintTo(const PressedCase& c, std::ostream* out) {
  *out << c.name;
}

class PressedCloth : public testing::TestWithParam<std::tuple<pbd::DeviceKind, PressedCase>> {
 protected:
  static constexpr int columns = 31;

  static bool at_border(int v) {
    const int row = v / columns, column = v % columns;
    return row == 0 || column == 0 || row == columns - 1 || column == columns - 1;
  }
};

TEST_P(PressedCloth, Opens) {
  const auto& [device, c] = GetParam();
  WorldDef settings = world_def(device, 0.05f);
  settings.substeps = c.substeps;
  settings.iterations = c.iterations;
  settings.gravity = {0, c.held ? -9.81f : 0, 0};
  World world(settings);
  world.set_wind({});
  ClothDef def = sheet(0.8f, 0.8f, columns, columns);
  def.stretch = {c.share, 1, c.share};
  def.self_collision = false;
  const ClothId id = world.create_cloth(def);
  std::vector<uint32_t> border;
  for (int v = 0; v < columns * columns; ++v)
    if (c.held && at_border(v)) border.push_back(static_cast<uint32_t>(v));
  if (c.held) world.create_attachment(attach(id, border));

  // What regains a tenth of its width in a hundredth of a second, and what falls by its width.
  const float fastest_opening = 10 * 0.8f, fastest_fall = std::sqrt(2 * 9.81f * 0.8f);
  for (int k = 0; k < 60; ++k) {
    world.step(1 / 60.0f);
    for (Vec3 v : world.cloth_velocities(id)) ASSERT_LT(length(v), fastest_opening + fastest_fall) << k;
  }
  const ClothState state = world.cloth_state(id);
  EXPECT_LT(state.mean_stretch, c.mean_stretch);
  EXPECT_LT(state.max_stretch, c.max_stretch);
}

INSTANTIATE_TEST_SUITE_P(
    On, PressedCloth,
    testing::Combine(
        testing::ValuesIn(usable_devices()),
        // Free cloth buckles one way or another depending on rounding: its worst edge is at 1.02 to 1.15.
        testing::Values(PressedCase{"Free", 0.5f, false, 8, 2, 0.03f, 1.2f},
                        PressedCase{"ToAThirdAndFree", 0.33f, false, 8, 2, 0.06f, 1.2f},
                        PressedCase{"Held", 0.66f, true, 8, 4, 0.04f, 1.05f},
                        PressedCase{"ToAThirdAndHeld", 0.33f, true, 8, 4, 0.06f, 1.05f})),
    [](const auto& instance) {
      return std::string(std::get<1>(instance.param).name) + '_' +
             testing::PrintToString(std::get<0>(instance.param));
    });

}  // namespace
}  // namespace meniscus::tests
