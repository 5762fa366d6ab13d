// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Builds tethers from distances that fast marching finds along the surface.
#include "cloth/build/tethers.h"

#include <meniscus/error.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <string>
#include <tuple>

#include "cloth/build/rest_geometry.h"
#include "cloth/build/stretch.h"
#include "cloth/build/topology.h"

namespace meniscus::cloth {

namespace {

using Eigen::Vector3d;

constexpr double unreached = std::numeric_limits<double>::infinity();

// The distance to a vertex, and the held vertex that it is measured from.
struct Arrival {
  double distance = unreached;
  uint32_t source = none;
};

// Intersects a circle of radius `da` about a with a circle of radius `db` about b. The points are a distance
// `ab` apart on the x axis. Finds the intersection with negative y. Returns false if there is none.
bool meet(double ab, double da, double db, double& x, double& y) {
  x = (ab * ab + da * da - db * db) / (2 * ab);
  const double y2 = da * da - x * x;
  if (y2 < 0) return false;
  y = -std::sqrt(y2);
  return true;
}

// A triangle in its own plane: a at the origin, b on the x axis, c at (cx, cy) with cy > 0.
struct Flat {
  double ab, cx, cy;

  Flat(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
    const Vector3d side = b - a;
    ab = side.norm();
    cx = (c - a).dot(side) / ab;
    cy = (c - a).cross(side).norm() / ab;
  }

  /// The straight distance to c from the point at these distances from a and b, if the line crosses the side
  /// ab.
  double from_point(double da, double db) const {
    double x, y;
    if (!meet(ab, da, db, x, y)) return unreached;
    const double crossing = x + (cx - x) * -y / (cy - y);
    return crossing >= 0 && crossing <= ab ? std::hypot(cx - x, cy - y) : unreached;
  }
};

// Departs from the fast marching of Kimmel & Sethian in three ways. First, the front is a circle about the
// unfolded position of the held vertex (Novotni & Klein 2002), and not a straight line. That is exact on a
// flat sheet. Second, a vertex is visited again when a later one shortens its path, so that obtuse triangles
// need no splitting. Third, no distance is less than the straight distance to the held vertex. Where the
// fronts of two held vertices meet, the circle gives too short a distance. On a flat sheet the third rule
// corrects this. On a folded sheet single vertices there come out too near, by up to a few per cent.
class Marching {
 public:
  explicit Marching(const ClothMesh& mesh) : mesh_(mesh), around_(mesh), arrivals_(mesh.vertices.size()) {}

  std::vector<Arrival> from(std::span<const uint32_t> held) {
    for (uint32_t v : held) reach(v, {0, v});
    while (!front_.empty()) {
      const auto [distance, v] = front_.top();
      front_.pop();
      if (distance > arrivals_[v].distance) continue;  // visited again since
      for (uint32_t t : around_.of(v)) spread(t);
    }
    return std::move(arrivals_);
  }

 private:
  Vector3d place(uint32_t v) const { return to_double(mesh_.vertices[v]); }

  void spread(uint32_t triangle) {
    const auto& t = mesh_.triangles[triangle];
    for (int k = 0; k < 3; ++k) update(t[k], t[(k + 1) % 3], t[(k + 2) % 3]);
  }

  /// Updates c if the path through the triangle (a, b, c) is shorter.
  void update(uint32_t a, uint32_t b, uint32_t c) {
    const Arrival &at_a = arrivals_[a], &at_b = arrivals_[b];
    if (std::min(at_a.distance, at_b.distance) >= arrivals_[c].distance) return;
    const Vector3d pa = place(a), pb = place(b), pc = place(c);
    Arrival best = arrivals_[c];
    const auto offer = [&](double distance, uint32_t source) {
      if (source == none || distance == unreached) return;
      distance = std::max(distance, (pc - place(source)).norm());
      if (distance < best.distance) best = {distance, source};
    };
    offer(at_a.distance + (pc - pa).norm(), at_a.source);
    offer(at_b.distance + (pc - pb).norm(), at_b.source);
    if (at_a.source != none && at_b.source != none) {
      const double through = Flat(pa, pb, pc).from_point(at_a.distance, at_b.distance);
      offer(through, at_a.source);
      offer(through, at_b.source);
    }
    constexpr double worth_it = 1 - 1e-7;  // rounding must not cause endless visits
    if (best.distance < worth_it * arrivals_[c].distance) reach(c, best);
  }

