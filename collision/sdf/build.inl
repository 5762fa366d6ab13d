// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Builds a field in three passes: distances and signs from the mesh; the crossings of the membranes that
// close its holes; distances to those.
#pragma once

#include "collision/mesh/triangle_bvh_query.h"
#include "collision/sdf/build.h"
#include "collision/sdf/membrane.h"

namespace meniscus::collision {

namespace sdf_kernels {

constexpr uint32_t run_length =
    8;  // nodes along x that one call takes: each starts from the result of the last one

MENISCUS_HD inline uint32_t runs_a_row(const Lattice& nodes) {
  return (nodes.nx + run_length - 1) / run_length;
}
MENISCUS_HD inline uint32_t run_count(const Lattice& nodes) {
  return runs_a_row(nodes) * nodes.ny * nodes.nz;
}

struct Run {
  uint32_t begin, end, j, k;
};

MENISCUS_HD inline Run run_at(const Lattice& nodes, uint32_t r) {
  const uint32_t a_row = runs_a_row(nodes), begin = r % a_row * run_length;
  const uint32_t end = begin + run_length < nodes.nx ? begin + run_length : nodes.nx;
  return {begin, end, r / a_row % nodes.ny, r / a_row / nodes.ny};
}

MENISCUS_HD inline bool within(const BvhNode& box, Vec3 p) {
  return p.x > box.lower.x && p.y > box.lower.y && p.z > box.lower.z &&  //
         p.x < box.upper.x && p.y < box.upper.y && p.z < box.upper.z;
}

struct SignedDistances {
  TriangleBvhView mesh;
  Lattice nodes;
  pbd::View<float> distances;

  MENISCUS_HD void operator()(uint32_t r) const {
    const Run run = run_at(nodes, r);
    uint32_t guess = 0;
    for (uint32_t i = run.begin; i < run.end; ++i) {
      const Vec3 p = nodes.point(i, run.j, run.k);
      const ClosestPoint closest = closest_point(mesh, p, guess);
      const bool inside = within(mesh.nodes[0], p) && is_inside(mesh, p);
      distances[nodes.index(i, run.j, run.k)] = inside ? -closest.distance : closest.distance;
      guess = closest.slot;
    }
  }
};

// Finds where on an edge the winding number passes a half.
struct MembraneCrossings {
  TriangleBvhView mesh;
  Lattice nodes;
  pbd::View<const MembraneEdge> edges;
  pbd::View<float> fractions;

  MENISCUS_HD void operator()(uint32_t e) const {
    const MembraneEdge edge = edges[e];
    const Vec3 from = nodes.point(edge.node);
    const Vec3 to = from + nodes.spacing * Vec3{edge.axis == 0 ? 1.0f : 0.0f, edge.axis == 1 ? 1.0f : 0.0f,
                                                edge.axis == 2 ? 1.0f : 0.0f};
    const float excess_from = fabsf(winding_number(mesh, from)) - 0.5f;
    const float excess_to = fabsf(winding_number(mesh, to)) - 0.5f;
    fractions[e] = clamped(excess_from / (excess_from - excess_to), 0, 1);
  }
};

struct DistancesToMembrane {
  TriangleBvhView membrane;
  Lattice nodes;
  pbd::View<float> distances;

  MENISCUS_HD void operator()(uint32_t at) const {
    const float distance = distances[at];
    const float nearer = distance_within(membrane, nodes.point(at), fabsf(distance));
    distances[at] = copysignf(nearer, distance);  // −0 is inside
  }
};

}  // namespace sdf_kernels

template <class D>
void close_holes(D& device, const DeviceTriangleBvh& mesh, Sdf& sdf) {
  const Lattice& nodes = sdf.nodes();
  const std::vector<MembraneEdge> edges = membrane_edges(nodes, sdf.values().read(nodes.count()));
  if (edges.empty()) return;
  const auto count = static_cast<uint32_t>(edges.size());
  pbd::Buffer<MembraneEdge> device_edges(device, "edges through a mesh's holes");
  pbd::Buffer<float> fractions(device, "crossings of a mesh's holes");
  device_edges.resize_discard(count);
  device_edges.write(edges);
  fractions.resize_discard(count);
  device.parallel_for(
      "find membranes", count,
      sdf_kernels::MembraneCrossings{mesh.view(), nodes, device_edges.view(), fractions.view()});

  const TriangleBvh membrane(membrane_mesh(nodes, edges, fractions.read(count)));
  const DeviceTriangleBvh device_membrane(device, membrane);
  device.parallel_for("distances to membranes", nodes.count(),
                      sdf_kernels::DistancesToMembrane{device_membrane.view(), nodes, sdf.values().view()});
  device.wait();  // the membrane is freed from here on
}

template <class D>
Sdf build_sdf(D& device, const DeviceTriangleBvh& mesh, float cell_size, float margin) {
  Sdf sdf(device, lattice_around(mesh.bounds(), cell_size, margin, "cell_size"));
  device.parallel_for("signed distances", sdf_kernels::run_count(sdf.nodes()),
                      sdf_kernels::SignedDistances{mesh.view(), sdf.nodes(), sdf.values().view()});
  close_holes(device, mesh, sdf);
  return sdf;
}

}  // namespace meniscus::collision
