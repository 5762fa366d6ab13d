// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The load of the grid's pressure on solids. If the faces of a node are not equally open, part of its
// pressure acts on the solid between them. The contacts near the node receive it, including those with cloth,
// so that fluid and solids exchange equal and opposite impulses.
#pragma once

#include "fluid/pressure_grid/motion_kernels.h"
#include "fluid/pressure_grid/tuning.h"

namespace meniscus::fluid::grid_kernels {

/// The area, m², on which a node's pressure pushes solids. The push on the fluid points along it.
struct WallAreas {
  NodeTable nodes;
  View<const uint32_t> flags;
  View<const NodeFaces> faces;
  float width2;

  MENISCUS_HD float area(uint32_t node, int axis) const {
    const FaceState f = faces[node].face[axis];
    return f.mass > 0 ? f.area : 0.0f;
  }
  MENISCUS_HD Vec3 at(uint32_t node) const {
    if ((flags[node] & (node_fluid | node_touched)) != (node_fluid | node_touched)) return {0, 0, 0};
    const NodeCoordinates c = nodes.coordinates(node);
    float a[3];
    for (int axis = 0; axis < 3; ++axis)
      a[axis] = width2 * (area(node, axis) - area(nodes.beside(c, axis, -1), axis));
    return {a[0], a[1], a[2]};
  }
};

/// The load of a node's pressure on the solids near it.
struct NodeLoad {
  Vec3 area;     ///< m²
  Vec3 inverse;  ///< on each axis the reciprocal of the sum of the contacts' weights
};

/// The weights of contacts at a node on each axis. They grow as the particle nears the node and the surface,
/// and as the surface faces the push. If all of these are 0, any contact counts, so that no load is lost.
MENISCUS_HD inline Vec3 contact_weights(const Contact& c, Vec3 particle, float at_node, Vec3 area,
                                        float width) {
  if (pbd::is_attachment(c)) return {0, 0, 0};
  const float near = pbd::clamp(1 - plane_distance(c, particle) / width, grid_tuning::least_nearness, 1.0f);
  const auto facing = [](float normal, float push) {
    const float along_push = push < 0 ? -normal : normal;
    return grid_tuning::least_facing + (along_push > 0 ? along_push * along_push : 0.0f);
  };
  const float weight = at_node * near * near;
  return weight * Vec3{facing(c.normal.x, area.x), facing(c.normal.y, area.y), facing(c.normal.z, area.z)};
}

MENISCUS_HD inline Vec3 product(Vec3 a, Vec3 b) {
  return {a.x * b.x, a.y * b.y, a.z * b.z};
}

/// Of a node's contacts.
struct ContactSums {
  Vec3 weights{0, 0, 0}, gives{0, 0, 0};
};

/// Sums the weights of a node's contacts, and the compliance of their bodies.
struct WeighContacts {
  Space space;
  WallAreas areas;
  View<const Found> found;
  View<const Vec4> position;
  ContactView contacts;
  View<NodeLoad> load;
  View<float> give;  ///< m⁴/kg
  FromBelow<ContactSums> below{};

  MENISCUS_HD void operator()(uint32_t node) const {
    const Vec3 area = areas.at(node);
    ContactSums sums = below.of(node);
    add(node, area, sums);
    const auto over = [](float x) { return x > 0 ? 1 / x : 0.0f; };
    const Vec3 inverse{over(sums.weights.x), over(sums.weights.y), over(sums.weights.z)};
    load[node] = {area, inverse};
    const Vec3 each = product(area, inverse);
    give[node] = dot(product(each, each), sums.gives);
  }

  MENISCUS_HD void add(uint32_t node, Vec3 area, ContactSums& sums) const {
    if (!(dot(area, area) > 0)) return;
    for_each_around(space, node, found, TouchingCells{contacts.start}, [&](uint32_t i, Vec3 away) {
      for (uint32_t n = contacts.start[i]; n < contacts.start[i + 1]; ++n) {
        const Contact& c = contacts.contacts[n];
        const Vec3 w = contact_weights(c, position[i].xyz(), node_weight(away), area, space.width());
        sums.weights += w;
        sums.gives += c.body_inverse_mass * product(w, w);
      }
    });
  }
};

/// For the rank above: the sums of this rank's contacts for the nodes of its first layer. Their cells come
/// first in the order of a node's cells, so the rank above goes on from these sums.
struct WeighContactsAbove {
  NodeLayers layers;
  WeighContacts weigh;
  View<ContactSums> sums;

  MENISCUS_HD void operator()(uint32_t k) const {
    const uint32_t node = layers.node(k);
    ContactSums all;
    weigh.add(node, weigh.areas.at(node), all);
    sums[k] = all;
  }
};

/// Leaves nothing of nodes without fluid.
struct ClearNodes {
  View<uint32_t> flags;
  View<float> filled, right, give;
  View<NodeFaces> faces;
  View<NodeLoad> load;

  MENISCUS_HD void operator()(uint32_t node) const {
    flags[node] = 0;
    filled[node] = right[node] = give[node] = 0;
    faces[node] = {};
    load[node] = {};
  }
};

/// Adds the push to the contacts: the solids receive it like that of the density constraint.
struct PushSolids {
  Space space;
  View<const Found> found;
  View<const Vec4> position;
  ContactView contacts;
  View<const NodeLoad> load;
  PressureOf pressure;
  float fraction;

  MENISCUS_HD void operator()(uint32_t n) const {
    const uint32_t i = contacts.touching_particle(n);
    if (i == pbd::no_index) return;
    const Vec3 p = position[i].xyz();
    const float width = space.width();
    for_each_node(space.nodes, space.place(p, found[i].xyz()), [&](uint32_t node, float weight) {
      const NodeLoad at = load[node];
      if (dot(at.area, at.area) == 0) return;
      const Vec3 each = fraction * pressure(node) * product(at.area, at.inverse);
      for (uint32_t k = contacts.start[i]; k < contacts.start[i + 1]; ++k) {
        Contact& c = contacts.contacts[k];
        c.density_push += product(each, contact_weights(c, p, weight, at.area, width));
      }
    });
  }
};

}  // namespace meniscus::fluid::grid_kernels
