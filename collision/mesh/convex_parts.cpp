// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Cuts a solid into parts that are nearly convex.
#include "collision/mesh/convex_parts.h"

#include <meniscus/error.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "collision/mesh/box_clip.h"
#include "collision/mesh/hull.h"
#include "collision/mesh/triangle_bvh.h"
#include "collision/mesh/triangle_bvh_query.h"
#include "collision/mesh/tuning.h"
#include "pbd/math/vec.h"

namespace meniscus::collision {

namespace {

using mesh_tuning::cells_an_axis;

Vec3 rounded(const Double3& p) {
  return {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])};
}

/// The outermost of the points that are added, in 26 directions.
class Supports {
 public:
  void add(const Double3& p) {
    for (size_t d = 0; d < points_.size(); ++d) keep_higher(d, height_of(d, p), p);
    any_ = true;
  }
  void add(const Supports& other) {
    if (!other.any_) return;
    for (size_t d = 0; d < points_.size(); ++d) keep_higher(d, other.heights_[d], other.points_[d]);
    any_ = true;
  }
  /// m³, of the hull of these points.
  double volume() const {
    if (!any_) return 0;
    std::array<Vec3, 26> points;
    std::transform(points_.begin(), points_.end(), points.begin(), rounded);
    const std::optional<TriangleMesh> hull = find_hull(points);
    return hull ? signed_volume(*hull) : 0;
  }
  bool any() const { return any_; }

 private:
  static double height_of(size_t d, const Double3& p) {
    const auto n = static_cast<int>(d < 13 ? d : d + 1);  // the middle of 27 is none
    return (n % 3 - 1) * p[0] + (n / 3 % 3 - 1) * p[1] + (n / 9 - 1) * p[2];
  }
  void keep_higher(size_t d, double height, const Double3& p) {
    if (any_ && height <= heights_[d]) return;
    heights_[d] = height;
    points_[d] = p;
  }

  bool any_ = false;
  std::array<double, 26> heights_{};
  std::array<Double3, 26> points_{};
};

/// A range of cells along each axis.
struct CellRange {
  std::array<size_t, 3> begin, end;
};
constexpr CellRange whole_range{{0, 0, 0}, {cells_an_axis, cells_an_axis, cells_an_axis}};

std::pair<CellRange, CellRange> divided(const CellRange& range, size_t axis, size_t at) {
  CellRange low = range, high = range;
  low.end[axis] = high.begin[axis] = at;
  return {low, high};
}

/// The outermost points in each of the equal cells of a box.
class CellGrid {
 public:
  explicit CellGrid(const DoubleBox& box) : box_(box) {}

  double plane(size_t axis, size_t k) const {
    const double t = static_cast<double>(k) / cells_an_axis;
    return box_.lower[axis] + (box_.upper[axis] - box_.lower[axis]) * t;
  }

  /// Divides a polygon among the cells along an axis and the next ones.
  void add(const ClippedPolygon& polygon, size_t axis, size_t first) {
    if (axis == 3) {
      for (int i = 0; i < polygon.count(); ++i) cells_[first].add(polygon[i]);
      return;
    }
    for (size_t k = 0; k < cells_an_axis; ++k) {
      double low = polygon[0][axis], high = low;
      for (int i = 1; i < polygon.count(); ++i) {
        low = std::min(low, polygon[i][axis]);
        high = std::max(high, polygon[i][axis]);
      }
      if (low > plane(axis, k + 1) || high < plane(axis, k)) continue;
      ClippedPolygon piece = polygon;
      piece.cut(static_cast<int>(axis), plane(axis, k), 1);
      piece.cut(static_cast<int>(axis), plane(axis, k + 1), -1);
      if (piece.count() > 0) add(piece, axis + 1, first * cells_an_axis + k);
    }
  }

  /// Adds the corners of cells that are solid.
  template <class IsSolid>
  void add_corners(const IsSolid& is_solid) {
    constexpr size_t n = cells_an_axis;
    for (size_t i = 0; i < (n + 1) * (n + 1) * (n + 1); ++i) {
      const std::array<size_t, 3> node{i / (n + 1) / (n + 1), i / (n + 1) % (n + 1), i % (n + 1)};
      const Double3 p{plane(0, node[0]), plane(1, node[1]), plane(2, node[2])};
      if (!is_solid(p)) continue;
      for (size_t c = 0; c < 8; ++c) {
        const size_t x = node[0] - (c & 1), y = node[1] - (c >> 1 & 1), z = node[2] - (c >> 2);
        if (x < n && y < n && z < n) cells_[(x * n + y) * n + z].add(p);  // −1 is beyond n, too
      }
    }
  }

  double volume(const CellRange& range) const {
    Supports all;
    for (size_t x = range.begin[0]; x < range.end[0]; ++x) {
      for (size_t y = range.begin[1]; y < range.end[1]; ++y) {
        for (size_t z = range.begin[2]; z < range.end[2]; ++z)
          all.add(cells_[(x * cells_an_axis + y) * cells_an_axis + z]);
      }
    }
    return all.volume();
  }

  /// The least that both halves have after a cut through the middle.
  double volume_once_divided(const CellRange& range) const {
    double least = std::numeric_limits<double>::infinity();
    for (size_t axis = 0; axis < 3; ++axis) {
      const auto [low, high] = divided(range, axis, (range.begin[axis] + range.end[axis]) / 2);
      least = std::min(least, volume(low) + volume(high));
    }
    return least;
  }

