// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The kernels that sample the scalar field and extract its level set as triangles.
#pragma once

#include "fluid/surface/surface_mesh.h"
#include "fluid/surface/tuning.h"

namespace meniscus::fluid::surface_kernels {

using pbd::View;

/// The unit of the integers in which the field is summed.
inline constexpr float field_unit = 1.0f / (1 << 20);

/// An ellipsoid's contribution to the field, with lengths in cells: u² = a x² + … of the offset from its
/// centre.
struct Splat {
  Vec3 centre, extent;  ///< half of its box
  float xx, yy, zz, xy, xz, yz;
  float weight;  ///< in units of the field; 0: it does not count
};

MENISCUS_HD inline Splat splat_of(const Ellipsoid& e, const SurfaceField& field) {
  Splat s{};
  const float scale = field.reach / field.cell;
  const Vec3 r = scale * e.radii;
  const Vec3 centre = e.centre / field.cell;
  const Vec3 axes[] = {rotate(e.rotation, {1, 0, 0}), rotate(e.rotation, {0, 1, 0}),
                       rotate(e.rotation, {0, 0, 1})};
  const float radii[] = {r.x, r.y, r.z};
  Vec3 extent2{0, 0, 0};
  for (int k = 0; k < 3; ++k) {
    const Vec3 n = axes[k];
    const float r2 = radii[k] * radii[k], w = 1 / r2;
    s.xx += w * n.x * n.x;
    s.yy += w * n.y * n.y;
    s.zz += w * n.z * n.z;
    s.xy += w * n.x * n.y;
    s.xz += w * n.x * n.z;
    s.yz += w * n.y * n.z;
    extent2 += r2 * Vec3{n.x * n.x, n.y * n.y, n.z * n.z};
  }
  s.centre = centre;
  s.extent = {sqrtf(extent2.x), sqrtf(extent2.y), sqrtf(extent2.z)};
  constexpr float limit = 2.0f * most_blocks_out;  // in nodes, half of what blocks hold
  const float furthest = max_component(abs(centre) + s.extent);
  const float volume = e.radii.x * e.radii.y * e.radii.z;
  if (furthest < limit && volume > 0)  // false if a number is not finite
    s.weight = field.weight / field_unit * powf(field.unit_volume / volume, field.power);
  return s;
}

/// The nodes inside a splat's box, along an axis.
struct NodeRange {
  int32_t first, last;
};

MENISCUS_HD inline NodeRange nodes_within(float middle, float extent) {
  return {static_cast<int32_t>(ceilf(middle - extent)), static_cast<int32_t>(floorf(middle + extent))};
}

/// Marks all blocks with a node inside a splat's box, or just below it: cubes that its surface may cut have
/// their lowest corners there.
struct MarkBlocks {
  View<const Ellipsoid> ellipsoids;
  SurfaceMembers members;
  SurfaceField field;
  BlockTable table;

  MENISCUS_HD void operator()(uint32_t i) const {
    if (!members.count(i)) return;
    const Splat s = splat_of(ellipsoids[i], field);
    if (!(s.weight > 0)) return;
    const NodeRange x = blocks(s.centre.x, s.extent.x), y = blocks(s.centre.y, s.extent.y),
                    z = blocks(s.centre.z, s.extent.z);
    for (int32_t c = z.first; c <= z.last; ++c) {
      for (int32_t b = y.first; b <= y.last; ++b) {
        for (int32_t a = x.first; a <= x.last; ++a) table.insert({a, b, c});
      }
    }
  }

  MENISCUS_HD static NodeRange blocks(float middle, float extent) {
    const NodeRange nodes = nodes_within(middle, extent);
    return {(nodes.first - 1) >> 2, nodes.last >> 2};
  }
};

/// Visits the nodes within the reach of splats.
struct SplatNodes {
  View<const Ellipsoid> ellipsoids;
  SurfaceMembers members;
  SurfaceField field;
  BlockTable table;

