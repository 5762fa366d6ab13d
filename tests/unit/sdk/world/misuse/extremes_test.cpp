// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Fluid, a body and cloth in a closed tank, at steps, sizes, speeds, gravities and places far from the usual
// ones. A step may be refused, and then nothing has changed. Else all stays finite.
#include <gtest/gtest.h>

#include "tests/cloth_worlds.h"

namespace meniscus::tests {
namespace {

struct Extreme {
  float dt = 0.01f;       ///< s
  float spacing = 0.05f;  ///< m
  float speed = 0;        ///< m/s, of fluid, body and cloth, each in another direction
  float gravity = 9.81f;  ///< m/s²
  int particles = 64;
  float offset = 0;  ///< m, from the origin
  DensitySolver solver = DensitySolver::chebyshev;
};

std::ostream& operator<<(std::ostream& out, const Extreme& e) {
  return out << "dt " << e.dt << " s, spacing " << e.spacing << " m, " << e.speed << " m/s, gravity "
             << e.gravity << " m/s², " << e.particles << " particles, " << e.offset << " m away, solver "
             << static_cast<int>(e.solver);
}

/// A tank of 12 × 12 × 12 spacings.
class ExtremeWorld {
 public:
  ExtremeWorld(pbd::DeviceKind device, const Extreme& e) : world_(world_of(device, e)), s_(e.spacing) {
    const Vec3 origin{e.offset, 0, e.offset};
    const FluidId water = world_.create_fluid({});
    world_.create_shape(tank(origin - s_ * Vec3{6, 0, 6}, origin + s_ * Vec3{6, 12, 6}));
    BodyDef box;
    box.geometry = BoxGeometry{{s_, s_, s_}};
    box.pose.position = origin + s_ * Vec3{3, 6, 0};
    box.velocity = {-e.speed, 0, 0};
    body_ = world_.create_body(box);
    ClothDef veil = sheet(4 * s_, 4 * s_, 5, 5, origin + s_ * Vec3{-2, 8, 0});
    veil.velocity = {0, 0, e.speed};
    cloth_ = world_.create_cloth(veil);
    std::vector<Vec3> points = lattice(4, 4, 4, s_, origin + s_ * Vec3{-4, 0, -2});
    points.resize(static_cast<size_t>(e.particles));
    if (!points.empty())
      world_.add_particles(water, points, std::vector<Vec3>(points.size(), {e.speed, 0, e.speed}));
  }

  /// Returns whether the step was refused.
  bool step(float dt) {
    const uint64_t before = world_.state_hash();
    try {
      world_.step(dt);
      return false;
    } catch (const Error& error) {
      EXPECT_EQ(static_cast<int>(error.code()), static_cast<int>(ErrorCode::non_finite)) << error.what();
      EXPECT_EQ(world_.state_hash(), before);
      return true;
    }
  }

  void expect_finite() const {
    const Diagnostics d = world_.diagnostics();
    EXPECT_EQ(d.non_finite, 0u);
    EXPECT_TRUE(std::isfinite(d.kinetic_energy));
    const auto all_finite = [](std::span<const Vec3> values) {
      return std::all_of(values.begin(), values.end(), [](Vec3 v) { return is_finite(v); });
    };
    EXPECT_TRUE(all_finite(world_.positions()) && all_finite(world_.velocities())) << "fluid";
    EXPECT_TRUE(all_finite(world_.cloth_positions(cloth_)) && all_finite(world_.cloth_velocities(cloth_)))
        << "cloth";
    const BodyState body = world_.body_state(body_);
    EXPECT_TRUE(is_finite(body.pose.position) && is_finite(body.velocity) && is_finite(body.angular_velocity))
        << "body";
  }

  const World& world() const { return world_; }

 private:
  static WorldDef world_of(pbd::DeviceKind device, const Extreme& e) {
    WorldDef def = world_def(device, e.spacing);
    def.threads = 1;
    def.gravity = {0, -e.gravity, 0};
    def.density.solver = e.solver;
    return def;
  }

  World world_;
  float s_;
  BodyId body_;
  ClothId cloth_;
};

class ExtremesTest : public OnDevice {
 protected:
  void try_out(const Extreme& e) {
    std::ostringstream what;
    what << e;
    SCOPED_TRACE(what.str());
    ExtremeWorld world(GetParam(), e);
    bool refused = false;
    for (int k = 0; k < 4 && !refused; ++k) refused = world.step(e.dt);
    world.expect_finite();
    ++tried_;
    refused_ += refused;
  }
  void TearDown() override {
    RecordProperty("tried", tried_);
    RecordProperty("refused", refused_);
    std::printf("%d extremes, of which %d refused\n", tried_, refused_);
  }

  static constexpr float steps[] = {1e-6f, 1e-3f, 0.1f};
  static constexpr float speeds[] = {0, 20, 500};

 private:
  int tried_ = 0, refused_ = 0;
};

TEST_P(ExtremesTest, StepsSizesSpeedsAndGravities) {
  for (const float dt : steps) {
    for (const float spacing : {1e-3f, 0.05f, 10.0f}) {
      for (const float speed : speeds) {
        for (const float gravity : {0.0f, 9.81f, 981.0f}) try_out({dt, spacing, speed, gravity});
      }
    }
  }
}

TEST_P(ExtremesTest, HardlyAnyParticles) {
  for (const DensitySolver solver : {DensitySolver::chebyshev, DensitySolver::grid}) {
    for (const int particles : {0, 1, 2}) {
      for (const float dt : steps) {
        for (const float speed : {0.0f, 500.0f}) try_out({dt, 0.05f, speed, 9.81f, particles, 0, solver});
      }
    }
  }
}

TEST_P(ExtremesTest, FarFromTheOrigin) {
  for (const float dt : steps) {
    for (const float spacing : {1e-3f, 0.05f, 10.0f}) try_out({dt, spacing, 20, 9.81f, 64, 1e5f});
  }
  const ExtremeWorld far(GetParam(), {.offset = 1e5f}), near(GetParam(), {});
  const auto warns = [](const ExtremeWorld& world) {
    const std::vector<std::string> all = world.world().warnings();
    return std::any_of(all.begin(), all.end(),
                       [](const std::string& w) { return w.find("origin") < w.size(); });
  };
  EXPECT_TRUE(warns(far));
  EXPECT_FALSE(warns(near));
}

TEST_P(ExtremesTest, ThePressureGrid) {
  for (const float dt : steps) {
    for (const float spacing : {1e-3f, 10.0f}) {
      for (const float speed : speeds) {
        for (const float gravity : {0.0f, 981.0f})
          try_out({dt, spacing, speed, gravity, 64, 0, DensitySolver::grid});
      }
    }
  }
}

MENISCUS_ON_EACH_DEVICE(ExtremesTest);

}  // namespace
}  // namespace meniscus::tests
