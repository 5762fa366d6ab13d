// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tests of how particles that pass through cloth are counted.
#include "sdk/cli/record/scene_checks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "sdk/cli/record/run_summary.h"

namespace meniscus::cli {
namespace {

using Triangle = std::array<Vec3, 3>;

/// In the plane y = height, with its normal up.
Triangle level_triangle(float height) {
  return {{{-1, height, -1}, {0, height, 1}, {1, height, -1}}};
}

TEST(Passage, IsSignedByTheNormal) {
  const Triangle still = level_triangle(0);
  EXPECT_EQ(passage(still, still, {0, -1, 0}, {0, 1, 0}), 1);
  EXPECT_EQ(passage(still, still, {0, 1, 0}, {0.1f, -1, 0.2f}), -1);
  EXPECT_EQ(passage(still, still, {0, 1, 0}, {0, 0.5f, 0}), 0) << "it does not get there";
  EXPECT_EQ(passage(still, still, {3, -1, 0}, {3, 1, 0}), 0) << "it passes beside it";
  EXPECT_EQ(passage(still, still, {-2, -1, 0}, {3.4f, 1, 0}), 0) << "its box meets that of the way";
}

TEST(Passage, OfATriangleThatMoves) {
  EXPECT_EQ(passage(level_triangle(1), level_triangle(-1), {0, 0, 0}, {0, 0, 0}), 1);
  EXPECT_EQ(passage(level_triangle(1), level_triangle(-1), {0, 2, 0}, {0, 0, 0}), 0) << "they move as one";
}

/// A square of two triangles about the origin, in two pieces if `parted`.
struct Square {
  FrameSample sample;
  std::vector<Vec3> positions;
  std::vector<ParticleId> ids;

  explicit Square(bool parted = false) {
    sample.cloth.vertices = {{-1, 0, -1}, {-1, 0, 1}, {1, 0, 1}, {1, 0, -1}};
    sample.cloth.triangles = {{0, 1, 2}, {0, 2, 3}};
    sample.cloth.pieces = {0, parted ? 1u : 0u};
    sample.cloth.names = parted ? std::vector<std::string>{"a", "b"} : std::vector<std::string>{"a"};
  }

  const FrameSample& with(std::vector<Vec3> points, std::vector<ParticleId> names) {
    positions = std::move(points);
    ids = std::move(names);
    sample.particles.positions = positions;
    sample.particles.ids = ids;
    return sample;
  }
};

TEST(ClothCrossings, FollowsParticlesByTheirIds) {
  Square square;
  ClothCrossings crossings;
  crossings.start(square.with({{0.5f, 1, 0}, {-0.5f, 1, 0}}, {3, 5}));
  // 3 is gone and 7 is new, below: nothing has passed.
  crossings.add(square.with({{-0.5f, 0.5f, 0}, {0.5f, -1, 0}}, {5, 7}));
  EXPECT_EQ(crossings.through_all(), 0u);
  crossings.add(square.with({{-0.5f, -0.5f, 0}, {0.5f, -1, 0}}, {5, 7}));
  EXPECT_EQ(crossings.through_all(), 1u);
  crossings.add(square.with({{-0.5f, 0.5f, 0}, {0.5f, 1, 0}}, {5, 7}));
  EXPECT_EQ(crossings.through_all(), 3u) << "back is a passage as well";
}

TEST(ClothCrossings, CountsEachPieceOnItsOwn) {
  Square square(true);
  ClothCrossings crossings;
  crossings.start(square.with({{-0.5f, 1, 0.5f}}, {0}));
  crossings.add(square.with({{-0.5f, -1, 0.5f}}, {0}));
  EXPECT_EQ(crossings.through(0), 1u);
  EXPECT_EQ(crossings.through(1), 0u);
}

/// A fold, drawn through a particle that rests: both of its layers pass it.
TEST(ClothCrossings, ToAndFroWithinAFrameIsNone) {
  Square fold;
  fold.sample.cloth.vertices = {{-1, 0, -1}, {-1, 0.2f, 1}, {1, 0.1f, 0}, {-1, 0.4f, -1}};
  fold.sample.cloth.triangles = {{0, 2, 1}, {1, 2, 3}};
  ClothCrossings crossings;
  crossings.start(fold.with({{-0.5f, -1, -0.3f}}, {0}));
  crossings.add(fold.with({{-0.5f, 2, -0.3f}}, {0}));
  EXPECT_EQ(crossings.through_all(), 0u);
}

TEST(ClothCrossings, ATearOpensAWay) {
  Square square;
  ClothCrossings crossings;
  crossings.start(square.with({{0, 1, 0}}, {0}));
  // The halves part along the diagonal on which the particle comes down: vertices 0 and 2 have copies.
  square.sample.cloth.vertices = {{-1.5f, 0, -0.5f}, {-1.5f, 0, 1.5f},  {0.5f, 0, 1.5f},
                                  {1.5f, 0, -1.5f},  {-0.5f, 0, -1.5f}, {1.5f, 0, 0.5f}};
  square.sample.cloth.triangles = {{0, 1, 2}, {4, 5, 3}};
  crossings.add(square.with({{0, -1, 0}}, {0}));
  EXPECT_EQ(crossings.through_all(), 0u);
}

class SceneChecksTest : public testing::Test {
 protected:
  static SceneCheck check(CheckKind kind, std::optional<float> low, std::optional<float> high) {
    SceneCheck c;
    c.kind = kind;
    c.name = "it";
    c.low = low;
    c.high = high;
    return c;
  }

