// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Containers of cloth are swung for a minute at up to 5 m/s, and no water gets through the cloth.
#include <gtest/gtest.h>

#include "tests/coupling/swung_cloth.h"

namespace meniscus::tests {
namespace {

class SwungClothForAMinute : public testing::TestWithParam<SwungVesselCase> {};

TEST_P(SwungClothForAMinute, IsNotCrossed) {
  const auto [device, kind] = GetParam();
  SwungVessel vessel(device, kind);
  vessel.swing(60);
  EXPECT_EQ(vessel.crossed(), 0u);
  if (kind != ClothVessel::sling) {
    EXPECT_EQ(vessel.lost(), 0u);
  }
}

INSTANTIATE_TEST_SUITE_P(On, SwungClothForAMinute, swung_vessels(), swung_vessel_name);

}  // namespace
}  // namespace meniscus::tests