  void reach(uint32_t v, Arrival arrival) {
    arrivals_[v] = arrival;
    front_.push({arrival.distance, v});
  }

  using Entry = std::pair<double, uint32_t>;

  const ClothMesh& mesh_;
  VertexTriangles around_;
  std::vector<Arrival> arrivals_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front_;
};

// The compliance of strips of fabric.
class Strips {
 public:
  Strips(const ClothMesh& mesh, const FabricParameters& fabric)
      : mesh_(mesh), fabric_(fabric), around_(mesh), triangles_(triangles_at_rest(mesh)) {}

  /// m/N, along the straight line from `anchor` to v, with the area that v represents.
  float compliance(uint32_t anchor, uint32_t v, double length) const {
    const Vector3d displacement = to_double(mesh_.vertices[v]) - to_double(mesh_.vertices[anchor]);
    double area = 0, cos2 = 0;
    for (uint32_t k : around_.of(v)) {
      const TriangleAtRest& t = triangles_[k];
      const double cosine = (displacement - displacement.dot(t.normal) * t.normal).normalized().dot(t.warp);
      area += t.area / 3;
      cos2 += cosine * cosine / static_cast<double>(around_.of(v).size());
    }
    const double compliance = length * length / area * yield_along(cos2, fabric_);
    return static_cast<float>(std::min(compliance, most_compliance));
  }

 private:
  const ClothMesh& mesh_;
  const FabricParameters& fabric_;
  VertexTriangles around_;
  std::vector<TriangleAtRest> triangles_;
};

}  // namespace

std::vector<Tether> build_tethers(const ClothMesh& mesh, std::span<const uint32_t> held,
                                  const FabricParameters& fabric) {
  for (uint32_t v : held) {
    if (v < mesh.vertices.size()) continue;
    throw Error(ErrorCode::invalid_argument, "vertex " + std::to_string(v) +
                                                 " of a cloth is held, but there are " +
                                                 std::to_string(mesh.vertices.size()));
  }
  const std::vector<Arrival> arrivals = Marching(mesh).from(held);
  const Strips strips(mesh, fabric);
  std::vector<Tether> tethers;
  for (uint32_t v = 0; v < arrivals.size(); ++v) {
    const Arrival& a = arrivals[v];
    if (a.source == none || a.source == v) continue;
    tethers.push_back(
        {v, a.source, static_cast<float>(a.distance), strips.compliance(a.source, v, a.distance)});
  }
  std::stable_sort(tethers.begin(), tethers.end(),
                   [](const Tether& a, const Tether& b) { return a.anchor < b.anchor; });
  return tethers;
}

std::vector<Tether> tethers_beside(const Chains& chains, const ClothModel& model) {
  const size_t vertices = model.rest.size();
  std::vector<bool> held(vertices), ends_free(vertices), holds(vertices);
  for (uint32_t v : model.held) held[v] = true;
  for (const Chain& chain : chains.chains) {
    const std::span edges = std::span(chains.edges).subspan(chain.first, chain.count);
    const bool leads = held[edges.front().a] ||
                       std::ranges::any_of(edges, [&](const EdgeConstraint& e) { return held[e.b]; });
    std::vector<bool>& kind = leads ? holds : ends_free;
    kind[edges.front().a] = true;
    for (const EdgeConstraint& e : edges) kind[e.b] = true;
  }
  std::vector<Tether> tethers = model.tethers;
  for (Tether& t : tethers) {
    if (!ends_free[t.vertex] || holds[t.vertex]) t.self_mass = 0;
  }
  return tethers;
}

}  // namespace meniscus::cloth
