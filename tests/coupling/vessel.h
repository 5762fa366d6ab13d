// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Moving containers with thin walls; counts how often their contents pass through a wall.
#pragma once

#include <array>
#include <optional>

#include "tests/coupling/body_worlds.h"

namespace meniscus::tests {

/// A box-shaped container, in its own frame.
struct Vessel {
  Vec3 inner;        ///< m, half extents of the inside
  float wall;        ///< m, its walls' thickness
  bool lid = false;  ///< else it is open at the top

  /// Six slabs, or five, that overlap at the edges.
  CompoundGeometry geometry() const {
    const float t = 0.5f * wall;
    const Vec3 outer = inner + Vec3{wall, wall, wall}, middle = inner + Vec3{t, t, t};
    CompoundGeometry slabs;
    for (float side : {-1.0f, 1.0f}) {
      slabs.parts.push_back(part(BoxGeometry{{t, outer.y, outer.z}}, {side * middle.x, 0, 0}));
      slabs.parts.push_back(part(BoxGeometry{{outer.x, outer.y, t}}, {0, 0, side * middle.z}));
      if (side < 0 || lid)
        slabs.parts.push_back(part(BoxGeometry{{outer.x, t, outer.z}}, {0, side * middle.y, 0}));
    }
    return slabs;
  }
};

/// Follows each particle in the container's frame. In that frame the walls do not move and the inside is
/// convex. So a particle has crossed a wall if its displacement between two calls passes through an inner
/// face.
class Crossings {
 public:
  Crossings(const World& world, BodyId body, const Vessel& vessel) : body_(body), vessel_(vessel) {
    last_ = local_positions(world);
  }

  /// After each substep. The number of particles must not change.
  void look(const World& world) {
    const std::vector<Sum3> now = local_positions(world);
    for (size_t i = 0; i < now.size(); ++i) count_ += crosses(last_[i], now[i]);
    last_ = now;
  }

  int count() const { return count_; }
  /// The number of particles that are neither in the container nor above it.
  int lost() const {
    int lost = 0;
    for (const Sum3& p : last_) {
      lost += std::fabs(p.x) > double{vessel_.inner.x} || std::fabs(p.z) > double{vessel_.inner.z} ||
              p.y < double{-vessel_.inner.y} || (vessel_.lid && p.y > double{vessel_.inner.y});
    }
    return lost;
  }

 private:
  std::vector<Sum3> local_positions(const World& world) const {
    const Pose pose = world.body_state(body_).pose;
    std::vector<Sum3> local;
    local.reserve(world.particle_count());
    for (Vec3 p : world.positions()) local.push_back(rotated_back(pose.rotation, Sum3(p) - pose.position));
    return local;
  }

  bool crosses(const Sum3& a, const Sum3& b) const {
    const std::array<double, 3> from{a.x, a.y, a.z}, to{b.x, b.y, b.z},
        half{double{vessel_.inner.x}, double{vessel_.inner.y}, double{vessel_.inner.z}};
    for (size_t axis = 0; axis < 3; ++axis) {
      for (double side : {-1.0, 1.0}) {
        if (axis == 1 && side > 0 && !vessel_.lid) continue;
        const double before = side * from[axis] - half[axis], after = side * to[axis] - half[axis];
        if ((before <= 0) == (after <= 0)) continue;
        if (meets_face(from, to, before / (before - after), axis, half)) return true;
      }
    }
    return false;
  }

  /// Whether a displacement meets the face within its edges, at the fraction t of it.
  static bool meets_face(const std::array<double, 3>& from, const std::array<double, 3>& to, double t,
                         size_t axis, const std::array<double, 3>& half) {
    for (size_t other = 0; other < 3; ++other) {
      if (other == axis) continue;
      // What leaves by an edge leaves by either face.
      if (std::fabs(from[other] + t * (to[other] - from[other])) > half[other] + 1e-6) return false;
    }
    return true;
  }

  BodyId body_;
  Vessel vessel_;
  std::vector<Sum3> last_;
  int count_ = 0;
};

/// So that each substep can be looked at. On a device, or a device with a solver.
template <class Case>
WorldDef one_substep(const Case& which, float spacing) {
  WorldDef def = world_def(which, spacing);
  def.substeps = 1;
  return def;
}

inline Quat turned(Vec3 unit_axis, double angle) {
  const float sine = static_cast<float>(std::sin(0.5 * angle));
  return {sine * unit_axis.x, sine * unit_axis.y, sine * unit_axis.z,
          static_cast<float>(std::cos(0.5 * angle))};
}

/// A closed container, half full, shaken in three directions and spun, alternately fast and slowly. Its
/// outermost point moves by up to 20 particle radii in a substep of 4 ms.
class ShakenVessel {
 public:
  template <class Case>
  explicit ShakenVessel(const Case& which) : world_(one_substep(which, s)) {
    body_ = world_.create_body(kinematic(vessel_.geometry(), {0, 0, 0}));
    world_.add_fluid(
        block(world_.create_fluid({}), -1.0f * vessel_.inner, {vessel_.inner.x, 0, vessel_.inner.z}));
    crossings_.emplace(world_, body_, vessel_);
  }

