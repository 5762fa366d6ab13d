// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Computes mass, centre and principal moments of inertia.
#include "collision/mesh/mass_properties.h"
#include "collision/mesh/tuning.h"

#include <meniscus/error.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <sstream>
#include <string>

namespace meniscus::collision {

namespace {

using Vector = Eigen::Vector3d;
using Matrix = Eigen::Matrix3d;

constexpr double pi = std::numbers::pi;

void check_positive(double value, const char* name, const char* unit) {
  if (value > 0 && std::isfinite(value)) return;
  std::ostringstream message;
  message << name << " is " << value << ' ' << unit << ": it must be positive and finite";
  throw Error(ErrorCode::invalid_argument, message.str());
}

void check_density(double density) {
  check_positive(density, "density", "kg/m³");
}

Vector exact(Vec3 v) {
  return {v.x, v.y, v.z};
}
Vec3 rounded(const Vector& v) {
  return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}
Eigen::Quaterniond exact(Quat q) {
  return Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized();
}
Quat rounded(const Eigen::Quaterniond& q) {
  return {static_cast<float>(q.x()), static_cast<float>(q.y()), static_cast<float>(q.z()),
          static_cast<float>(q.w())};
}

void check_moments(double mass, const Vector& moments) {
  const bool sound = std::isfinite(mass) && moments.allFinite() && mass > 0 &&
                     moments.minCoeff() > mesh_tuning::least_moment * moments.maxCoeff() &&
                     rounded(moments).x > 0 && rounded(moments).y > 0 && rounded(moments).z > 0;
  if (sound) return;
  std::ostringstream message;
  message << "a body of " << mass << " kg has the principal moments of inertia " << moments.x() << ", "
          << moments.y() << " and " << moments.z()
          << " kg m²: mass and moments must be positive, and none below " << mesh_tuning::least_moment
          << " of the largest";
  throw Error(ErrorCode::mesh, message.str());
}

MassProperties symmetric_body(double mass, const Vector& moments) {
  check_moments(mass, moments);
  return {mass, {0, 0, 0}, rounded(moments), {0, 0, 0, 1}};
}

// The mass properties of a body with this inertia tensor about its centre.
MassProperties principal(double mass, const Vector& centre, const Matrix& inertia) {
  const Matrix products = inertia - Matrix(inertia.diagonal().asDiagonal());
  Vector moments = inertia.diagonal();
  Eigen::Quaterniond axes = Eigen::Quaterniond::Identity();
  if (products.cwiseAbs().maxCoeff() > mesh_tuning::rounded_product * inertia.trace()) {
    const Eigen::SelfAdjointEigenSolver<Matrix> solver(inertia);
    Matrix frame = solver.eigenvectors();
    if (frame.determinant() < 0) frame.col(2) = -frame.col(2);
    moments = solver.eigenvalues();
    axes = Eigen::Quaterniond(frame).normalized();
  }
  check_moments(mass, moments);
  return {mass, rounded(centre), rounded(moments), rounded(axes)};
}

// The inertia of a body with the second moments ∫ρ x xᵀ.
Matrix inertia_of(const Matrix& second) {
  return second.trace() * Matrix::Identity() - second;
}

}  // namespace

MassProperties sphere_mass(float radius, double density) {
  check_positive(radius, "radius", "m");
  check_density(density);
  const double r = radius, mass = density * 4 / 3 * pi * r * r * r;
  return symmetric_body(mass, Vector::Constant(0.4 * mass * r * r));
}

MassProperties box_mass(Vec3 half_extents, double density) {
  for (float half : {half_extents.x, half_extents.y, half_extents.z})
    check_positive(half, "half extent", "m");
  check_density(density);
  const Vector half = exact(half_extents), squares = half.cwiseProduct(half);
  const double mass = density * 8 * half.prod();
  return symmetric_body(mass, mass / 3 * (Vector::Constant(squares.sum()) - squares));
}

MassProperties cylinder_mass(float radius, float half_height, double density) {
  check_positive(radius, "radius", "m");
  check_positive(half_height, "half height", "m");
  check_density(density);
  const double r = radius, half = half_height, mass = density * 2 * half * pi * r * r;
  const double across = mass * (r * r / 4 + half * half / 3);
  return symmetric_body(mass, {across, mass * r * r / 2, across});
}

MassProperties capsule_mass(float radius, float half_height, double density) {
  check_positive(radius, "radius", "m");
  if (half_height != 0) check_positive(half_height, "half height", "m");  // 0: a ball
  check_density(density);
  const double r = radius, half = half_height;
  const double tube = density * 2 * half * pi * r * r, ball = density * 4 / 3 * pi * r * r * r;
  // A half-ball's centre lies 3/8 r from its flat side.
  const double across =
      tube * (r * r / 4 + half * half / 3) + ball * (0.4 * r * r + half * half + 0.75 * half * r);
  return symmetric_body(tube + ball, {across, tube * r * r / 2 + 0.4 * ball * r * r, across});
}

MassProperties mesh_mass(const TriangleMesh& mesh, double density) {
  check_density(density);
  if (mesh.triangles.empty()) throw Error(ErrorCode::mesh, "a mesh without triangles has no mass");
  const Aabb box = bounds(mesh);
  const Vector origin = 0.5 * (exact(box.lower) + exact(box.upper));  // near the body, to limit cancellation
  double volume = 0;
  Vector first = Vector::Zero();
  Matrix second = Matrix::Zero();
  for (const auto& t : mesh.triangles) {
    const Vector a = exact(mesh.vertices[t[0]]) - origin, b = exact(mesh.vertices[t[1]]) - origin,
                 c = exact(mesh.vertices[t[2]]) - origin, sum = a + b + c;
    const double six_volumes = a.dot(b.cross(c));
    volume += six_volumes / 6;
    first += six_volumes / 24 * sum;
    second += six_volumes / 120 *
              (a * a.transpose() + b * b.transpose() + c * c.transpose() + sum * sum.transpose());
  }
  if (!(volume > 0)) {
    throw Error(ErrorCode::mesh, "a mesh has a volume of " + std::to_string(volume) +
                                     " m³: it must be closed, with triangles that face outwards");
  }
  const Vector centre = first / volume;
  const Matrix about_centre = second - volume * centre * centre.transpose();
  return principal(density * volume, origin + centre, density * inertia_of(about_centre));
}

MassProperties with_mass(const MassProperties& body, double mass) {
  check_positive(mass, "mass", "kg");
  MassProperties scaled = body;
  scaled.mass = mass;
  scaled.inertia = rounded(mass / body.mass * exact(body.inertia));
  return scaled;
}

MassProperties combine(std::span<const PlacedMass> parts) {
  if (parts.empty())
    throw Error(ErrorCode::invalid_argument, "a compound has no parts: it needs at least one");
  const auto centre_of = [](const PlacedMass& part) -> Vector {
    return exact(part.pose.position) + exact(part.pose.rotation) * exact(part.body.centre);
  };
  double mass = 0;
  Vector first = Vector::Zero();
  for (const PlacedMass& part : parts) {
    mass += part.body.mass;
    first += part.body.mass * centre_of(part);
  }
  const Vector centre = first / mass;
  Matrix inertia = Matrix::Zero();
  for (const PlacedMass& part : parts) {
    const Matrix axes = (exact(part.pose.rotation) * exact(part.body.axes)).toRotationMatrix();
    const Vector arm = centre_of(part) - centre;
    inertia += axes * exact(part.body.inertia).asDiagonal() * axes.transpose();
    inertia += part.body.mass * inertia_of(arm * arm.transpose());  // Steiner's theorem
  }
  return principal(mass, centre, inertia);
}

}  // namespace meniscus::collision
