// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The pool of pool_test.cpp with eight times as many particles, 40 layers deep.
#include "tests/validation/pool.h"

namespace meniscus::tests {
namespace {

class FinePoolTest : public OnDevice {};

TEST_P(FinePoolTest, Settles) {
  expect_pool_settles(GetParam(), 0.05f, frame_time, 1.2);
}

TEST_P(FinePoolTest, SettlesWithTheStepDoubled) {
  expect_pool_settles(GetParam(), 0.05f, 2 * frame_time, 2);
}

MENISCUS_ON_EACH_DEVICE(FinePoolTest);

}  // namespace
}  // namespace meniscus::tests
