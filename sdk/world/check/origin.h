// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The origin about which a world computes. Arguments pass inward and results outward at World's boundary.
#pragma once

#include <meniscus/world.h>

#include <optional>

namespace meniscus {

class Origin {
 public:
  explicit Origin(Vec3 at) : at_(at) {}

  Vec3 at() const { return at_; }
  bool is_zero() const { return at_.x == 0 && at_.y == 0 && at_.z == 0; }
  /// m: the step of floats at the origin, to which arguments are rounded. It is 0 at zero.
  float input_step() const;

  // From the user's frame to that in which the world computes.
  Vec3 inward(Vec3 p) const;
  Pose inward(const Pose& pose) const;
  Aabb inward(const Aabb& box) const;
  PeriodicDef inward(PeriodicDef def) const;
  WorldDef inward(WorldDef def) const;
  ShapeDef inward(ShapeDef def) const;
  EmitterDef inward(EmitterDef def) const;
  SinkDef inward(SinkDef def) const;
  ProbeDef inward(ProbeDef def) const;
  ForceFieldDef inward(ForceFieldDef def) const;
  BodyDef inward(BodyDef def) const;
  JointDef inward(JointDef def) const;
  ClothDef inward(ClothDef def) const;
  RopeDef inward(RopeDef def) const;
  AttachmentDef inward(AttachmentDef def) const;
  FluidVolumeDef inward(FluidVolumeDef def) const;
  std::vector<Vec3> inward(std::span<const Vec3> points) const;

  // Back to the user's frame.
  Vec3 outward(Vec3 p) const;
  BodyState outward(BodyState state) const;
  ClothState outward(ClothState state) const;
  SurfaceMesh outward(SurfaceMesh mesh) const;
  std::vector<ParticleContact> outward(std::vector<ParticleContact> contacts) const;
  std::vector<SolidContact> outward(std::vector<SolidContact> contacts) const;
  std::optional<RayHit> outward(std::optional<RayHit> hit) const;
  std::optional<NearestPoint> outward(std::optional<NearestPoint> place) const;

 private:
  Vec3 at_;
};

/// A definition in the frame of the world: the definition itself where the origin is zero.
template <class Def>
class Inward {
 public:
  Inward(const Origin& origin, const Def& def) : given_(def) {
    if (!origin.is_zero()) moved_ = origin.inward(def);
  }
  operator const Def&() const { return moved_ ? *moved_ : given_; }

 private:
  const Def& given_;
  std::optional<Def> moved_;
};

/// The same for points.
class InwardPoints {
 public:
  InwardPoints(const Origin& origin, std::span<const Vec3> points) : points_(points) {
    if (!origin.is_zero()) points_ = moved_ = origin.inward(points);
  }
  InwardPoints(const InwardPoints&) = delete;
  InwardPoints& operator=(const InwardPoints&) = delete;
  operator std::span<const Vec3>() const { return points_; }

 private:
  std::vector<Vec3> moved_;
  std::span<const Vec3> points_;
};

/// Points in the user's frame, kept in `kept`: the points themselves where the origin is zero.
inline std::span<const Vec3> outward(const Origin& origin, std::span<const Vec3> points,
                                     std::vector<Vec3>& kept) {
  if (origin.is_zero()) return points;
  kept.clear();
  for (const Vec3& p : points) kept.push_back(origin.outward(p));
  return kept;
}

}  // namespace meniscus
