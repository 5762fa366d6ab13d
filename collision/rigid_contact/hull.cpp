// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Makes hulls for contacts: chooses vertices, and unites triangles of one plane to faces.
#include "collision/rigid_contact/hull.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

#include "collision/mesh/hull.h"
#include "collision/rigid_contact/tuning.h"

namespace meniscus::collision {

namespace {

using Loop = std::vector<uint32_t>;
using Edge = std::pair<uint32_t, uint32_t>;

struct Plane {
  Vec3 normal;
  float offset;
};

Plane plane_of(const TriangleMesh& mesh, size_t triangle) {
  const auto& t = mesh.triangles[triangle];
  const Vec3 a = mesh.vertices[t[0]];
  const Vec3 n = cross(mesh.vertices[t[1]] - a, mesh.vertices[t[2]] - a);
  const Vec3 unit = normalized_or(n, {0, 0, 0});
  return {unit, dot(unit, a)};
}

/// m: how far p lies outside a hull.
float beyond(const std::vector<Plane>& planes, Vec3 p) {
  float most = -1e30f;
  for (const Plane& plane : planes) most = std::max(most, dot(plane.normal, p) - plane.offset);
  return most;
}

/// The hull of those of the points that stand out most, one after the other.
TriangleMesh reduced(const std::vector<Vec3>& points, float& error) {
  std::vector<Vec3> kept;
  for (const Vec3 d : {Vec3{1, 0, 0}, Vec3{-1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, -1, 0}, Vec3{0, 0, 1},
                       Vec3{0, 0, -1}, Vec3{1, 1, 1}}) {
    const auto further = [d](Vec3 a, Vec3 b) { return dot(d, a) < dot(d, b); };
    kept.push_back(*std::ranges::max_element(points, further));
  }
  size_t before = 0;
  while (true) {
    const std::optional<TriangleMesh> hull = find_hull(kept);
    if (!hull) {  // the first few may lie in a plane
      kept = std::vector<Vec3>(points.begin(),
                               points.begin() + std::min<ptrdiff_t>(static_cast<ptrdiff_t>(kept.size()) + 8,
                                                                    static_cast<ptrdiff_t>(points.size())));
      continue;
    }
    std::vector<Plane> planes;
    for (size_t t = 0; t < hull->triangles.size(); ++t) planes.push_back(plane_of(*hull, t));
    const auto nearer = [&](Vec3 a, Vec3 b) { return beyond(planes, a) < beyond(planes, b); };
    const Vec3 next = *std::ranges::max_element(points, nearer);
    error = std::max(0.0f, beyond(planes, next));
    // What lies outside by rounding alone may not become a vertex.
    const bool grows = hull->vertices.size() > before;
    before = hull->vertices.size();
    if (before >= most_hull_vertices || error == 0 || !grows) return *hull;
    kept = hull->vertices;
    kept.push_back(next);
  }
}

/// Numbers the triangles by faces: each one takes its neighbours whose corners lie in its plane, the largest
/// triangle first.
std::vector<uint32_t> faces_of(const TriangleMesh& mesh, float flatness) {
  const size_t count = mesh.triangles.size();
  std::map<Edge, uint32_t> owner;
  std::vector<float> area(count);
  for (uint32_t t = 0; t < count; ++t) {
    const auto& c = mesh.triangles[t];
    for (int k = 0; k < 3; ++k) owner[{c[k], c[(k + 1) % 3]}] = t;
    const Vec3 a = mesh.vertices[c[0]];
    area[t] = length(cross(mesh.vertices[c[1]] - a, mesh.vertices[c[2]] - a));
  }
  std::vector<uint32_t> order(count), face(count, ~0u);
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::stable_sort(order, [&](uint32_t a, uint32_t b) { return area[a] > area[b]; });
  for (const uint32_t seed : order) {
    if (face[seed] != ~0u) continue;
    const Plane plane = plane_of(mesh, seed);
    std::vector<uint32_t> waiting{seed};
    face[seed] = seed;
    while (!waiting.empty()) {
      const auto& c = mesh.triangles[waiting.back()];
      waiting.pop_back();
      for (int k = 0; k < 3; ++k) {
        const uint32_t next = owner.at({c[(k + 1) % 3], c[k]});
        const auto is_in_plane = [&](uint32_t v) {
          return std::fabs(dot(plane.normal, mesh.vertices[v]) - plane.offset) <= flatness;
        };
        if (face[next] != ~0u || !std::ranges::all_of(mesh.triangles[next], is_in_plane) ||
            dot(plane_of(mesh, next).normal, plane.normal) < 0)
          continue;
        face[next] = seed;
        waiting.push_back(next);
      }
    }
  }
  return face;
}

/// The corners of each face in order. Nothing if one has more than one outline.
std::optional<std::map<uint32_t, Loop>> loops_of(const TriangleMesh& mesh,
                                                 const std::vector<uint32_t>& face) {
  std::map<Edge, uint32_t> owner;
  for (uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& c = mesh.triangles[t];
    for (int k = 0; k < 3; ++k) owner[{c[k], c[(k + 1) % 3]}] = face[t];
  }
  std::map<uint32_t, std::map<uint32_t, uint32_t>> next;
  for (const auto& [edge, own] : owner) {
    if (owner.at({edge.second, edge.first}) == own) continue;
    if (!next[own].emplace(edge.first, edge.second).second) return std::nullopt;
  }
  std::map<uint32_t, Loop> loops;
  for (const auto& [own, follows] : next) {
    const uint32_t first = follows.begin()->first;
    Loop& loop = loops[own];
    for (uint32_t v = first; loop.empty() || v != first; v = follows.at(v)) {
      if (loop.size() > follows.size() || !follows.contains(v)) return std::nullopt;
      loop.push_back(v);
    }
    if (loop.size() != follows.size()) return std::nullopt;
  }
  return loops;
}

Vec3 normal_of(const std::vector<Vec3>& vertices, const Loop& loop) {
  Vec3 sum{0, 0, 0};
  for (size_t k = 1; k + 1 < loop.size(); ++k)
    sum += cross(vertices[loop[k]] - vertices[loop[0]], vertices[loop[k + 1]] - vertices[loop[0]]);
  return normalized_or(sum, {0, 1, 0});
}

void add_face(ContactHull& hull, Loop loop) {
  const Vec3 normal = normal_of(hull.vertices, loop);
  const auto further = [&](uint32_t a, uint32_t b) {
    return dot(normal, hull.vertices[a]) < dot(normal, hull.vertices[b]);
  };
  std::rotate(loop.begin(), std::ranges::max_element(loop, further), loop.end());
  hull.faces.push_back(
      {normal, static_cast<uint32_t>(hull.corners.size()), static_cast<uint32_t>(loop.size())});
  hull.corners.insert(hull.corners.end(), loop.begin(), loop.end());
}

void add_edges(ContactHull& hull) {
  std::map<Edge, uint32_t> left;
  for (uint32_t f = 0; f < hull.faces.size(); ++f) {
    const HullFace& face = hull.faces[f];
    for (uint32_t k = 0; k < face.count; ++k)
      left[{hull.corners[face.first + k], hull.corners[face.first + (k + 1) % face.count]}] = f;
  }
  for (const auto& [edge, f] : left) {
    if (edge.first < edge.second)
      hull.edges.push_back({edge.first, edge.second, f, left.at({edge.second, edge.first})});
  }
}

/// Takes the vertices that are corners of faces, and numbers them anew.
std::map<uint32_t, uint32_t> take_vertices(ContactHull& hull, const TriangleMesh& mesh,
                                           const std::map<uint32_t, Loop>& loops) {
  std::map<uint32_t, uint32_t> number;
  for (const auto& [own, loop] : loops)
    for (const uint32_t v : loop) number.emplace(v, 0);
  for (auto& [v, n] : number) {
    n = static_cast<uint32_t>(hull.vertices.size());
    hull.vertices.push_back(mesh.vertices[v]);
  }
  return number;
}

void centre(ContactHull& hull) {
  Aabb box{hull.vertices[0], hull.vertices[0]};
  for (const Vec3 v : hull.vertices) box = {min(box.lower, v), max(box.upper, v)};
  hull.centre = 0.5f * (box.lower + box.upper);
  hull.half = 0.5f * (box.upper - box.lower);
  for (Vec3& v : hull.vertices) {
    v -= hull.centre;
    hull.radius = std::max(hull.radius, length(v));
  }
}

}  // namespace

ContactHull make_contact_hull(std::span<const Vec3> points) {
  ContactHull hull;
  TriangleMesh mesh = hull_mesh(points);
  if (mesh.vertices.size() > most_hull_vertices) mesh = reduced(mesh.vertices, hull.error);
  const Aabb box = bounds(mesh);
  const float flatness = rigid_contact_tuning::hull_flatness * 0.5f * length(box.upper - box.lower);
  auto loops = loops_of(mesh, faces_of(mesh, flatness));
  if (!loops) {
    std::vector<uint32_t> each(mesh.triangles.size());
    std::iota(each.begin(), each.end(), 0u);
    loops = loops_of(mesh, each);
  }
  const std::map<uint32_t, uint32_t> number = take_vertices(hull, mesh, *loops);
  centre(hull);
  for (auto& [own, loop] : *loops) {
    for (uint32_t& v : loop) v = number.at(v);
    add_face(hull, loop);
  }
  add_edges(hull);
  return hull;
}

}  // namespace meniscus::collision
