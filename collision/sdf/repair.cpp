// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Repairs meshes on the host with one thread, so that all devices get the same surface.
#include "collision/sdf/repair.h"

#include <meniscus/error.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>
#include <unordered_map>
#include <utility>

#include "collision/mesh/defects.h"
#include "collision/mesh/triangle_bvh_query.h"
#include "collision/sdf/build.h"
#include "collision/sdf/tuning.h"
#include "pbd/device/cpu/cpu_device.h"
#include "pbd/marching_cubes.h"
#include "pbd/mesh_edges.h"

namespace meniscus::collision {

namespace {

using sdf_tuning::most_repair_points;

/// The surface where a field is 0, closed if all outer nodes are outside.
class Isosurface {
 public:
  Isosurface(const Lattice& nodes, const std::vector<float>& values) : nodes_(nodes), values_(values) {
    const std::vector<pbd::CubeTriangles> table = pbd::marching_cubes();
    for (uint32_t k = 0; k + 1 < nodes.nz; ++k) {
      for (uint32_t j = 0; j + 1 < nodes.ny; ++j) {
        for (uint32_t i = 0; i + 1 < nodes.nx; ++i) add_cell(i, j, k, table);
      }
    }
  }

  TriangleMesh mesh;

 private:
  /// On a surface that lies inside, the distance is −0.
  bool is_within(uint32_t at) const { return std::signbit(values_[at]); }
  uint32_t node(uint32_t i, uint32_t j, uint32_t k, uint32_t corner) const {
    return nodes_.index(i + (corner & 1), j + (corner >> 1 & 1), k + (corner >> 2));
  }

  void add_cell(uint32_t i, uint32_t j, uint32_t k, const std::vector<pbd::CubeTriangles>& table) {
    uint32_t inside = 0;
    for (uint32_t c = 0; c < 8; ++c) inside |= uint32_t{is_within(node(i, j, k, c))} << c;
    const pbd::CubeTriangles& cube = table[inside];
    for (uint32_t t = 0; t < cube.count; ++t) {
      std::array<uint32_t, 3> corners;
      for (uint32_t n = 0; n < 3; ++n) {
        const auto [low, axis] = pbd::cube_edge(cube.edges[3 * t + n]);
        corners[n] = vertex(node(i, j, k, low), node(i, j, k, low | 1u << axis), axis);
      }
      mesh.triangles.push_back(corners);
    }
  }

  uint32_t vertex(uint32_t from, uint32_t to, uint32_t axis) {
    const auto next = static_cast<uint32_t>(mesh.vertices.size());
    const auto [place, fresh] = numbers_.try_emplace(uint64_t{from} * 3 + axis, next);
    if (fresh) {
      // Never at a node, where the vertices of several edges would coincide.
      const float t = clamped(values_[from] / (values_[from] - values_[to]), sdf_tuning::off_node,
                              1 - sdf_tuning::off_node);
      const Vec3 a = nodes_.point(from), b = nodes_.point(to);
      mesh.vertices.push_back(a + t * (b - a));
    }
    return place->second;
  }

