// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Divides regions into cells.
#include "sdk/world/free_cells.h"

#include <meniscus/error.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "collision/mesh/mesh.h"
#include "pbd/math/vec.h"

namespace meniscus {

namespace {

/// A grid of cells over a box, all of them free but for the margin.
FreeCells fill_box(Vec3 lower, Vec3 upper, float spacing) {
  const Vec3 extent = upper - lower;
  const auto cells = [&](float length) {
    return std::max(1, static_cast<int>(std::lround(2 * length / spacing)));
  };
  const int nx = cells(extent.x), ny = cells(extent.y), nz = cells(extent.z);
  const Vec3 size{extent.x / float(nx), extent.y / float(ny), extent.z / float(nz)};
  constexpr int pad = FreeCells::pad;
  FreeCells c{lower - float(pad) * size, size, nx + 2 * pad, ny + 2 * pad, nz + 2 * pad,
              size.x * size.y * size.z,  {}};
  c.is.assign(c.at(0, 0, c.nz), 0);
  for (int k = pad; k < pad + nz; ++k) {
    for (int j = pad; j < pad + ny; ++j)
      std::fill_n(c.is.begin() + static_cast<std::ptrdiff_t>(c.at(pad, j, k)), nx, char{1});
  }
  return c;
}

struct DivideRegion {
  Engine& engine;
  float spacing;
  const FileReader& files;

  FreeCells operator()(const BoxRegion& r) const {
    const Vec3 extent = r.upper - r.lower;
    const float least = std::min({extent.x, extent.y, extent.z});
    // Rounding as for a lattice: no particle fits into less than a spacing.
    return least < (1 - 1e-3f) * spacing ? FreeCells{} : fill_box(r.lower, r.upper, spacing);
  }

  FreeCells operator()(const BallRegion& r) const {
    if (2 * r.radius < spacing) return {};
    const Vec3 corner{r.radius, r.radius, r.radius};
    FreeCells c = fill_box(-1.0f * corner, corner, spacing);
    size_t count = 0;
    for (int k = 0; k < c.nz; ++k) {
      for (int j = 0; j < c.ny; ++j) {
        for (int i = 0; i < c.nx; ++i) {
          c.is[c.at(i, j, k)] = length(c.centre(i, j, k)) < r.radius;
          count += static_cast<size_t>(c.is[c.at(i, j, k)]);
        }
      }
    }
    c.volume = 4 * std::numbers::pi_v<float> / 3 * r.radius * r.radius * r.radius / static_cast<float>(count);
    return c;
  }

  FreeCells operator()(const MeshRegion& r) const {
    const auto source = collision::MeshSource::of(r, files);
    const float cell = 0.5f * spacing;
    const std::vector<Vec3> inside = engine.fill_mesh(collision::load_mesh(source), cell);
    if (inside.empty()) {
      throw Error(ErrorCode::mesh,
                  "the " + source.name() + " has no inside, or none that a particle fits into");
    }
    Vec3 lower = inside.front(), upper = lower;
    for (Vec3 p : inside) {
      lower = min(lower, p);
      upper = max(upper, p);
    }
    const Vec3 half{0.5f * cell, 0.5f * cell, 0.5f * cell};
    FreeCells c = fill_box(lower - half, upper + half, spacing);
    std::fill(c.is.begin(), c.is.end(), char{0});
    const auto place = [](float x, float size) { return static_cast<int>(std::floor(x / size)); };
    for (Vec3 p : inside) {
      const Vec3 d = p - c.lower;
      c.is[c.at(place(d.x, c.size.x), place(d.y, c.size.y), place(d.z, c.size.z))] = 1;
    }
    return c;
  }
};

}  // namespace

bool FreeCells::is_free(Vec3 p) const {
  const Vec3 d = p - lower;
  const int i = static_cast<int>(std::floor(d.x / size.x)), j = static_cast<int>(std::floor(d.y / size.y)),
            k = static_cast<int>(std::floor(d.z / size.z));
  return i >= 0 && j >= 0 && k >= 0 && i < nx && j < ny && k < nz && is[at(i, j, k)];
}

FreeCells cells_of(const Region& region, Engine& engine, float spacing, const FileReader& files) {
  return std::visit(DivideRegion{engine, spacing, files}, region);
}

}  // namespace meniscus
