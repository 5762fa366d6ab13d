// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The same parameters hold a pool 2 m deep at its density whatever the spacing and the step are.
#include "tests/validation/pool.h"

namespace meniscus::tests {
namespace {

class PoolTest : public OnDevice {};

TEST_P(PoolTest, Settles) {
  expect_pool_settles(GetParam(), 0.1f, frame_time, 1.2);
}

TEST_P(PoolTest, SettlesWithTheSpacingDoubled) {
  expect_pool_settles(GetParam(), 0.2f, frame_time, 1.2);
}

TEST_P(PoolTest, SettlesWithTheStepDoubled) {
  expect_pool_settles(GetParam(), 0.1f, 2 * frame_time, 1.2);
}

TEST_P(PoolTest, SettlesWithTheStepHalved) {
  expect_pool_settles(GetParam(), 0.1f, frame_time / 2, 1.2);
}

MENISCUS_ON_EACH_DEVICE(PoolTest);

}  // namespace
}  // namespace meniscus::tests
