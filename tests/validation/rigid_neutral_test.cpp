// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Validation: bodies as dense as water stay where they are.
#include "tests/validation/rigid_neutral.h"

namespace meniscus::tests {
namespace {

TEST(RigidNeutral, BodiesAsDenseAsWaterNeitherSinkNorRise) {
  expect_all_neutral(pbd::DeviceKind::cpu, 0.4f, 0.05f, 2);
}

}  // namespace
}  // namespace meniscus::tests
