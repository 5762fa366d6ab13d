// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// How the solver makes room for what a step finds: it believes only searches that had all contacts.
#include <gtest/gtest.h>

#include <numeric>
#include <vector>

#include "pbd/device/cpu/cpu_device.h"
#include "pbd/solver.h"

namespace meniscus::pbd {
namespace {

/// A source that finds the same number of contacts for each particle.
class EqualContacts : public ContactSource<CpuDevice> {
 public:
  EqualContacts(CpuDevice& device, uint32_t each) : device_(device), each_(each) {}
  bool any() const override { return true; }
  void count(const Substep<CpuDevice>& substep, const ContactCounter& counter) override {
    device_.parallel_for("test/count", substep.particles.owned,
                         [=, each = each_](uint32_t i) { counter.add(i, each); });
  }
  void fill(const Substep<CpuDevice>&, const ContactWriter&) override {}

 private:
  CpuDevice& device_;
  uint32_t each_;
};

/// A set that lacks room in the first pass through a step, and then moves all particles to one place. In the
/// other passes it does nothing.
class WildFirstPass : public ConstraintSet<CpuDevice> {
 public:
  void start_step() override { ++passes; }
  void project(Substep<CpuDevice>& substep, int) override {
    if (passes > 1) return;
    substep.device.parallel_for("test/gather", substep.particles.owned,
                                [to = substep.particles.position](uint32_t i) {
                                  to[i] = {0, 0, 0, 1};
                                });
  }
  bool had_room() const override { return passes > 1; }
  void make_room() override { ++growths; }

  int passes = 0, growths = 0;
};

struct Outcome {
  int passes, growths;
  size_t before, after;  ///< bytes of neighbour lists
};

/// A step of 1,000 particles that have this many contacts each.
Outcome step_with(uint32_t contacts_each) {
  constexpr uint32_t count = 1000;
  CpuDevice device(1);
  Particles particles(device);
  Solver<CpuDevice> solver(device, particles, {.gravity = {0, 0, 0}, .substeps = 2});
  EqualContacts contacts(device, contacts_each);
  WildFirstPass set;
  solver.add(contacts);
  solver.add(set);
  solver.reserve(count);
  std::vector<Vec4> positions;
  for (uint32_t i = 0; i < count; ++i) positions.push_back({static_cast<float>(i), 0, 0, 1});
  std::vector<uint32_t> slots(count);
  std::iota(slots.begin(), slots.end(), 0u);
  particles.append(positions, std::vector<Vec4>(count), std::vector<Phase>(count), slots);
  solver.particles_changed(0, count);
  const auto lists = [&] { return device.held().find("neighbour lists")->second; };
  const size_t before = lists();
  solver.step(1.0f / 60);
  return {set.passes, set.growths, before, lists()};
}

TEST(SolverRoom, GrowsWhatLackedRoomAndRepeatsTheStep) {
  const Outcome outcome = step_with(0);
  EXPECT_EQ(outcome.passes, 2);
  EXPECT_EQ(outcome.growths, 1);
  EXPECT_GT(outcome.after, outcome.before);
}

// The list of touching particles is then an arbitrary part of them. Whatever follows in that pass would make
// memory depend on the number of threads and on earlier contents of memory.
TEST(SolverRoom, APassWithoutRoomForContactsGrowsNothingElse) {
  const Outcome outcome = step_with(4);
  EXPECT_GT(outcome.passes, 2);  // there is room for 1,024 contacts at first
  EXPECT_EQ(outcome.growths, 0);
  EXPECT_EQ(outcome.after, outcome.before);
}

}  // namespace
}  // namespace meniscus::pbd
