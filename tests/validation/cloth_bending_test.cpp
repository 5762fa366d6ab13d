// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Cloth bends as stiffly as asked at 4 substeps of 10 iterations, with D hₜ²/(ρ Δ⁴) = 5.
#include <utility>

#include "tests/validation/cloth_worlds.h"
#include "tests/validation/elastica.h"

namespace meniscus::tests {
namespace {

constexpr float density = 0.2f;  // kg/m²
constexpr float dt = frame / 4;  // s, of a substep
constexpr float stiffness_of(float side, float ratio = 5) {
  return ratio * density * side * side * side * side / (dt * dt);
}

float random(uint32_t& bits) {  // −1 to 1
  bits = bits * 1664525u + 1013904223u;
  return 2 * float(bits >> 8) / 16777216.0f - 1;
}

/// A strip along x of squares that stand on their corners, `half` their half diagonal. Diagonals turn from
/// row to row.
ClothTriangles bias_strip(float half, int columns, int rows) {
  ClothTriangles mesh;
  std::vector<int> number(static_cast<size_t>((columns + 1) * (rows + 1)), -1);
  const auto at = [&](int i, int j) { return static_cast<size_t>(j * (columns + 1) + i); };
  for (int j = 0; j <= rows; ++j) {
    for (int i = j % 2; i <= columns; i += 2) {
      number[at(i, j)] = static_cast<int>(mesh.vertices.size());
      mesh.vertices.push_back({float(i) * half, 0, float(j) * half});
    }
  }
  for (int j = 0; j <= rows; ++j) {
    for (int i = 1 - j % 2; i <= columns; i += 2) {  // the centre of a square
      std::vector<uint32_t> around;
      for (const auto& [x, z] : {std::pair{i - 1, j}, {i, j + 1}, {i + 1, j}, {i, j - 1}}) {
        if (x >= 0 && x <= columns && z >= 0 && z <= rows)
          around.push_back(static_cast<uint32_t>(number[at(x, z)]));
      }
      const bool turned = around.size() == 4 && (i + j - 1) / 2 % 2 == 0;
      if (turned) around = {around[1], around[2], around[3], around[0]};
      for (size_t k = 1; k + 1 < around.size(); ++k) {
        for (uint32_t v : {around[0], around[k], around[k + 1]}) mesh.triangles.push_back(v);
      }
    }
  }
  return mesh;
}

/// A strip along x of squares whose inner vertices are moved at random, halved at random. It starts with a
/// row that is not moved.
ClothTriangles irregular_strip(float side, int columns, int rows) {
  ClothTriangles mesh;
  uint32_t bits = 12345;
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i <= columns; ++i) {
      const bool moves_x = i > 1 && i < columns, moves_z = moves_x && j > 0 && j < rows;
      const float x = 0.3f * random(bits), z = 0.3f * random(bits);
      mesh.vertices.push_back(
          {side * (float(i) + (moves_x ? x : 0)), 0, side * (float(j) + (moves_z ? z : 0))});
    }
  }
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const auto a = static_cast<uint32_t>(j * (columns + 1) + i), b = a + 1;
      const uint32_t c = a + static_cast<uint32_t>(columns) + 1, d = c + 1;
      const auto two = random(bits) > 0 ? std::array{a, c, d, a, d, b} : std::array{a, c, b, b, c, d};
      mesh.triangles.insert(mesh.triangles.end(), two.begin(), two.end());
    }
  }
  return mesh;
}

std::vector<uint32_t> those(std::span<const Vec3> x, const auto& is) {
  std::vector<uint32_t> chosen;
  for (uint32_t v = 0; v < x.size(); ++v) {
    if (is(x[v])) chosen.push_back(v);
  }
  return chosen;
}

class ClothBending : public OnDevice {
 protected:
  World world_ = make_world({0, -9.81f, 0});

  World make_world(Vec3 gravity) const {
    WorldDef def = cloth_world(GetParam(), 4, 10);
    def.gravity = gravity;
    return World(def);
  }
  ClothId create(ClothDef def, float stiffness) {
    def.self_collision = def.tethers = false;
    def.fabric.density = density;
    def.fabric.bending_stiffness = stiffness;
    def.fabric.shear_stiffness = 20000;
    def.fabric.lift = 0;
    return world_.create_cloth(def);
  }
  /// Runs in air that takes the motion out.
  void run_to_rest(int frames = 300) {
    world_.set_wind({.air_density = 20});
    run(world_, frames, frame);
  }

