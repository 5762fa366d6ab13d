// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The kernel that solves the clusters of a pass.
#pragma once

#include "cloth/build/clusters.h"
#include "cloth/solve/bending_kernels.h"
#include "cloth/solve/stretch_kernels.h"

namespace meniscus::cloth {

/// The vertices of a cluster while it is solved, in the shared memory of a GPU. Gathering from it is many
/// times faster than from the cache. Edges of the cluster are loaded into it as well, if there are at most
/// `most_items`. Otherwise each batch would wait for the device's memory.
struct ClusterScratch {
  static constexpr uint32_t most_items = 640;

  Vec4 x[Cluster::most_vertices], accumulated_delta[Cluster::most_vertices], previous[Cluster::most_vertices];
  uint32_t number[Cluster::most_vertices];
  struct {
    EdgeConstraint edges[most_items];
    float multiplier[most_items], last_step[most_items];
  } edge;

  template <class D>
  MENISCUS_HD void take(stretch_kernels::SolveEdge::Items<D>& items, uint32_t k) const {
    const EdgeConstraint& e = edge.edges[k];
    items.set(0, e);
    items.constants = {0, 0, e.rest_length, e.compliance};
    items.multiplier = edge.multiplier[k];
    items.last_step = edge.last_step[k];
  }
};

/// The properties of vertices that constraints use, whether solved one by one or side by side.
struct ClusterVertices {
  ClusterScratch& scratch;
  const VertexState& all;

  MENISCUS_HD float inverse_dt() const { return all.inverse_dt; }

  MENISCUS_HD Vertex at(uint32_t v) const { return {scratch.x[v], scratch.accumulated_delta[v]}; }
  MENISCUS_HD Vec4 previous(uint32_t v) const { return scratch.previous[v]; }
  MENISCUS_HD uint32_t piece_number(uint32_t v) const { return all.piece_number(scratch.number[v]); }
  MENISCUS_HD float stretch_damping(uint32_t v) const { return all.stretch_damping(scratch.number[v]); }
  MENISCUS_HD float bending_damping(uint32_t v) const { return all.bending_damping(scratch.number[v]); }
  MENISCUS_HD void push(uint32_t v, const Vertex& vertex, Vec3 positional_impulse) const {
    const Vertex after = pushed(vertex, 1, pbd::with_w(positional_impulse, 0));
    scratch.x[v] = after.x;
    scratch.accumulated_delta[v] = after.accumulated_delta;
  }

  template <class D>
  MENISCUS_HD LaneVertex<D> at(const pbd::Places<D>& v) const {
    return {gather(x(), v.index()), gather(accumulated_delta(), v.index())};
  }
  template <class D>
  MENISCUS_HD auto previous(const pbd::Places<D>& v) const {
    return gather(View<Vec4>{scratch.previous, Cluster::most_vertices}, v.index()).xyz();
  }
  template <class D>
  MENISCUS_HD typename D::Real stretch_damping(const pbd::Places<D>& v) const {
    return all.stretch_damping_by_lane<D>([&](uint32_t lane) { return scratch.number[v.at[lane]]; });
  }
  template <class D, class R = typename D::Real>
  MENISCUS_HD void push(const pbd::Places<D>& v, const LaneVertex<D>& vertex, const R& s,
                        const pbd::Vec3Of<R>& positional_impulse) const {
    push_side_by_side(x(), accumulated_delta(), v, vertex, s, positional_impulse);
  }

 private:
  MENISCUS_HD View<Vec4> x() const { return {scratch.x, Cluster::most_vertices}; }
  MENISCUS_HD View<Vec4> accumulated_delta() const {
    return {scratch.accumulated_delta, Cluster::most_vertices};
  }
};

/// The clusters of one pass. A group of threads solves each cluster, batch by batch.
struct SolveClusters {
  using Scratch = ClusterScratch;

  View<const Cluster> clusters;
  View<const Batch> batches;
  View<const uint32_t> numbers;  ///< of the clusters' vertices
  VertexState all;
  bending_kernels::SolveHinge hinge;
  stretch_kernels::SolveStrain strain;
  stretch_kernels::SolveEdge edge;
  uint32_t first;  ///< cluster of the pass
  bool backwards;

  /// Loads the constants of the cluster.
  template <class Group>
  MENISCUS_HD void prepare(const Group& group, Scratch& scratch, uint32_t n) const {
    const Cluster cluster = clusters[first + n];
    group.for_each(cluster.end_vertex - cluster.first_vertex,
                   [&](uint32_t v) { scratch.number[v] = numbers[cluster.first_vertex + v]; });
    if (!brings_items<Group>(cluster)) return;
    group.for_each(cluster.end_item - cluster.first_item, [&](uint32_t k) {
      const uint32_t item = cluster.first_item + k;
      scratch.edge.edges[k] = load(edge.edges, item);
    });
  }

