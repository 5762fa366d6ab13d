// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// The linear system of a rod's multipliers, and its solution by elimination along the rod and back.
#pragma once

#include "cloth/rods/elements.h"
#include "pbd/math/matrix.h"

namespace meniscus::cloth {

/// A row of 3×3 blocks of a symmetric band matrix, with its right-hand side. Each row couples to the two rows
/// after it.
struct BandRow {
  Sym3 diagonal;
  Mat3 next, after;  ///< the blocks below the diagonal in this column: one and two rows further
  Vec3 right;
};

/// The rows of a chain in the order of their solution: stretch and bending of each segment in turn, 2k and
/// 2k + 1. A closed chain is cut before the segment `cut`. The segment before the cut is left out.
struct BandOrder {
  RodChain chain;
  uint32_t cut;

  MENISCUS_HD uint32_t count() const { return 2 * chain.count - 1 - chain.closed; }
  MENISCUS_HD uint32_t operator[](uint32_t i) const {
    uint32_t k = cut + i / 2;
    if (k >= chain.count) k -= chain.count;
    return 2 * (chain.first + k) + i % 2;
  }
};

/// What elimination has subtracted from rows that it has not reached yet.
struct BandCarry {
  Sym3 diagonal{};
  Mat3 next{};
  Vec3 right{};
};

/// LDLᵀ factorization and solution of the band; `right` becomes the solution.
MENISCUS_HD inline void solve_band(pbd::View<BandRow> rows, const BandOrder& order) {
  const uint32_t count = order.count();
  BandCarry near, far;  // for this row and for the next one
  for (uint32_t i = 0; i < count; ++i) {
    BandRow& row = rows[order[i]];
    const Sym3 pivot = inverse(row.diagonal - near.diagonal);
    const Mat3 next = row.next - near.next, after = row.after;
    const Vec3 right = row.right - near.right;
    const Mat3 lower = next * pivot, lower2 = after * pivot;
    row = {pivot, lower, lower2, right};
    near = {far.diagonal + symmetric_product(lower, next), times_transposed(lower2, next),
            far.right + lower * right};
    far = {symmetric_product(lower2, after), {}, lower2 * right};
  }
  Vec3 x1{0, 0, 0}, x2{0, 0, 0};  // of the rows one and two further
  for (uint32_t i = count; i-- > 0;) {
    BandRow& row = rows[order[i]];
    const Vec3 x =
        row.diagonal * row.right - transposed_times(row.next, x1) - transposed_times(row.after, x2);
    row.right = x;
    x2 = x1;
    x1 = x;
  }
}

}  // namespace meniscus::cloth
