// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Makes the triangles of films.
#include "collision/film/film_surface.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>

#include "collision/film/tuning.h"
#include "collision/mesh/triangle.h"

namespace meniscus::collision {

namespace {

using Edge = std::pair<uint32_t, uint32_t>;

Triangle corners_of(const TriangleMesh& mesh, const std::array<uint32_t, 3>& t) {
  return {mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]};
}

double area_of(const TriangleMesh& mesh) {
  double sum = 0;
  for (const auto& t : mesh.triangles) sum += 0.5 * double{length(area_normal(corners_of(mesh, t)))};
  return sum;
}

/// The surface that a profile in the xy plane, from the top to the bottom of the axis, sweeps around y.
TriangleMesh revolved(std::span<const Vec3> profile, float radius, float edge) {
  const float around = 2 * std::numbers::pi_v<float> * radius / edge;
  const auto sides = static_cast<uint32_t>(std::clamp(std::ceil(around), 8.0f, 256.0f));
  TriangleMesh mesh;
  mesh.vertices = {profile.front(), profile.back()};
  for (const Vec3& p : profile.subspan(1, profile.size() - 2)) {
    for (uint32_t k = 0; k < sides; ++k) {
      const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(k) / static_cast<float>(sides);
      mesh.vertices.push_back({p.x * std::cos(angle), p.y, p.x * std::sin(angle)});
    }
  }
  const auto rings = static_cast<uint32_t>(profile.size()) - 2;
  const auto at = [&](uint32_t ring, uint32_t k) { return 2 + ring * sides + k % sides; };
  for (uint32_t k = 0; k < sides; ++k) {
    mesh.triangles.push_back({0, at(0, k + 1), at(0, k)});
    mesh.triangles.push_back({1, at(rings - 1, k), at(rings - 1, k + 1)});
    for (uint32_t r = 0; r + 1 < rings; ++r) {
      mesh.triangles.push_back({at(r, k), at(r, k + 1), at(r + 1, k)});
      mesh.triangles.push_back({at(r, k + 1), at(r + 1, k + 1), at(r + 1, k)});
    }
  }
  return mesh;
}

/// Merges the vertices in each cell of a lattice, where edges are much shorter than its cells.
TriangleMesh merged(const TriangleMesh& mesh, float cell) {
  std::map<std::array<int64_t, 3>, uint32_t> numbers;
  std::vector<uint32_t> number, members;
  TriangleMesh out;
  for (const Vec3& v : mesh.vertices) {
    const auto along = [&](float x) { return static_cast<int64_t>(std::floor(x / cell)); };
    const auto [entry, is_new] =
        numbers.try_emplace({along(v.x), along(v.y), along(v.z)}, static_cast<uint32_t>(out.vertices.size()));
    if (is_new) out.vertices.push_back({0, 0, 0}), members.push_back(0);
    number.push_back(entry->second);
    out.vertices[entry->second] = out.vertices[entry->second] + v;
    ++members[entry->second];
  }
  for (size_t k = 0; k < members.size(); ++k)
    out.vertices[k] = (1 / static_cast<float>(members[k])) * out.vertices[k];
  for (const auto& [a, b, c] : mesh.triangles) {
    const uint32_t i = number[a], j = number[b], k = number[c];
    if (i != j && j != k && k != i) out.triangles.push_back({i, j, k});
  }
  return out;
}

/// Halves all edges that are longer than `edge`, and divides their triangles.
class Halving {
 public:
  Halving(TriangleMesh& mesh, float edge) : mesh_(mesh), edge_(edge) {}

  /// Whether there were any.
  bool run() {
    std::vector<std::array<uint32_t, 3>> before;
    before.swap(mesh_.triangles);
    for (const auto& t : before) divide(t);
    return !middles_.empty();
  }

 private:
  uint32_t middle(uint32_t a, uint32_t b) {
    const Vec3 p = mesh_.vertices[a], q = mesh_.vertices[b];
    if (!(length(p - q) > edge_)) return no_middle;
    const auto [entry, is_new] = middles_.try_emplace(Edge{std::min(a, b), std::max(a, b)},
                                                      static_cast<uint32_t>(mesh_.vertices.size()));
    if (is_new) mesh_.vertices.push_back(0.5f * (p + q));
    return entry->second;
  }
  /// Cuts from the corner opposite of an edge's middle, once or twice, or into four.
  void divide(std::array<uint32_t, 3> t) {
    std::array<uint32_t, 3> m{middle(t[0], t[1]), middle(t[1], t[2]), middle(t[2], t[0])};
    const auto halved = std::count_if(m.begin(), m.end(), [](uint32_t k) { return k != no_middle; });
    const auto add = [&](uint32_t a, uint32_t b, uint32_t c) { mesh_.triangles.push_back({a, b, c}); };
    if (halved == 0) return add(t[0], t[1], t[2]);
    // Turned until the first edge is halved, and of two, the first two.
    while (m[0] == no_middle || (halved == 2 && m[1] == no_middle)) {
      std::rotate(t.begin(), t.begin() + 1, t.end());
      std::rotate(m.begin(), m.begin() + 1, m.end());
    }
    if (halved == 1) return add(t[0], m[0], t[2]), add(m[0], t[1], t[2]);
    add(m[0], t[1], m[1]);
    if (halved == 3) return add(t[0], m[0], m[2]), add(m[1], t[2], m[2]), add(m[0], m[1], m[2]);
    const float across = length(mesh_.vertices[t[0]] - mesh_.vertices[m[1]]);
    if (across < length(mesh_.vertices[m[0]] - mesh_.vertices[t[2]]))
      return add(t[0], m[0], m[1]), add(t[0], m[1], t[2]);
    add(t[0], m[0], t[2]), add(m[0], m[1], t[2]);
  }

