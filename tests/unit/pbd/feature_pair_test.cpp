// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Nearest places of vertices, triangles and edges, and the time of their meeting, against doubles.
#include "pbd/feature_pair.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace meniscus::pbd {
namespace {

using Double3 = std::array<double, 3>;

Double3 exactly(Vec3 v) {
  return {v.x, v.y, v.z};
}
Double3 operator-(const Double3& a, const Double3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Double3 along(const Double3& a, const Double3& b, double t) {
  return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])};
}
double dot(const Double3& a, const Double3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
double norm(const Double3& a) {
  return std::sqrt(dot(a, a));
}
Double3 cross(const Double3& a, const Double3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double point_to_segment(const Double3& p, const Double3& a, const Double3& b) {
  const double whole = dot(b - a, b - a);
  const double t = whole > 0 ? std::clamp(dot(p - a, b - a) / whole, 0.0, 1.0) : 0;
  return norm(p - along(a, b, t));
}

double point_to_triangle(const Double3& p, const Double3& a, const Double3& b, const Double3& c) {
  double least = std::min({point_to_segment(p, a, b), point_to_segment(p, b, c), point_to_segment(p, c, a)});
  const Double3 n = cross(b - a, c - a);
  if (dot(n, n) == 0) return least;
  const bool inside = dot(cross(b - a, p - a), n) >= 0 && dot(cross(c - b, p - b), n) >= 0 &&
                      dot(cross(a - c, p - c), n) >= 0;
  return inside ? std::min(least, std::fabs(dot(p - a, n)) / norm(n)) : least;
}

double segment_to_segment(const Double3& a, const Double3& b, const Double3& c, const Double3& d) {
  double least = std::min({point_to_segment(a, c, d), point_to_segment(b, c, d), point_to_segment(c, a, b),
                           point_to_segment(d, a, b)});
  const Double3 e = b - a, f = d - c, r = a - c, n = cross(e, f);
  const double nn = dot(n, n);
  if (nn == 0) return least;
  const double s = dot(cross(f, r), n) / nn, t = dot(cross(e, r), n) / nn;
  return s > 0 && s < 1 && t > 0 && t < 1 ? std::min(least, std::fabs(dot(n, r)) / std::sqrt(nn)) : least;
}

double exact_distance(const FeaturePair& p, double t) {
  std::array<Double3, 4> x;
  for (size_t k = 0; k < 4; ++k) x[k] = along(exactly(p.start[k]), exactly(p.start[k] + p.motion[k]), t);
  return p.edges ? segment_to_segment(x[0], x[1], x[2], x[3]) : point_to_triangle(x[0], x[1], x[2], x[3]);
}

class SelfContactGeometry : public testing::TestWithParam<bool> {  // whether of two edges
 protected:
  std::mt19937 random_{7};

  Vec3 anywhere(float size) {
    std::uniform_real_distribution<float> u(-size, size);
    return {u(random_), u(random_), u(random_)};
  }

  FeaturePair still() {
    FeaturePair p{};
    p.edges = GetParam();
    for (Vec3& x : p.start) x = anywhere(1);
    return p;
  }

  static void expect_nearest(const FeaturePair& p, double tolerance) {
    const Nearest found = nearest(p, 0);
    EXPECT_NEAR(found.distance, exact_distance(p, 0), tolerance);
    EXPECT_NEAR(length(found.r), found.distance, 1e-6);
    float weight[4];
    corner_weights(p.edges, found.u, found.v, weight);
    Vec3 r{0, 0, 0};
    for (int k = 0; k < 4; ++k) r += weight[k] * p.start[k];
    EXPECT_NEAR(length(r - found.r), 0, tolerance);
    EXPECT_NEAR(weight[0] + weight[1] + weight[2] + weight[3], 0, 1e-6);
    for (int k = 0; k < 4; ++k) {
      const bool positive = k == 0 || (p.edges && k == 1);
      EXPECT_GE(positive ? weight[k] : -weight[k], -1e-6) << "corner " << k;
    }
  }
};

TEST_P(SelfContactGeometry, FindsTheNearestPlaces) {
  for (int n = 0; n < 20000; ++n) expect_nearest(still(), 2e-6);
}

TEST(FeaturePair, KnowsWhatLiesOverATriangle) {
  std::mt19937 random(8);
  std::uniform_real_distribution<float> u(-1, 1);
  int over = 0;
  for (int n = 0; n < 5000; ++n) {
    FeaturePair p{};
    for (Vec3& x : p.start) x = {u(random), u(random), u(random)};
    EXPECT_EQ(is_over_triangle(p, 0), nearest(p, 0).on == 7);
    over += is_over_triangle(p, 0);
  }
  EXPECT_GT(over, 300);
  EXPECT_LT(over, 4000);
}

TEST_P(SelfContactGeometry, FindsThemOnSlivers) {
  for (int n = 0; n < 20000; ++n) {
    FeaturePair p = still();
    const float width = std::pow(10.0f, -1.0f - 6.0f * float(n % 7) / 6);
    // A triangle whose third corner lies by its first edge; two edges that are hardly askew.
    if (p.edges)
      p.start[3] = p.start[2] + 0.7f * (p.start[1] - p.start[0]) + anywhere(width);
    else
      p.start[3] = p.start[1] + 0.4f * (p.start[2] - p.start[1]) + anywhere(width);
    expect_nearest(p, 2e-5);
  }
}

TEST_P(SelfContactGeometry, FindsThemOnParallelAndPointLikeOnes) {
  for (int n = 0; n < 2000; ++n) {
    FeaturePair p = still();
    const float shift = 0.25f * float(n % 9 - 4);
    const Vec3 first = p.edges ? p.start[1] - p.start[0] : p.start[2] - p.start[1];
    if (p.edges) {
      p.start[2] = p.start[2] + shift * first;
      p.start[3] = n % 3 ? p.start[2] + first : p.start[2] - first;
    } else {
      p.start[3] = p.start[1] + shift * first;
    }
    expect_nearest(p, 1e-5);
    if (n % 10 == 0) {
      p.start[3] = p.start[2];
      expect_nearest(p, 2e-6);
      p.start[1] = p.edges ? p.start[0] : p.start[2];
      expect_nearest(p, 2e-6);
    }
  }
}

TEST_P(SelfContactGeometry, StopsBeforeTheyMeet) {
  int met = 0, exactly_there = 0;
  for (int n = 0; n < 20000; ++n) {
    FeaturePair p = still();
    for (Vec3& m : p.motion) m = anywhere(n % 2 ? 1.0f : 4.0f);
    const float start = nearest(p, 0).distance;
    if (start < 1e-3f) continue;
    const float t = time_of_nearness(p, 0.1f * start);
    const double end = std::min(1.0f, t);
    double least = start;
    for (int k = 0; k <= 100; ++k) least = std::min(least, exact_distance(p, end * k / 100));
    EXPECT_GE(least, 0.07 * start) << "case " << n;
    if (t > 1) continue;
    ++met;
    exactly_there += exact_distance(p, t) < 0.101 * start;
  }
  EXPECT_GT(met, 500);
  EXPECT_GT(exactly_there, 0.97 * met);  // the others graze, and are stopped a little later
}

TEST_P(SelfContactGeometry, SeesWhatGoesThrough) {
  std::uniform_real_distribution<float> share(0.05f, 0.95f);
  for (int n = 0; n < 5000; ++n) {
    FeaturePair p = still();
    // At some time during the motion the two coincide.
    const float when = share(random_), u = share(random_), v = share(random_) * (p.edges ? 1 : 1 - u);
    float weight[4];
    corner_weights(p.edges, u, v, weight);
    for (Vec3& m : p.motion) m = anywhere(2);
    Vec3 apart{0, 0, 0};
    for (int k = 0; k < 4; ++k) apart += weight[k] * p.at(k, when);
    const int first = p.edges ? 2 : 1;
    for (int k = 0; k < first; ++k) p.motion[k] -= apart / when;
    const float start = nearest(p, 0).distance;
    if (start < 1e-3f) continue;
    EXPECT_LE(time_of_nearness(p, 0.1f * start), when + 1e-4f) << "case " << n;
  }
}

INSTANTIATE_TEST_SUITE_P(Of, SelfContactGeometry, testing::Bool(),
                         [](const auto& test) { return test.param ? "edges" : "vertex_and_triangle"; });

}  // namespace
}  // namespace meniscus::pbd
