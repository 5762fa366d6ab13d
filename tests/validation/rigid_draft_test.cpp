// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Archimedes, at a size that a CPU does in two minutes: half as dense as water, 16 spacings high.
#include "tests/validation/rigid_draft.h"

namespace meniscus::tests {
namespace {

TEST(RigidDraft, ABoxFloatsAsDeepAsArchimedesSays) {
  expect_draft(pbd::DeviceKind::cpu, {500, 0.05f, 16});
}

}  // namespace
}  // namespace meniscus::tests
