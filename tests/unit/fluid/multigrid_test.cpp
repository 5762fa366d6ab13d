// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The grid's solver against elimination in double precision, and how many iterations depth takes.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/bench/harness/solver_bench.h"
#include "tests/devices.h"

namespace meniscus::tests {
namespace {

class MultigridTest : public OnDevice {
 protected:
  std::unique_ptr<SolverBench> bench_ = make_solver_bench(GetParam());

  /// A box of fluid, `ragged` with holes in it, closed all around but at the top of the last axis; with
  /// coefficients from 0.5 to 2, or all 1.
  static GridEquation box(const int (&size)[3], bool ragged) {
    GridEquation e;
    for (int axis = 0; axis < 3; ++axis)
      while ((1 << e.table.bits[axis]) < size[axis] + 2) ++e.table.bits[axis];
    std::mt19937 random(7);
    std::uniform_real_distribution<float> share(0, 1);
    const uint32_t nodes = e.table.count();
    std::vector<bool> fluid(nodes, false);
    const auto in_box = [&](const fluid::NodeCoordinates& c) {
      for (int axis = 0; axis < 3; ++axis)
        if (c.at[axis] < 1 || c.at[axis] > size[axis]) return false;
      return true;
    };
    for (uint32_t n = 0; n < nodes; ++n)
      fluid[n] = in_box(e.table.coordinates(n)) && !(ragged && share(random) < 0.15f);
    e.coefficients.assign(nodes, {0, 0, 0, 0});
    e.right.assign(nodes, 0);
    for (uint32_t n = 0; n < nodes; ++n) {
      const fluid::NodeCoordinates c = e.table.coordinates(n);
      float* face[] = {&e.coefficients[n].x, &e.coefficients[n].y, &e.coefficients[n].z};
      for (int axis = 0; axis < 3; ++axis) {
        const uint32_t other = e.table.beside(c, axis, 1);
        const bool to_air = axis == 2 && fluid[n] && c.at[2] == size[2];
        if ((fluid[n] && fluid[other]) || to_air) *face[axis] = ragged ? 0.5f + 1.5f * share(random) : 1.0f;
      }
    }
    for (uint32_t n = 0; n < nodes; ++n) {
      if (!fluid[n]) continue;
      const fluid::NodeCoordinates c = e.table.coordinates(n);
      pbd::Vec4& own = e.coefficients[n];
      own.w = own.x + own.y + own.z + e.coefficients[e.table.beside(c, 0, -1)].x +
              e.coefficients[e.table.beside(c, 1, -1)].y + e.coefficients[e.table.beside(c, 2, -1)].z;
      e.right[n] = share(random) - 0.5f;
      if (own.w == 0) own.w = 1;  // all alone
    }
    return e;
  }

  template <class Visit>
  static void for_each_entry(const GridEquation& e, uint32_t n, const Visit& visit) {
    const fluid::NodeCoordinates c = e.table.coordinates(n);
    for (int axis = 0; axis < 3; ++axis) {
      const auto along = [&](const pbd::Vec4& v) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; };
      const uint32_t before = e.table.beside(c, axis, -1);
      visit(before, double{along(e.coefficients[before])});
      visit(e.table.beside(c, axis, 1), double{along(e.coefficients[n])});
    }
  }

  /// By Gauss, with pivots on the diagonal: the matrix is positive definite.
  static std::vector<double> eliminated(const GridEquation& e) {
    const size_t nodes = e.table.count();
    std::vector<std::vector<double>> a(nodes, std::vector<double>(nodes, 0));
    std::vector<double> x(e.right.begin(), e.right.end());
    for (uint32_t n = 0; n < nodes; ++n) {
      const double diagonal = double{e.coefficients[n].w};
      a[n][n] = diagonal > 0 ? diagonal : 1;
      if (diagonal > 0)
        for_each_entry(e, n, [&](uint32_t m, double c) {
          if (e.coefficients[m].w > 0) a[n][m] -= c;
        });
    }
    for (size_t k = 0; k < nodes; ++k) {
      for (size_t i = k + 1; i < nodes; ++i) {
        const double factor = a[i][k] / a[k][k];
        if (factor == 0) continue;
        for (size_t j = k; j < nodes; ++j) a[i][j] -= factor * a[k][j];
        x[i] -= factor * x[k];
      }
    }
    for (size_t k = nodes; k-- > 0;) {
      for (size_t j = k + 1; j < nodes; ++j) x[k] -= a[k][j] * x[j];
      x[k] /= a[k][k];
    }
    return x;
  }

  static double residual(const GridEquation& e, const std::vector<float>& p) {
    double left = 0, all = 0;
    for (uint32_t n = 0; n < e.table.count(); ++n) {
      double r = double{e.right[n]} - double{e.coefficients[n].w} * double{p[n]};
      for_each_entry(e, n, [&](uint32_t m, double c) { r += c * double{p[m]}; });
      if (e.coefficients[n].w > 0) left += r * r;
      all += double{e.right[n]} * double{e.right[n]};
    }
    return std::sqrt(left / all);
  }
};

TEST_P(MultigridTest, FindsWhatEliminationFinds) {
  const GridEquation e = box({5, 6, 11}, true);
  const std::vector<double> exact = eliminated(e);
  const std::vector<float> found = bench_->solve(e, 25);
  double scale = 0;
  for (double x : exact) scale = std::max(scale, std::fabs(x));
  for (size_t n = 0; n < exact.size(); ++n)
    EXPECT_NEAR(double{found[n]}, exact[n], 2e-5 * scale) << "node " << n;
}

// A push from below has to lift the whole column: on a grid of single sweeps it would take one for each node.
TEST_P(MultigridTest, DepthTakesNoMoreIterations) {
  for (int depth : {30, 60, 124}) {
    GridEquation e = box({14, 14, depth}, false);
    for (uint32_t n = 0; n < e.table.count(); ++n)
      e.right[n] = e.coefficients[n].w > 0 && e.table.coordinates(n).at[2] == 1 ? 1.0f : 0.0f;
    const std::vector<float> found = bench_->solve(e, 4);
    const double floor = double{found[e.table.index(7, 7, 1)]};
    EXPECT_NEAR(floor / depth, 1, 0.05) << depth << " nodes deep";
  }
}

TEST_P(MultigridTest, RaggedEdgesDoNotHarm) {
  const GridEquation e = box({20, 20, 3}, true);
  EXPECT_LT(residual(e, bench_->solve(e, 4)), 0.5);
  EXPECT_LT(residual(e, bench_->solve(e, 12)), 0.05);
}

MENISCUS_ON_EACH_DEVICE(MultigridTest);

}  // namespace
}  // namespace meniscus::tests
