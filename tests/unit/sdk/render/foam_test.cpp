// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Spray, foam and bubbles in pictures.
#include <algorithm>

#include "tests/bench/harness/render_bench.h"

namespace meniscus::tests {
namespace {

constexpr float spacing = 0.05f;

class FoamPictureTest : public RenderTest {
 protected:
  /// Straight down on a slab of water that is 0.4 m deep.
  static io::PreviewScene above_ground() {
    io::PreviewScene scene = small_scene(spacing);
    scene.shapes = {shape(PlaneGeometry{})};
    scene.camera = SceneCamera{{0, 4, 0.01f}, {0, 0, 0}, 35};
    return scene;
  }
  static Water slab() {
    return Water(points_where(spacing, {0.8f, 1, 0.8f}, [&](Vec3 p) { return p.y > 0 && p.y < 0.4f; }),
                 spacing);
  }

  /// A patch at this height, about the middle of the picture.
  static std::vector<DiffuseParticle> patch(float height, DiffuseKind kind, float life = 2) {
    std::vector<DiffuseParticle> all;
    for (const Vec3 p : lattice(60, 1, 60, 0.01f, {-0.3f, height, -0.3f}))
      all.push_back({p, {0, 0, 0}, life, kind});
    return all;
  }

  io::Image with(const io::PreviewScene& scene, render::Moment moment,
                 std::span<const DiffuseParticle> diffuse) {
    moment.diffuse = diffuse;
    return draw(scene, moment);
  }
};

TEST_F(FoamPictureTest, FoamIsWhiteOnTheWaterAndTheRestIsAsItWas) {
  const Water water = slab();
  const io::Image bare = with(above_ground(), water.moment(), {});
  const io::Image foamy = with(above_ground(), water.moment(), patch(0.4f, DiffuseKind::foam));
  const Pixel foam = at(foamy, 80, 60);
  EXPECT_GT(sum(foam), sum(at(bare, 80, 60)) + 100);
  EXPECT_LT(std::max({foam.r, foam.g, foam.b}) - std::min({foam.r, foam.g, foam.b}), 40) << "it is white";
  EXPECT_EQ(difference(at(foamy, 4, 60), at(bare, 4, 60)), 0);
}

TEST_F(FoamPictureTest, BubblesAreDyedByTheWaterBeforeThem) {
  const Water water = slab();
  const Pixel bare = at(with(above_ground(), water.moment(), {}), 80, 60);
  const Pixel high = at(with(above_ground(), water.moment(), patch(0.3f, DiffuseKind::bubble)), 80, 60);
  const Pixel deep = at(with(above_ground(), water.moment(), patch(0.05f, DiffuseKind::bubble)), 80, 60);
  EXPECT_GT(sum(high), sum(bare));
  EXPECT_LT(deep.r, high.r) << "water takes red first";
  EXPECT_LT(sum(deep), sum(high));
  EXPECT_GT(high.b - high.r, 40) << "it is not white";
}

TEST_F(FoamPictureTest, ASolidHidesThem) {
  io::PreviewScene scene = above_ground();
  scene.shapes.push_back(shape(BoxGeometry{{0.5f, 0.05f, 0.5f}}, {0, 0.8f, 0}));
  const Water water = slab();
  const io::Image bare = with(scene, water.moment(), {});
  const io::Image behind = with(scene, water.moment(), patch(0.4f, DiffuseKind::foam));
  const io::Image before = with(scene, water.moment(), patch(1.0f, DiffuseKind::spray));
  EXPECT_EQ(difference(at(bare, 80, 60), at(behind, 80, 60)), 0);
  EXPECT_GT(difference(at(bare, 80, 60), at(before, 80, 60)), 30);
}

TEST_F(FoamPictureTest, ItFadesAtItsEnd) {
  const Water water = slab();
  const int fresh = sum(at(with(above_ground(), water.moment(), patch(0.4f, DiffuseKind::foam)), 80, 60));
  const int old =
      sum(at(with(above_ground(), water.moment(), patch(0.4f, DiffuseKind::foam, 0.05f)), 80, 60));
  EXPECT_LT(old, fresh - 50);
}

TEST_F(FoamPictureTest, TheirOrderDoesNotCount) {
  const Water water = slab();
  std::vector<DiffuseParticle> all = patch(0.4f, DiffuseKind::foam), deep = patch(0.1f, DiffuseKind::bubble);
  all.insert(all.end(), deep.begin(), deep.end());
  const Pixel first = at(with(above_ground(), water.moment(), all), 80, 60);
  std::reverse(all.begin(), all.end());
  EXPECT_LE(difference(at(with(above_ground(), water.moment(), all), 80, 60), first), 3);
}

}  // namespace
}  // namespace meniscus::tests
