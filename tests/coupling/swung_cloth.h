// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Containers of cloth with water in them, swung round a circle; counts how much water gets through the cloth.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <ostream>
#include <string>
#include <tuple>

#include "tests/cloth_worlds.h"
#include "tests/coupling/vessel.h"
#include "tests/sheet_crossings.h"

namespace meniscus::tests {

enum class ClothVessel {
  sling,  ///< half a cylinder of cloth that hangs by its long borders
  bag,    ///< a closed ball of cloth, of which a hand holds the upper half
  bowl,   ///< five thin slabs under a lid of cloth
};

inline void PrintTo(ClothVessel vessel, std::ostream* out) {
  *out << std::array{"sling", "bag", "bowl"}[static_cast<size_t>(vessel)];
}

/// A device and a vessel, as the parameter of a test.
using SwungVesselCase = std::tuple<pbd::DeviceKind, ClothVessel>;

inline auto swung_vessels() {
  return testing::Combine(testing::ValuesIn(usable_devices()),
                          testing::Values(ClothVessel::sling, ClothVessel::bag, ClothVessel::bowl));
}

inline std::string swung_vessel_name(const testing::TestParamInfo<SwungVesselCase>& test) {
  return testing::PrintToString(std::get<1>(test.param)) + "_" +
         testing::PrintToString(std::get<0>(test.param));
}

/// A metre from the hub, it gathers speed until it moves at 5 m/s, and then slows down and turns back, to and
/// fro; a sling, which would lose all of its water, goes on round.
class SwungVessel {
 public:
  SwungVessel(pbd::DeviceKind device, ClothVessel kind) : kind_(kind), world_(swung(device)) {
    const Vec3 middle{0, -radius, 0};
    BodyDef hand = kinematic(SphereGeometry{0.05f}, {0, 0, 0});
    if (kind == ClothVessel::bowl) hand.geometry = moved(bowl.geometry(), middle);
    hand.filter.groups = 2;
    body_ = world_.create_body(hand);
    cloth_ = world_.create_cloth(cloth(middle));
    for (const Aabb& hem : hems()) {
      AttachmentDef hold = attach(cloth_, {});
      hold.region = Aabb{middle + hem.lower, middle + hem.upper};
      hold.body = body_;
      world_.create_attachment(hold);
    }
    world_.add_fluid(water(middle));
    crossings_.emplace(world_.cloth_positions(cloth_), world_.cloth_triangles(cloth_));
  }

  void swing(double seconds) {
    for (const double end = world_.time() + seconds; world_.time() < end;) {
      const double speed = speed_at(world_.time());
      fastest_ = std::max(fastest_, speed);
      angle_ += double{dt} * speed / double{radius};
      world_.move_body(body_, {{0, 0, 0}, turned({0, 0, 1}, angle_)}, dt);
      world_.step(dt);
      crossed_ += crossings_->advance(world_.cloth_positions(cloth_), world_.positions());
    }
  }

  const World& world() const { return world_; }
  size_t crossed() const { return crossed_; }
  double fastest() const { return fastest_; }

  /// The number of particles further from the container's centre than its extent.
  size_t lost() const {
    const Pose pose = world_.body_state(body_).pose;
    const Sum3 middle = rotated(pose.rotation, {0, double{-radius}, 0});
    size_t lost = 0;
    for (Vec3 p : world_.positions()) lost += norm(Sum3(p) - middle) > 0.35;
    return lost;
  }

 private:
  static constexpr float s = 0.04f, dt = 1 / 480.0f, radius = 1;  // m, s, m
  static constexpr Vessel bowl{{0.16f, 0.12f, 0.16f}, s, false};

  static WorldDef swung(pbd::DeviceKind device) {
    WorldDef def = one_substep(device, s);
    def.substeps = 2;
    def.iterations = 4;
    return def;
  }

  static CompoundGeometry moved(CompoundGeometry compound, Vec3 way) {
    for (CompoundPart& part : compound.parts) part.pose.position += way;
    return compound;
  }

  ClothDef cloth(Vec3 middle) const {
    ClothDef def = sheet(0.36f, 0.36f, 19, 19, middle);
    if (kind_ == ClothVessel::sling) def.geometry = trough();
    if (kind_ == ClothVessel::bag) def.geometry = ClothSphere{0.2f, 8};
    if (kind_ == ClothVessel::bowl) def.pose.position.y += bowl.inner.y;
    def.fabric.density = 0.4f;
    def.filter.mask = ~2u;  // it lies on what holds it
    def.self_collision = false;
    return def;
  }

  static ClothTriangles trough() {
    ClothTriangles half;
    constexpr uint32_t columns = 29, rows = 21;
    for (uint32_t row = 0; row < rows; ++row) {
      for (uint32_t column = 0; column < columns; ++column) {
        const double angle = M_PI * column / (columns - 1);
        half.vertices.push_back({static_cast<float>(-0.18 * std::cos(angle)),
                                 static_cast<float>(-0.18 * std::sin(angle)),
                                 0.02f * static_cast<float>(row) - 0.2f});
        if (row + 1 == rows || column + 1 == columns) continue;
        const uint32_t a = row * columns + column, b = a + columns;
        half.triangles.insert(half.triangles.end(), {a, b, a + 1, a + 1, b, b + 1});
      }
    }
    return half;
  }

  /// Relative to the container's centre.
  std::vector<Aabb> hems() const {
    if (kind_ == ClothVessel::sling) return {{{-1, -0.01f, -1}, {1, 1, 1}}};
    if (kind_ == ClothVessel::bag) return {{{-1, 0.02f, -1}, {1, 1, 1}}};
    const float wall = 0.155f;
    return {{{-1, -1, -1}, {-wall, 1, 1}},
            {{wall, -1, -1}, {1, 1, 1}},
            {{-wall, -1, -1}, {wall, 1, -wall}},
            {{-wall, -1, wall}, {wall, 1, 1}}};
  }

  FluidVolumeDef water(Vec3 middle) {
    FluidVolumeDef def =
        block(world_.create_fluid({}), -1.0f * bowl.inner, {bowl.inner.x, 0.5f * bowl.inner.y, bowl.inner.z});
    if (kind_ == ClothVessel::sling) def.region = BoxRegion{{-0.1f, -0.14f, -0.14f}, {0.1f, -0.02f, 0.14f}};
    if (kind_ == ClothVessel::bag) def.region = BallRegion{0.17f};
    def.pose.position = middle;
    return def;
  }

  /// m/s
  double speed_at(double t) const {
    if (kind_ == ClothVessel::sling) return std::min(5.0, 8 * t);
    return 5 * std::sin(M_PI * t / 1.6);
  }

  ClothVessel kind_;
  World world_;
  BodyId body_{};
  ClothId cloth_{};
  std::optional<SheetCrossings> crossings_;
  size_t crossed_ = 0;
  double angle_ = 0, fastest_ = 0;
};

}  // namespace meniscus::tests
