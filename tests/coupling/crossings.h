// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// An exact count of where cloth is in a solid, or a solid has passed through cloth, in double precision. It
// shares no code with the contacts that it checks.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "tests/cloth_worlds.h"
#include "tests/coupling/body_worlds.h"

namespace meniscus::tests {

inline double dot(const Sum3& a, const Sum3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

struct Face {
  Sum3 a, b, c;
};

inline double distance_to_segment(const Sum3& p, const Sum3& a, const Sum3& b) {
  const Sum3 along = b - a;
  const double t = std::clamp(dot(p - a, along) / dot(along, along), 0.0, 1.0);
  return norm(p - (a + t * along));
}

/// From a point to a face.
inline double distance_to(const Sum3& p, const Face& f) {
  const Sum3 n = cross(f.b - f.a, f.c - f.a);
  const bool inside = dot(cross(f.b - f.a, p - f.a), n) >= 0 && dot(cross(f.c - f.b, p - f.b), n) >= 0 &&
                      dot(cross(f.a - f.c, p - f.c), n) >= 0;
  if (inside && norm(n) > 0) return std::fabs(dot(p - f.a, n)) / norm(n);
  return std::min(
      {distance_to_segment(p, f.a, f.b), distance_to_segment(p, f.b, f.c), distance_to_segment(p, f.c, f.a)});
}

/// Between two segments.
inline double distance_between(const Sum3& a, const Sum3& b, const Sum3& c, const Sum3& d) {
  const Sum3 u = b - a, v = d - c, r = a - c;
  const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), det = uu * vv - uv * uv;
  if (det > 1e-12 * uu * vv) {
    const double s = (uv * dot(v, r) - vv * dot(u, r)) / det, t = (uu * dot(v, r) - uv * dot(u, r)) / det;
    if (s >= 0 && s <= 1 && t >= 0 && t <= 1) return norm(r + s * u - t * v);
  }
  return std::min({distance_to_segment(a, c, d), distance_to_segment(b, c, d), distance_to_segment(c, a, b),
                   distance_to_segment(d, a, b)});
}

/// Whether the segment from p to q passes through a face.
inline bool passes(const Sum3& p, const Sum3& q, const Face& f) {
  const Sum3 n = cross(f.b - f.a, f.c - f.a);
  const double from = dot(p - f.a, n), to = dot(q - f.a, n);
  if ((from > 0) == (to > 0)) return false;
  const Sum3 at = p + from / (from - to) * (q - p);
  return dot(cross(f.b - f.a, at - f.a), n) >= 0 && dot(cross(f.c - f.b, at - f.b), n) >= 0 &&
         dot(cross(f.a - f.c, at - f.c), n) >= 0;
}

/// How far a face is from the middle of a solid, over how far it must be: less than 1 is inside. All in the
/// frame of the solid.
inline double clearance(const SphereGeometry& s, const Face& f) {
  return distance_to({0, 0, 0}, f) / double{s.radius};
}
inline double clearance(const CapsuleGeometry& s, const Face& f) {
  const Sum3 a{0, double{-s.half_height}, 0}, b{0, double{s.half_height}, 0};
  if (passes(a, b, f)) return 0;
  const double sides = std::min(
      {distance_between(a, b, f.a, f.b), distance_between(a, b, f.b, f.c), distance_between(a, b, f.c, f.a)});
  return std::min({sides, distance_to(a, f), distance_to(b, f)}) / double{s.radius};
}
/// The least scale of the box at which no axis separates the two (Akenine-Möller 2001).
inline double clearance(const BoxGeometry& s, const Face& f) {
  const std::array<Sum3, 3> axes{Sum3{1, 0, 0}, Sum3{0, 1, 0}, Sum3{0, 0, 1}},
      sides{f.b - f.a, f.c - f.b, f.a - f.c};
  double most = 0;
  const auto separate = [&](const Sum3& n) {
    const double reach = std::fabs(n.x) * double{s.half_extents.x} +
                         std::fabs(n.y) * double{s.half_extents.y} +
                         std::fabs(n.z) * double{s.half_extents.z};
    if (reach < 1e-12) return;
    const auto [least, largest] = std::minmax({dot(n, f.a), dot(n, f.b), dot(n, f.c)});
    most = std::max(most, std::max(least, -largest) / reach);
  };
  for (const Sum3& axis : axes) {
    separate(axis);
    for (const Sum3& side : sides) separate(cross(axis, side));
  }
  separate(cross(sides[0], sides[1]));
  return most;
}

/// The times in [0, 1] at which a point is in the plane of a moving face: the roots of a cubic.
inline std::vector<double> coplanar_times(const std::array<Sum3, 3>& from, const std::array<Sum3, 3>& to) {
  const auto volume = [&](double t) {
    std::array<Sum3, 3> r;
    for (size_t k = 0; k < 3; ++k) r[k] = from[k] + t * (to[k] - from[k]);
    return dot(r[0], cross(r[1], r[2]));
  };
  // The cubic through four values, and the extrema between which it is monotonic.
  const double f0 = volume(0), f1 = volume(1), f2 = volume(-1), f3 = volume(2);
  const double b = 0.5 * (f1 + f2) - f0, odd = 0.5 * (f1 - f2), a = (f3 - f0 - 4 * b - 2 * odd) / 6,
               c = odd - a;
  std::vector<double> ends{0, 1}, times;
  const double root = b * b - 3 * a * c;
  if (root >= 0) {
    const double q = -(b + std::copysign(std::sqrt(root), b));
    for (double t : {q / (3 * a), c / q}) {
      if (t > 0 && t < 1) ends.push_back(t);
    }
  }
  std::sort(ends.begin(), ends.end());
  for (size_t k = 0; k + 1 < ends.size(); ++k) {
    double low = ends[k], high = ends[k + 1];
    if ((volume(low) > 0) == (volume(high) > 0)) continue;
    for (int n = 0; n < 100; ++n) {
      const double middle = 0.5 * (low + high);
      ((volume(middle) > 0) == (volume(low) > 0) ? low : high) = middle;
    }
    times.push_back(0.5 * (low + high));
  }
  return times;
}

/// Whether a point that moves from p to q passes through a face that moves.
inline bool passes(const Sum3& p, const Sum3& q, const Face& from, const Face& to) {
  const std::array<Sum3, 3> r{from.a - p, from.b - p, from.c - p}, s{to.a - q, to.b - q, to.c - q};
  const std::vector<double> times = coplanar_times(r, s);
  return std::any_of(times.begin(), times.end(), [&](double t) {
    std::array<Sum3, 3> x;
    for (size_t k = 0; k < 3; ++k) x[k] = r[k] + t * (s[k] - r[k]);
    const Sum3 n = cross(x[1] - x[0], x[2] - x[0]);
    return dot(cross(x[0], x[1]), n) >= 0 && dot(cross(x[1], x[2]), n) >= 0 && dot(cross(x[2], x[0]), n) >= 0;
  });
}

/// Follows one solid and one piece of cloth from substep to substep.
template <class Geometry>
class Crossings {
 public:
  Crossings(const World& world, ClothId cloth, BodyId body, const Geometry& geometry)
      : world_(world), cloth_(cloth), body_(body), geometry_(geometry) {
    count();
    passed_ = 0;
  }

