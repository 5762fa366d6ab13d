// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Water stays in containers of cloth that are swung. The minute for which the figure is stated is in
// validation/swung_cloth_gpu_test.cpp.
#include "tests/coupling/swung_cloth.h"

#include <gtest/gtest.h>

namespace meniscus::tests {
namespace {

class SwungClothTest : public testing::TestWithParam<SwungVesselCase> {};

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

INSTANTIATE_TEST_SUITE_P(On, SwungClothTest, swung_vessels(), swung_vessel_name);

}  // namespace
}  // namespace meniscus::tests
