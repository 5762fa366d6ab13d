// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Orders triangles for the tree by recursive bisection.
#include "pbd/surface_tree/order.h"

#include <algorithm>
#include <numeric>

#include "pbd/surface_tree/boxes.h"

namespace meniscus::pbd {

namespace {

using Place = std::vector<uint32_t>::iterator;

/// Bisects a run of triangles along its longest side, down to groups of eight. A Morton curve would be as
/// fast, but its groups are less compact where a mesh is not a grid of 2ⁿ.
class Halving {
 public:
  explicit Halving(const std::vector<Vec3>& centroids) : centroids_(centroids) {}

  void run(Place begin, Place end) const {
    const auto count = static_cast<size_t>(end - begin);
    if (count <= BoxGroup::size) return;
    const Place middle = begin + static_cast<std::ptrdiff_t>(first_half(count));
    const int axis = longest_axis(begin, end);
    std::nth_element(begin, middle, end, [&](uint32_t a, uint32_t b) {
      const float x = component(centroids_[a], axis), y = component(centroids_[b], axis);
      return x < y || (x == y && a < b);
    });
    run(begin, middle);
    run(middle, end);
  }

 private:
  /// About half, in whole groups of the highest level that is not too coarse for it.
  static size_t first_half(size_t count) {
    size_t unit = BoxGroup::size;
    while (unit * BoxGroup::size <= count / 4) unit *= BoxGroup::size;
    return std::max(unit, (count / 2 + unit / 2) / unit * unit);
  }

  int longest_axis(Place begin, Place end) const {
    Aabb box = empty_box;
    for (Place t = begin; t != end; ++t) box = joined(box, {centroids_[*t], centroids_[*t]});
    const Vec3 size = box.upper - box.lower;
    return size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  }

  static float component(Vec3 v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

  const std::vector<Vec3>& centroids_;
};

}  // namespace

std::vector<uint32_t> tree_order(std::span<const SurfaceTriangle> triangles,
                                 std::span<const Vec3> positions) {
  std::vector<Vec3> centroids;
  centroids.reserve(triangles.size());
  for (const SurfaceTriangle& t : triangles)
    centroids.push_back((positions[t.a] + positions[t.b] + positions[t.c]) / 3);
  std::vector<uint32_t> numbers(triangles.size());
  std::iota(numbers.begin(), numbers.end(), 0u);
  std::stable_sort(numbers.begin(), numbers.end(),
                   [&](uint32_t a, uint32_t b) { return triangles[a].piece < triangles[b].piece; });

  std::vector<uint32_t> order;
  order.reserve(numbers.size());
  const Halving halving(centroids);
  for (Place begin = numbers.begin(); begin != numbers.end();) {
    const uint32_t piece = triangles[*begin].piece;
    const Place end =
        std::find_if(begin, numbers.end(), [&](uint32_t t) { return triangles[t].piece != piece; });
    halving.run(begin, end);
    order.insert(order.end(), begin, end);
    while (order.size() % BoxGroup::size != 0) order.push_back(no_index);
    begin = end;
  }
  return order;
}

}  // namespace meniscus::pbd
