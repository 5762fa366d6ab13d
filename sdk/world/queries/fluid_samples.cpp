// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// World's samples of the fluid at points.
#include <cmath>
#include <unordered_map>

#include "pbd/math/hash.h"
#include "sdk/world/check/check.h"
#include "sdk/world/check/periodic.h"
#include "sdk/world/world_calls.h"

namespace meniscus {

namespace {

/// The sums around a point, in doubles: their order is that of the particles.
struct PointSum {
  double density = 0, weight = 0, x = 0, y = 0, z = 0;
  uint32_t particles = 0;

  FluidSample sample() const {
    FluidSample s;
    s.density = static_cast<float>(density);
    s.particles = particles;
    if (weight > 0)
      s.velocity = {static_cast<float>(x / weight), static_cast<float>(y / weight),
                    static_cast<float>(z / weight)};
    return s;
  }
};

/// The points by cells of a support radius. There are far fewer points than particles, so the particles look
/// for points.
class PointCells {
 public:
  PointCells(std::span<const Vec3> points, float h) : h_(h) {
    for (uint32_t k = 0; k < points.size(); ++k) cells_[cell_of(points[k])].push_back(k);
  }

  /// Calls visit(point) for points in the cells around p.
  template <class Visit>
  void for_each_near(Vec3 p, const Visit& visit) const {
    const Cell at = cell_of(p);
    for (int64_t dz = -1; dz <= 1; ++dz) {
      for (int64_t dy = -1; dy <= 1; ++dy) {
        for (int64_t dx = -1; dx <= 1; ++dx) {
          const auto found = cells_.find({at.x + dx, at.y + dy, at.z + dz});
          if (found == cells_.end()) continue;
          for (const uint32_t k : found->second) visit(k);
        }
      }
    }
  }

 private:
  struct Cell {
    int64_t x, y, z;

    bool operator==(const Cell&) const = default;
  };
  struct HashCell {
    std::size_t operator()(const Cell& c) const {
      const auto word = [](int64_t i) { return static_cast<uint64_t>(i); };
      return pbd::mixed(pbd::mixed(pbd::mixed(word(c.x)) ^ word(c.y)) ^ word(c.z));
    }
  };
  Cell cell_of(Vec3 p) const {
    const auto index = [&](float x) { return static_cast<int64_t>(std::floor(double{x} / h_)); };
    return {index(p.x), index(p.y), index(p.z)};
  }

  double h_;
  std::unordered_map<Cell, std::vector<uint32_t>, HashCell> cells_;
};

/// A point and its images beyond the seams that are within a support radius of them.
std::vector<std::pair<uint32_t, Vec3>> with_images(std::span<const Vec3> points,
                                                   const PeriodicDef& periodic) {
  std::vector<std::pair<uint32_t, Vec3>> all;
  const auto shifts = [](const std::optional<PeriodicExtent>& e) {
    return e ? std::vector<float>{0, e->high - e->low, e->low - e->high} : std::vector<float>{0};
  };
  for (uint32_t k = 0; k < points.size(); ++k) {
    for (const float x : shifts(periodic.x))
      for (const float y : shifts(periodic.y))
        for (const float z : shifts(periodic.z)) all.emplace_back(k, points[k] + Vec3{x, y, z});
  }
  return all;
}

}  // namespace

std::vector<FluidSample> World::Calls::sample_fluid(std::span<const Vec3> points,
                                                    std::optional<FluidId> fluid) const {
  for (const Vec3 p : points) check::value("a point of sample_fluid", p);
  if (fluid) impl_->fluids.get(*fluid);
  std::vector<Vec3> at;
  std::vector<uint32_t> whose;
  for (const auto& [k, p] : with_images(points, impl_->def.periodic)) {
    at.push_back(p);
    whose.push_back(k);
  }
  const float h = impl_->kernel.h;
  std::vector<double> densities;  // of a particle at W = 1/V, by group
  impl_->fluids.for_each([&](uint32_t index, const ParticleMaterial& m) {
    densities.resize(index + 1);
    densities[index] = double{m.fluid.rest_density};
  });
  const PointCells cells(at, h);
  std::vector<PointSum> sums(points.size());
  const std::span<const Vec3> x = positions(), v = velocities();
  const std::span<const uint32_t> groups = fluids();
  fluid::with_shape(impl_->kernel, [&](const auto& kernel) {
    for (size_t i = 0; i < x.size(); ++i) {
      if (fluid && groups[i] != fluid->index) continue;
      cells.for_each_near(x[i], [&](uint32_t k) {
        const Vec3 d = x[i] - at[k];
        if (!(dot(d, d) < h * h)) return;
        const double w = double{kernel.weight(dot(d, d))};
        PointSum& sum = sums[whose[k]];
        sum.density += densities[groups[i]] * w;
        sum.weight += w;
        sum.x += w * double{v[i].x};
        sum.y += w * double{v[i].y};
        sum.z += w * double{v[i].z};
        ++sum.particles;
      });
    }
  });
  std::vector<FluidSample> samples;
  for (const PointSum& sum : sums) samples.push_back(sum.sample());
  return samples;
}

}  // namespace meniscus
