// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
#pragma once

#include "pbd/math/vec.h"

namespace meniscus::cloth {

/// lower x(i − 1) + diagonal x(i) + upper x(i + 1) = right, with 0 for what is beyond the ends; x are numbers
/// R or vectors of them.
template <class R, class X = R>
struct alignas(16) alignas(R) TridiagonalRow {
  R lower, diagonal, upper;
  X right;
};

/// Elimination and substitution by one thread (Thomas). Afterwards `right` is the solution.
template <class R, class X>
MENISCUS_HD void eliminate(TridiagonalRow<R, X>* rows, uint32_t count) {
  R upper(0);
  X right{};
  for (uint32_t i = 0; i < count; ++i) {
    const TridiagonalRow<R, X> r = rows[i];
    const R inverse = R(1) / (r.diagonal - r.lower * upper);
    upper = inverse * r.upper;
    right = inverse * (r.right - r.lower * right);
    rows[i].upper = upper;
    rows[i].right = right;
  }
  X x{};
  for (uint32_t i = count; i-- > 0;) rows[i].right = x = rows[i].right - rows[i].upper * x;
}

/// Cyclic reduction of all rows at once by a group of threads (Hockney & Jesshope 1981): each turn couples
/// rows that are twice as far apart. Returns which of the two has the solution in `right`.
template <class Group, class R, class X>
MENISCUS_HD TridiagonalRow<R, X>* reduce_cyclically(const Group& group, TridiagonalRow<R, X>* rows,
                                                    TridiagonalRow<R, X>* other, uint32_t count) {
  using Row = TridiagonalRow<R, X>;
  for (uint32_t apart = 1; apart < count; apart *= 2) {
    group.for_each(count, [=](uint32_t i) {
      constexpr Row beyond{0, 1, 0, X{}};
      const Row r = rows[i];
      const Row before = i >= apart ? rows[i - apart] : beyond;
      const Row after = i + apart < count ? rows[i + apart] : beyond;
      const R a = -r.lower / before.diagonal, b = -r.upper / after.diagonal;
      other[i] = {a * before.lower, r.diagonal + a * before.upper + b * after.lower, b * after.upper,
                  r.right + a * before.right + b * after.right};
    });
    Row* const done = other;
    other = rows;
    rows = done;
  }
  group.for_each(count, [=](uint32_t i) { rows[i].right = rows[i].right / rows[i].diagonal; });
  return rows;
}

/// Either. Returns where the solution is; one thread needs no `other`.
template <class Group, class R, class X>
MENISCUS_HD TridiagonalRow<R, X>* solve_tridiagonal(const Group& group, TridiagonalRow<R, X>* rows,
                                                    TridiagonalRow<R, X>* other, uint32_t count) {
  if constexpr (Group::is_one_thread) {
    eliminate(rows, count);
    return rows;
  } else {
    return reduce_cyclically(group, rows, other, count);
  }
}

}  // namespace meniscus::cloth