  template <class Group>
  MENISCUS_HD void operator()(const Group& group, Scratch& scratch, uint32_t n) const {
    const Cluster cluster = clusters[first + n];
    const uint32_t vertices = cluster.end_vertex - cluster.first_vertex;
    const bool near = brings_items<Group>(cluster);
    const uint32_t edges = near ? cluster.end_item - cluster.first_item : 0;
    group.for_each(vertices > edges ? vertices : edges, [&](uint32_t k) {
      if (k < edges) {
        const Vec4 last = edge.multiplier[cluster.first_item + k];
        scratch.edge.multiplier[k] = last.w;
        scratch.edge.last_step[k] = last.x;
      }
      if (k >= vertices) return;
      const uint32_t i = all.particles.sorted + scratch.number[k];
      scratch.x[k] = all.particles.position[i];
      scratch.accumulated_delta[k] = all.particles.accumulated_delta[i];
      scratch.previous[k] = all.particles.previous[i];
    });
    sweep(group, cluster, scratch, near);
    group.for_each(vertices, [&](uint32_t v) {
      const uint32_t i = all.particles.sorted + scratch.number[v];
      all.particles.position[i] = scratch.x[v];
      all.particles.accumulated_delta[i] = scratch.accumulated_delta[v];
    });
  }

 private:
  template <class Group>
  MENISCUS_HD static bool brings_items(const Cluster& cluster) {
    return !Group::is_one_thread && cluster.end_item - cluster.first_item <= Scratch::most_items;
  }

  template <class Group>
  MENISCUS_HD void sweep(const Group& group, const Cluster& cluster, Scratch& scratch, bool near) const {
    const ClusterVertices vertices{scratch, all};
    const uint32_t count = cluster.end_batch - cluster.first_batch;
    const auto batch_at = [&](uint32_t k) {
      return batches[backwards ? cluster.end_batch - 1 - k : cluster.first_batch + k];
    };
    Batch batch = batch_at(0);
    for (uint32_t k = 0; k < count; ++k) {
      const Batch next = k + 1 < count ? batch_at(k + 1) : Batch{batch.kind, 0, 0};
      const uint32_t near_from = near ? cluster.first_item : none_near;
      switch (batch.kind) {
        case ConstraintKind::hinge:
          solve(group, vertices, batch, next, hinge);
          break;
        case ConstraintKind::strain:
          solve(group, vertices, batch, next, strain);
          break;
        case ConstraintKind::edge:
          solve_by_lanes(group, vertices, batch, next, edge, near_from);
          break;
      }
      batch = next;
    }
  }

  /// Solves a batch, and prefetches the next one meanwhile.
  template <class Group, class Solver>
  MENISCUS_HD static void solve(const Group& group, const ClusterVertices& vertices, const Batch& batch,
                                const Batch& next, const Solver& solver) {
    const uint32_t ahead = next.kind == batch.kind ? next.count : 0;
    group.for_each(batch.count, [&](uint32_t i) {
      if (i < ahead) solver.prefetch(next.first + i);
      solver(vertices, batch.first + i);
    });
  }
  /// The same for constraints that are solved side by side in SIMD lanes.
  template <class Group, class Solver>
  MENISCUS_HD static void solve_by_lanes(const Group& group, const ClusterVertices& vertices,
                                         const Batch& batch, const Batch& next, const Solver& solver,
                                         uint32_t near_from) {
    using D = typename Group::Device;
    constexpr uint32_t lanes = D::lane_count;
    const uint32_t ahead = near_from == none_near && next.kind == batch.kind ? next.count : 0;
    group.for_each((batch.count + lanes - 1) / lanes, [&](uint32_t k) {
      const uint32_t i = lanes * k;
      if (i < ahead) solver.prefetch(next.first + i);
      const pbd::SideBySide<D> together(batch.first + i, batch.first + batch.count);
      if constexpr (!Group::is_one_thread) {
        if (near_from != none_near) {
          typename Solver::template Items<D> items;
          vertices.scratch.take(items, batch.first + i - near_from);
          return solver.run(vertices, together, items);
        }
      }
      solver.run(vertices, together, solver.items(together));
    });
  }

  static constexpr uint32_t none_near = 0xffffffff;
};

}  // namespace meniscus::cloth
