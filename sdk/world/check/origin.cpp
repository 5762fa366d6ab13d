// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Arguments and results at the origin about which a world computes.
#include "sdk/world/check/origin.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "pbd/math/vec.h"

namespace meniscus {

namespace {

using Exact = std::array<double, 3>;

Exact exact(Vec3 v) {
  return {v.x, v.y, v.z};
}

double dot(const Exact& a, const Exact& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Exact cross(const Exact& a, const Exact& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// What a pose adds to points of its frame, along the axes of that frame: Rᵀ (position − origin).
Exact shift_of(const Pose& pose, Vec3 origin) {
  const Quat q = pose.rotation;
  const double n = std::sqrt(double{q.x} * q.x + double{q.y} * q.y + double{q.z} * q.z + double{q.w} * q.w);
  const Exact u{-q.x / n, -q.y / n, -q.z / n};
  const Exact p = exact(pose.position), o = exact(origin);
  const Exact v{p[0] - o[0], p[1] - o[1], p[2] - o[2]}, once = cross(u, v), twice = cross(u, once);
  Exact sum;
  for (std::size_t k = 0; k < 3; ++k) sum[k] = v[k] + 2 * (q.w / n * once[k] + twice[k]);
  return sum;
}

Vec3 shifted(Vec3 p, const Exact& by) {
  return {static_cast<float>(p.x + by[0]), static_cast<float>(p.y + by[1]), static_cast<float>(p.z + by[2])};
}

/// Whether a point of a frame is nearer to the origin of the world than to that of the frame. Then it is the
/// point that the user has put far away, not the frame.
bool is_far_in_frame(Vec3 p, const Exact& shift) {
  const Vec3 there = shifted(p, shift);
  return dot(exact(there), exact(there)) < dot(exact(p), exact(p));
}

/// Places a region in the frame of the world, one overload a kind.
struct PlaceRegion {
  Pose& pose;
  const Origin& origin;
  Exact shift = shift_of(pose, origin.at());

  void operator()(BoxRegion& box) const {
    if (!is_far_in_frame(box.lower, shift)) {
      pose = origin.inward(pose);
      return;
    }
    box = {shifted(box.lower, shift), shifted(box.upper, shift)};
    pose.position = {0, 0, 0};
  }
  void operator()(HalfSpaceRegion& half) const {
    half.offset = static_cast<float>(half.offset + dot(exact(half.normal), shift));
    pose.position = {0, 0, 0};
  }
  void operator()(BallRegion&) const { pose = origin.inward(pose); }
  void operator()(MeshRegion&) const { pose = origin.inward(pose); }
};

std::optional<PeriodicExtent> moved(std::optional<PeriodicExtent> extent, float origin) {
  if (extent) *extent = {extent->low - origin, extent->high - origin};
  return extent;
}

}  // namespace

float Origin::input_step() const {
  if (is_zero()) return 0;
  const float most = std::max({std::fabs(at_.x), std::fabs(at_.y), std::fabs(at_.z)});
  return std::nextafter(most, std::numeric_limits<float>::infinity()) - most;
}

Vec3 Origin::inward(Vec3 p) const {
  return p - at_;
}

Pose Origin::inward(const Pose& pose) const {
  return {inward(pose.position), pose.rotation};
}

Aabb Origin::inward(const Aabb& box) const {
  return {inward(box.lower), inward(box.upper)};
}

PeriodicDef Origin::inward(PeriodicDef def) const {
  return {moved(def.x, at_.x), moved(def.y, at_.y), moved(def.z, at_.z)};
}

WorldDef Origin::inward(WorldDef def) const {
  def.periodic = inward(def.periodic);
  return def;
}

ShapeDef Origin::inward(ShapeDef def) const {
  if (auto* plane = std::get_if<PlaneGeometry>(&def.geometry)) {
    plane->offset = static_cast<float>(plane->offset + dot(exact(plane->normal), shift_of(def.pose, at_)));
    def.pose.position = {0, 0, 0};
    return def;
  }
  def.pose = inward(def.pose);
  return def;
}

EmitterDef Origin::inward(EmitterDef def) const {
  if (!def.body) def.pose = inward(def.pose);
  return def;
}

SinkDef Origin::inward(SinkDef def) const {
  if (!def.body) std::visit(PlaceRegion{def.pose, *this}, def.region);
  return def;
}

ForceFieldDef Origin::inward(ForceFieldDef def) const {
  def.pose = inward(def.pose);
  return def;
}

ProbeDef Origin::inward(ProbeDef def) const {
  def.point = inward(def.point);
  if (def.patch) def.patch = inward(*def.patch);
  return def;
}

BodyDef Origin::inward(BodyDef def) const {
  def.pose = inward(def.pose);
  for (Keyframe& k : def.keyframes) k.pose = inward(k.pose);
  return def;
}

JointDef Origin::inward(JointDef def) const {
  def.frame = inward(def.frame);
  return def;
}

ClothDef Origin::inward(ClothDef def) const {
  def.pose = inward(def.pose);
  return def;
}

RopeDef Origin::inward(RopeDef def) const {
  const Exact shift = shift_of(def.pose, at_);
  if (!def.points.empty() && is_far_in_frame(def.points.front(), shift)) {
    for (Vec3& p : def.points) p = shifted(p, shift);
    def.pose.position = {0, 0, 0};
  } else {
    def.pose = inward(def.pose);
  }
  return def;
}

AttachmentDef Origin::inward(AttachmentDef def) const {
  if (def.region) def.region = inward(*def.region);
  return def;
}

FluidVolumeDef Origin::inward(FluidVolumeDef def) const {
  std::visit(PlaceRegion{def.pose, *this}, def.region);
  return def;
}

std::vector<Vec3> Origin::inward(std::span<const Vec3> points) const {
  std::vector<Vec3> moved(points.begin(), points.end());
  for (Vec3& p : moved) p = inward(p);
  return moved;
}

// ---- results ----

Vec3 Origin::outward(Vec3 p) const {
  return is_zero() ? p : p + at_;
}

BodyState Origin::outward(BodyState state) const {
  state.pose.position = outward(state.pose.position);
  state.centre_of_mass = outward(state.centre_of_mass);
  return state;
}

ClothState Origin::outward(ClothState state) const {
  state.centre = outward(state.centre);
  return state;
}

SurfaceMesh Origin::outward(SurfaceMesh mesh) const {
  for (Vec3& p : mesh.vertices) p = outward(p);
  return mesh;
}

std::vector<ParticleContact> Origin::outward(std::vector<ParticleContact> contacts) const {
  for (ParticleContact& c : contacts) c.point = outward(c.point);
  return contacts;
}

std::vector<SolidContact> Origin::outward(std::vector<SolidContact> contacts) const {
  for (SolidContact& c : contacts) c.point = outward(c.point);
  return contacts;
}

std::optional<NearestPoint> Origin::outward(std::optional<NearestPoint> place) const {
  if (place) place->point = outward(place->point);
  return place;
}

std::optional<RayHit> Origin::outward(std::optional<RayHit> hit) const {
  if (hit) hit->point = outward(hit->point);
  return hit;
}

}  // namespace meniscus