  /// visit(node, amount) for each node to which particle i adds an amount of the field.
  template <class Visit>
  MENISCUS_HD void visit(uint32_t i, const Visit& visit) const {
    if (!members.count(i)) return;
    const Splat s = splat_of(ellipsoids[i], field);
    if (!(s.weight > 0)) return;
    const NodeRange x = nodes_within(s.centre.x, s.extent.x), y = nodes_within(s.centre.y, s.extent.y),
                    z = nodes_within(s.centre.z, s.extent.z);
    for (int32_t c = z.first >> 2; c <= z.last >> 2; ++c) {
      for (int32_t b = y.first >> 2; b <= y.last >> 2; ++b) {
        for (int32_t a = x.first >> 2; a <= x.last >> 2; ++a) {
          const uint32_t number = table.find({a, b, c});
          if (number != no_block)
            visit_block(s, within(x, a), within(y, b), within(z, c), number * block_nodes, visit);
        }
      }
    }
  }

 private:
  MENISCUS_HD static NodeRange within(NodeRange nodes, int32_t block) {
    const int32_t low = block << 2, high = low + 3;
    return {nodes.first > low ? nodes.first : low, nodes.last < high ? nodes.last : high};
  }

  template <class Visit>
  MENISCUS_HD void visit_block(const Splat& s, NodeRange x, NodeRange y, NodeRange z, uint32_t first,
                               const Visit& visit) const {
    for (int32_t c = z.first; c <= z.last; ++c) {
      const float dz = static_cast<float>(c) - s.centre.z;
      for (int32_t b = y.first; b <= y.last; ++b) {
        const float dy = static_cast<float>(b) - s.centre.y;
        const float linear = 2 * (s.xy * dy + s.xz * dz);
        const float constant = 1 - (s.yy * dy * dy + s.zz * dz * dz + 2 * s.yz * dy * dz);
        for (int32_t a = x.first; a <= x.last; ++a) {
          const float dx = static_cast<float>(a) - s.centre.x;
          const float left = constant - dx * (s.xx * dx + linear);  // 1 − u²
          if (left <= 0) continue;
          const auto amount = static_cast<uint32_t>(s.weight * left * left * left + 0.5f);
          if (amount) visit(first + node_in_block({a, b, c}), amount);
        }
      }
    }
  }
};

/// Adds each splat to the nodes within its reach.
struct AddSplats {
  SplatNodes nodes;
  View<uint32_t> values;

  MENISCUS_HD void operator()(uint32_t i) const {
    nodes.visit(i, [&](uint32_t node, uint32_t amount) { pbd::atomic_add(values[node], amount); });
  }
};

/// The field at the nodes, as the cubes read it.
struct FieldView {
  BlockView blocks;
  View<const uint32_t> values;
  uint32_t iso;

  /// The value at the node at this offset from node i; 0 where there is no block.
  MENISCUS_HD uint32_t at(uint32_t i, GridPlace away) const {
    const uint32_t node = blocks.neighbour(i, away);
    return node == no_block ? 0 : values[node];
  }
  MENISCUS_HD bool is_inside(uint32_t value) const { return value >= iso; }

  MENISCUS_HD static GridPlace corner(uint32_t c) {
    return {static_cast<int32_t>(c & 1), static_cast<int32_t>(c >> 1 & 1), static_cast<int32_t>(c >> 2)};
  }
  /// Bit c: corner c of the cube above node i is inside.
  MENISCUS_HD uint32_t inside_corners(uint32_t i) const {
    uint32_t inside = 0;
    for (uint32_t c = 0; c < 8; ++c) inside |= static_cast<uint32_t>(is_inside(at(i, corner(c)))) << c;
    return inside;
  }
  /// Bit a: the surface cuts the edge from node i along axis a.
  MENISCUS_HD uint32_t cut_edges(uint32_t i) const {
    const bool self = is_inside(values[i]);
    uint32_t cut = 0;
    for (uint32_t a = 0; a < 3; ++a)
      cut |= static_cast<uint32_t>(is_inside(at(i, corner(1u << a))) != self) << a;
    return cut;
  }
};

MENISCUS_HD constexpr uint32_t bits_in(uint32_t three_bits) {
  return (three_bits & 1) + (three_bits >> 1 & 1) + (three_bits >> 2 & 1);
}

struct CountVertices {
  FieldView field;
  View<uint32_t> counts;

