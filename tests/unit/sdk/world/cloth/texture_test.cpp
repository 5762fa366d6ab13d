// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Texture coordinates of cloth: they follow from its rest shape, or from its file, and tears keep them.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

#include "tests/cloth_worlds.h"
#include "tests/unit/sdk/world/solids/body_worlds.h"

namespace meniscus::tests {
namespace {

class ClothTextureTest : public OnDevice {
 protected:
  ClothId create(const ClothGeometry& geometry) {
    ClothDef def;
    def.geometry = geometry;
    return world_.create_cloth(def);
  }

  /// The signed area of each triangle in the texture.
  std::vector<double> areas(ClothId id) const {
    const std::span<const TexturePoint> at = world_.cloth_texture(id);
    std::vector<double> areas;
    for (size_t k = 0; k + 2 < at.size(); k += 3)
      areas.push_back(0.5 * (double{at[k + 1].u - at[k].u} * (at[k + 2].v - at[k].v) -
                             double{at[k + 2].u - at[k].u} * (at[k + 1].v - at[k].v)));
    return areas;
  }

  World world_{weightless(GetParam())};
};

double sum(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += std::abs(value);
  return sum;
}

TEST_P(ClothTextureTest, ASheetFillsTheSquare) {
  const ClothId id = create(SheetGeometry{3, 2, 4, 3});
  const std::span<const TexturePoint> texture = world_.cloth_texture(id);
  const std::span<const uint32_t> corners = world_.cloth_triangles(id);
  ASSERT_EQ(texture.size(), corners.size());
  for (size_t k = 0; k < corners.size(); ++k) {
    EXPECT_NEAR(texture[k].u, static_cast<float>(corners[k] % 4) / 3, 1e-6f);
    EXPECT_NEAR(texture[k].v, static_cast<float>(corners[k] / 4) / 2, 1e-6f);
  }
  EXPECT_NEAR(sum(areas(id)), 1, 1e-6);
}

TEST_P(ClothTextureTest, ATubeIsUnrolledWithoutAnOverlapAtItsSeam) {
  const ClothId id = create(ClothTube{0.2f, 0.4f, 1, 16, 5, false});
  EXPECT_NEAR(sum(areas(id)), 1, 1e-5);
  for (const double area : areas(id)) EXPECT_NEAR(std::abs(area), 0.5 / 64, 1e-6) << "none goes back around";
  const ClothId bag = create(ClothTube{0.2f, 0.4f, 1, 16, 5, true});
  const double disc = 0.25 * 16 * std::sin(std::numbers::pi / 16) * std::cos(std::numbers::pi / 16);
  EXPECT_NEAR(sum(areas(bag)), 1 + disc, 1e-3) << "and its bottom";
}

TEST_P(ClothTextureTest, ASphereHasLongitudeAndLatitude) {
  const ClothId id = create(ClothSphere{0.5f, 6});
  const std::span<const Vec3> x = world_.cloth_positions(id);
  const std::span<const uint32_t> corners = world_.cloth_triangles(id);
  const std::span<const TexturePoint> texture = world_.cloth_texture(id);
  for (size_t k = 0; k < corners.size(); ++k) {
    const Vec3 p = x[corners[k]];
    EXPECT_NEAR(texture[k].v, 0.5 + std::asin(p.y / 0.5) / std::numbers::pi, 1e-3);
    if (std::hypot(p.x, p.z) < 1e-4f) continue;
    const double turn = 2 * std::numbers::pi * double{texture[k].u};
    EXPECT_NEAR(std::cos(turn), p.x / std::hypot(p.x, p.z), 1e-4);
    EXPECT_NEAR(std::sin(turn), p.z / std::hypot(p.x, p.z), 1e-4);
  }
  for (size_t k = 0; k < corners.size(); ++k)
    EXPECT_LT(std::abs(texture[k].u - texture[k / 3 * 3].u), 0.51f) << "triangle " << k / 3;
}

TEST_P(ClothTextureTest, AFileHasItsOwnAndWeldingKeepsThemApart) {
  const TemporaryFolder folder;
  // Two charts: the middle column has other coordinates on its two sides.
  const char* charts =
      "v 0 0 0\nv 0.1 0 0\nv 0.2 0 0\nv 0 0 0.1\nv 0.1 0 0.1\nv 0.2 0 0.1\n"
      "vt 0 0\nvt 0.3 0\nvt 0 1\nvt 0.3 1\nvt 0.6 0\nvt 0.9 0\nvt 0.6 1\nvt 0.9 1\n"
      "f 1/1 4/3 5/4\nf 1/1 5/4 2/2\nf 2/5 5/7 6/8\nf 2/5 6/8 3/6\n";
  const ClothId id = create(ClothFile{folder.write("charts.obj", charts), 1});
  const std::span<const TexturePoint> texture = world_.cloth_texture(id);
  const std::span<const Vec3> x = world_.cloth_positions(id);
  const std::span<const uint32_t> corners = world_.cloth_triangles(id);
  ASSERT_EQ(texture.size(), 12u);
  for (size_t k = 0; k < 12; ++k) {
    const float left = k < 6 ? 0 : 0.3f;
    EXPECT_NEAR(texture[k].u, 3 * x[corners[k]].x + left, 1e-6f) << k;
    EXPECT_NEAR(texture[k].v, 10 * x[corners[k]].z, 1e-6f) << k;
  }
}

TEST_P(ClothTextureTest, TrianglesOfAFileThatWeldingDropsAreNoMoreThere) {
  const TemporaryFolder folder;
  const char* seam =
      "v 0 0 0\nv 0.1 0 0\nv 0.100004 0 0\nv 0.2 0 0\nv 0 0 0.1\nv 0.1 0 0.1\nv 0.100004 0 0.1\nv 0.2 0 0.1\n"
      "vt 0 0\nvt 1 0\nvt 2 0\nvt 3 0\nvt 0 1\nvt 1 1\nvt 2 1\nvt 3 1\n"
      "f 1/1 5/5 6/6\nf 1/1 6/6 2/2\nf 2/2 6/6 7/7\nf 2/2 7/7 3/3\nf 3/3 7/7 8/8\nf 3/3 8/8 4/4\n";
  const ClothId id = create(ClothFile{folder.write("seam.obj", seam), 1});
  const std::span<const TexturePoint> texture = world_.cloth_texture(id);
  ASSERT_EQ(texture.size(), 12u);
  for (size_t k = 0; k < 6; ++k) EXPECT_LE(texture[k].u, 1) << k;
  for (size_t k = 6; k < 12; ++k) EXPECT_GE(texture[k].u, 2) << k;
}

TEST_P(ClothTextureTest, TrianglesInMemoryAndPlainFilesHaveNone) {
  const TemporaryFolder folder;
  EXPECT_TRUE(
      world_.cloth_texture(create(ClothTriangles{{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}}, {0, 2, 1}})).empty());
  const char* plain = "v 0 0 0\nv 1 0 0\nv 0 0 1\nf 1 3 2\n";
  EXPECT_TRUE(world_.cloth_texture(create(ClothFile{folder.write("plain.obj", plain), 1})).empty());
}

TEST_P(ClothTextureTest, AFileIsReadAtTheCreationAlone) {
  const char* textured = "v 0 0 0\nv 1 0 0\nv 0 0 1\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 3/3 2/2\n";
  for (const std::string text : {textured, "v 0 0 0\nv 1 0 0\nv 0 0 1\nf 1 3 2\n"}) {
    int reads = 0;
    WorldDef def = weightless(GetParam());
    def.read_file = [&](const std::string&) {
      ++reads;
      return text;
    };
    world_ = World(def);
    const ClothId id = create(ClothFile{"flag.obj", 1});
    const int at_creation = reads;
    for (int k = 0; k < 3; ++k) EXPECT_EQ(world_.cloth_texture(id).size(), text == textured ? 3u : 0u);
    const World clone = world_.clone();
    EXPECT_EQ(clone.cloth_texture(clone.cloth_ids().at(0)).size(), text == textured ? 3u : 0u);
    EXPECT_EQ(reads, at_creation);
  }
}

TEST_P(ClothTextureTest, AFileMayChangeOrGo) {
  const TemporaryFolder folder;
  const char* before = "v 0 0 0\nv 1 0 0\nv 0 0 1\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 3/3 2/2\n";
  const char* after = "v 0 0 0\nv 2 0 0\nv 0 0 1\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 3/3 2/2\n";
  const ClothId id = create(ClothFile{folder.write("flag.obj", before), 1});
  folder.write("flag.obj", after);
  ASSERT_EQ(world_.cloth_texture(id).size(), 3u);
  EXPECT_EQ(world_.cloth_texture(id)[1].v, 1);
}

TEST_P(ClothTextureTest, TearsAndSnapshotsKeepIt) {
  ClothDef def = sheet(1, 1, 9, 9, {0, 0, 0});
  def.fabric.tear_strain = 0.05f;
  def.stretch = {1.5f, 1, 1};
  const ClothId id = world_.create_cloth(def);
  const auto values = [&] {
    std::vector<std::pair<float, float>> values;
    for (const TexturePoint p : world_.cloth_texture(id)) values.emplace_back(p.u, p.v);
    return values;
  };
  const Snapshot start = world_.snapshot();
  const auto before = values();
  for (int k = 0; k < 5; ++k) world_.step(0.01f);
  EXPECT_GT(world_.cloth_positions(id).size(), 81u) << "it tore";
  EXPECT_EQ(values(), before);
  world_.restore(start);
  EXPECT_EQ(values(), before);
}

MENISCUS_ON_EACH_DEVICE(ClothTextureTest);

}  // namespace
}  // namespace meniscus::tests
