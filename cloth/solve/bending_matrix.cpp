// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Assembles the matrix of isometric bending.
#include "cloth/solve/bending_matrix.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "cloth/build/tuning.h"

namespace meniscus::cloth {

namespace {

struct Entry {
  uint32_t column;
  double value;
};

std::array<double, 4> weights_of(const IsometricConstraint& h) {
  const double b = double{h.weight[0]}, c = double{h.weight[1]}, d = double{h.weight[2]};
  return {-(b + c + d), b, c, d};
}

/// Σ k²/m of a hinge, 1/kg
double mobility_of(const IsometricConstraint& h, std::span<const float> masses) {
  const std::array<uint32_t, 4> at{h.a, h.b, h.c, h.d};
  const std::array<double, 4> k = weights_of(h);
  double sum = 0;
  for (size_t i = 0; i < 4; ++i) sum += k[i] * k[i] / double{masses[at[i]]};
  return sum;
}

/// D/(A₁ + A₂), J/m². That of unyielding cloth is infinite.
double stiffness_of(const IsometricConstraint& h, std::span<const float> masses) {
  return std::min(1 / double{h.compliance}, build_tuning::stiffest_bending / mobility_of(h, masses));
}

/// Rows of the upper triangle, each in the order of columns and without doubles. Both halves of the matrix
/// then have the same bits, and what its rows exert on one another cancels.
std::vector<std::vector<Entry>> upper_rows(std::span<const IsometricConstraint> hinges,
                                           std::span<const float> masses) {
  std::vector<std::vector<Entry>> rows(masses.size());
  for (const IsometricConstraint& h : hinges) {
    const std::array<uint32_t, 4> at{h.a, h.b, h.c, h.d};
    const std::array<double, 4> k = weights_of(h);
    const double stiffness = stiffness_of(h, masses);
    for (size_t i = 0; i < 4; ++i) {
      for (size_t j = i + 1; j < 4; ++j) {
        const auto [low, high] = std::minmax(at[i], at[j]);
        rows[low].push_back({high, stiffness * k[i] * k[j]});
      }
    }
  }
  for (std::vector<Entry>& row : rows) {
    std::stable_sort(row.begin(), row.end(),
                     [](const Entry& a, const Entry& b) { return a.column < b.column; });
    size_t kept = 0;
    for (const Entry& e : row) {
      if (kept > 0 && row[kept - 1].column == e.column)
        row[kept - 1].value += e.value;
      else
        row[kept++] = e;
    }
    row.resize(kept);
  }
  return rows;
}

/// Σ_j |Q_ij| x_j
double sum_of_sizes(const BendingMatrix& matrix, const std::vector<double>& x, uint32_t i) {
  constexpr uint32_t slice = BendingMatrix::slice;
  const uint32_t s = i / slice;
  double diagonal = 0, sum = 0;
  for (uint32_t n = matrix.slice_start[s] + i % slice; n < matrix.slice_start[s + 1]; n += slice) {
    const double q = double{matrix.value[n]};
    diagonal -= q;
    sum += std::abs(q) * x[matrix.column[n]];
  }
  return sum + diagonal * x[i];
}

float median(std::vector<float>& values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

BendingMatrix bending_matrix(std::span<const IsometricConstraint> hinges, std::span<const float> masses) {
  BendingMatrix matrix;
  if (hinges.empty()) return matrix;
  const std::vector<std::vector<Entry>> upper = upper_rows(hinges, masses);
  const auto vertices = static_cast<uint32_t>(masses.size());
  std::vector<uint32_t> length(vertices, 0);
  for (uint32_t i = 0; i < vertices; ++i) {
    length[i] += static_cast<uint32_t>(upper[i].size());
    for (const Entry& e : upper[i]) ++length[e.column];
  }
  constexpr uint32_t slice = BendingMatrix::slice;
  matrix.slice_start.push_back(0);
  for (uint32_t i = 0; i < vertices; i += slice) {
    const auto begin = length.begin() + i, end = length.begin() + std::min(i + slice, vertices);
    matrix.slice_start.push_back(matrix.slice_start.back() + slice * *std::max_element(begin, end));
  }
  matrix.column.resize(matrix.slice_start.back());
  matrix.value.resize(matrix.slice_start.back(), 0);
  for (uint32_t s = 0; s + 1 < matrix.slice_start.size(); ++s) {
    for (uint32_t n = matrix.slice_start[s]; n < matrix.slice_start[s + 1]; ++n)
      matrix.column[n] = std::min(s * slice + n % slice, vertices - 1);
  }
  std::vector<uint32_t> filled(vertices, 0);
  const auto put = [&](uint32_t row, uint32_t column, double value) {
    const uint32_t at = matrix.slice_start[row / slice] + slice * filled[row]++ + row % slice;
    matrix.column[at] = column;
    matrix.value[at] = static_cast<float>(value);
  };
  for (uint32_t i = 0; i < vertices; ++i) {
    for (const Entry& e : upper[i]) {
      put(i, e.column, e.value);
      put(e.column, i, e.value);
    }
  }
  return matrix;
}

std::vector<BendingRate> bending_rates(const BendingMatrix& matrix,
                                       std::span<const IsometricConstraint> hinges,
                                       std::span<const float> masses, std::span<const Piece> pieces) {
  std::vector<BendingRate> rates(pieces.size());
  if (hinges.empty()) return rates;
  std::vector<uint32_t> piece_of(masses.size());
  for (uint32_t p = 0; p < pieces.size(); ++p)
    std::fill(piece_of.begin() + pieces[p].first_vertex, piece_of.begin() + pieces[p].end_vertex, p);
  std::vector<double> mode(masses.size(), 1), next(masses.size());
  std::vector<double> greatest(pieces.size());
  for (int round = 0; round < build_tuning::bound_rounds; ++round) {
    std::fill(greatest.begin(), greatest.end(), 0);
    for (uint32_t i = 0; i < masses.size(); ++i) {
      next[i] = sum_of_sizes(matrix, mode, i) / double{masses[i]};
      double& most = greatest[piece_of[i]];
      most = std::max(most, next[i] / mode[i]);
    }
    for (uint32_t i = 0; i < masses.size(); ++i) {
      const double most = greatest[piece_of[i]];
      mode[i] = most > 0 ? std::max(next[i] / most, 1e-3) : 1;
    }
  }
  for (size_t p = 0; p < pieces.size(); ++p) rates[p].fastest = static_cast<float>(greatest[p]);
  std::vector<std::vector<float>> of_hinges(pieces.size());
  for (const IsometricConstraint& h : hinges) {
    of_hinges[piece_of[h.a]].push_back(static_cast<float>(mobility_of(h, masses) * stiffness_of(h, masses)));
  }
  for (size_t p = 0; p < pieces.size(); ++p) {
    rates[p].typical = median(of_hinges[p]);
    rates[p].damping = std::max(pieces[p].bending_damping, 0.0f);
  }
  return rates;
}

}  // namespace meniscus::cloth
