// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Bodies for tests, and what a world with bodies holds in all, summed in double precision.
#pragma once

#include <cmath>

#include "tests/worlds.h"

namespace meniscus::tests {

inline BodyDef body(const Geometry& geometry, Vec3 position, float density) {
  BodyDef def;
  def.geometry = geometry;
  def.pose.position = position;
  def.density = density;
  return def;
}

inline BodyDef kinematic(const Geometry& geometry, Vec3 position) {
  BodyDef def = body(geometry, position, 1000);
  def.motion = BodyMotion::kinematic;
  return def;
}

inline CompoundPart part(const Geometry& geometry, Vec3 position) {
  return {geometry, {position, {0, 0, 0, 1}}};
}

/// A vector whose sums over many particles keep their digits.
struct Sum3 {
  double x = 0, y = 0, z = 0;

  Sum3() = default;
  Sum3(double a, double b, double c) : x(a), y(b), z(c) {}
  Sum3(Vec3 v) : x(double{v.x}), y(double{v.y}), z(double{v.z}) {}
  Sum3& operator+=(const Sum3& o) {
    x += o.x;
    y += o.y;
    z += o.z;
    return *this;
  }
};

inline Sum3 operator+(Sum3 a, const Sum3& b) {
  return a += b;
}
inline Sum3 operator*(double k, const Sum3& a) {
  return {k * a.x, k * a.y, k * a.z};
}
inline Sum3 operator-(const Sum3& a, const Sum3& b) {
  return a + -1.0 * b;
}
inline Sum3 cross(const Sum3& a, const Sum3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double norm(const Sum3& a) {
  return std::hypot(a.x, a.y, a.z);
}
inline Sum3 rotated(const Quat& q, const Sum3& v) {
  const Sum3 axis{q.x, q.y, q.z}, twice = 2.0 * cross(axis, v);
  return v + double{q.w} * twice + cross(axis, twice);
}
inline Sum3 rotated_back(const Quat& q, const Sum3& v) {
  return rotated({-q.x, -q.y, -q.z, q.w}, v);
}

/// About the centre of mass, kg·m²/s.
inline Sum3 spin(const World& world, BodyId id) {
  const BodyMass mass = world.body_mass(id);
  const BodyState state = world.body_state(id);
  const auto to_axes = [&](const Sum3& v) {
    return rotated_back(mass.principal_axes, rotated_back(state.pose.rotation, v));
  };
  const Sum3 w = to_axes(state.angular_velocity), i = mass.inertia;
  return rotated(state.pose.rotation, rotated(mass.principal_axes, {i.x * w.x, i.y * w.y, i.z * w.z}));
}

struct Momentum {
  Sum3 linear, angular;  ///< kg·m/s; kg·m²/s about the origin
  double gross = 0;      ///< Σ m · speed
};

inline void add(Momentum& sum, double mass, const Sum3& position, const Sum3& velocity) {
  sum.linear += mass * velocity;
  sum.angular += mass * cross(position, velocity);
  sum.gross += mass * norm(velocity);
}

inline Momentum fluid_momentum(const World& world, FluidId fluid) {
  Momentum sum;
  const double mass = double{world.particle_mass(fluid)};
  const auto x = world.positions(), v = world.velocities();
  for (size_t i = 0; i < x.size(); ++i) add(sum, mass, x[i], v[i]);
  return sum;
}

inline Momentum body_momentum(const World& world, BodyId id) {
  Momentum sum;
  const BodyState state = world.body_state(id);
  add(sum, double{world.body_mass(id).mass}, state.centre_of_mass, state.velocity);
  sum.angular += spin(world, id);
  return sum;
}

/// Vertices weigh a third of their triangles.
inline Momentum cloth_momentum(const World& world, ClothId id) {
  const auto x = world.cloth_positions(id), v = world.cloth_velocities(id);
  const auto triangles = world.cloth_triangles(id);
  std::vector<double> share(x.size());
  for (uint32_t corner : triangles) share[corner] += 1;
  const double mass = double{world.cloth_state(id).mass} / static_cast<double>(triangles.size());
  Momentum sum;
  for (size_t k = 0; k < x.size(); ++k) add(sum, mass * share[k], x[k], v[k]);
  return sum;
}

inline Momentum operator+(Momentum a, const Momentum& b) {
  a.linear += b.linear;
  a.angular += b.angular;
  a.gross += b.gross;
  return a;
}

}  // namespace meniscus::tests
