// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#include "sdk/world/seeding.h"

#include <meniscus/error.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <unordered_map>

#include "collision/mesh.h"
#include "pbd/math/vec.h"

namespace meniscus {

namespace {

/// Cells along an extent: a lattice that fills it with half a spacing free at either end, rounding aside.
int cells_along(float extent, float spacing) {
  return static_cast<int>(std::floor(extent / spacing + 1e-3f));
}

struct FillRegion {
  Engine& engine;
  float spacing;

  std::vector<Vec3> operator()(const BoxRegion& r) const {
    const Vec3 size = r.upper - r.lower;
    const int nx = cells_along(size.x, spacing), ny = cells_along(size.y, spacing),
              nz = cells_along(size.z, spacing);
    std::vector<Vec3> points;
    points.reserve(static_cast<size_t>(std::max(0, nx)) * static_cast<size_t>(std::max(0, ny)) *
                   static_cast<size_t>(std::max(0, nz)));
    for (int k = 0; k < nz; ++k) {
      for (int j = 0; j < ny; ++j) {
        for (int i = 0; i < nx; ++i) {
          points.push_back(r.lower + spacing * Vec3{float(i) + 0.5f, float(j) + 0.5f, float(k) + 0.5f});
        }
      }
    }
    return points;
  }

  std::vector<Vec3> operator()(const BallRegion& r) const {
    std::vector<Vec3> points =
        (*this)(BoxRegion{{-r.radius, -r.radius, -r.radius}, {r.radius, r.radius, r.radius}});
    std::erase_if(points, [&](Vec3 p) { return length(p) > r.radius; });
    return points;
  }

  std::vector<Vec3> operator()(const MeshRegion& r) const {
    std::vector<Vec3> points = engine.fill_mesh(collision::load_mesh(r.file, r.scale), spacing);
    if (points.empty()) {
      throw Error(ErrorCode::mesh,
                  "the mesh " + r.file + " has no inside, or none that a particle fits into");
    }
    return points;
  }
};

/// Points in cubes of one spacing, to find the near ones of a place.
class PointCells {
 public:
  PointCells(std::span<const Vec3> points, float size) : points_(points), size_(size) {
    for (uint32_t i = 0; i < points.size(); ++i) cells_[key(cell(points[i]))].push_back(i);
  }

  bool any_within(Vec3 p, float distance) const {
    const Cell c = cell(p);
    for (int64_t dx = -1; dx <= 1; ++dx) {
      for (int64_t dy = -1; dy <= 1; ++dy) {
        for (int64_t dz = -1; dz <= 1; ++dz) {
          const auto found = cells_.find(key({c.x + dx, c.y + dy, c.z + dz}));
          if (found == cells_.end()) continue;
          for (uint32_t i : found->second) {
            if (length(points_[i] - p) < distance) return true;
          }
        }
      }
    }
    return false;
  }

 private:
  struct Cell {
    int64_t x, y, z;
  };

  Cell cell(Vec3 p) const {
    return {static_cast<int64_t>(std::floor(p.x / size_)), static_cast<int64_t>(std::floor(p.y / size_)),
            static_cast<int64_t>(std::floor(p.z / size_))};
  }
  static uint64_t key(Cell c) {
    return static_cast<uint64_t>(c.x) * 73856093u ^ static_cast<uint64_t>(c.y) * 19349663u ^
           static_cast<uint64_t>(c.z) * 83492791u;
  }

  std::span<const Vec3> points_;
  float size_;
  std::unordered_map<uint64_t, std::vector<uint32_t>> cells_;
};

}  // namespace

std::vector<Vec3> fill_region(const FluidVolumeDef& def, Engine& engine, float spacing) {
  std::vector<Vec3> points = std::visit(FillRegion{engine, spacing}, def.region);
  for (Vec3& p : points) p = to_world(def.pose, p);
  return points;
}

std::vector<Vec3> safe_points(std::span<const Vec3> points, std::span<const Vec3> taken, Engine& engine,
                              float spacing, const CollisionFilter& filter) {
  // A lattice that just fits a container has its outer layer at half a spacing: leave that to rounding.
  const float clearance = 0.49f * spacing, apart = 0.7f * spacing;
  const std::vector<float> distance = engine.solid_distances(points, spacing, filter);
  const PointCells cells(taken, spacing);
  std::vector<Vec3> safe;
  safe.reserve(points.size());
  for (size_t i = 0; i < points.size(); ++i) {
    if (distance[i] >= clearance && !cells.any_within(points[i], apart)) safe.push_back(points[i]);
  }
  return safe;
}

}  // namespace meniscus
