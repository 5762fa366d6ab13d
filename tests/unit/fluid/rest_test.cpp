// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Water comes to rest without xsph where W and ∇W are one kernel, at the level and pressure of hydrostatics.
#include "tests/unit/fluid/rest.h"

namespace meniscus::tests {
namespace {

class RestTest : public OnDevice {};

TEST_P(RestTest, WaterComesToRest) {
  const RestMeasure measure = come_to_rest(GetParam(), {.height = 0.5f, .width = 0.4f, .seconds = 3});
  EXPECT_LT(measure.rms, 0.03);  // 0.1 with poly6_spiky
  EXPECT_NEAR(measure.level, 1, 0.01);
  EXPECT_NEAR(measure.pressure, 1, 0.04);
}

TEST_P(RestTest, TheCubicSplineHasThePressureOfTheDepth) {
  const RestMeasure measure = come_to_rest(
      GetParam(), {.kernel = SmoothingKernel::cubic_spline, .height = 0.5f, .width = 0.4f, .seconds = 3});
  EXPECT_LT(measure.rms, 0.03);
  EXPECT_NEAR(measure.level, 1, 0.01);
  EXPECT_NEAR(measure.pressure, 1, 0.05);
}

MENISCUS_ON_EACH_DEVICE(RestTest);

}  // namespace
}  // namespace meniscus::tests
