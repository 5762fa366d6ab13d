// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Distributes the places of particles over discs, rectangles and meshes.
#include "sdk/world/flow/emitter_sites.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include "collision/mesh/mesh.h"
#include "pbd/math/vec.h"
#include "sdk/world/check/check.h"
#include "sdk/world/flow/tuning.h"
#include "sdk/world/solids/surface_samples.h"

namespace meniscus {

namespace {

constexpr double most_places = 1e6;

void check_size(const char* name, double area, double spacing) {
  if (area / (spacing * spacing) <= most_places) return;
  std::ostringstream value;
  value << area << " m²";
  check::refuse(name, value.str(), "at most a million particle spacings squared");
}

/// The number of particles side by side: one per spacing squared. It is rounded so that layers are never
/// closer than `closest`.
int places_on(double area, double spacing) {
  return std::max(1, static_cast<int>(area / (spacing * spacing) + flow_tuning::place_rounding));
}

/// The `count` points of a square lattice that are nearest to its origin, relative to their centre. The
/// origin is a lattice point, or with `shift` = 1/2 the middle of four. `moment` is the sum of the squared
/// distances.
std::vector<Vec3> nearest_lattice_points(int count, float shift, double& moment) {
  const int reach = static_cast<int>(std::ceil(std::sqrt(count / std::numbers::pi))) + 2;
  std::vector<Vec3> points;
  for (int k = -reach; k <= reach; ++k) {
    for (int i = -reach; i <= reach; ++i)
      points.push_back({static_cast<float>(i) + shift, 0, static_cast<float>(k) + shift});
  }
  std::stable_sort(points.begin(), points.end(), [](Vec3 a, Vec3 b) { return dot(a, a) < dot(b, b); });
  points.resize(static_cast<size_t>(count));
  Vec3 centre{0, 0, 0};
  moment = 0;
  for (Vec3 p : points) {
    centre += p / static_cast<float>(count);
    moment += double{dot(p, p)};
  }
  for (Vec3& p : points) p -= centre;
  return points;
}

/// The numbers of cells along a rectangle's sides. Cells have about the size of a spacing, chosen so that
/// layers have about that distance, too.
std::pair<int, int> divide(double width, double depth, double spacing) {
  std::pair<int, int> best{1, 1};
  double least = std::numeric_limits<double>::infinity();
  const int columns = static_cast<int>(width / spacing), rows = static_cast<int>(depth / spacing);
  for (int c : {columns, columns + 1}) {
    for (int r : {rows, rows + 1}) {
      const double least_side = 0.999 * flow_tuning::closest * spacing;
      const bool too_close = (c > 1 && width < c * least_side) || (r > 1 && depth < r * least_side);
      if (c < 1 || r < 1 || too_close) continue;
      const double layer = c * r * spacing * spacing / (width * depth);
      const double off =
          std::fabs(std::log(layer)) + (layer < flow_tuning::closest ? flow_tuning::close_layer_cost : 0);
      if (off < least) best = {c, r};
      least = std::min(least, off);
    }
  }
  return best;
}

struct MakeSites {
  double spacing;
  const FileReader& files;

  EmitterSites operator()(const DiscOpening& o) const {
    EmitterSites sites;
    sites.area = std::numbers::pi * o.radius * o.radius;
    check_size("DiscOpening's area", sites.area, spacing);
    const int count = places_on(sites.area, spacing);
    double about_point = 0, about_cell = 0;
    std::vector<Vec3> points = nearest_lattice_points(count, 0, about_point);
    std::vector<Vec3> other = nearest_lattice_points(count, 0.5f, about_cell);
    const auto cell = static_cast<float>(std::sqrt(sites.area / count));
    for (Vec3 p : about_point <= about_cell ? points : other) sites.places.push_back({cell * p, {0, 1, 0}});
    return sites;
  }

  EmitterSites operator()(const RectangleOpening& o) const {
    EmitterSites sites;
    sites.area = double{o.width} * o.depth;
    check_size("RectangleOpening's area", sites.area, spacing);
    check_size("RectangleOpening's longer side, squared,",
               std::pow(std::max(double{o.width}, double{o.depth}), 2) / most_places, spacing);
    const auto [columns, rows] = divide(o.width, o.depth, spacing);
    for (int k = 0; k < rows; ++k) {
      for (int i = 0; i < columns; ++i) {
        const float x = (static_cast<float>(i) + 0.5f) / static_cast<float>(columns) - 0.5f;
        const float z = (static_cast<float>(k) + 0.5f) / static_cast<float>(rows) - 0.5f;
        sites.places.push_back({{o.width * x, 0, o.depth * z}, {0, 1, 0}});
      }
    }
    return sites;
  }

  EmitterSites operator()(const MeshOpening& o) const {
    const collision::TriangleMesh mesh = collision::load_mesh(collision::MeshSource::of(o, files));
    EmitterSites sites;
    sites.area = surface_area(mesh);
    check_size("MeshOpening's area", sites.area, spacing);
    for (const SurfaceSample& s : spread_samples(mesh, static_cast<uint32_t>(places_on(sites.area, spacing))))
      sites.places.push_back({s.position, s.normal});
    return sites;
  }
};

}  // namespace

EmitterSites emitter_sites(const EmitterOpening& opening, float spacing, const FileReader& files) {
  EmitterSites sites = std::visit(MakeSites{spacing, files}, opening);
  sites.layer = static_cast<double>(sites.places.size()) * spacing * spacing * spacing / sites.area;
  return sites;
}

}  // namespace meniscus