  void shake(double seconds) {
    for (const double end = world_.time() + seconds; world_.time() < end;) {
      const Pose from = world_.body_state(body_).pose;
      advance_phase();
      world_.move_body(body_, pose(), dt);
      world_.step(dt);
      crossings_->look(world_);
      note_motion(from, world_.body_state(body_).pose);
    }
  }

  const World& world() const { return world_; }
  const Crossings& crossings() const { return *crossings_; }
  double furthest_in_radii() const { return furthest_ / (0.5 * double{s}); }

 private:
  static constexpr float s = 0.05f, dt = 0.004f;

  /// Every two seconds, from soft to wild and back.
  void advance_phase() {
    const double wild = 0.5 - 0.5 * std::cos(M_PI * world_.time());
    phase_ += double{dt} * (2 + 250 * wild);
    turn_ += double{dt} * (1 + 25 * wild);
  }

  Pose pose() const {
    const double amplitude = 0.3;
    const auto at = [&](double k, double start) {
      return static_cast<float>(amplitude * (std::sin(k * phase_ + start) - std::sin(start)));
    };
    return {{at(1, 0), at(1.27, 0.5), at(0.81, 1)}, turned({0.48f, 0.6f, 0.64f}, turn_)};
  }

  void note_motion(const Pose& from, const Pose& to) {
    for (float x : {-1.0f, 1.0f}) {
      for (float y : {-1.0f, 1.0f}) {
        for (float z : {-1.0f, 1.0f}) {
          const Sum3 corner{vessel_.inner.x * x, vessel_.inner.y * y, vessel_.inner.z * z};
          const Sum3 way = Sum3(to.position) + rotated(to.rotation, corner) -
                           (Sum3(from.position) + rotated(from.rotation, corner));
          furthest_ = std::max(furthest_, norm(way));
        }
      }
    }
  }

  Vessel vessel_{{0.25f, 0.25f, 0.25f}, 0.5f * s, true};
  World world_;
  BodyId body_{};
  std::optional<Crossings> crossings_;
  double phase_ = 0, turn_ = 0, furthest_ = 0;
};

/// An open cup two thirds full, carried round a circle a metre across at about 1 m/s², and tilted to and fro
/// by 3°. The water's surface leans by less than 10°; it would reach the rim at 45°.
class CarriedCup {
 public:
  template <class Case>
  explicit CarriedCup(const Case& which) : world_(one_substep(which, s)) {
    body_ = world_.create_body(kinematic(cup_.geometry(), {0, 0, 0}));
    world_.add_fluid(
        block(world_.create_fluid({}), -1.0f * cup_.inner, {cup_.inner.x, cup_.inner.y / 3, cup_.inner.z}));
    crossings_.emplace(world_, body_, cup_);
  }

  void carry(double seconds) {
    for (const double end = world_.time() + seconds; world_.time() < end;) {
      world_.move_body(body_, pose(world_.time() + double{dt}), dt);
      world_.step(dt);
      crossings_->look(world_);
    }
  }

  const World& world() const { return world_; }
  const Crossings& crossings() const { return *crossings_; }

 private:
  static constexpr float s = 0.05f, dt = 0.004f;

  /// Round a circle of half a metre at 1.4 rad/s, once it has gathered speed in two seconds.
  static Pose pose(double t) {
    const double rate = 1.4, start = std::min(t, 2.0);
    const double angle = rate * (0.5 * start * start / 2 + std::max(0.0, t - 2));
    const double tilt = 3 * M_PI / 180 * std::sin(0.8 * t);
    const Vec3 at{static_cast<float>(0.5 * std::cos(angle) - 0.5),
                  static_cast<float>(0.05 * std::sin(0.7 * t)), static_cast<float>(0.5 * std::sin(angle))};
    return {at, turned({0.6f, 0, 0.8f}, tilt)};
  }

  Vessel cup_{{0.2f, 0.3f, 0.2f}, 0.5f * s, false};
  World world_;
  BodyId body_{};
  std::optional<Crossings> crossings_;
};

}  // namespace meniscus::tests
