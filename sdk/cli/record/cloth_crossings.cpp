// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Detects when a moving point passes through a moving triangle, and counts these passages per piece.
#include "sdk/cli/record/cloth_crossings.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace meniscus::cli {
namespace {

struct Vector {
  double x, y, z;
};

Vector operator+(const Vector& a, const Vector& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
Vector operator-(const Vector& a, const Vector& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
Vector operator*(double s, const Vector& a) {
  return {s * a.x, s * a.y, s * a.z};
}
Vector of(Vec3 a) {
  return {a.x, a.y, a.z};
}
Vector cross(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double dot(const Vector& a, const Vector& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
double triple(const Vector& a, const Vector& b, const Vector& c) {
  return dot(a, cross(b, c));
}

/// A triangle's corners relative to the point, and their motion.
struct Pass {
  std::array<Vector, 3> start, motion;

  std::array<Vector, 3> at(double t) const {
    std::array<Vector, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k) corners[k] = start[k] + t * motion[k];
    return corners;
  }

  /// Six times the volume of the tetrahedron of point and triangle; negative if the point is on the normal's
  /// side.
  double volume(double t) const {
    const auto c = at(t);
    return triple(c[0], c[1], c[2]);
  }

  /// Whether the point, which lies in the triangle's plane, is inside the triangle.
  bool is_within(double t) const {
    const auto c = at(t);
    const Vector normal = cross(c[1] - c[0], c[2] - c[0]);
    for (std::size_t k = 0; k < 3; ++k) {
      if (triple(normal, c[k], c[(k + 1) % 3]) < 0) return false;
    }
    return true;
  }
};

/// The volume as a cubic in time, c₀ + c₁ t + c₂ t² + c₃ t³.
struct Cubic {
  double c0, c1, c2, c3;

  explicit Cubic(const Pass& pass) {
    const auto& [a, b, c] = pass.start;
    const auto& [u, v, w] = pass.motion;
    c0 = triple(a, b, c);
    c1 = triple(u, b, c) + triple(a, v, c) + triple(a, b, w);
    c2 = triple(u, v, c) + triple(u, b, w) + triple(a, v, w);
    c3 = triple(u, v, w);
  }

  /// Decides by the Bernstein coefficients, between which it stays for times from 0 to 1. `end` is the last
  /// of them.
  bool may_change_sign(double end) const {
    const bool sign = c0 > 0;
    return (c0 + c1 / 3 > 0) != sign || (c0 + (2 * c1 + c2) / 3 > 0) != sign || (end > 0) != sign;
  }
};

/// The zeros of the quadratic a t² + b t + c, in ascending order.
std::vector<double> zeros_of(double a, double b, double c) {
  if (a == 0) return b == 0 ? std::vector<double>{} : std::vector{-c / b};
  const double inside = b * b - 4 * a * c;
  if (inside < 0) return {};
  const double q = -0.5 * (b + std::copysign(std::sqrt(inside), b));
  if (q == 0) return {0};
  return {std::min(q / a, c / q), std::max(q / a, c / q)};
}

/// 0, the times between 0 and 1 at which the volume is extremal, and 1.
std::vector<double> monotone_parts(const Cubic& volume) {
  std::vector<double> times{0};
  for (const double t : zeros_of(3 * volume.c3, 2 * volume.c2, volume.c1)) {
    if (t > times.back() && t < 1) times.push_back(t);
  }
  times.push_back(1);
  return times;
}

double zero_between(const Pass& pass, double low, double high) {
  const bool sign = pass.volume(low) > 0;
  for (int round = 0; round < 60; ++round) {
    const double middle = 0.5 * (low + high);
    ((pass.volume(middle) > 0) == sign ? low : high) = middle;
  }
  return low;
}

std::array<Vec3, 3> corners_of(const io::ClothFrame& cloth, std::size_t triangle) {
  const auto& t = cloth.triangles[triangle];
  return {cloth.vertices[t[0]], cloth.vertices[t[1]], cloth.vertices[t[2]]};
}

/// The box around a triangle's corners at both times.
Aabb around_both(const std::array<Vec3, 3>& from, const std::array<Vec3, 3>& to) {
  Aabb box = around({from[0], to[0]});
  for (std::size_t k = 1; k < 3; ++k) box = united(box, around({from[k], to[k]}));
  return box;
}

}  // namespace

int passage(const std::array<Vec3, 3>& from, const std::array<Vec3, 3>& to, Vec3 point_from, Vec3 point_to) {
  Pass pass{};
  for (std::size_t k = 0; k < 3; ++k) {
    pass.start[k] = of(from[k]) - of(point_from);
    pass.motion[k] = of(to[k]) - of(point_to) - pass.start[k];
  }
  const Cubic volume(pass);
  if (!volume.may_change_sign(pass.volume(1))) return 0;
  const std::vector<double> times = monotone_parts(volume);
  int net = 0;
  for (std::size_t k = 0; k + 1 < times.size(); ++k) {
    const bool before = pass.volume(times[k]) > 0, after = pass.volume(times[k + 1]) > 0;
    if (before != after && pass.is_within(zero_between(pass, times[k], times[k + 1]))) net += before ? 1 : -1;
  }
  return net;
}

void ClothCrossings::start(const FrameSample& sample) {
  keep(sample);
}

void ClothCrossings::keep(const FrameSample& sample) {
  corners_.clear();
  for (std::size_t t = 0; t < sample.cloth.triangles.size(); ++t)
    corners_.push_back({corners_of(sample.cloth, t)});
  positions_.assign(sample.particles.positions.begin(), sample.particles.positions.end());
  ids_.assign(sample.particles.ids.begin(), sample.particles.ids.end());
  counts_.resize(sample.cloth.names.size());
}

/// The displacements of particles that exist in both frames; ids are in ascending order.
std::vector<Path> ClothCrossings::paths_to(const io::ParticleFrame& now) const {
  std::vector<Path> paths;
  for (std::size_t i = 0, old = 0; i < now.size(); ++i) {
    while (old < ids_.size() && ids_[old] < now.ids[i]) ++old;
    if (old < ids_.size() && ids_[old] == now.ids[i]) paths.push_back({positions_[old], now.positions[i]});
  }
  return paths;
}

void ClothCrossings::add(const FrameSample& sample) {
  std::vector<Aabb> boxes;
  for (std::size_t t = 0; t < corners_.size(); ++t)
    boxes.push_back(around_both(corners_[t].at, corners_of(sample.cloth, t)));
  if (!boxes.empty()) {
    count(PathColumns(paths_to(sample.particles),
                      std::accumulate(boxes.begin(), boxes.end(), boxes[0], united)),
          boxes, sample.cloth);
  }
  keep(sample);
}

void ClothCrossings::count(const PathColumns& paths, const std::vector<Aabb>& boxes,
                           const io::ClothFrame& cloth) {
  std::vector<int> net(paths.count(), 0);
  uint32_t piece = 0;
  const auto finish_piece = [&] {
    for (int& passages : net) counts_[piece] += static_cast<uint64_t>(std::abs(std::exchange(passages, 0)));
  };
  for (std::size_t t = 0; t < corners_.size(); ++t) {
    if (cloth.pieces[t] != piece) finish_piece();
    piece = cloth.pieces[t];
    const std::array<Vec3, 3>&from = corners_[t].at, to = corners_of(cloth, t);
    paths.for_each_near(
        boxes[t], [&](std::size_t n, const Path& path) { net[n] += passage(from, to, path.from, path.to); });
  }
  finish_piece();
}

uint64_t ClothCrossings::through_all() const {
  return std::accumulate(counts_.begin(), counts_.end(), uint64_t{0});
}

}  // namespace meniscus::cli
