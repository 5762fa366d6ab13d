// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#include "pbd/math/units.h"

#include <gtest/gtest.h>

#include <limits>

namespace meniscus::pbd {
namespace {

TEST(WholeUnits, AreTheNearestIntegers) {
  EXPECT_EQ(whole_units(-2.6f), -3);
  EXPECT_EQ(whole_units(0x1p40f), int64_t{1} << 40);
}

TEST(WholeUnits, AThousandOfAnySizeHaveASum) {
  const float huge = std::numeric_limits<float>::max();
  int64_t sum = 0;
  for (int n = 0; n < 1024; ++n) ASSERT_FALSE(__builtin_add_overflow(sum, whole_units(-huge), &sum));
  EXPECT_LT(sum, 0);
  EXPECT_EQ(whole_units(huge), -whole_units(-huge));
}

}  // namespace
}  // namespace meniscus::pbd
