// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Ten simulated minutes of coupled scenes: no memory is lost, no particle appears or vanishes, nothing leaves
// its tank, and water keeps its volume. MENISCUS_SOAK_SECONDS is another duration.
#include "tests/soak/soak_scenes.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <tuple>
#include <utility>

namespace meniscus::tests {
namespace {

struct NamedScene {
  const char* name;
  SoakMaker make;
};
void PrintTo(const NamedScene& scene, std::ostream* out) {
  *out << scene.name;
}

float soak_seconds() {
  const char* given = std::getenv("MENISCUS_SOAK_SECONDS");
  return given ? std::strtof(given, nullptr) : 600.0f;
}

/// Bytes that the process holds.
std::size_t resident_bytes() {
  std::size_t all = 0, resident = 0;
  std::ifstream("/proc/self/statm") >> all >> resident;
  return resident * 4096;
}

/// How far a point is outside, along the axis where that is most; 0 inside.
float distance_outside(const Aabb& box, Vec3 p) {
  const Vec3 below = box.lower - p, above = p - box.upper;
  return std::max({0.0f, below.x, below.y, below.z, above.x, above.y, above.z});
}

/// What has left its tank. `deepest`: the furthest that cloth has been within a wall so far, m.
std::size_t escaped(const SoakScene& scene, std::size_t outside, float& deepest) {
  if (!scene.tank_of_cloth || outside == 0) return outside;
  const World& world = scene.world;
  std::size_t count = 0;
  const auto add = [&](std::span<const Vec3> points) {
    for (Vec3 p : points) {
      const float distance = distance_outside(scene.tank_of_cloth->box, p);
      deepest = std::max(deepest, distance);
      count += distance > scene.tank_of_cloth->give;
    }
  };
  add(world.positions());
  for (const ClothId cloth : world.cloth_ids()) add(world.cloth_positions(cloth));
  return count;
}

/// The number of particles that a world should have.
class Balance {
 public:
  explicit Balance(const World& world) : due_(static_cast<int64_t>(world.particle_count())) {}
  void add(const StepReport& r) { due_ += int64_t{r.emitted} + r.dripped - r.removed - r.absorbed; }
  void add(int64_t by_hand) { due_ += by_hand; }
  int64_t due() const { return due_; }

 private:
  int64_t due_;
};

class SoakTest : public testing::TestWithParam<std::tuple<pbd::DeviceKind, NamedScene>> {};

TEST_P(SoakTest, TenMinutesLeaveNoTrace) {
  const auto& [device, named] = GetParam();
  SoakScene scene{World(world_def(device, soak_spacing)), {}};
  named.make(scene);
  World& world = scene.world;
  Balance balance(world);
  std::size_t device_bytes = 0, host_bytes = 0;
  double worst_error = 0;
  float deepest = 0;
  const int steps = static_cast<int>(soak_seconds() / soak_dt), look = 600, minute = 3600;
  for (int step = 0; step < steps; ++step) {
    if (scene.act) scene.act(world, step);
    balance.add(std::exchange(scene.added_by_hand, 0));
    balance.add(world.step(soak_dt));
    if ((step + 1) % look != 0) continue;
    const Diagnostics d = world.diagnostics();
    ASSERT_EQ(static_cast<int64_t>(world.particle_count()), balance.due()) << "step " << step;
    ASSERT_EQ(d.non_finite, 0u) << "step " << step;
    EXPECT_EQ(escaped(scene, d.outside, deepest), 0u) << "step " << step << ", " << deepest << " m";
    if ((step + 1) % minute == 0) {
      std::printf("%s: minute %d, %.2f MB on the device, %.1f MB in the process\n", named.name,
                  (step + 1) / minute, static_cast<double>(world.device_bytes()) * 1e-6,
                  static_cast<double>(resident_bytes()) * 1e-6);
      std::fflush(stdout);
    }
    worst_error = std::max(worst_error, d.density_error_mean);
    if (step < steps / 2) {
      device_bytes = std::max(device_bytes, world.device_bytes());
      host_bytes = std::max(host_bytes, resident_bytes());
    }
  }
  std::printf(
      "%s: %zu particles, mean density error at most %.3f %%, device %.2f to %.2f MB, host %.1f to %.1f MB\n",
      named.name, world.particle_count(), 100 * worst_error, 1e-6 * double(device_bytes),
      1e-6 * double(world.device_bytes()), 1e-6 * double(host_bytes), 1e-6 * double(resident_bytes()));
  if (deepest > 0) std::printf("%s: cloth up to %.1f mm within walls\n", named.name, 1000 * double{deepest});
  // Lists of contacts keep the room that the fullest heap so far needed.
  EXPECT_LE(world.device_bytes(), device_bytes + device_bytes / 4) << "grew in the second half";
  EXPECT_LE(resident_bytes(), host_bytes + host_bytes / 50) << "grew in the second half";
  EXPECT_LT(worst_error, 0.01) << "the volume is right to 1 %";
}

INSTANTIATE_TEST_SUITE_P(
    On, SoakTest,
    testing::Combine(testing::ValuesIn(usable_devices()),
                     testing::Values(NamedScene{"fountain", fountain}, NamedScene{"tearing", tearing},
                                     NamedScene{"laundry", laundry}, NamedScene{"sleepers", sleepers},
                                     NamedScene{"turnover", turnover}, NamedScene{"balloons", balloons})),
    [](const auto& test) {
      return std::string(std::get<1>(test.param).name) + "_" +
             testing::PrintToString(std::get<0>(test.param));
    });

}  // namespace
}  // namespace meniscus::tests
