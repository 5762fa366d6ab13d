// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Water stays in containers of cloth that are swung. The minute for which the figure is stated is in
// validation/swung_cloth_gpu_test.cpp.
#include "tests/coupling/swung_cloth.h"

#include <gtest/gtest.h>

namespace meniscus::tests {
namespace {

class SwungClothTest : public testing::TestWithParam<std::tuple<pbd::DeviceKind, ClothVessel>> {};

TEST_P(SwungClothTest, HoldsItsWater) {
  const auto [device, kind] = GetParam();
  SwungVessel vessel(device, kind);
  EXPECT_GT(vessel.world().particle_count(), 100u);
  vessel.swing(0.9);
  EXPECT_EQ(vessel.crossed(), 0u);
  EXPECT_GT(vessel.fastest(), 4.9);
  if (kind != ClothVessel::sling) {
    EXPECT_EQ(vessel.lost(), 0u);
  }
}

INSTANTIATE_TEST_SUITE_P(On, SwungClothTest,
                         testing::Combine(testing::ValuesIn(usable_devices()),
                                          testing::Values(ClothVessel::sling, ClothVessel::bag,
                                                          ClothVessel::bowl)),
                         [](const auto& test) {
                           return testing::PrintToString(std::get<1>(test.param)) + "_" +
                                  testing::PrintToString(std::get<0>(test.param));
                         });

}  // namespace
}  // namespace meniscus::tests
