// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Fills regions with lattice points, and removes those without room.
#include "sdk/world/seeding.h"

#include <meniscus/error.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <string>

#include "collision/mesh/mesh.h"
#include "pbd/math/vec.h"
#include "sdk/engine/point_table.h"
#include "sdk/engine/tuning.h"
#include "sdk/world/disorder.h"
#include "sdk/world/tuning.h"

namespace meniscus {

namespace {

/// The number of cells along an extent, so that half a spacing stays free at either end, within rounding. The
/// extent may itself be rounded, by `rounding` m.
int cells_along(float extent, float spacing, float rounding) {
  return static_cast<int>(std::floor((extent + rounding) / spacing + 1e-3f));
}

struct FillRegion {
  Engine& engine;
  float spacing;
  float rounding;
  const FileReader& files;

  std::vector<Vec3> operator()(const BoxRegion& r) const {
    const Vec3 size = r.upper - r.lower;
    const int nx = cells_along(size.x, spacing, rounding), ny = cells_along(size.y, spacing, rounding),
              nz = cells_along(size.z, spacing, rounding);
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
    const auto source = collision::MeshSource::of(r, files);
    std::vector<Vec3> points = engine.fill_mesh(collision::load_mesh(source), spacing);
    if (points.empty()) {
      throw Error(ErrorCode::mesh,
                  "the " + source.name() + " has no inside, or none that a particle fits into");
    }
    return points;
  }
};

}  // namespace

std::vector<Vec3> fill_region(const FluidVolumeDef& def, Engine& engine, float spacing, float rounding,
                              const FileReader& files) {
  std::vector<Vec3> points = std::visit(FillRegion{engine, spacing, rounding, files}, def.region);
  for (Vec3& p : points) p = to_world(def.pose, p);
  return points;
}

namespace {

/// Frees no cell in a solid, in another particle's volume, or beside cloth.
void occupy(FreeCells& cells, const FluidVolumeDef& def, Engine& engine, float spacing,
            std::span<const Vec3> taken, const CollisionFilter& filter,
            const std::function<void(std::vector<Vec3>&)>& keep) {
  std::vector<size_t> number;
  std::vector<Vec3> centres;
  for (int k = 0; k < cells.nz; ++k) {
    for (int j = 0; j < cells.ny; ++j) {
      for (int i = 0; i < cells.nx; ++i) {
        if (!cells.is[cells.at(i, j, k)]) continue;
        number.push_back(cells.at(i, j, k));
        centres.push_back(to_world(def.pose, cells.centre(i, j, k)));
      }
    }
  }
  const std::vector<float> distance = engine.solid_distances(centres, spacing, filter);
  // The radius of a ball of a spacing cubed.
  const float radius = std::cbrt(3 / (4 * std::numbers::pi_v<float>)) * spacing;
  PointTable near;
  near.fill(taken, radius);
  std::vector<Vec3> kept = centres;
  keep(kept);
  size_t next = 0;
  for (size_t n = 0; n < centres.size(); ++n) {
    const bool is_kept = next < kept.size() && kept[next] == centres[n];
    next += is_kept;
    bool is_free = is_kept && distance[n] > 0;
    near.view().for_each_near(centres[n],
                              [&](uint32_t i) { is_free &= length(taken[i] - centres[n]) >= radius; });
    cells.is[number[n]] = is_free;
  }
}

/// Moves points that are too near to solids away from them, along the gradient of the distance.
void leave_solids(std::vector<Vec3>& points, Engine& engine, float spacing, const CollisionFilter& filter) {
  const float clearance = 0.5f * spacing, step = 0.02f * spacing;
  for (int round = 0; round < world_tuning::rounds_out_of_solids; ++round) {
    const std::vector<float> distance = engine.solid_distances(points, spacing, filter);
    std::vector<size_t> number;
    std::vector<Vec3> around;
    for (size_t i = 0; i < points.size(); ++i) {
      if (distance[i] >= clearance) continue;
      number.push_back(i);
      for (Vec3 d : {Vec3{step, 0, 0}, Vec3{0, step, 0}, Vec3{0, 0, step}}) {
        around.push_back(points[i] + d);
        around.push_back(points[i] - d);
      }
    }
    if (number.empty()) return;
    const std::vector<float> beside = engine.solid_distances(around, spacing, filter);
    for (size_t n = 0; n < number.size(); ++n) {
      const float* b = &beside[6 * n];
      const Vec3 normal = normalized_or(Vec3{b[0] - b[1], b[2] - b[3], b[4] - b[5]}, {0, 0, 0});
      points[number[n]] += (clearance - distance[number[n]]) * normal;
    }
  }
}

}  // namespace

std::vector<Vec3> fill_in_disorder(const FluidVolumeDef& def, Engine& engine, float spacing,
                                   const FileReader& files, std::span<const Vec3> taken,
                                   const CollisionFilter& filter,
                                   const std::function<void(std::vector<Vec3>&)>& keep) {
  FreeCells cells = cells_of(def.region, engine, spacing, files);
  if (cells.is.empty()) return {};
  occupy(cells, def, engine, spacing, taken, filter, keep);
  const auto placed = [&](std::vector<Vec3> points) {
    for (Vec3& p : points) p = to_world(def.pose, p);
    return points;
  };
  return placed(disordered_points(cells, spacing, [&](std::vector<Vec3>& points) {
    std::vector<Vec3> in_world = placed(points);
    leave_solids(in_world, engine, spacing, filter);
    for (size_t i = 0; i < points.size(); ++i) points[i] = to_local(def.pose, in_world[i]);
  }));
}

std::vector<Vec3> shaken(std::vector<Vec3> points, Engine& engine, float spacing,
                         const CollisionFilter& filter) {
  const std::vector<float> distance = engine.solid_distances(points, spacing, filter);
  std::mt19937 random(1);
  const auto shift = [&] {
    return spacing * (static_cast<float>(random()) * 0x1p-32f - 0.5f) * world_tuning::shaking;
  };
  for (size_t i = 0; i < points.size(); ++i) {
    const float x = shift(), y = shift(), z = shift();
    if (distance[i] >= spacing) points[i] += Vec3{x, y, z};
  }
  return points;
}

std::vector<Vec3> safe_points(std::span<const Vec3> points, std::span<const Vec3> taken, Engine& engine,
                              float spacing, float rounding, const CollisionFilter& filter) {
  const float clearance = engine_tuning::clearance * spacing - rounding,
              apart = engine_tuning::apart * spacing;
  const std::vector<float> distance = engine.solid_distances(points, spacing, filter);
  PointTable near;
  near.fill(taken, apart);
  const auto is_taken = [&](Vec3 p) {
    bool found = false;
    near.view().for_each_near(p, [&](uint32_t i) { found |= length(taken[i] - p) < apart; });
    return found;
  };
  std::vector<Vec3> safe;
  safe.reserve(points.size());
  for (size_t i = 0; i < points.size(); ++i) {
    if (distance[i] >= clearance && !is_taken(points[i])) safe.push_back(points[i]);
  }
  return safe;
}

}  // namespace meniscus