  const Lattice& nodes_;
  const std::vector<float>& values_;
  std::unordered_map<uint64_t, uint32_t> numbers_;
};

/// Triangles that close each hole by a fan around the mean of its vertices.
std::vector<std::array<Vec3, 3>> fans_over_holes(const TriangleMesh& mesh) {
  std::vector<pbd::EdgeUse> open;
  pbd::for_each_edge(pbd::edge_uses(mesh), [&](std::span<const pbd::EdgeUse> edge) {
    if (edge.size() == 1) open.push_back(edge[0]);
  });
  std::vector<uint32_t> parent(mesh.vertices.size());
  std::iota(parent.begin(), parent.end(), 0u);
  const auto root = [&](uint32_t v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  for (const pbd::EdgeUse& edge : open) parent[root(edge.low)] = root(edge.high);
  std::vector<Vec3> sum(mesh.vertices.size(), {0, 0, 0});
  std::vector<float> count(mesh.vertices.size());
  for (const pbd::EdgeUse& edge : open) {
    for (const uint32_t v : {edge.low, edge.high}) {
      sum[root(v)] += mesh.vertices[v];
      ++count[root(v)];
    }
  }
  std::vector<std::array<Vec3, 3>> fans;
  for (const pbd::EdgeUse& edge : open) {
    const Vec3 middle = sum[root(edge.low)] / count[root(edge.low)];
    const Vec3 low = mesh.vertices[edge.low], high = mesh.vertices[edge.high];
    fans.push_back({edge.forward ? high : low, edge.forward ? low : high, middle});
  }
  return fans;
}

/// The outer surface of a mesh: where its inside ends.
struct OuterSurface {
  double volume = 0;    ///< m³, inside; fans close the holes
  float deviation = 0;  ///< m, the largest distance to the repaired mesh
};

/// The pieces along a side into which a triangle is divided.
int pieces_of(const TriangleMesh& mesh, const std::array<uint32_t, 3>& t, float size) {
  const Vec3 a = mesh.vertices[t[0]], b = mesh.vertices[t[1]], c = mesh.vertices[t[2]];
  return std::max(
      1, static_cast<int>(std::ceil(std::max({length(b - a), length(c - a), length(c - b)}) / size)));
}

/// m, from a cell on: the size of pieces of which a mesh has no more than a grid has points.
float piece_size(const TriangleMesh& mesh, float cell_size) {
  for (float size = cell_size;; size *= 2) {
    double count = 0;
    for (const auto& t : mesh.triangles) count += std::pow(pieces_of(mesh, t, size), 2);
    if (count <= std::max<double>(most_repair_points, static_cast<double>(mesh.triangles.size())))
      return size;
  }
}

/// Each triangle is looked at in pieces, of a cell's size if there are not too many.
OuterSurface outer_surface(const TriangleMesh& mesh, const TriangleBvhView& bvh,
                           const TriangleBvhView& repaired, float cell_size) {
  OuterSurface outer;
  const float size = piece_size(mesh, cell_size);
  double outwards = 0;  // m², of triangles that face outwards less those that face inwards
  const Aabb box = bounds(mesh);
  const Vec3 centre = 0.5f * (box.lower + box.upper);
  const auto visit = [&](Vec3 p, Vec3 normal, float area) {
    const Vec3 step = sdf_tuning::beside_surface * cell_size * normal;
    const bool before = is_inside(bvh, p + step), behind = is_inside(bvh, p - step);
    if (before == behind) return;
    outwards += behind ? double{area} : -double{area};
    outer.volume += (behind ? 1 : -1) * double{dot(p - centre, normal)} * double{area} / 3;
    outer.deviation = std::max(outer.deviation, closest_point(repaired, p).distance);
  };
  for (const auto& t : mesh.triangles) {
    const Vec3 a = mesh.vertices[t[0]], ab = mesh.vertices[t[1]] - a, ac = mesh.vertices[t[2]] - a;
    const Vec3 twice_area = cross(ab, ac), normal = normalized_or(twice_area, {0, 1, 0});
    const int n = pieces_of(mesh, t, size);
    const float area = 0.5f * length(twice_area) / static_cast<float>(n * n);
    const auto visit_piece = [&](int i, int j, float third) {
      const float u = (static_cast<float>(i) + third) / static_cast<float>(n);
      const float v = (static_cast<float>(j) + third) / static_cast<float>(n);
      visit(a + u * ab + v * ac, normal, area);
    };
    for (int i = 0; i < n; ++i) {
      for (int j = 0; i + j < n; ++j) {
        visit_piece(i, j, 1.0f / 3);
        if (i + j + 1 < n) visit_piece(i, j, 2.0f / 3);
      }
    }
  }
  for (const auto& [a, b, c] : fans_over_holes(mesh)) {
    const double sixfold = double{dot(a - centre, cross(b - centre, c - centre))};
    outer.volume += (outwards < 0 ? -sixfold : sixfold) / 6;
  }
  return outer;
}

double points_in(const Aabb& box, float cell_size) {
  const Vec3 size = (box.upper - box.lower) / cell_size + Vec3{4, 4, 4};
  return double{size.x} * size.y * size.z;
}

[[noreturn]] void refuse(const std::string& what, const std::string& why) {
  throw Error(ErrorCode::mesh, what + " cannot be repaired: " + why);
}

RepairedMesh repaired_with(pbd::CpuDevice& device, const TriangleMesh& mesh, const TriangleBvh& bvh,
                           const DeviceTriangleBvh& device_bvh, float cell_size, const std::string& what) {
  const Sdf field = build_sdf(device, device_bvh, cell_size, cell_size);
  const std::vector<float> values = field.values().read(field.nodes().count());
  RepairedMesh result;
  result.mesh = std::move(Isosurface(field.nodes(), values).mesh);
  if (result.mesh.triangles.empty()) refuse(what, "it has no inside");
  result.volume = signed_volume(result.mesh);
  const TriangleBvh repaired(result.mesh);
  const OuterSurface outer = outer_surface(mesh, bvh.view(), repaired.view(), cell_size);
  result.volume_before = outer.volume;
  result.deviation = outer.deviation;
  return result;
}

}  // namespace

RepairedMesh repair_mesh(const TriangleMesh& mesh, float cell_size, const std::string& what) {
  const Aabb box = bounds(mesh);
  while (points_in(box, cell_size) > most_repair_points) cell_size *= 1.1f;
  pbd::CpuDevice device(1);
  const TriangleBvh bvh(mesh);
  const DeviceTriangleBvh device_bvh(device, bvh);
  for (float cell = cell_size;; cell *= 0.5f) {
    RepairedMesh result = repaired_with(device, mesh, bvh, device_bvh, cell, what);
    result.cell_size = cell_size;
    if (result.deviation <= cell_size) return result;
    if (cell > cell_size * sdf_tuning::finest_repair && points_in(box, 0.5f * cell) <= most_repair_points)
      continue;
    std::ostringstream why;
    why << "a wall is thinner than the smallest cells, " << cell << " m, and " << result.deviation
        << " m of it are lost";
    refuse(what, why.str());
  }
}

}  // namespace meniscus::collision
