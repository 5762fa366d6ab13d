// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// What a solver reports whose failed step cannot be taken back.
#include <gtest/gtest.h>

#include <numeric>
#include <string>
#include <vector>

#include "pbd/device/cpu/cpu_device.h"
#include "pbd/solver.h"

namespace meniscus::pbd {
namespace {

/// A set on a device that fails in a step, and again when the step is to be taken back.
class FailsTwice : public ConstraintSet<CpuDevice> {
 public:
  explicit FailsTwice(std::string reason) : reason_(std::move(reason)) {}
  void project(Substep<CpuDevice>&, int) override { throw Error(ErrorCode::device, "the first failure"); }
  void undo_step() override { throw Error(ErrorCode::device, reason_); }

 private:
  std::string reason_;
};

/// What a step of one particle with such a set reports.
StateLost loss_of(const std::string& reason) {
  CpuDevice device(1);
  Particles particles(device);
  Solver<CpuDevice> solver(device, particles, {});
  FailsTwice set(reason);
  solver.add(set);
  solver.reserve(1);
  const std::vector<uint32_t> slots{0};
  particles.append({{{0, 0, 0, 1}}}, std::vector<Vec4>(1), std::vector<Phase>(1), slots);
  solver.particles_changed(0, 1);
  try {
    solver.step(1.0f / 60);
  } catch (const StateLost& loss) {
    return loss;
  }
  ADD_FAILURE() << "the state is not lost";
  return {};
}

TEST(SolverLoss, NamesWhyTheStateCouldNotBeRestored) {
  const StateLost loss = loss_of("the second failure");
  EXPECT_EQ(loss.code(), ErrorCode::device);
  EXPECT_STREQ(loss.what(), "the second failure");
}

TEST(SolverLoss, CutsALongReason) {
  const std::string reason(1000, 'x');
  const std::string reported = loss_of(reason).what();
  EXPECT_LT(reported.size(), reason.size());
  EXPECT_EQ(reported, reason.substr(0, reported.size()));
}

}  // namespace
}  // namespace meniscus::pbd
