// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Floating and neutral bodies at the sizes that take a GPU.
#include "tests/validation/rigid_draft.h"
#include "tests/validation/rigid_neutral.h"

namespace meniscus::tests {
namespace {

using validation::DraftCase;

class RigidGpuTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!pbd::cuda_status().usable) GTEST_SKIP() << pbd::cuda_status().reason;
  }
};

class DraftGpuTest : public RigidGpuTest, public testing::WithParamInterface<DraftCase> {};

TEST_P(DraftGpuTest, ABoxFloatsAsDeepAsArchimedesSays) {
  expect_draft(pbd::DeviceKind::cuda, GetParam());
}

// A box of 0.8 m, at two resolutions.
INSTANTIATE_TEST_SUITE_P(Boxes, DraftGpuTest,
                         testing::Values(DraftCase{250, 0.05f, 16}, DraftCase{500, 0.05f, 16},
                                         DraftCase{750, 0.05f, 16}, DraftCase{250, 0.025f, 32},
                                         DraftCase{500, 0.025f, 32}, DraftCase{750, 0.025f, 32}));

TEST_F(RigidGpuTest, CoarseBodiesAsDenseAsWaterNeitherSinkNorRise) {
  expect_all_neutral(pbd::DeviceKind::cuda, 0.4f, 0.05f, 3);
}

TEST_F(RigidGpuTest, FineBodiesAsDenseAsWaterNeitherSinkNorRise) {
  expect_all_neutral(pbd::DeviceKind::cuda, 0.4f, 0.025f, 3);
}

}  // namespace
}  // namespace meniscus::tests
