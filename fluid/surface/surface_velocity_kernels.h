// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The kernels that give the vertices of the surface velocities:
//   v(x) = Σ a (1 − u²)³ vᵢ / Σ a (1 − u²)³
// Both sums are known at nodes. Along an edge each is interpolated linearly, as the field is.
#pragma once

#include "fluid/surface/surface_mesh_kernels.h"
#include "fluid/surface/tuning.h"

namespace meniscus::fluid::surface_kernels {

/// Marks nodes at the end of an edge that the surface cuts.
struct CountEnds {
  FieldView field;
  View<uint32_t> counts;

  MENISCUS_HD void operator()(uint32_t i) const {
    const bool self = field.is_inside(field.values[i]);
    uint32_t cut = 0;
    for (uint32_t a = 0; a < 3; ++a) {
      const GridPlace step = FieldView::corner(1u << a);
      cut |= static_cast<uint32_t>(field.is_inside(field.at(i, step)) != self) |
             static_cast<uint32_t>(field.is_inside(field.at(i, {-step.x, -step.y, -step.z})) != self);
    }
    counts[i] = cut;
  }
};

/// Adds the velocity of each particle to such nodes, weighted by what it adds to the field.
struct AddMomenta {
  SplatNodes nodes;
  View<const pbd::Vec4> velocities;
  View<const uint32_t> start;  ///< of these nodes among the momenta
  View<NodeMomentum> momenta;

  MENISCUS_HD void operator()(uint32_t i) const {
    const Vec3 v = velocities[i].xyz();
    const int64_t x = whole(v.x), y = whole(v.y), z = whole(v.z);
    nodes.visit(i, [&](uint32_t node, uint32_t amount) {
      if (start[node + 1] == start[node]) return;
      NodeMomentum& to = momenta[start[node]];
      pbd::atomic_add(to.x, x * amount);
      pbd::atomic_add(to.y, y * amount);
      pbd::atomic_add(to.z, z * amount);
    });
  }

 private:
  MENISCUS_HD static int64_t whole(float speed) {
    constexpr float most = surface_tuning::fastest;
    return static_cast<int64_t>(pbd::clamp(speed, -most, most) / surface_tuning::speed_unit);
  }
};

struct WriteVelocities {
  FieldView field;
  View<const uint32_t> vertex_start, end_start;
  View<const NodeMomentum> momenta;
  View<Vec3> velocities;

  MENISCUS_HD void operator()(uint32_t i) const {
    uint32_t to = vertex_start[i];
    if (vertex_start[i + 1] == to) return;
    const uint32_t cut = field.cut_edges(i);
    for (uint32_t a = 0; a < 3; ++a) {
      if (!(cut >> a & 1)) continue;
      const GridPlace step = FieldView::corner(1u << a);
      const uint32_t end = field.blocks.neighbour(i, step);
      const uint32_t from_value = field.values[i], end_value = field.at(i, step);
      const float t = crossing(from_value, end_value, field.iso);
      const float sum = (1 - t) * static_cast<float>(from_value) + t * static_cast<float>(end_value);
      velocities[to++] = 1 / sum * ((1 - t) * momentum(i) + t * momentum(end));
    }
  }

 private:
  MENISCUS_HD Vec3 momentum(uint32_t node) const {
    if (node == no_block || end_start[node + 1] == end_start[node]) return {0, 0, 0};
    const NodeMomentum& m = momenta[end_start[node]];
    return surface_tuning::speed_unit *
           Vec3{static_cast<float>(m.x), static_cast<float>(m.y), static_cast<float>(m.z)};
  }
};

}  // namespace meniscus::fluid::surface_kernels
