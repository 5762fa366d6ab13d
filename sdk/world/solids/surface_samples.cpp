// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Spreads points over a surface by sample elimination (Yuksel 2015).
#include "sdk/world/solids/surface_samples.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <random>

#include "collision/mesh/triangle.h"
#include "pbd/math/vec.h"
#include "sdk/engine/point_table.h"
#include "sdk/world/solids/tuning.h"

namespace meniscus {

namespace {

using collision::Triangle;

Triangle corners_of(const collision::TriangleMesh& mesh, size_t t) {
  const auto& [a, b, c] = mesh.triangles[t];
  return {mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]};
}

/// Cumulative sums of the triangles' areas.
std::vector<double> summed_areas(const collision::TriangleMesh& mesh) {
  std::vector<double> sums;
  double sum = 0;
  for (size_t t = 0; t < mesh.triangles.size(); ++t)
    sums.push_back(sum += 0.5 * length(area_normal(corners_of(mesh, t))));
  return sums;
}

std::vector<SurfaceSample> random_samples(const collision::TriangleMesh& mesh, size_t count) {
  const std::vector<double> areas = summed_areas(mesh);
  std::mt19937_64 bits;  // its numbers are the same on every platform; those of distributions are not
  const auto random = [&] { return static_cast<double>(bits() >> 11) * 0x1p-53; };
  std::vector<SurfaceSample> samples;
  samples.reserve(count);
  while (samples.size() < count) {
    const auto chosen = std::upper_bound(areas.begin(), areas.end() - 1, random() * areas.back());
    const Triangle t = corners_of(mesh, static_cast<size_t>(chosen - areas.begin()));
    const auto across = static_cast<float>(std::sqrt(random())), along = static_cast<float>(random());
    const Vec3 p = t.a + across * (1 - along) * (t.b - t.a) + across * along * (t.c - t.a);
    samples.push_back({p, normalized_or(area_normal(t), {0, 1, 0})});
  }
  return samples;
}

/// A sample that another one crowds, and by how much.
struct Crowding {
  uint32_t other;
  double weight;
};

class Elimination {
 public:
  Elimination(const std::vector<SurfaceSample>& samples, double area, uint32_t count)
      : crowds_(samples.size()), weight_(samples.size(), 0) {
    // The radius of discs that would fill the area at their densest.
    const double radius = std::sqrt(area / (2 * std::sqrt(3.0) * count));
    std::vector<Vec3> points;
    for (const SurfaceSample& s : samples) points.push_back(s.position);
    PointTable table;
    table.fill(points, static_cast<float>(2 * radius));
    for (uint32_t i = 0; i < points.size(); ++i) {
      table.view().for_each_near(points[i], [&](uint32_t j) {
        const double d = double{length(points[j] - points[i])};
        if (j == i || d >= 2 * radius || dot(samples[i].normal, samples[j].normal) < solids_tuning::same_side)
          return;
        const auto known = [&](const Crowding& c) { return c.other == j; };
        if (std::any_of(crowds_[i].begin(), crowds_[i].end(), known)) return;
        crowds_[i].push_back({j, std::pow(1 - d / (2 * radius), solids_tuning::crowding_exponent)});
        weight_[i] += crowds_[i].back().weight;
      });
    }
  }

  /// Which samples remain when all but `count` are eliminated.
  std::vector<bool> run(uint32_t count) {
    using Entry = std::pair<double, uint32_t>;
    std::priority_queue<Entry> most_crowded;
    for (uint32_t i = 0; i < weight_.size(); ++i) most_crowded.push({weight_[i], i});
    std::vector<bool> stays(weight_.size(), true);
    for (size_t left = weight_.size(); left > count;) {
      const auto [weight, i] = most_crowded.top();
      most_crowded.pop();
      if (!stays[i] || weight != weight_[i]) continue;  // an outdated entry: the weight has changed since
      stays[i] = false;
      --left;
      for (const Crowding& c : crowds_[i]) {
        weight_[c.other] -= c.weight;
        most_crowded.push({weight_[c.other], c.other});
      }
    }
    return stays;
  }

 private:
  std::vector<std::vector<Crowding>> crowds_;
  std::vector<double> weight_;
};

}  // namespace

double surface_area(const collision::TriangleMesh& mesh) {
  return summed_areas(mesh).back();
}

std::vector<SurfaceSample> spread_samples(const collision::TriangleMesh& mesh, uint32_t count) {
  const std::vector<SurfaceSample> samples = random_samples(mesh, size_t{5} * count);
  const std::vector<bool> stays = Elimination(samples, surface_area(mesh), count).run(count);
  std::vector<SurfaceSample> spread;
  for (size_t i = 0; i < samples.size(); ++i) {
    if (stays[i]) spread.push_back(samples[i]);
  }
  return spread;
}

}  // namespace meniscus
