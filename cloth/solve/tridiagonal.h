// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Tridiagonal systems: elimination by one thread, cyclic reduction by a group of threads.
#pragma once

#include <cstdint>

#include "pbd/device/base/whole.h"
#include "pbd/device/scalar.h"
#include "pbd/math/vec.h"

namespace meniscus::cloth {

using pbd::read_whole;
using pbd::write_whole;

/// A row: lower x(i − 1) + diagonal x(i) + upper x(i + 1) = right, with 0 beyond the ends. The x are numbers
/// R or vectors of them.
template <class R, class X = R>
struct alignas(alignof(R) >= 16         ? alignof(R)
               : sizeof(X) == sizeof(R) ? 16
                                        : 8) TridiagonalRow {
  R lower, diagonal, upper;
  X right;
};

/// Elimination and substitution by one thread (Thomas). Afterwards `right` holds the solution.
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

/// Row i after the rows `apart` before and behind it are eliminated from it. The division must be exact to
/// the last place. With an inexact one, a strip that starts compressed hangs 1.3 % too flat.
template <class R, class X>
MENISCUS_HD TridiagonalRow<R, X> reduced(const TridiagonalRow<R, X>* rows, uint32_t count, uint32_t i,
                                         uint32_t apart) {
  using Row = TridiagonalRow<R, X>;
  constexpr Row beyond{0, 1, 0, X{}};
  const Row r = read_whole(rows, i);
  const Row before = i >= apart ? read_whole(rows, i - apart) : beyond;
  const Row after = i + apart < count ? read_whole(rows, i + apart) : beyond;
  const R a = -r.lower / before.diagonal, b = -r.upper / after.diagonal;
  return {a * before.lower, r.diagonal + a * before.upper + b * after.lower, b * after.upper,
          r.right + a * before.right + b * after.right};
}

/// How strongly rows depend on one another. `loose`: some diagonals are well above the sum of their
/// neighbours, and distant rows hardly matter.
enum class Coupling { tight, loose };

/// Cyclic reduction of all rows at once by a group of threads (Hockney & Jesshope 1981). Each turn couples
/// rows that are twice as far apart. Where the coupling is loose, it stops as soon as no row depends on
/// another. `other` has room for as many rows. Afterwards `right` holds the solution.
template <Coupling coupling, class Group, class R, class X>
MENISCUS_HD void reduce_all(const Group& group, TridiagonalRow<R, X>* rows, TridiagonalRow<R, X>* other,
                            uint32_t count) {
  using Row = TridiagonalRow<R, X>;
  Row *from = rows, *to = other;
  bool coupled = true;
  for (uint32_t apart = 1; apart < count && coupled; apart *= 2) {
    if constexpr (coupling == Coupling::tight) {
      group.for_each(count, [=](uint32_t i) { write_whole(to, i, reduced(from, count, i, apart)); });
    } else {
      coupled = group.any(count, [=](uint32_t i) {
        constexpr float rounding = 3e-8f;
        const Row r = reduced(from, count, i, apart);
        write_whole(to, i, r);
        return rounding * fabsf(r.diagonal) < pbd::max(fabsf(r.lower), fabsf(r.upper));
      });
    }
    Row* const done = to;
    to = from;
    from = done;
  }
  group.for_each(count, [=](uint32_t i) {
    const Row r = read_whole(from, i);
    rows[i].right = r.right / r.diagonal;
  });
}

/// The solution of row i, where `coarse` has the solution of every other row.
template <class R, class X>
MENISCUS_HD void substitute(const TridiagonalRow<R, X>* coarse, TridiagonalRow<R, X>* rows, uint32_t count,
                            uint32_t i) {
  X x = i / 2 < count / 2 ? coarse[i / 2].right : X{};
  if (i % 2 == 0) {
    const TridiagonalRow<R, X> r = read_whole(rows, i);
    const X before = i > 0 ? coarse[i / 2 - 1].right : X{};
    x = (r.right - r.lower * before - r.upper * x) / r.diagonal;
  }
  rows[i].right = x;
}

/// Cyclic reduction by a group of threads. Every other row is eliminated, until few enough rows are left to
/// be reduced all at once. That takes fewer turns but more work. `other` has room for as many rows.
/// Afterwards `right` holds the solution.
template <Coupling coupling, class Group, class R, class X>
MENISCUS_HD void reduce_cyclically(const Group& group, TridiagonalRow<R, X>* rows,
                                   TridiagonalRow<R, X>* other, uint32_t count) {
  using Row = TridiagonalRow<R, X>;
  constexpr uint32_t few = 256;
  Row *level = rows, *next = other;
  uint32_t halvings = 0;
  for (; count >> halvings > few; ++halvings) {
    const uint32_t above = count >> halvings, half = above / 2;
    group.for_each(half, [=](uint32_t k) { write_whole(next, k, reduced(level, above, 2 * k + 1, 1)); });
    level = next;
    next += half;
  }
  reduce_all<coupling>(group, level, next, count >> halvings);
  while (halvings > 0) {
    const uint32_t above = count >> --halvings;
    const Row* const coarse = level;
    level = halvings ? level - above : rows;
    group.for_each(above, [=](uint32_t i) { substitute(coarse, level, above, i); });
  }
}

/// Solves a system. `other` has room for as many rows. Groups of several threads use it.
template <Coupling coupling, class Group, class R, class X>
MENISCUS_HD void solve_tridiagonal(const Group& group, TridiagonalRow<R, X>* rows,
                                   TridiagonalRow<R, X>* other, uint32_t count) {
  if constexpr (Group::is_one_thread) {
    eliminate(rows, count);
  } else {
    reduce_cyclically<coupling>(group, rows, other, count);
  }
}

}  // namespace meniscus::cloth
