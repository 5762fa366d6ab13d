// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The kernels of multigrid.h. The equation of a node is Σ_f c_f (p − p_f) + extra p = b, over its six faces.
#pragma once

#include "fluid/pressure_grid/node_table.h"
#include "fluid/pressure_grid/tuning.h"
#include "pbd/device/base/view.h"
#include "pbd/math/vec.h"

namespace meniscus::fluid::multigrid_kernels {

using pbd::Vec4;
using pbd::View;

/// x, y, z: c of the faces towards the next node on each axis. w: the diagonal, 0 if the node is not an
/// unknown, so that p stays 0.
using Coefficients = Vec4;

MENISCUS_HD inline float along(const Vec4& v, int axis) {
  return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

struct Level {
  NodeTable table;
  View<Coefficients> coefficients;
  View<float> pressure, right;

  /// Calls visit(coordinates, number, c) for each adjacent node, where c belongs to the face between.
  template <class Visit>
  MENISCUS_HD void for_each_beside(const NodeCoordinates& c, const Coefficients& self,
                                   const Visit& visit) const {
    MENISCUS_UNROLL
    for (int axis = 0; axis < 3; ++axis) {
      NodeCoordinates before = c, after = c;
      --before.at[axis];
      ++after.at[axis];
      const uint32_t node = table.index(before);
      visit(before, node, along(coefficients[node], axis));
      visit(after, table.index(after), along(self, axis));
    }
  }

  /// b + Σ c p of the adjacent nodes, where p is pressure_of(coordinates, number).
  template <class PressureOf>
  MENISCUS_HD float pull(const NodeCoordinates& c, uint32_t node, const Coefficients& self,
                         const PressureOf& pressure_of) const {
    float sum = right[node];
    for_each_beside(c, self, [&](const NodeCoordinates& at, uint32_t beside, float face) {
      sum += face * pressure_of(at, beside);
    });
    return sum;
  }
  MENISCUS_HD float pull(const NodeCoordinates& c, uint32_t node, const Coefficients& self) const {
    return pull(c, node, self, [&](const NodeCoordinates&, uint32_t beside) { return pressure[beside]; });
  }
};

/// The colour of a node on a chequerboard: adjacent nodes have different colours.
MENISCUS_HD inline int colour(const NodeCoordinates& c) {
  return (c.at[0] + c.at[1] + c.at[2]) & 1;
}

/// One half of a Gauss–Seidel sweep: the nodes of one colour.
struct Relax {
  Level level;
  int turn;

  MENISCUS_HD void operator()(uint32_t node) const {
    const NodeCoordinates c = level.table.coordinates(node);
    if (colour(c) != turn) return;
    const Coefficients self = level.coefficients[node];
    if (self.w > 0) level.pressure[node] = level.pull(c, node, self) / self.w;
  }
};

/// A level's first sweep, from 0 everywhere: colour 0, then colour 1, whose nodes compute their neighbours of
/// colour 0 themselves.
struct StartSweep {
  Level level;

  MENISCUS_HD void operator()(uint32_t node) const {
    const NodeCoordinates c = level.table.coordinates(node);
    const Coefficients self = level.coefficients[node];
    float p = 0;
    if (self.w > 0) {
      p = colour(c) == 0 ? level.right[node]
                         : level.pull(c, node, self, [&](const NodeCoordinates&, uint32_t beside) {
                             const float w = level.coefficients[beside].w;
                             return w > 0 ? level.right[beside] / w : 0.0f;
                           });
      p /= self.w;
    }
    level.pressure[node] = p;
  }
};

/// A coarse node represents two fine ones on each axis on which the fine table has more than one.
struct Parents {
  NodeTable fine, coarse;

  MENISCUS_HD int halves(int axis) const { return static_cast<int>(fine.bits[axis] - coarse.bits[axis]); }
  MENISCUS_HD uint32_t parent(const NodeCoordinates& c) const {
    return coarse.index(c.at[0] >> halves(0), c.at[1] >> halves(1), c.at[2] >> halves(2));
  }
  /// Calls visit(child, coordinates of the child).
  template <class Visit>
  MENISCUS_HD void for_each_child(const NodeCoordinates& c, const Visit& visit) const {
    const int hx = halves(0), hy = halves(1), hz = halves(2);
    for (int z = 0; z <= hz; ++z) {
      for (int y = 0; y <= hy; ++y) {
        for (int x = 0; x <= hx; ++x) {
          const NodeCoordinates child{{(c.at[0] << hx) + x, (c.at[1] << hy) + y, (c.at[2] << hz) + z}};
          visit(fine.index(child), child);
        }
      }
    }
  }
};

/// The coarse equation: sums of the fine equations for a p that is constant on a coarse node's children. The
/// two nodes of a coarse face are twice as far apart, which halves its coefficient. A small remainder, where
/// only the adjacent nodes determine p, is rounding. In a sealed component, p would be that of the sums
/// divided by the remainder, and would dominate the solution.
struct Coarsen {
  Level fine, coarse;

  MENISCUS_HD void operator()(uint32_t node) const {
    const Parents parents{fine.table, coarse.table};
    const NodeCoordinates c = coarse.table.coordinates(node);
    float extra = 0, faces = 0, whole = 0;
    Coefficients self{0, 0, 0, 0};
    parents.for_each_child(c, [&](uint32_t child, const NodeCoordinates& at) {
      const Coefficients mine = fine.coefficients[child];
      if (!(mine.w > 0)) return;
      extra += mine.w;
      whole += mine.w;
      MENISCUS_UNROLL
      for (int axis = 0; axis < 3; ++axis) {
        const float scale = parents.halves(axis) ? 0.5f : 1.0f;
        for (int step = -1; step <= 1; step += 2) {
          NodeCoordinates other = at;
          other.at[axis] += step;
          const uint32_t beside = fine.table.index(other);
          if (!(fine.coefficients[beside].w > 0)) continue;
          const float face = along(step > 0 ? mine : fine.coefficients[beside], axis);
          extra -= face;
          if (parents.parent(other) == node) continue;
          faces += scale * face;
          if (step > 0) add(self, axis, scale * face);
        }
      }
    });
    self.w = faces + (extra > multigrid_tuning::coarse_rounding * whole ? extra : 0.0f);
    coarse.coefficients[node] = self;
  }

  MENISCUS_HD static void add(Coefficients& to, int axis, float value) {
    if (axis == 0) to.x += value;
    if (axis == 1) to.y += value;
    if (axis == 2) to.z += value;
  }
};

/// Transfers the residual to the coarse level. After a sweep it is 0 at nodes of colour 1.
struct Restrict {
  Level fine, coarse;

  MENISCUS_HD void operator()(uint32_t node) const {
    float sum = 0;
    const Parents parents{fine.table, coarse.table};
    parents.for_each_child(coarse.table.coordinates(node), [&](uint32_t child, const NodeCoordinates& c) {
      const Coefficients self = fine.coefficients[child];
      if (colour(c) == 0 && self.w > 0) sum += fine.pull(c, child, self) - self.w * fine.pressure[child];
    });
    coarse.right[node] = sum;
  }
};

/// Adds the coarse level's solution, the same to all children, and does the next half of a sweep, of
/// colour 1. Restriction and prolongation are each other's transpose, so that a cycle is symmetric. Nodes of
/// colour 0 are not updated, because the other half does not read them.
struct ProlongAndRelax {
  Level fine, coarse;

  MENISCUS_HD void operator()(uint32_t node) const {
    const NodeCoordinates c = fine.table.coordinates(node);
    if (colour(c) == 0) return;
    const Coefficients self = fine.coefficients[node];
    if (!(self.w > 0)) return;
    const Parents parents{fine.table, coarse.table};
    const float sum = fine.pull(c, node, self, [&](const NodeCoordinates& at, uint32_t beside) {
      if (!(fine.coefficients[beside].w > 0)) return 0.0f;
      return fine.pressure[beside] + coarse.pressure[parents.parent(at)];
    });
    fine.pressure[node] = sum / self.w;
  }
};

/// The levels that one group of threads solves alone, as a launch would take longer than its work.
struct SmallLevels {
  static constexpr uint32_t most = multigrid_tuning::small_bits + 1;  // halved on one axis at least
  Level level[most];
  uint32_t count;
  int sweeps;

  struct Scratch {};

  /// Builds all levels but the first.
  template <class Group>
  MENISCUS_HD void coarsen(const Group& group) const {
    for (uint32_t k = 0; k + 1 < count; ++k)
      group.for_each(level[k + 1].table.count(), Coarsen{level[k], level[k + 1]});
  }
  template <class Group>
  MENISCUS_HD void relax(const Group& group, uint32_t k, int turn) const {
    group.for_each(level[k].table.count(), Relax{level[k], turn});
  }
  template <class Group>
  MENISCUS_HD void sweep_down(const Group& group, uint32_t k) const {
    group.for_each(level[k].table.count(), StartSweep{level[k]});
    for (int sweep = 1; sweep < sweeps; ++sweep) {
      relax(group, k, 0);
      relax(group, k, 1);
    }
  }
  template <class Group>
  MENISCUS_HD void sweep_up(const Group& group, uint32_t k) const {
    group.for_each(level[k].table.count(), ProlongAndRelax{level[k], level[k + 1]});
    for (int sweep = 1; sweep < sweeps; ++sweep) {
      relax(group, k, 0);
      relax(group, k, 1);
    }
    relax(group, k, 0);
  }
  template <class Group>
  MENISCUS_HD void solve(const Group& group) const {
    for (uint32_t k = 0; k + 1 < count; ++k) {
      sweep_down(group, k);
      group.for_each(level[k + 1].table.count(), Restrict{level[k], level[k + 1]});
    }
    sweep_down(group, count - 1);
    for (uint32_t k = count - 1; k-- > 0;) sweep_up(group, k);
  }
};

struct CoarsenSmall {
  using Scratch = SmallLevels::Scratch;
  SmallLevels levels;

  template <class Group>
  MENISCUS_HD void operator()(const Group& group, Scratch&, uint32_t) const {
    levels.coarsen(group);
  }
};

struct SolveSmall {
  using Scratch = SmallLevels::Scratch;
  SmallLevels levels;

  template <class Group>
  MENISCUS_HD void operator()(const Group& group, Scratch&, uint32_t) const {
    levels.solve(group);
  }
};

// ---- conjugate gradients ----

struct Sum {
  MENISCUS_HD double operator()(double a, double b) const { return a + b; }
};

/// The state of the conjugate gradient iteration.
struct Search {
  View<float> solution, direction, ghost;
  View<double> products;  ///< r·z of this and the last iteration, alternating; p·A p
  uint32_t now, before;

  static constexpr uint32_t curvature = 2;
};

/// The last half of the finest level's sweep, of colour 0. Computes r·z, where z is the cycle's result for r.
struct FinishCycle {
  Level level;

  MENISCUS_HD double operator()(uint32_t node) const {
    const Coefficients self = level.coefficients[node];
    if (!(self.w > 0)) return 0;
    const NodeCoordinates c = level.table.coordinates(node);
    if (colour(c) == 0) level.pressure[node] = level.pull(c, node, self) / self.w;
    return double{level.right[node]} * double{level.pressure[node]};
  }
};

/// q = A p; computes p·q.
struct ApplyToDirection {
  Level level;
  Search search;

  MENISCUS_HD double operator()(uint32_t node) const {
    const Coefficients self = level.coefficients[node];
    float ghost = 0;
    if (self.w > 0) {
      float pull = 0;
      level.for_each_beside(level.table.coordinates(node), self,
                            [&](const NodeCoordinates&, uint32_t beside, float face) {
                              pull += face * search.direction[beside];
                            });
      ghost = self.w * search.direction[node] - pull;
    }
    search.ghost[node] = ghost;
    return double{search.direction[node]} * double{ghost};
  }
};

struct StepAlong {
  Level level;
  Search search;
  bool first;

  MENISCUS_HD void operator()(uint32_t node) const {
    const double curvature = search.products[Search::curvature];
    const float step = curvature > 0 ? static_cast<float>(search.products[search.now] / curvature) : 0.0f;
    search.solution[node] = (first ? 0 : search.solution[node]) + step * search.direction[node];
    level.right[node] -= step * search.ghost[node];
  }
};

/// The next direction: the cycle's result, plus a fraction of the last direction.
struct TurnDirection {
  Level level;
  Search search;

  MENISCUS_HD void operator()(uint32_t node) const {
    const double before = search.products[search.before];
    const float kept = before > 0 ? static_cast<float>(search.products[search.now] / before) : 0.0f;
    search.direction[node] = level.pressure[node] + kept * search.direction[node];
  }
};

}  // namespace meniscus::fluid::multigrid_kernels
