// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The places within an opening from which particles leave.
#include "sdk/world/flow/emitter_sites.h"

#include <gtest/gtest.h>

#include "sdk/world/solids/surface_samples.h"
#include "tests/unit/sdk/world/flow/emitter_worlds.h"

namespace meniscus::tests {
namespace {

constexpr float s = 0.01f;

float nearest_places(const EmitterSites& sites) {
  float nearest = infinity;
  for (const EmitterSite& a : sites.places) {
    for (const EmitterSite& b : sites.places) {
      if (&a != &b) nearest = std::min(nearest, length(a.position - b.position));
    }
  }
  return nearest;
}

/// However large an opening is, each particle has the room of a spacing cubed, and none is too near another.
void expect_sound(const EmitterSites& sites, float closest) {
  EXPECT_NEAR(sites.area * sites.layer, static_cast<double>(sites.places.size()) * std::pow(double{s}, 3),
              1e-12);
  EXPECT_GE(sites.layer, 0.7 * double{s});
  if (sites.places.size() > 5) {
    EXPECT_LE(sites.layer, 1.3 * double{s});
  }
  EXPECT_GE(nearest_places(sites), closest * s);
}

TEST(EmitterSites, DiscsOfAnySize) {
  for (float radius = 0.2f * s; radius < 12 * s; radius *= 1.07f) {
    SCOPED_TRACE(radius / s);
    const EmitterSites sites = emitter_sites(DiscOpening{radius}, s);
    EXPECT_NEAR(sites.area, std::numbers::pi * double{radius} * double{radius}, 1e-9);
    expect_sound(sites, 0.83f);
    for (const EmitterSite& site : sites.places) {
      EXPECT_LT(length(site.position), 1.1f * radius);
      EXPECT_EQ(site.position.y, 0);
      EXPECT_EQ(site.direction, (Vec3{0, 1, 0}));
    }
  }
}

TEST(EmitterSites, RectanglesOfAnySides) {
  for (float width = 0.3f * s; width < 9 * s; width *= 1.13f) {
    for (float depth = 0.3f * s; depth < 9 * s; depth *= 1.17f) {
      SCOPED_TRACE(testing::Message() << width / s << " × " << depth / s);
      const EmitterSites sites = emitter_sites(RectangleOpening{width, depth}, s);
      if (double{width} * double{depth} < 1.4 * double{s} * double{s}) continue;  // a drip, or a slit
      EXPECT_GE(nearest_places(sites), 0.69f * s);
      if (width > 2 * s && depth > 2 * s) expect_sound(sites, 0.69f);
      for (const EmitterSite& site : sites.places) {
        EXPECT_LT(std::fabs(site.position.x), 0.5f * width);
        EXPECT_LT(std::fabs(site.position.z), 0.5f * depth);
      }
    }
  }
}

TEST(EmitterSites, AMeshGivesAlongItsNormals) {
  const TemporaryFolder folder;
  const std::string file = folder.write("brick.obj", brick_obj);  // 1 × 2 × 3
  const EmitterSites sites = emitter_sites(MeshOpening{file, 5 * s}, s);
  EXPECT_NEAR(sites.area, 22 * 25 * double{s} * double{s}, 1e-6);
  EXPECT_EQ(sites.places.size(), 550u);
  expect_sound(sites, 0.6f);
  std::array<int, 6> on_face{};
  for (const EmitterSite& site : sites.places) {
    const Vec3 n = site.direction, p = site.position / (5 * s);
    const Vec3 size{1, 2, 3};
    int face = 0;
    for (auto axis : {&Vec3::x, &Vec3::y, &Vec3::z}) {
      if (std::fabs(n.*axis) > 0.5f) {
        EXPECT_NEAR(p.*axis, n.*axis > 0 ? size.*axis : 0.0f, 1e-5f);
        ++on_face[static_cast<size_t>(2 * face + (n.*axis > 0))];
      }
      ++face;
    }
  }
  const std::array<int, 6> areas{6, 6, 3, 3, 2, 2};
  for (size_t f = 0; f < 6; ++f) EXPECT_NEAR(on_face[f], 25 * areas[f], 10) << f;
}

TEST(EmitterSites, SamplesOfAMeshAreTheSameEachTime) {
  const TemporaryFolder folder;
  const MeshOpening opening{folder.write("brick.obj", brick_obj), 2 * s};
  const EmitterSites a = emitter_sites(opening, s), b = emitter_sites(opening, s);
  ASSERT_EQ(a.places.size(), b.places.size());
  for (size_t i = 0; i < a.places.size(); ++i) EXPECT_EQ(a.places[i].position, b.places[i].position);
}

TEST(EmitterSites, AMeshGivesItsAreaTimesTheSpeed) {
  const TemporaryFolder folder;
  World world(weightless(pbd::DeviceKind::cpu, emitter_spacing));
  EmitterDef def =
      emitter(world.create_fluid({}), MeshOpening{folder.write("brick.obj", brick_obj), 0.2f}, 1);
  const EmitterId id = world.create_emitter(def);
  world.create_sink({"", BallRegion{1}, true, {}, {}});
  run(world, 60, 1.0f / 60);
  EXPECT_NEAR(emitted_volume(world, id), 22 * 0.04, 0.01 * 22 * 0.04 + 22 * 0.04 * double{emitter_spacing});
}

}  // namespace
}  // namespace meniscus::tests
