// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include "cloth/bending_kernels.h"
#include "cloth/clusters.h"
#include "cloth/stretch_kernels.h"

namespace meniscus::cloth {

/// The vertices of a cluster while it is worked on: in a GPU's shared memory, which gathers them many times
/// faster than its cache does.
struct ClusterScratch {
  Vec4 x[Cluster::most_vertices], moved[Cluster::most_vertices], previous[Cluster::most_vertices];
  uint32_t number[Cluster::most_vertices];
};

/// What constraints see of it: those that are solved one by one, and those that are side by side.
struct ClusterVertices {
  ClusterScratch& scratch;
  const VertexState& all;

  MENISCUS_HD float inverse_dt() const { return all.inverse_dt; }

  MENISCUS_HD Vertex at(uint32_t v) const { return {scratch.x[v], scratch.moved[v]}; }
  MENISCUS_HD Vec4 previous(uint32_t v) const { return scratch.previous[v]; }
  MENISCUS_HD float stretch_damping(uint32_t v) const { return all.stretch_damping(scratch.number[v]); }
  MENISCUS_HD float bending_damping(uint32_t v) const { return all.bending_damping(scratch.number[v]); }
  MENISCUS_HD void push(uint32_t v, const Vertex& vertex, Vec3 impulse) const {
    const Vertex after = pushed(vertex, 1, pbd::with_w(impulse, 0));
    scratch.x[v] = after.x;
    scratch.moved[v] = after.moved;
  }

  template <class D>
  MENISCUS_HD LaneVertex<D> at(const pbd::Places<D>& v) const {
    return {gather(x(), v.index()), gather(moved(), v.index())};
  }
  template <class D>
  MENISCUS_HD auto previous(const pbd::Places<D>& v) const {
    return gather(View<Vec4>{scratch.previous, Cluster::most_vertices}, v.index()).xyz();
  }
  template <class D>
  MENISCUS_HD typename D::Real stretch_damping(const pbd::Places<D>& v) const {
    return all.stretch_damping_by_lane<D>([&](uint32_t lane) { return scratch.number[v.at[lane]]; });
  }
  template <class D>
  MENISCUS_HD typename D::Real bending_damping(const pbd::Places<D>& v) const {
    return all.bending_damping_by_lane<D>([&](uint32_t lane) { return scratch.number[v.at[lane]]; });
  }
  template <class D, class R = typename D::Real>
  MENISCUS_HD void push(const pbd::Places<D>& v, const LaneVertex<D>& vertex, const R& s,
                        const pbd::Vec3Of<R>& impulse) const {
    push_side_by_side(x(), moved(), v, vertex, s, impulse);
  }

 private:
  MENISCUS_HD View<Vec4> x() const { return {scratch.x, Cluster::most_vertices}; }
  MENISCUS_HD View<Vec4> moved() const { return {scratch.moved, Cluster::most_vertices}; }
};

/// The clusters of one pass, each by a group of threads, batch by batch.
struct SolveClusters {
  using Scratch = ClusterScratch;

  View<const Cluster> clusters;
  View<const Batch> batches;
  View<const uint32_t> numbers;  ///< of the clusters' vertices
  VertexState all;
  bending_kernels::SolveIsometric isometric;
  bending_kernels::SolveHinge hinge;
  stretch_kernels::SolveStrain strain;
  stretch_kernels::SolveEdge edge;
  uint32_t first;  ///< cluster of the pass
  bool backwards;

  template <class Group>
  MENISCUS_HD void operator()(const Group& group, Scratch& scratch, uint32_t n) const {
    const Cluster cluster = clusters[first + n];
    const uint32_t vertices = cluster.end_vertex - cluster.first_vertex;
    group.for_each(vertices, [&](uint32_t v) {
      const uint32_t number = numbers[cluster.first_vertex + v], i = all.particles.sorted + number;
      scratch.number[v] = number;
      scratch.x[v] = all.particles.position[i];
      scratch.moved[v] = all.particles.moved[i];
      scratch.previous[v] = all.particles.previous[i];
    });
    sweep(group, cluster, ClusterVertices{scratch, all});
    group.for_each(vertices, [&](uint32_t v) {
      const uint32_t i = all.particles.sorted + scratch.number[v];
      all.particles.position[i] = scratch.x[v];
      all.particles.moved[i] = scratch.moved[v];
    });
  }

  template <class Group>
  MENISCUS_HD void sweep(const Group& group, const Cluster& cluster, const ClusterVertices& vertices) const {
    const uint32_t count = cluster.end_batch - cluster.first_batch;
    const auto batch_at = [&](uint32_t k) {
      return batches[backwards ? cluster.end_batch - 1 - k : cluster.first_batch + k];
    };
    Batch batch = batch_at(0);
    for (uint32_t k = 0; k < count; ++k) {
      const Batch next = k + 1 < count ? batch_at(k + 1) : Batch{batch.kind, 0, 0};
      switch (batch.kind) {
        case ConstraintKind::isometric:
          solve_by_lanes(group, vertices, batch, next, isometric);
          break;
        case ConstraintKind::hinge:
          solve(group, vertices, batch, next, hinge);
          break;
        case ConstraintKind::strain:
          solve(group, vertices, batch, next, strain);
          break;
        case ConstraintKind::edge:
          solve_by_lanes(group, vertices, batch, next, edge);
          break;
      }
      batch = next;
    }
  }

  /// While a batch is solved, the next one comes near.
  template <class Group, class Solver>
  MENISCUS_HD static void solve(const Group& group, const ClusterVertices& vertices, const Batch& batch,
                                const Batch& next, const Solver& solver) {
    const uint32_t ahead = next.kind == batch.kind ? next.count : 0;
    group.for_each(batch.count, [&](uint32_t i) {
      if (i < ahead) solver.prefetch(next.first + i);
      solver(vertices, batch.first + i);
    });
  }
  /// The same for constraints that are solved side by side.
  template <class Group, class Solver>
  MENISCUS_HD static void solve_by_lanes(const Group& group, const ClusterVertices& vertices,
                                         const Batch& batch, const Batch& next, const Solver& solver) {
    using D = typename Group::Device;
    constexpr uint32_t lanes = D::lane_count;
    const uint32_t ahead = next.kind == batch.kind ? next.count : 0;
    group.for_each((batch.count + lanes - 1) / lanes, [&](uint32_t k) {
      const uint32_t i = lanes * k;
      if (i < ahead) solver.prefetch(next.first + i);
      solver.run(vertices, pbd::SideBySide<D>(batch.first + i, batch.first + batch.count));
    });
  }
};

}  // namespace meniscus::cloth
