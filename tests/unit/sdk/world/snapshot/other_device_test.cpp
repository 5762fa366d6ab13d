// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A file of one kind of device goes on on the other, within the difference of their rounding.
#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include "tests/unit/sdk/world/snapshot/cases.h"

namespace meniscus::tests {
namespace {

namespace fs = std::filesystem;

class OtherDeviceTest : public testing::TestWithParam<SnapshotCase> {
 protected:
  void SetUp() override {
    if (usable_devices().size() < 2) GTEST_SKIP() << "there is no GPU";
  }
  void TearDown() override { fs::remove(path_); }

  /// Saves a world of one device, and steps it and its copy on the other one.
  void expect_alike(pbd::DeviceKind from, pbd::DeviceKind to) {
    World world = GetParam().make(world_def(from, 0.05f));
    run(world, GetParam().before, snapshot_step);
    world.save(path_);
    LoadDef def;
    def.device = choice_of(to);
    World other = World::load(path_, def);
    EXPECT_NE(other.device().kind, world.device().kind);
    ASSERT_EQ(other.particle_count(), world.particle_count());
    EXPECT_EQ(other.state_hash(), world.state_hash()) << "nothing has moved yet";
    world.step(snapshot_step);
    other.step(snapshot_step);
    expect_near_states(world, other);
  }

 private:
  static constexpr double mean_bound = 0.02;  // support radii, of a step's difference

  static double mean_distance(std::span<const Vec3> a, std::span<const Vec3> b) {
    double sum = 0;
    const size_t count = std::min(a.size(), b.size());
    for (size_t k = 0; k < count; ++k) sum += double{length(a[k] - b[k])};
    return count ? sum / static_cast<double>(count) : 0;
  }

  static void expect_near_states(const World& a, const World& b) {
    const double bound = mean_bound * double{a.support_radius()};
    const std::span<const ParticleId> ids = a.ids(), others = b.ids();
    if (std::equal(ids.begin(), ids.end(), others.begin(), others.end())) {
      EXPECT_LT(mean_distance(a.positions(), b.positions()), bound);
    } else {  // a particle at the edge of a sink, or of the room at an opening
      EXPECT_NEAR(static_cast<double>(ids.size()), static_cast<double>(others.size()),
                  0.01 * static_cast<double>(ids.size()) + 2);
    }
    const std::vector<ClothId> cloths = a.cloth_ids(), copies = b.cloth_ids();
    for (size_t k = 0; k < cloths.size(); ++k)
      EXPECT_LT(mean_distance(a.cloth_positions(cloths[k]), b.cloth_positions(copies[k])), bound);
    const std::vector<BodyId> bodies = a.body_ids(), same = b.body_ids();
    for (size_t k = 0; k < bodies.size(); ++k) {
      const Vec3 apart = a.body_state(bodies[k]).pose.position - b.body_state(same[k]).pose.position;
      EXPECT_LT(double{length(apart)}, bound);
    }
  }

  std::string path_ =
      (fs::path(testing::TempDir()) / ("other_device_" + std::to_string(getpid()) + ".menisnap")).string();
};

TEST_P(OtherDeviceTest, GoesOnThere) {
  {
    SCOPED_TRACE("from the CPU");
    expect_alike(pbd::DeviceKind::cpu, pbd::DeviceKind::cuda);
  }
  SCOPED_TRACE("from the GPU");
  expect_alike(pbd::DeviceKind::cuda, pbd::DeviceKind::cpu);
}

INSTANTIATE_TEST_SUITE_P(Case, OtherDeviceTest, testing::ValuesIn(snapshot_cases()),
                         [](const auto& chosen) { return std::string(chosen.param.name); });

}  // namespace
}  // namespace meniscus::tests
