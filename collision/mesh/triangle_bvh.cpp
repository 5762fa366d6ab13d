// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Builds the tree of boxes over the triangles of a mesh.
#include "collision/mesh/triangle_bvh.h"

#include <meniscus/error.h>

#include <algorithm>
#include <numeric>

namespace meniscus::collision {

namespace {

constexpr uint32_t leaf_size = 4;

Vec3 centroid(const Triangle& t) {
  return (t.a + t.b + t.c) / 3.0f;
}

float component(Vec3 v, int axis) {
  return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

int longest_axis(Vec3 extent) {
  if (extent.x >= extent.y && extent.x >= extent.z) return 0;
  return extent.y >= extent.z ? 1 : 2;
}

struct Moments {
  double area = 0;
  double first[3] = {};   // Σ a c
  double normal[3] = {};  // Σ a n
};

Moments moments_of(const Triangle* begin, const Triangle* end) {
  Moments m;
  for (const Triangle* t = begin; t != end; ++t) {
    const Vec3 n = 0.5f * area_normal(*t), c = centroid(*t);
    const double area = length(n);
    m.area += area;
    for (int k = 0; k < 3; ++k) {
      m.first[k] += area * component(c, k);
      m.normal[k] += component(n, k);
    }
  }
  return m;
}

FarField far_field_of(const Triangle* begin, const Triangle* end) {
  const Moments m = moments_of(begin, end);
  const auto mean = [&](int k) { return static_cast<float>(m.first[k] / m.area); };
  FarField far{};
  far.centre = m.area > 0 ? Vec3{mean(0), mean(1), mean(2)} : begin->a;
  far.dipole = {static_cast<float>(m.normal[0]), static_cast<float>(m.normal[1]),
                static_cast<float>(m.normal[2])};
  for (const Triangle* t = begin; t != end; ++t) {
    const Vec3 n = 0.5f * area_normal(*t), c = centroid(*t) - far.centre;
    far.diagonal += Vec3{c.x * n.x, c.y * n.y, c.z * n.z};
    far.mixed += Vec3{c.x * n.y + c.y * n.x, c.y * n.z + c.z * n.y, c.z * n.x + c.x * n.z};
    for (Vec3 corner : {t->a, t->b, t->c}) far.radius = std::max(far.radius, length(corner - far.centre));
  }
  return far;
}

Aabb box_of(const Triangle* begin, const Triangle* end) {
  Aabb box{begin->a, begin->a};
  for (const Triangle* t = begin; t != end; ++t) {
    box.lower = min(box.lower, min(t->a, min(t->b, t->c)));
    box.upper = max(box.upper, max(t->a, max(t->b, t->c)));
  }
  return box;
}

struct Sortable {
  Triangle triangle;
  uint32_t source;
};

// Splits a range at the median along the longest axis of its centroids. Equal values are ordered by number,
// so the result is unique.
void split_at_median(std::span<Sortable> range) {
  Vec3 lower = centroid(range[0].triangle), upper = lower;
  for (const Sortable& s : range) {
    lower = min(lower, centroid(s.triangle));
    upper = max(upper, centroid(s.triangle));
  }
  const int axis = longest_axis(upper - lower);
  const auto half = range.begin() + static_cast<std::ptrdiff_t>(range.size() / 2);
  std::nth_element(range.begin(), half, range.end(), [axis](const Sortable& s, const Sortable& t) {
    const float a = component(centroid(s.triangle), axis), b = component(centroid(t.triangle), axis);
    return a != b ? a < b : s.source < t.source;
  });
}

// Orders the triangles so that each subtree is a contiguous range.
void order(std::span<Sortable> range) {
  if (range.size() <= leaf_size) return;
  split_at_median(range);
  order(range.first(range.size() / 2));
  order(range.subspan(range.size() / 2));
}

std::vector<Sortable> ordered_triangles(const TriangleMesh& mesh) {
  std::vector<Sortable> list;
  for (const auto& t : mesh.triangles) {
    const Triangle triangle{mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]};
    list.push_back({triangle, static_cast<uint32_t>(list.size())});
  }
  order(list);
  return list;
}

template <class T>
pbd::View<const T> view_of(const std::vector<T>& list) {
  return {list.data(), static_cast<uint32_t>(list.size())};
}

template <class T>
void upload(pbd::Buffer<T>& buffer, const std::vector<T>& host) {
  buffer.resize_discard(static_cast<uint32_t>(host.size()));
  buffer.write(host);
}

}  // namespace

TriangleBvh::TriangleBvh(const TriangleMesh& mesh) {
  if (mesh.triangles.empty())
    throw Error(ErrorCode::mesh, "the mesh has no triangles: it needs at least one");
  for (const Sortable& s : ordered_triangles(mesh)) {
    triangles_.push_back(s.triangle);
    sources_.push_back(s.source);
  }
  build(0, static_cast<uint32_t>(triangles_.size()));
}

void TriangleBvh::build(uint32_t first, uint32_t count) {
  const Triangle* begin = triangles_.data() + first;
  const Aabb box = box_of(begin, begin + count);
  const bool leaf = count <= leaf_size;
  const size_t at = nodes_.size();
  nodes_.push_back({box.lower, box.upper, 0, first, leaf ? count : 0});
  far_fields_.push_back(far_field_of(begin, begin + count));
  if (!leaf) {
    build(first, count / 2);
    build(first + count / 2, count - count / 2);
  }
  nodes_[at].end = static_cast<uint32_t>(nodes_.size());
}

TriangleBvhView TriangleBvh::view() const {
  return {view_of(nodes_), view_of(far_fields_), view_of(triangles_), view_of(sources_)};
}

DeviceTriangleBvh::DeviceTriangleBvh(pbd::Device& device, const TriangleBvh& host)
    : bounds_(host.bounds()),
      nodes_(device, "nodes of a mesh's tree"),
      far_fields_(device, "far fields of a mesh's tree"),
      triangles_(device, "triangles of a mesh"),
      sources_(device, "triangle numbers of a mesh") {
  upload(nodes_, host.nodes());
  upload(far_fields_, host.far_fields());
  upload(triangles_, host.triangles());
  upload(sources_, host.sources());
  device.wait();  // the host's arrays may be freed from here on
}

TriangleBvhView DeviceTriangleBvh::view() const {
  return {nodes_.view(), far_fields_.view(), triangles_.view(), sources_.view()};
}

}  // namespace meniscus::collision