  /// A level strip 1 m long beyond its clamp, which is in the middle between the first two rows of vertices.
  void expect_elastica(const ClothDef& def, float side, float stiffness) {
    const ClothId id = create(def, stiffness);
    const auto start = copy_of(world_.cloth_positions(id));
    float least = start[0].x, most = start[0].x;
    for (Vec3 x : start) {
      least = std::min(least, x.x);
      most = std::max(most, x.x);
    }
    world_.create_attachment(attach(id, those(start, [&](Vec3 x) { return x.x < least + 1.01f * side; })));
    run_to_rest();
    const Vec3 tip =
        mean_of(world_.cloth_positions(id), those(start, [&](Vec3 x) { return x.x > most - 1e-4f; }));
    const double asked = elastica_tip(double{density} * 9.81 / double{stiffness}, {0, 1});
    record("drop", -double{tip.y});
    record("error_percent", 100 * (-double{tip.y} / asked - 1));
    EXPECT_NEAR(-double{tip.y}, asked, 0.05 * asked);
    EXPECT_EQ(world_.cloth_bending_fraction(id), 1);
  }
};

constexpr float side = 1 / 20.5f;

TEST_P(ClothBending, OfAStripAlongTheWarpIsAsAsked) {
  expect_elastica(sheet(21 * side, 8 * side, 22, 9), side, stiffness_of(side));
}

TEST_P(ClothBending, OfAStripAt45DegreesIsAsAsked) {
  constexpr float half = 1 / 28.5f;
  ClothDef def;
  def.name = "bias";
  def.geometry = bias_strip(half, 29, 12);
  expect_elastica(def, half, stiffness_of(half * std::sqrt(2.0f)));
}

TEST_P(ClothBending, OfAnIrregularMeshIsAsAsked) {
  ClothDef def;
  def.name = "irregular";
  def.geometry = irregular_strip(side, 21, 8);
  expect_elastica(def, side, stiffness_of(side));
}

// A square plate whose four sides are supported sags by 0.004062 w a⁴/D in its middle (Timoshenko &
// Woinowsky-Krieger 1959, § 30). Gravity is low, so that its stretch does not carry it.
TEST_P(ClothBending, OfAPlateOnFourSupportsIsAsAsked) {
  constexpr float a = 1, gravity = 0.2f, plate_side = a / 20;
  const float stiffness = stiffness_of(plate_side);
  world_ = make_world({0, -gravity, 0});
  const ClothId id = create(sheet(a, a, 21, 21), stiffness);
  world_.create_attachment(attach(id, those(world_.cloth_positions(id), [&](Vec3 x) {
                                    return std::max(std::fabs(x.x), std::fabs(x.z)) > 0.49f * a;
                                  })));
  run_to_rest();
  const double asked =
      0.004062 * double{density} * double{gravity} * std::pow(double{a}, 4) / double{stiffness};
  const double sag = -double{world_.cloth_positions(id)[10 * 21 + 10].y};
  record("error_percent", 100 * (sag / asked - 1));
  EXPECT_NEAR(sag, asked, 0.05 * asked);
}

// An upright strip that is clamped below buckles under its own weight where w L³/D = 7.837 (Greenhill 1881).
// Gravity is a little out of true, so that it leans. Around that load it leans as one leans whose load is
// within 5 % of its own.
TEST_P(ClothBending, BucklesAtTheLoadThatIsAsked) {
  constexpr float askew = 0.01f;
  const float stiffness = stiffness_of(side);
  for (const double load : {0.9 * 7.837, 1.1 * 7.837}) {
    const auto gravity = static_cast<float>(load * double{stiffness} / double{density});
    world_ = make_world({askew * gravity, -gravity, 0});
    ClothDef def = sheet(21 * side, 8 * side, 22, 9);
    def.pose.rotation = about_z(90);
    const ClothId id = create(def, stiffness);
    world_.create_attachment(attach(id, column_of(def, 0) + column_of(def, 1)));
    run_to_rest(900);
    const double leans = double{mean_of(world_.cloth_positions(id), column_of(def, 21)).x};
    record("lean_at_" + std::to_string(int(10 * load)), leans);
    EXPECT_GT(leans, elastica_tip(0.95 * load, {-1, double{askew}})) << load;
    EXPECT_LT(leans, elastica_tip(1.05 * load, {-1, double{askew}})) << load;
  }
}

TEST_P(ClothBending, IsReportedWhereItIsNotHad) {
  const ClothId had = create(sheet(1, 1, 11, 11), stiffness_of(0.1f));
  const ClothId stiff = create(sheet(1, 1, 11, 11, {0, 1, 0}), stiffness_of(0.1f, 1000));
  EXPECT_EQ(world_.cloth_bending_fraction(stiff), 1);  // nothing has moved
  world_.step(frame);
  EXPECT_EQ(world_.cloth_bending_fraction(had), 1);
  EXPECT_LT(world_.cloth_bending_fraction(stiff), 0.5f);
  EXPECT_GT(world_.cloth_bending_fraction(stiff), 0.01f);
}

MENISCUS_ON_EACH_DEVICE(ClothBending);

}  // namespace
}  // namespace meniscus::tests
