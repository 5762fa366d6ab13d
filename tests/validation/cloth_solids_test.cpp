// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Solids that hit cloth, and cloth that hits solids, at 1 to 20 thicknesses a step: nothing gets through.
#include <filesystem>
#include <functional>

#include "collision/mesh/mesh.h"
#include "tests/validation/cloth_worlds.h"

namespace meniscus::tests {
namespace {

constexpr float thickness = 0.008f;
constexpr uint32_t side = 33;  // vertices
constexpr const char* bunny_file = "/usr/share/glmark2/models/bunny.obj";
constexpr float bunny_scale = 0.3f;

/// A solid, and how deep a point of its frame is in it; m.
struct Intruder {
  Geometry geometry;
  Quat rotation{0, 0, 0, 1};
  float top;  ///< above its origin, m
  std::function<double(Vec3)> depth;
};

Intruder ball() {
  return {SphereGeometry{0.2f}, {0, 0, 0, 1}, 0.2f, [](Vec3 q) { return 0.2 - double{length(q)}; }};
}

/// On its corner.
Intruder cube() {
  const Vec3 up = normalized_or(Vec3{1, 1, 1}, {0, 1, 0}), axis = cross(up, Vec3{0, 1, 0});
  const auto depth = [](Vec3 q) { return 0.15 - double{max_component(abs(q))}; };
  return {BoxGeometry{{0.15f, 0.15f, 0.15f}}, normalized(Quat{axis.x, axis.y, axis.z, 1 + up.y}),
          0.15f * std::sqrt(3.0f), depth};
}

/// How often the mesh winds around a point: 1 inside.
double winding(const collision::TriangleMesh& mesh, Vec3 point) {
  double angle = 0;
  for (const auto& t : mesh.triangles) {
    const Vec3 a = mesh.vertices[t[0]] - point, b = mesh.vertices[t[1]] - point,
               c = mesh.vertices[t[2]] - point;
    const double la = length(a), lb = length(b), lc = length(c);
    angle += 2 * std::atan2(double{dot(a, cross(b, c))},
                            la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
  }
  return angle / (4 * 3.14159265358979);
}

class ClothSolids : public OnDevice {
 protected:
  enum class Mover { solid, cloth };
  struct Found {
    int inside = 0;           ///< vertices, summed over the steps looked at
    bool passed_by = false;   ///< cloth is below the solid's origin on its axis, and not by its corners
    bool still_above = true;  ///< and above it, unless the sheet has slid off
  };

  /// `every`: how often it looks.
  Found meet(const Intruder& solid, Mover mover, float per_step, int every = 1) {
    WorldDef settings = cloth_world(GetParam(), 8, 2);
    if (mover == Mover::solid) settings.gravity = {0, 0, 0};
    World world(settings);
    const float speed = per_step * thickness / frame, way = 0.5f;
    ClothDef def = sheet(1, 1, side, side);
    def.fabric.thickness = thickness;
    if (mover == Mover::cloth) def.velocity = {0, -speed, 0};
    const ClothId id = world.create_cloth(def);
    Pose pose{{0, -solid.top - 0.03f, 0}, solid.rotation};
    BodyDef moving;
    moving.motion = BodyMotion::kinematic;
    moving.geometry = solid.geometry;
    moving.pose = pose;
    BodyId body{};
    if (mover == Mover::solid) {
      body = world.create_body(moving);
      world.move_body(body, {pose.position + Vec3{0, way, 0}, pose.rotation}, way / speed);
    } else {
      ShapeDef fixed = shape(solid.geometry);
      fixed.pose = pose;
      world.create_shape(fixed);
    }
    Found found;
    const int steps = mover == Mover::solid ? static_cast<int>(way / (per_step * thickness)) + 10 : 30;
    for (int k = 1; k <= steps; ++k) {
      world.step(frame);
      if (k % every && k != steps) continue;
      if (mover == Mover::solid) pose = world.body_state(body).pose;
      for (Vec3 x : world.cloth_positions(id)) found.inside += solid.depth(to_local(pose, x)) > 1e-5;
      look_along_axis(world, id, at_rest(def), pose.position, found);
    }
    return found;
  }

  /// The sheet's corners may close below a solid that it has wrapped.
  static void look_along_axis(const World& world, ClothId id, const std::vector<Vec3>& rest, Vec3 origin,
                              Found& found) {
    const auto x = world.cloth_positions(id);
    const auto t = world.cloth_triangles(id);
    const Vec3 o = origin + Vec3{1e-4f, 0, 2e-4f};  // on no edge
    bool above = false;
    for (size_t k = 0; k < t.size(); k += 3) {
      const Vec3 a = x[t[k]] - o, b = x[t[k + 1]] - o, c = x[t[k + 2]] - o;
      const auto turn = [](Vec3 p, Vec3 q) { return p.x * q.z - p.z * q.x; };
      const float ab = turn(a, b), bc = turn(b, c), ca = turn(c, a);
      if (!((ab > 0 && bc > 0 && ca > 0) || (ab < 0 && bc < 0 && ca < 0))) continue;
      const bool over = (bc * a.y + ca * b.y + ab * c.y) / (ab + bc + ca) > 0;
      above |= over;
      found.passed_by |= !over && length(rest[t[k]]) < 0.5f;
    }
    found.still_above &= above || !surrounds(x, o);
  }

  /// Whether the sheet's border goes around an upright axis: a sheet that was hit flies off, and may leave
  /// it.
  static bool surrounds(std::span<const Vec3> x, Vec3 axis) {
    double angle = 0;
    const auto turn = [&](uint32_t from, uint32_t to) {
      const Vec3 p = x[from] - axis, q = x[to] - axis;
      angle += std::atan2(double{p.x * q.z - p.z * q.x}, double{p.x * q.x + p.z * q.z});
    };
    constexpr uint32_t last = side - 1;
    for (uint32_t k = 0; k < last; ++k) {
      turn(k, k + 1);
      turn(side * k + last, side * (k + 1) + last);
      turn(side * last + last - k, side * last + last - k - 1);
      turn(side * (last - k), side * (last - k - 1));
    }
    return std::abs(angle) > 3;
  }

  void expect_kept_out(const Intruder& solid, Mover mover, std::initializer_list<float> speeds, int every) {
    for (float per_step : speeds) {
      const Found found = meet(solid, mover, per_step, every);
      EXPECT_EQ(found.inside, 0) << per_step << " thicknesses a step";
      // Cloth that flies on may close below a solid that it has wrapped.
      if (mover == Mover::solid) {
        EXPECT_FALSE(found.passed_by) << per_step << " thicknesses a step";
      }
      EXPECT_TRUE(found.still_above) << per_step << " thicknesses a step";
    }
  }
};

TEST_P(ClothSolids, ABallThatMoves) {
  expect_kept_out(ball(), Mover::solid, {1, 5, 20}, 1);
}
// Cloth that folds up around it: what is joined by the last resort of self-contacts must stay out as well.
TEST_P(ClothSolids, ABallThatIsHit) {
  expect_kept_out(ball(), Mover::cloth, {1, 5, 14.5f, 18.75f, 19.5f, 20, 24, 25}, 1);
}
TEST_P(ClothSolids, ACornerThatMoves) {
  expect_kept_out(cube(), Mover::solid, {1, 5, 20}, 1);
}
TEST_P(ClothSolids, ACornerThatIsHit) {
  expect_kept_out(cube(), Mover::cloth, {1, 5, 20}, 1);
}

TEST_P(ClothSolids, TheBunny) {
  if (!std::filesystem::exists(bunny_file))
    GTEST_SKIP() << "the bunny of the package glmark2-data is not here";
  const collision::TriangleMesh mesh = collision::load_mesh(bunny_file, bunny_scale);
  float top = 0;
  for (Vec3 v : mesh.vertices) top = std::max(top, v.y);
  const auto depth = [&](Vec3 q) {
    const bool beside = max_component(abs(q)) > bunny_scale;
    return beside || winding(mesh, q) < 0.5 ? -1.0 : 1.0;
  };
  const Intruder bunny{MeshGeometry{bunny_file, bunny_scale, 0.008f}, {0, 0, 0, 1}, top, depth};
  expect_kept_out(bunny, Mover::solid, {5, 20}, 1000);
  expect_kept_out(bunny, Mover::cloth, {5, 20}, 1000);
}

MENISCUS_ON_EACH_DEVICE(ClothSolids);

}  // namespace
}  // namespace meniscus::tests