  /// Call it after each substep.
  void count() {
    const auto x = world_.cloth_positions(cloth_);
    const auto triangles = world_.cloth_triangles(cloth_);
    const Pose pose = world_.body_state(body_).pose;
    const Sum3 centre = pose.position;
    const std::vector<Sum3> now(x.begin(), x.end());
    inside_ = 0;
    least_ = 1e30;
    for (size_t t = 0; t < triangles.size(); t += 3) {
      const auto face = [&](const std::vector<Sum3>& at) {
        return Face{at[triangles[t]], at[triangles[t + 1]], at[triangles[t + 2]]};
      };
      const Face to = face(now);
      const auto local = [&](const Sum3& p) { return rotated_back(pose.rotation, p - centre); };
      const double clear = clearance(geometry_, Face{local(to.a), local(to.b), local(to.c)});
      least_ = std::min(least_, clear);
      if (clear < 1) ++inside_;
      if (!before_.empty() && passes(centre_, centre, face(before_), to)) ++passed_;
    }
    most_inside_ = std::max(most_inside_, inside_);
    least_ever_ = std::min(least_ever_, least_);
    before_ = now;
    centre_ = centre;
  }

  int inside() const { return inside_; }            ///< faces that reach into the solid now
  int most_inside() const { return most_inside_; }  ///< in any substep
  int passed() const { return passed_; }            ///< passages of the solid's centre through a face
  double least_clearance() const { return least_ever_; }
  double clearance_now() const { return least_; }

 private:
  const World& world_;
  ClothId cloth_;
  BodyId body_;
  Geometry geometry_;
  std::vector<Sum3> before_;
  Sum3 centre_;
  int inside_ = 0, most_inside_ = 0, passed_ = 0;
  double least_ = 0, least_ever_ = 1e30;
};

}  // namespace meniscus::tests