  MENISCUS_HD void operator()(uint32_t i) const { counts[i] = bits_in(field.cut_edges(i)); }
};

struct CountTriangles {
  FieldView field;
  View<const CubeTriangles> table;
  View<uint32_t> counts;

  MENISCUS_HD void operator()(uint32_t i) const { counts[i] = table[field.inside_corners(i)].count; }
};

/// Where the surface cuts the edge between nodes of these values, from 0 to 1.
MENISCUS_HD inline float crossing(uint32_t from, uint32_t to, uint32_t iso) {
  const float a = static_cast<float>(from) - static_cast<float>(iso);
  const float b = static_cast<float>(to) - static_cast<float>(iso);
  return pbd::clamp(a / (a - b), surface_tuning::least_from_node, 1 - surface_tuning::least_from_node);
}

struct WriteVertices {
  FieldView field;
  View<const uint32_t> start;
  float cell;
  View<Vec3> vertices, normals;

  MENISCUS_HD void operator()(uint32_t i) const {
    uint32_t to = start[i];
    if (start[i + 1] == to) return;
    const uint32_t cut = field.cut_edges(i);
    const GridPlace p = field.blocks.place_of_node(i);
    const Vec3 place{static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
    for (uint32_t a = 0; a < 3; ++a) {
      if (!(cut >> a & 1)) continue;
      const GridPlace end = FieldView::corner(1u << a);
      const float t = crossing(field.values[i], field.at(i, end), field.iso);
      const Vec3 along{static_cast<float>(end.x), static_cast<float>(end.y), static_cast<float>(end.z)};
      vertices[to] = cell * (place + t * along);
      const Vec3 slope = (1 - t) * slope_at(i, {0, 0, 0}) + t * slope_at(i, end);
      const Vec3 out = field.is_inside(field.values[i]) ? along : -along;
      normals[to] = normalized_or(-slope, out);
      ++to;
    }
  }

 private:
  MENISCUS_HD Vec3 slope_at(uint32_t i, GridPlace p) const {
    const auto difference = [&](int32_t x, int32_t y, int32_t z) {
      return static_cast<float>(field.at(i, {p.x + x, p.y + y, p.z + z})) -
             static_cast<float>(field.at(i, {p.x - x, p.y - y, p.z - z}));
    };
    return {difference(1, 0, 0), difference(0, 1, 0), difference(0, 0, 1)};
  }
};

struct WriteTriangles {
  FieldView field;
  View<const CubeTriangles> table;
  View<const uint32_t> vertex_start, start;
  View<std::array<uint32_t, 3>> triangles;

  MENISCUS_HD void operator()(uint32_t i) const {
    const uint32_t first = start[i], count = start[i + 1] - first;
    if (count == 0) return;
    const CubeTriangles cube = table[field.inside_corners(i)];
    for (uint32_t t = 0; t < count; ++t) {
      uint32_t corners[3];
      for (uint32_t k = 0; k < 3; ++k) corners[k] = vertex(i, pbd::cube_edge(cube.edges[3 * t + k]));
      triangles[first + t] = {corners[0], corners[1], corners[2]};
    }
  }

 private:
  MENISCUS_HD uint32_t vertex(uint32_t i, CubeEdge edge) const {
    const uint32_t node = field.blocks.neighbour(i, FieldView::corner(edge.corner));
    const uint32_t before = field.cut_edges(node) & ((1u << edge.axis) - 1);
    return vertex_start[node] + bits_in(before);
  }
};

}  // namespace meniscus::fluid::surface_kernels