 private:
  DoubleBox box_;
  std::vector<Supports> cells_{cells_an_axis * cells_an_axis * cells_an_axis};
};

struct Part {
  DoubleBox box;
  TriangleMesh hull;
  double excess;  ///< m³
};

class Cutter {
 public:
  explicit Cutter(const TriangleMesh& mesh) : mesh_(mesh), bvh_(mesh) {
    const Aabb box = bounds(mesh);
    whole_ = {{double{box.lower.x}, double{box.lower.y}, double{box.lower.z}},
              {double{box.upper.x}, double{box.upper.y}, double{box.upper.z}}};
  }

  std::optional<Part> whole() const { return part_in(whole_); }

  /// Both halves of a part, less what has no volume.
  std::vector<Part> halves(const Part& part) const {
    const Cut cut = best_cut(part.box);
    DoubleBox low = part.box, high = part.box;
    low.upper[cut.axis] = high.lower[cut.axis] = cut.at;
    std::vector<Part> halves;
    for (const DoubleBox& box : {low, high}) {
      if (std::optional<Part> half = part_in(box)) halves.push_back(std::move(*half));
    }
    return halves;
  }

 private:
  struct Cut {
    size_t axis;
    double at;
  };

  bool is_solid(const Double3& p) const { return is_inside(bvh_.view(), rounded(p)); }

  static Double3 corner(const DoubleBox& box, size_t c) {
    return {c & 1 ? box.upper[0] : box.lower[0], c & 2 ? box.upper[1] : box.lower[1],
            c & 4 ? box.upper[2] : box.lower[2]};
  }

  /// Calls visit(polygon) for what the box holds of each triangle.
  template <class Visit>
  void for_each_polygon(const DoubleBox& box, const Visit& visit) const {
    for (const auto& t : mesh_.triangles) {
      if (are_apart(mesh_, t, box)) continue;
      ClippedPolygon polygon(mesh_, t);
      polygon.cut(box);
      if (polygon.count() > 0) visit(polygon);
    }
  }

  /// The part in a box. All its corners are corners of clipped triangles, or of the box.
  std::optional<Part> part_in(const DoubleBox& box) const {
    std::vector<Vec3> points;
    for_each_polygon(box, [&](const ClippedPolygon& polygon) {
      for (int i = 0; i < polygon.count(); ++i) points.push_back(rounded(polygon[i]));
    });
    for (size_t c = 0; c < 8; ++c) {
      if (is_solid(corner(box, c))) points.push_back(rounded(corner(box, c)));
    }
    std::optional<TriangleMesh> hull = find_hull(points);
    if (!hull) return std::nullopt;
    const double excess = signed_volume(*hull) - volume_within(mesh_, box);
    return Part{box, std::move(*hull), excess};
  }

  /// The cut after which one more through the middle of each side leaves the least. A single cut of a ring
  /// leaves as much as none.
  Cut best_cut(const DoubleBox& box) const {
    const CellGrid cells = cells_of(box);
    Cut best{0, 0.5 * (box.lower[0] + box.upper[0])};
    double least = std::numeric_limits<double>::infinity();
    for (size_t axis = 0; axis < 3; ++axis) {
      for (size_t k = 1; k < cells_an_axis; ++k) {
        const auto [low, high] = divided(whole_range, axis, k);
        const double in_low = cells.volume(low), in_high = cells.volume(high);
        if (in_low == 0 && in_high == 0) continue;
        const double cost = std::min(in_low, cells.volume_once_divided(low)) +
                            std::min(in_high, cells.volume_once_divided(high)) +
                            mesh_tuning::balance * std::abs(in_low - in_high);
        if (cost < least) least = cost, best = {axis, cells.plane(axis, k)};
      }
    }
    return best;
  }

  /// What the box holds, by cell: corners of the triangles that the cells cut, and the cells' own corners.
  CellGrid cells_of(const DoubleBox& box) const {
    CellGrid cells(box);
    for_each_polygon(box, [&](const ClippedPolygon& polygon) { cells.add(polygon, 0, 0); });
    cells.add_corners([&](const Double3& p) { return is_solid(p); });
    return cells;
  }

  const TriangleMesh& mesh_;
  TriangleBvh bvh_;
  DoubleBox whole_;
};

}  // namespace

ConvexParts convex_parts(const TriangleMesh& mesh, int most) {
  const Cutter cutter(mesh);
  std::optional<Part> whole = cutter.whole();
  if (!whole) throw Error(ErrorCode::mesh, "a mesh without volume has no convex parts");
  const double enough = mesh_tuning::most_excess * signed_volume(whole->hull);
  std::vector<Part> parts;
  parts.push_back(std::move(*whole));
  const auto exceeds_less = [](const Part& a, const Part& b) { return a.excess < b.excess; };
  while (parts.size() < static_cast<size_t>(most)) {
    const auto worst = std::max_element(parts.begin(), parts.end(), exceeds_less);
    if (worst->excess <= enough) break;
    std::vector<Part> halves = cutter.halves(*worst);
    if (halves.empty()) break;
    *worst = std::move(halves.front());
    if (halves.size() > 1) parts.push_back(std::move(halves.back()));
  }
  ConvexParts result;
  for (Part& part : parts) {
    result.excess += std::max(part.excess, 0.0);
    result.hulls.push_back(std::move(part.hull));
  }
  return result;
}

}  // namespace meniscus::collision
