// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Places lattices in and around boxes.
#include "collision/mesh/lattice.h"

#include <meniscus/error.h>

#include <array>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <string>

namespace meniscus::collision {

namespace {

std::array<double, 3> extent_of(const Aabb& box) {
  return {double{box.upper.x} - box.lower.x, double{box.upper.y} - box.lower.y,
          double{box.upper.z} - box.lower.z};
}

void check_length(float value, const char* name, bool zero_allowed) {
  if (std::isfinite(value) && (zero_allowed ? value >= 0 : value > 0)) return;
  throw Error(ErrorCode::invalid_argument, std::string(name) + " is " + std::to_string(value) +
                                               " m: it must be " +
                                               (zero_allowed ? "zero or more" : "positive") + ", and finite");
}

void check_count(const std::array<double, 3>& points, const Aabb& box, float spacing, const char* name) {
  const double count = points[0] * points[1] * points[2];
  if (count <= max_lattice_points) return;
  const std::array<double, 3> e = extent_of(box);
  std::ostringstream text;
  text << name << " is " << spacing << " m, which divides a mesh of " << e[0] << " x " << e[1] << " x "
       << e[2] << " m into " << std::setprecision(3) << count * 1e-6 << " million points: at most "
       << max_lattice_points / 1000000 << " million are allowed";
  throw Error(ErrorCode::invalid_argument, text.str());
}

Lattice centred(const std::array<double, 3>& points, const Aabb& box, float spacing) {
  const auto first = [&](float lower, float upper, double n) {
    return static_cast<float>(0.5 * (double{lower} + upper) - 0.5 * (n - 1) * spacing);
  };
  return {{first(box.lower.x, box.upper.x, points[0]), first(box.lower.y, box.upper.y, points[1]),
           first(box.lower.z, box.upper.z, points[2])},
          spacing,
          static_cast<uint32_t>(points[0]),
          static_cast<uint32_t>(points[1]),
          static_cast<uint32_t>(points[2])};
}

}  // namespace

Lattice lattice_around(const Aabb& box, float spacing, float margin, const char* name) {
  check_length(spacing, name, false);
  check_length(margin, "margin", true);
  std::array<double, 3> points = extent_of(box);
  for (double& n : points) n = std::ceil((n + 2.0 * margin) / spacing) + 2;
  check_count(points, box, spacing, name);
  return centred(points, box, spacing);
}

Lattice lattice_within(const Aabb& box, float spacing, const char* name) {
  check_length(spacing, name, false);
  std::array<double, 3> points = extent_of(box);
  for (double& n : points) n = std::max(1.0, std::round(n / spacing));
  check_count(points, box, spacing, name);
  return centred(points, box, spacing);
}

}  // namespace meniscus::collision
