// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Position-based fluid stays stable at a step of a whole frame, 16 ms without substeps, where explicit
// methods fail (Macklin & Müller 2013, Figure 4).
#include "sdk/scene/scene_file.h"
#include "tests/validation/measures.h"
#include "tests/validation/scenes.h"

namespace meniscus::tests {
namespace {

/// Diagnostics::outside does not count particles that have passed over the open tank's rim.
size_t count_beyond_tank(const World& world) {
  const std::span<const Vec3> positions = world.positions();
  return static_cast<size_t>(std::count_if(positions.begin(), positions.end(), [](Vec3 p) {
    return std::fabs(p.x) > 4 || std::fabs(p.z) > 4 || p.y < 0;
  }));
}

class OneStepFrameTest : public OnDevice {};

TEST_P(OneStepFrameTest, BunnyDropComesToRest) {
  const std::vector<std::string> overrides{"world.substeps=1"};
  Scene scene = read_scene(sample_scene("bunny_drop"), overrides);
  scene.world.device = choice_of(GetParam());
  World world = build_scene(scene).world;
  record_device(world);
  Watch watch(world);
  const double height = world.diagnostics().potential_energy;
  DensityErrors all, end;
  double fastest = 0, moving = 0;
  while (world.time() < 10) {
    world.step(frame_time);
    const Diagnostics now = world.diagnostics();
    watch.add(now);
    all.add(world, now);
    fastest = std::max<double>(fastest, now.max_speed);
    if (world.time() < 9) continue;
    end.add(world, now);
    moving = std::max(moving, now.kinetic_energy / (height - now.potential_energy));
  }
  record("kinetic_over_fallen", moving);
  record("max_speed_m_s", fastest);
  record("run_density_error_mean_percent", all.mean());
  record("run_density_error_worst_percent", all.worst());
  end.record_all();
  watch.expect_sound();
  EXPECT_EQ(count_beyond_tank(world), 0u);
  EXPECT_LE(moving, 0.02);
  EXPECT_LE(end.mean(), 2);
}

MENISCUS_ON_EACH_DEVICE(OneStepFrameTest);

}  // namespace
}  // namespace meniscus::tests