  /// Of the only check, after frames of 1 s with this sample at each.
  nlohmann::ordered_json after(const std::vector<FrameSample>& samples, std::optional<double> energy = 1) {
    SceneChecks checks(scene_);
    checks.start(samples.front());
    double time = 0;
    for (FrameSample s : samples) {
      s.particles.time = ++time;
      checks.add(s, energy);
    }
    return checks.summary().at(0);
  }

  static FrameSample with_error(double mean) {
    FrameSample s;
    s.diagnostics.density_error_mean = mean;
    return s;
  }

  Scene scene_;
};

TEST_F(SceneChecksTest, BreaksAtTheFirstFrameThatIsNotAllowed) {
  scene_.checks = {check(CheckKind::density_error, {}, 0.25f)};
  const auto held = after({with_error(0.125), with_error(0.25)});
  EXPECT_EQ(held["state"], "held");
  EXPECT_EQ(held["least"], 0.125);
  EXPECT_EQ(held["most"], 0.25);
  EXPECT_TRUE(held["low"].is_null());
  const auto broken = after({with_error(0), with_error(0.3), with_error(0), with_error(0.4)});
  EXPECT_EQ(broken["state"], "broken");
  EXPECT_EQ(broken["broken_at_s"], 2);
  EXPECT_EQ(broken["most"], 0.4);
  EXPECT_EQ(check_line(broken), "\"it\" broken at 2 s: density_error was 0 to 0.4, allowed is at most 0.25");
  EXPECT_EQ(after({with_error(NAN)})["state"], "broken");
}

TEST_F(SceneChecksTest, LooksWithinItsTimesAlone) {
  scene_.checks = {check(CheckKind::density_error, 0.5f, {})};
  scene_.checks[0].from = 2;
  scene_.checks[0].until = 3;
  EXPECT_EQ(after({with_error(0), with_error(1), with_error(1), with_error(0)})["state"], "held");
  EXPECT_EQ(after({with_error(0), with_error(1), with_error(0)})["state"], "broken");
  EXPECT_EQ(after({with_error(0), with_error(0)})["state"], "broken");
  const auto early = after({with_error(0)});
  EXPECT_EQ(early["state"], "not reached");
  EXPECT_EQ(check_line(early), "\"it\" not reached: density_error allowed is at least 0.5");
}

TEST_F(SceneChecksTest, LooksAtTheBodyThatItNames) {
  scene_.bodies.resize(2);
  scene_.bodies[0].def.name = "anchor";
  scene_.bodies[1].def.name = "boat";
  scene_.checks = {check(CheckKind::body_position, 3, 3)};
  scene_.checks[0].body = "boat";
  FrameSample s;
  s.bodies.resize(2);
  s.bodies[1].pose.position = {1, 3, 2};
  s.bodies[1].velocity = {0, 3, 4};
  EXPECT_EQ(after({s})["state"], "held");
  scene_.checks[0].axis = Axis::z;
  EXPECT_EQ(after({s})["most"], 2);
  scene_.checks[0].kind = CheckKind::body_speed;
  EXPECT_EQ(after({s})["most"], 5);
  scene_.checks[0].kind = CheckKind::body_tilt;
  EXPECT_EQ(after({s})["most"], 0);
  s.bodies[1].pose.rotation = {0, 0, 0.5f, std::sqrt(0.75f)};
  EXPECT_NEAR(after({s})["most"], 60, 1e-4);
}

TEST_F(SceneChecksTest, LooksAtTheClothThatItNames) {
  scene_.cloths.resize(2);
  scene_.cloths[0].name = "flag";
  scene_.cloths[1].name = "bag";
  scene_.checks = {check(CheckKind::max_stretch, {}, 1.5f)};
  scene_.checks[0].cloth = "bag";
  FrameSample s;
  s.cloths.resize(2);
  s.cloths[0].max_stretch = 9;
  s.cloths[1] = {.mean_stretch = 0.25f, .max_stretch = 1.25f, .volume = 4, .centre = {1, 2, 3}};
  s.tears = {7, 2};
  EXPECT_EQ(after({s})["state"], "held");
  scene_.checks[0].kind = CheckKind::mean_stretch;
  EXPECT_EQ(after({s})["most"], 0.25);
  scene_.checks[0].kind = CheckKind::cloth_position;
  EXPECT_EQ(after({s})["most"], 2);
  scene_.checks[0].kind = CheckKind::tears;
  EXPECT_EQ(after({s, s, s})["most"], 6) << "of all frames so far";
  scene_.checks[0].kind = CheckKind::cloth_volume;
  FrameSample half = s;
  half.cloths[1].volume = 2;
  EXPECT_EQ(after({s, half})["least"], 0.5);
}

TEST_F(SceneChecksTest, LooksAtParticlesAndProbes) {
  const std::vector<Vec3> positions{{0, 0, 0}, {1, 1, 1}, {1.5f, 0, 0}, {0, -0.1f, 0}};
  FrameSample s;
  s.particles.positions = positions;
  s.diagnostics.outside = 2;
  s.probes = {10, 20};
  scene_.checks = {check(CheckKind::share_inside, 0, 1)};
  scene_.checks[0].region = {{0, 0, 0}, {1, 1, 1}};
  EXPECT_EQ(after({s})["most"], 0.5) << "the border belongs to it";
  scene_.checks = {check(CheckKind::outside, {}, 1)};
  EXPECT_EQ(after({s})["state"], "broken");
  scene_.probes.resize(2);
  scene_.probes[1].def.name = "wall";
  scene_.checks = {check(CheckKind::probe, {}, 20)};
  scene_.checks[0].probe = "wall";
  EXPECT_EQ(after({s})["most"], 20);
}

TEST_F(SceneChecksTest, EnergyNeedsAFloor) {
  scene_.checks = {check(CheckKind::energy, {}, 1.5f)};
  EXPECT_THROW(SceneChecks checks(scene_), Error);
  scene_.shapes.resize(1);
  EXPECT_EQ(after({FrameSample{}}, 1.25)["most"], 1.25);
  EXPECT_EQ(after({FrameSample{}}, 1.75)["state"], "broken");
  EXPECT_EQ(after({FrameSample{}}, std::nullopt)["state"], "not reached");
}

}  // namespace
}  // namespace meniscus::cli
