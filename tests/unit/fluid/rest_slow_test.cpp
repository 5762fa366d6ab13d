// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Water comes to rest with wide supports and with short substeps.
#include "tests/unit/fluid/rest.h"

namespace meniscus::tests {
namespace {

class RestSlowTest : public OnDevice {};

TEST_P(RestSlowTest, WithAWideSupport) {
  EXPECT_LT(come_to_rest(GetParam(), {.support_ratio = 3}).rms, 0.02);
}

TEST_P(RestSlowTest, InShortSubsteps) {
  EXPECT_LT(come_to_rest(GetParam(), {.substeps = 20}).rms, 0.02);
}

MENISCUS_ON_EACH_DEVICE(RestSlowTest);

}  // namespace
}  // namespace meniscus::tests