  static constexpr uint32_t no_middle = ~0u;
  TriangleMesh& mesh_;
  float edge_;
  std::map<Edge, uint32_t> middles_;
};

/// Half the cotangent of the angle at `tip`.
float half_cotangent(Vec3 tip, Vec3 a, Vec3 b) {
  const Vec3 u = a - tip, v = b - tip;
  return 0.5f * dot(u, v) / std::max(length(cross(u, v)), 1e-30f);
}

void list_corners(FilmSurfaces& all) {
  std::vector<uint32_t> place(all.vertices.size() + 1, 0);
  for (const FilmTriangle& t : all.triangles)
    for (uint32_t v : t.corner) ++place[v + 1];
  std::partial_sum(place.begin(), place.end(), place.begin());
  all.first_corner = place;
  all.corners.resize(3 * all.triangles.size());
  for (uint32_t n = 0; n < all.triangles.size(); ++n) {
    const auto& c = all.triangles[n].corner;
    for (uint32_t k = 0; k < 3; ++k) {
      const uint32_t v = c[k], a = c[(k + 1) % 3], b = c[(k + 2) % 3];
      const Vec3 pv = all.vertices[v], pa = all.vertices[a], pb = all.vertices[b];
      all.corners[place[v]++] = {n, {a, b}, {half_cotangent(pb, pv, pa), half_cotangent(pa, pv, pb)}};
    }
  }
}

void rank_bodies(FilmSurfaces& all) {
  std::vector<double> size(all.bodies.size(), 0);
  std::vector<uint32_t> order(all.bodies.size());
  std::iota(order.begin(), order.end(), 0u);
  for (const FilmTriangle& t : all.triangles) size[t.body] += double{length(t.area)};
  std::stable_sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) { return size[a] < size[b]; });
  for (uint32_t k = 0; k < order.size(); ++k) all.bodies[order[k]].rank = k;
}

}  // namespace

TriangleMesh box_surface_mesh(Vec3 half) {
  TriangleMesh mesh;
  for (uint32_t k = 0; k < 8; ++k)
    mesh.vertices.push_back({k & 1 ? half.x : -half.x, k & 2 ? half.y : -half.y, k & 4 ? half.z : -half.z});
  mesh.triangles = {{0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}};
  return mesh;
}

TriangleMesh capsule_surface_mesh(float radius, float half_height, float edge) {
  const float quarter = 0.5f * std::numbers::pi_v<float>;
  const auto arcs = static_cast<int>(std::clamp(std::ceil(quarter * radius / edge), 2.0f, 64.0f));
  std::vector<Vec3> profile;
  for (int side : {1, -1}) {
    for (int k = 0; k <= arcs; ++k) {
      const int step = side > 0 ? k : arcs - k;
      if (side < 0 && k == 0 && half_height == 0) continue;  // a ball's equator is there already
      const float angle = quarter * static_cast<float>(step) / static_cast<float>(arcs);
      const float x = step == 0 ? 0 : radius * std::sin(angle);
      profile.push_back({x, static_cast<float>(side) * (half_height + radius * std::cos(angle)), 0});
    }
  }
  return revolved(profile, radius, edge);
}

TriangleMesh cylinder_surface_mesh(float radius, float half_height, float edge) {
  const Vec3 profile[] = {
      {0, half_height, 0}, {radius, half_height, 0}, {radius, -half_height, 0}, {0, -half_height, 0}};
  return revolved(profile, radius, edge);
}

TriangleMesh film_mesh(TriangleMesh mesh, float edge) {
  // Halving leaves edges of 0.7 of the longest on average, so triangles of about a quarter of its square.
  const auto finest = static_cast<float>(std::sqrt(4 * area_of(mesh) / film_tuning::most_triangles));
  const float longest = std::max(edge, finest);
  if (static_cast<double>(mesh.triangles.size()) * double{longest * longest} > 16 * area_of(mesh))
    mesh = merged(mesh, longest);
  while (mesh.triangles.size() < 2 * film_tuning::most_triangles && Halving(mesh, longest).run()) {
  }
  return mesh;
}

FilmSurfaces join_film_parts(std::span<const FilmPart> parts, uint32_t bodies) {
  FilmSurfaces all;
  all.bodies.resize(bodies);
  for (const FilmPart& part : parts) {
    FilmRange& range = all.bodies[part.body];
    const auto first = static_cast<uint32_t>(all.vertices.size());
    if (range.triangle_end == 0) range = {first, first, static_cast<uint32_t>(all.triangles.size()), 0, 0};
    for (const Vec3& v : part.mesh->vertices) all.vertices.push_back(to_world(part.pose, v));
    for (const auto& [a, b, c] : part.mesh->triangles) {
      const Triangle t{all.vertices[first + a], all.vertices[first + b], all.vertices[first + c]};
      all.triangles.push_back({{first + a, first + b, first + c},
                               part.body,
                               part.shape,
                               (1.0f / 3) * (t.a + t.b + t.c),
                               0.5f * area_normal(t)});
    }
    range.vertex_end = static_cast<uint32_t>(all.vertices.size());
    range.triangle_end = static_cast<uint32_t>(all.triangles.size());
  }
  list_corners(all);
  rank_bodies(all);
  return all;
}

}  // namespace meniscus::collision
