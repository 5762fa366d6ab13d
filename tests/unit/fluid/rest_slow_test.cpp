// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A deeper column comes to rest, also with wide supports and with short substeps.
#include "tests/unit/fluid/rest.h"

namespace meniscus::tests {
namespace {

class RestSlowTest : public OnDevice {};

TEST_P(RestSlowTest, InLongSubsteps) {
  const RestMeasure measure = come_to_rest(GetParam(), {});
  EXPECT_LT(measure.rms, 0.01);
  EXPECT_NEAR(measure.level, 1, 0.007);
  EXPECT_NEAR(measure.pressure, 1, 0.04);
}

TEST_P(RestSlowTest, WithAWideSupport) {
  EXPECT_LT(come_to_rest(GetParam(), {.support_ratio = 3}).rms, 0.02);
}

TEST_P(RestSlowTest, InShortSubsteps) {
  EXPECT_LT(come_to_rest(GetParam(), {.substeps = 20}).rms, 0.02);
}

MENISCUS_ON_EACH_DEVICE(RestSlowTest);

}  // namespace
}  // namespace meniscus::tests
